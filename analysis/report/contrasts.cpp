#include "analysis/report/contrasts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

/// Which of the two levels of a factor a cell has: 1 for the one that comes first in the protocol, else -1.
int sign(const StudyDesign& design, std::size_t cell, std::size_t factor) {
  return design.cells[cell].levels[factor] == design.cells.front().levels[factor] ? 1 : -1;
}

/// The level that is not the first cell's.
std::string other_level(const StudyDesign& design, std::size_t factor) {
  const std::string& first = design.cells.front().levels[factor];
  return std::ranges::find_if(design.cells,
                              [&](const DesignCell& cell) { return cell.levels[factor] != first; })
      ->levels[factor];
}

Contrast main_effect(const StudyDesign& design, std::size_t factor) {
  Contrast contrast{.kind = Contrast::Kind::MainEffect,
                    .factor = design.factors[factor],
                    .first = design.cells.front().levels[factor],
                    .second = other_level(design, factor),
                    .divisor = 2};
  for (std::size_t cell = 0; cell < design.cells.size(); ++cell)
    contrast.weights.push_back(sign(design, cell, factor));
  return contrast;
}

/// The first factor's effect under the second's first level, less that under its second level.
Contrast interaction(const StudyDesign& design, std::size_t one, std::size_t other) {
  Contrast contrast{
      .kind = Contrast::Kind::Interaction,
      .factor = listed({design.factors[one], design.factors[other]}),
      .first = design.cells.front().levels[other],
      .second = other_level(design, other),
      .effect = fmt::format("{} less {}", design.cells.front().levels[one], other_level(design, one))};
  for (std::size_t cell = 0; cell < design.cells.size(); ++cell)
    contrast.weights.push_back(sign(design, cell, one) * sign(design, cell, other));
  return contrast;
}

Contrast pair_of(const StudyDesign& design, std::size_t first, std::size_t second) {
  Contrast contrast{.first = design.cells[first].name,
                    .second = design.cells[second].name,
                    .weights = std::vector<int>(design.cells.size(), 0)};
  contrast.weights[first] = 1;
  contrast.weights[second] = -1;
  return contrast;
}

bool two_by_two(const StudyDesign& design) {
  return design.cells.size() == 4 && varied_factors(design).size() == 2;
}

}  // namespace

std::string name_of(const Contrast& contrast) {
  if (contrast.kind == Contrast::Kind::Interaction) return "interaction of " + contrast.factor;
  const std::string pair = fmt::format("{} against {}", contrast.first, contrast.second);
  return contrast.kind == Contrast::Kind::Cells ? pair : fmt::format("{}, {}", contrast.factor, pair);
}

std::vector<std::size_t> varied_factors(const StudyDesign& design) {
  std::vector<std::size_t> varied;
  for (std::size_t factor = 0; factor < design.factors.size(); ++factor) {
    std::set<std::string> levels;
    for (const DesignCell& cell : design.cells)
      if (factor < cell.levels.size()) levels.insert(cell.levels[factor]);
    if (levels.size() > 1) varied.push_back(factor);
  }
  return varied;
}

std::string factors_in_words(const StudyDesign& design) {
  std::vector<std::string> names;
  for (const std::size_t factor : varied_factors(design)) names.push_back(design.factors[factor]);
  return names.empty() ? "cell" : listed(names);
}

std::size_t planned_contrasts(const StudyDesign& design) {
  if (design.between_models == "none") return 0;
  return two_by_two(design) ? 3 : design.cells.size() == 2 ? 1 : 0;
}

std::vector<Contrast> contrasts(const StudyDesign& design) {
  std::vector<Contrast> all;
  if (two_by_two(design) && design.between_models != "none") {
    const std::vector<std::size_t> varied = varied_factors(design);
    all = {main_effect(design, varied[0]), main_effect(design, varied[1]),
           interaction(design, varied[0], varied[1])};
  }
  for (std::size_t i = 0; i < design.cells.size(); ++i)
    for (std::size_t j = i + 1; j < design.cells.size(); ++j) all.push_back(pair_of(design, i, j));
  return all;
}

std::optional<double> contrast_of(const Contrast& contrast, const std::vector<ExamineeCount>& cells) {
  long common = 1;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (contrast.weights[c] == 0) continue;
    if (cells[c].trials == 0) return std::nullopt;
    common = std::lcm(common, long{cells[c].trials});
  }
  long sum = 0;
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (contrast.weights[c] != 0) sum += contrast.weights[c] * cells[c].correct * (common / cells[c].trials);
  return static_cast<double>(sum) / static_cast<double>(common * contrast.divisor);
}

}  // namespace palpate::analysis
