#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/description/statistic.hpp"

namespace palpate::app {

// A statistic's description in the forms that its users read.

/// One line for `palpate stats --help`: "Are more answers correct than guessing gives? (exact binomial test)"
std::string summary_of(const analysis::Statistic& statistic);

/// For `palpate stats NAME --help`, below its options: what it tests, its data, an example.
std::string teaching_of(const analysis::Statistic& statistic);

/// All of them: a list for a terminal, the page docs/statistics.md, and an object for programs.
std::string statistics_as_text();
std::string statistics_as_markdown();
nlohmann::ordered_json statistics_as_json();

}  // namespace palpate::app
