// Whatever number an input holds, a statistic answers or says what is wrong: it never brings the program down,
// which would take the rest of a batch with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/statistics/statistics.hpp"
#include "tests/analysis/support/ask.hpp"

using namespace palpate::analysis;

namespace {

class Extremes : public testing::TestWithParam<std::string> {
 protected:
  static void ask(const nlohmann::ordered_json& asked) {
    try {
      run_statistic(GetParam(), asked);
    } catch (const std::invalid_argument& refusal) {
      EXPECT_GT(std::string(refusal.what()).size(), 10U) << asked.dump();
    } catch (const std::exception& error) {
      ADD_FAILURE() << asked.dump() << ": " << error.what();
    }
  }
  static nlohmann::ordered_json example() {
    nlohmann::ordered_json asked = statistic_named(GetParam()).example;
    for (const Input& input : statistic_named(GetParam()).inputs)  // as few repetitions as are accepted
      if (input.name == "resamples") asked[input.name] = 999;
    if (GetParam() == "psychometric") asked["replicates"] = 0;
    return asked;
  }
};

std::vector<std::string> every_name() {
  std::vector<std::string> all;
  for (const Statistic& statistic : statistics()) all.push_back(statistic.name);
  return all;
}

nlohmann::ordered_json as_list(const nlohmann::ordered_json& value, std::size_t length) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < length; ++i) list.push_back(value);
  return list;
}

}  // namespace

TEST_P(Extremes, OfInputsAreAnsweredOrRefused) {
  for (const Input& input : statistic_named(GetParam()).inputs) {
    for (const double value : {0.0, 1.0, 2.0, -1.0, 1e150, 1e-150}) {
      nlohmann::ordered_json asked = example();
      asked[input.name] = value == std::floor(value) && std::abs(value) < 10
                              ? nlohmann::ordered_json(static_cast<long>(value))
                              : nlohmann::ordered_json(value);
      if (input.kind == Input::Kind::Counts || input.kind == Input::Kind::Numbers ||
          input.kind == Input::Kind::PValues) {
        for (const std::size_t length : {2U, 4U}) {
          nlohmann::ordered_json lists = asked;
          lists[input.name] = as_list(asked[input.name], length);
          ask(lists);
        }
      }
      ask(asked);
    }
  }
}

TEST_P(Extremes, OfDataAreAnsweredOrRefused) {
  const nlohmann::ordered_json whole = example();
  if (!whole.contains("data")) return;
  for (const auto& column : whole["data"].items()) {
    for (const nlohmann::ordered_json& value :
         {nlohmann::ordered_json(0), nlohmann::ordered_json(1), nlohmann::ordered_json(1e150),
          nlohmann::ordered_json(1e-150)}) {
      nlohmann::ordered_json all = whole, first = whole;
      all["data"][column.key()] = as_list(value, column.value().size());
      first["data"][column.key()][0] = value;
      ask(all), ask(first);
    }
  }
  nlohmann::ordered_json row = whole;
  for (auto& column : row["data"]) column = as_list(column[0], 1);
  ask(row);
}

INSTANTIATE_TEST_SUITE_P(Statistics, Extremes, testing::ValuesIn(every_name()), [](const auto& parameter) {
  std::string name = parameter.param;
  std::ranges::replace(name, '-', '_');
  return name;
});
