#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/hard_cases/hard_case.hpp"

namespace palpate::hard_cases {

/// A case with the worst of its runs.
struct Result {
  HardCase hard_case{};
  Outcome worst{};
};

/// docs/hard-cases.md.
std::string document(const std::vector<Result>& results);

/// Where `committed` differs from `fresh`, in words; none where they say the same. Figures come out of rounding and of
/// this machine: they agree within a factor of ten, or where both keep their limit by a factor of a thousand.
std::vector<std::string> differences(std::string_view committed, std::string_view fresh,
                                     const std::vector<Result>& results);

}  // namespace palpate::hard_cases
