#include "analysis/description/resampled.hpp"

namespace palpate::analysis {

Input resamples_input() {
  return {.name = "resamples",
          .kind = Input::Kind::Count,
          .meaning = "Of the effect size's bootstrap interval",
          .usual = std::to_string(BootstrapOptions{}.resamples)};
}

BootstrapOptions bootstrap_options(const Arguments& asked) {
  return {.level = asked.level(),
          .resamples = asked.count("resamples"),
          .seed = static_cast<std::uint64_t>(asked.count("seed"))};
}

std::vector<std::string> matrix_names(const DataTable& table) {
  std::vector<std::string> names = table.names;
  for (std::size_t j = names.size(); j < table.columns.size(); ++j) names.push_back(std::to_string(j + 1));
  return names;
}

}  // namespace palpate::analysis
