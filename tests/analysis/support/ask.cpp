#include "tests/analysis/support/ask.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "analysis/statistics/statistics.hpp"

namespace palpate::analysis {
namespace {

DataTable table_of(const nlohmann::ordered_json& data) {
  DataTable table{.source = "data"};
  for (const auto& item : data.items()) {
    table.names.push_back(item.key());
    std::vector<std::string> column;
    for (const auto& cell : item.value()) {
      column.push_back(cell.is_string() ? cell.get<std::string>() : cell.dump());
    }
    table.columns.push_back(column);
  }
  for (std::size_t row = 0; row < table.columns[0].size(); ++row)
    table.lines.push_back(static_cast<long>(row) + 1);
  return table;
}

}  // namespace

Outcome run_statistic(const std::string& name, nlohmann::ordered_json asked) {
  DataTable table;
  if (asked.contains("data")) table = table_of(asked["data"]);
  asked.erase("data");
  const Statistic& statistic = statistic_named(name);
  return statistic.run(read_arguments(statistic, asked, table));
}

std::string refusal_of(const std::string& name, const nlohmann::ordered_json& asked) {
  try {
    run_statistic(name, asked);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  ADD_FAILURE() << name << " answered " << asked.dump();
  return "";
}

}  // namespace palpate::analysis
