#include "analysis/statistics/bradley_terry/comparison_graph.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

// The items that can be reached from the first along steps that `leads` allows.
template <typename Leads>
std::vector<bool> reached_from(std::size_t first, std::size_t count, const Leads& leads) {
  std::vector<bool> reached(count, false);
  std::vector<std::size_t> open = {first};
  reached[first] = true;
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    for (std::size_t j = 0; j < count; ++j) {
      if (reached[j] || !leads(i, j)) continue;
      reached[j] = true;
      open.push_back(j);
    }
  }
  return reached;
}

std::string names_where(const ComparisonGraph& graph, const std::vector<bool>& chosen, bool value) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i] == value) names.push_back(graph.names[i]);
  }
  return listed(names);
}

bool all(const std::vector<bool>& chosen) {
  return std::ranges::find(chosen, false) == chosen.end();
}

void refuse_disconnected(const ComparisonGraph& graph) {
  const auto& wins = graph.wins;
  const auto linked = reached_from(
      0, graph.names.size(), [&](std::size_t i, std::size_t j) { return wins[i][j] > 0 || wins[j][i] > 0; });
  if (all(linked)) return;
  throw std::invalid_argument(fmt::format(
      "no chain of comparisons links {} with {}; items on one scale must be compared, directly or "
      "through others",
      names_where(graph, linked, true), names_where(graph, linked, false)));
}

// Finite values need, for every split of the items in two, a win each way [Ford1957]: every item reaches
// every other along wins.
void refuse_one_sided(const ComparisonGraph& graph) {
  const std::size_t count = graph.names.size();
  for (const bool up : {false, true}) {
    const auto reached = reached_from(0, count, [&](std::size_t i, std::size_t j) {
      return (up ? graph.wins[j][i] : graph.wins[i][j]) > 0;
    });
    if (all(reached)) continue;
    // Downwards, nobody reached ever beat anybody left out; upwards, nobody left out ever beat anybody
    // reached.
    throw std::invalid_argument(fmt::format("{} never lost to {}: their distance has no finite estimate",
                                            names_where(graph, reached, up),
                                            names_where(graph, reached, !up)));
  }
}

}  // namespace

void validate(const Comparison& one) {
  if (one.winner == one.loser)
    throw std::invalid_argument(fmt::format("'{}' is compared with itself; accepted: two items", one.winner));
  if (one.count < 1)
    throw std::invalid_argument(fmt::format("count is {} for '{}' over '{}'; accepted: 1 and more", one.count,
                                            one.winner, one.loser));
}

ComparisonGraph comparison_graph(const std::vector<Comparison>& comparisons) {
  std::set<std::string> names;
  for (const Comparison& one : comparisons) {
    validate(one);
    names.insert({one.winner, one.loser});
  }
  if (names.empty()) throw std::invalid_argument("no comparisons; a scale needs two items at least");
  ComparisonGraph graph{.names = {names.begin(), names.end()}};
  graph.wins.assign(names.size(), std::vector<double>(names.size(), 0.0));
  const auto index = [&](const std::string& name) {
    return std::ranges::lower_bound(graph.names, name) - graph.names.begin();
  };
  for (const Comparison& one : comparisons) {
    graph.wins[index(one.winner)][index(one.loser)] += static_cast<double>(one.count);
  }
  refuse_disconnected(graph);
  refuse_one_sided(graph);
  return graph;
}

}  // namespace palpate::analysis
