// The haptic cycle with every law, effect and kind of probe, each beside its plain counterpart, beside the reading of the
// final contact set's compliance (the limit of `palpate cost`), and over a family of sizes. All take turns, so that what
// else the machine does falls on all alike, and what is counted is the processor's time, not the clock's. For percentiles
// of the clock's time see `palpate cost`.
//   cycle_bench [ROUNDS]   writes CSV; cycle_bench.py runs it, shows it and compares it
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <string>

#include "base/machine/machine.hpp"
#include "tests/bench/runner.hpp"

namespace palpate::bench {
namespace {

/// The middle half of a sample, and its middle.
struct Quartiles {
  double low = 0.0, median = 0.0, high = 0.0;
};

Quartiles quartiles_of(std::vector<double> sample) {
  std::ranges::sort(sample);
  const auto at = [&](double share) {
    return sample[static_cast<std::size_t>(std::lround(share * static_cast<double>(sample.size() - 1)))];
  };
  return {at(0.25), at(0.5), at(0.75)};
}

std::vector<double> over(const std::vector<double>& times, const std::vector<double>& plain) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < times.size(); ++round) ratios.push_back(times[round] / plain[round]);
  return ratios;
}

/// The factor of the time for twice the nodes, in each round: 2 to the slope of log time over log nodes.
std::vector<double> growth(const std::vector<const Runner*>& sizes) {
  std::vector<double> factors;
  for (std::size_t round = 0; round < sizes.front()->cycles.size(); ++round) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Runner* size : sizes) {
      const double nodes = std::log(size->nodes()), time = std::log(size->cycles[round]);
      x += nodes, y += time, xx += nodes * nodes, xy += nodes * time;
    }
    const auto n = static_cast<double>(sizes.size());
    factors.push_back(std::exp2((n * xy - x * y) / (n * xx - x * x)));
  }
  return factors;
}

void print(const Runner& runner, const std::string& beside, const std::vector<double>& ratios) {
  const Quartiles ratio = quartiles_of(ratios);
  fmt::print("{},{},{:.6g},{:.6g},{:.6g},{:.6g},{},{}\n", runner.row().name, beside, ratio.median, ratio.low,
             ratio.high, quartiles_of(runner.cycles).median, runner.contacts(), runner.allocations());
}

void run(int rounds) {
  std::vector<std::unique_ptr<Runner>> runners;
  std::map<std::string, const Runner*> by_name;
  const auto add = [&](const Row& row) {
    runners.push_back(std::make_unique<Runner>(row));
    by_name[row.name] = runners.back().get();
  };
  for (const Row& row : rows()) add(row);
  const std::size_t single = runners.size();
  for (const Family& family : families())
    for (const Row& size : family.sizes) add(size);

  for (int round = 0; round < rounds; ++round)
    for (const auto& runner : runners) runner->take_turn();

  fmt::print("# {}; {}\nrow,beside,ratio,low,high,microseconds,contacts,allocations\n", PALPATE_VERSION,
             base::describe_machine());
  for (std::size_t i = 0; i < single; ++i) {
    const Runner& runner = *runners[i];
    if (!runner.row().plain.empty())
      print(runner, runner.row().plain, over(runner.cycles, by_name.at(runner.row().plain)->cycles));
    print(runner, "the limit", over(runner.ends, runner.reads));
  }
  for (const Family& family : families()) {
    std::vector<const Runner*> sizes;
    for (const Row& size : family.sizes) sizes.push_back(by_name.at(size.name));
    print(*sizes.back(), "half the nodes", growth(sizes));
  }
}

}  // namespace
}  // namespace palpate::bench

int main(int count, char** arguments) {
  try {
    palpate::bench::run(count > 1 ? std::max(1, std::stoi(arguments[1])) : 31);
  } catch (const std::exception& error) {
    fmt::print(stderr, "Error: {}\n", error.what());
    return 1;
  }
  return 0;
}
