#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/description/arguments.hpp"

namespace palpate::analysis {

// A statistic as its user meets it. One description serves `palpate stats NAME` (options, help),
// `palpate stats batch` (keys) and docs/statistics.md (tables), so that the three cannot differ.

/// A part of a result, at the top level of its JSON object.
struct Output {
  std::string name{};
  std::string meaning{};
};

/// A result: `json` for programs, with every number that `text` was written from.
struct Outcome {
  nlohmann::ordered_json json{};
  std::string text{};  // for a terminal: a few lines, every line a whole thought
};

struct Statistic {
  std::string name{};      // "binomial"
  std::string question{};  // that it answers: "Are more answers correct than guessing gives?"
  std::string title{};     // "exact binomial test"
  std::string teaches{};   // what it tests, when it applies and when it does not; a paragraph or two
  std::vector<Input> inputs{};
  Data data{};
  std::vector<Output> outputs{};     // every key of Outcome::json but "procedure" and "method"
  nlohmann::ordered_json example{};  // arguments that run: for the help, the documentation and the tests
  std::function<Outcome(const Arguments&)> run{};
};

// Inputs that many statistics share.
Input correct_input();
Input trials_input();
Input chance_input();                           // 1/2 unless given
Input alpha_input();                            // 0.05 unless given
Input side_input(const std::string& usual);     // "greater", "less", "two-sided"
Input level_input();                            // 0.95 unless given
Input seed_input();                             // 1 unless given
Data difference_data(const std::string& what);  // one column, "difference"

}  // namespace palpate::analysis
