#pragma once

#include <optional>
#include <string>

#include "analysis/report/report.hpp"

namespace palpate::analysis {

/// Share of presentations that are told apart, p_d, from which on two conditions are no longer called
/// similar: the middle one of the three that ISO 4120 and ISO 5495 work with (20, 30, 40 %).
constexpr double kSimilarBelow = 0.3;

/// What the answers of a cell say where the planned test does not reject: how large a difference remains
/// possible, and how much they speak for chance.
/// @param level  confidence of the similarity test and of the bound
EvidenceForChance evidence_for_chance(const PrimaryTest& test, double level);

/// A sentence on it, for the summary.
std::string in_words(const EvidenceForChance& evidence);

}  // namespace palpate::analysis
