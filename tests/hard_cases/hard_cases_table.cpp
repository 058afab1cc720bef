// Measures every case and writes docs/hard-cases.md, or compares it with what is measured:
//   hard_cases_table docs/hard-cases.md
//   hard_cases_table --check docs/hard-cases.md
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <iterator>

#include "tests/hard_cases/table.hpp"

namespace palpate::hard_cases {
namespace {

std::vector<Result> measure() {
  std::vector<Result> results;
  for (const HardCase& hard_case : hard_cases()) {
    const Result& result = results.emplace_back(hard_case, worst(run_all(hard_case)));
    if (!result.worst.holds()) fmt::print(stderr, "{} {} does not hold\n", hard_case.number, hard_case.name);
  }
  return results;
}

int check(const std::string& file, const std::vector<Result>& results) {
  std::ifstream stream(file);
  const std::string committed{std::istreambuf_iterator<char>(stream), {}};
  const auto found = differences(committed, document(results), results);
  for (const std::string& difference : found) fmt::print(stderr, "{}\n", difference);
  if (!found.empty())
    fmt::print(stderr, "{} is stale; make it anew: ninja -C build/release hard_cases\n", file);
  return found.empty() ? 0 : 1;
}

int run(int arguments, char** argument) {
  if (arguments == 3 && std::string_view(argument[1]) == "--check") return check(argument[2], measure());
  if (arguments != 2) {
    fmt::print(stderr, "Error: usage: hard_cases_table [--check] FILE\n");
    return 1;
  }
  const std::string text = document(measure());
  std::ofstream(argument[1]) << text;
  return 0;
}

}  // namespace
}  // namespace palpate::hard_cases

int main(int arguments, char** argument) {
  try {
    return palpate::hard_cases::run(arguments, argument);
  } catch (const std::exception& error) {
    fmt::print(stderr, "Error: {}\n", error.what());
    return 1;
  }
}
