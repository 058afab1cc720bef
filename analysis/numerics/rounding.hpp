#pragma once

#include <span>
#include <vector>

namespace palpate::analysis {

// Numbers that are equal but for rounding. 0.3 - 0.2 and 0.1 differ in the last bits of a double: whoever
// subtracted before handing numbers over has lost ties, zeros and equalities, and a test of ranks, signs or
// spread would take round-off for data.

/// Differences of numbers: those whose magnitudes agree to 1e-12 of the greatest magnitude get one magnitude,
/// those within that of 0 become 0. Round-off stays below as long as what was subtracted is below a thousand
/// times the greatest difference.
std::vector<double> settled_differences(std::span<const double> differences);

/// Values as they were measured: those that agree to four units of their last place become the least of them.
std::vector<double> settled_values(std::span<const double> values);

}  // namespace palpate::analysis
