#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/numerics/examinee_count.hpp"
#include "analysis/report/study_table.hpp"

namespace palpate::analysis {

/// A comparison of cells within examinees: a weighted sum of an examinee's proportions correct.
struct Contrast {
  enum class Kind { Cells, MainEffect, Interaction };
  Kind kind = Kind::Cells;
  std::string factor{};           // of a main effect; "gap and contact.model" of an interaction
  std::string first{}, second{};  // cells or levels; the sum is first's less second's
  std::string effect{};           // of an interaction: what differs with first and second, "near less far"
  std::vector<int> weights{};     // one for each cell, before division by `divisor`
  int divisor = 1;
};

/// What it is called: "kuroda against sibille", "gap, near against far", "interaction of gap and contact.model".
std::string name_of(const Contrast& contrast);

/// What the plan compares where it names a test: the two cells, or with two factors of two levels both main
/// effects and their interaction. Then, and where it names none, each cell with each other. The planned ones
/// come first.
std::vector<Contrast> contrasts(const StudyDesign& design);

/// How many of them are planned.
std::size_t planned_contrasts(const StudyDesign& design);

/// The factors that take more than one level, as indices.
std::vector<std::size_t> varied_factors(const StudyDesign& design);

/// What the factors that vary are called: "contact.model", "gap and contact.model"; "cell" where none does.
std::string factors_in_words(const StudyDesign& design);

/// The contrast of one examinee, from his counts in each cell; empty where a cell that has a weight has no
/// answer. Counted in whole numbers and divided once, so that equal contrasts are equal.
std::optional<double> contrast_of(const Contrast& contrast, const std::vector<ExamineeCount>& cells);

}  // namespace palpate::analysis
