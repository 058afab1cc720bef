#include "app/study/power_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <stdexcept>
#include <thread>

#include "analysis/numerics/proportion_interval.hpp"
#include "analysis/numerics/to_json.hpp"
#include "analysis/report/primary_test.hpp"
#include "analysis/statistics/adjust/adjust.hpp"
#include "analysis/words/words.hpp"
#include "app/command_line/interrupt.hpp"
#include "app/command_line/progress.hpp"
#include "app/command_line/user_cache.hpp"
#include "app/study/study_table.hpp"
#include "base/text/shard.hpp"
#include "trials/observer/simulate.hpp"
#include "trials/observer/simulated_study.hpp"

namespace palpate::app {
namespace {

using nlohmann::ordered_json;

using Rejected = std::vector<bool>;  // in each cell

std::vector<analysis::OrderStratum> strata(const std::vector<trials::SittingCount>& cell) {
  std::vector<analysis::OrderStratum> sittings;
  sittings.reserve(cell.size());
  for (const trials::SittingCount& c : cell)
    sittings.push_back({c.trials, c.correct_first, c.answers_first, c.correct});
  return sittings;
}

/// The same without looks, by the p values adjusted over the cells.
Rejected adjusted_test(const analysis::StudyDesign& design,
                       const std::vector<std::vector<trials::SittingCount>>& counts) {
  std::vector<double> p;
  p.reserve(counts.size());
  for (const auto& cell : counts)
    p.push_back(analysis::primary_test(design, strata(cell), 0.95, std::nullopt)
                    .p.of(analysis::side_from_name(design.side)));
  const std::vector<double> adjusted = analysis::adjusted(design.adjust, p);
  Rejected rejected;
  rejected.reserve(adjusted.size());
  for (const double one : adjusted) rejected.push_back(one <= design.alpha);
  return rejected;
}

/// Whether the protocol's primary test rejects in each cell, at any look that it plans.
Rejected test(const analysis::StudyDesign& design,
              const std::vector<std::vector<trials::SittingCount>>& counts) {
  if (design.adjust != "none") return adjusted_test(design, counts);
  std::vector<int> looks = design.looks;
  if (looks.empty()) looks.push_back(design.planned_examinees);
  Rejected rejected;
  for (const auto& cell : counts) {
    const std::vector<analysis::OrderStratum> sittings = strata(cell);
    rejected.push_back(std::ranges::any_of(looks, [&](int look) {
      const auto seen = std::span(sittings).first(look);
      const analysis::PrimaryTest primary =
          analysis::primary_test(design, seen, 0.95, analysis::look_due(design, look));
      return analysis::rejects(primary.critical, primary.correct);
    }));
  }
  return rejected;
}

struct Range {
  long from = 0, to = 0;
};

Range range_of(const PowerSimulation& simulation) {
  return {.from = simulation.studies * (simulation.shard.k - 1) / simulation.shard.n,
          .to = simulation.studies * simulation.shard.k / simulation.shard.n};
}

/// Plays studies side by side; the counts do not depend on how many.
std::vector<long> play(const trials::Protocol& protocol, const trials::ObserverParameters& observer,
                       const trials::Stimuli& stimuli, std::uint64_t seed, const Range& range) {
  const analysis::StudyDesign design = design_of(protocol);
  std::vector<long> rejections(protocol.cells.size(), 0);
  const long side_by_side = std::max(1U, std::thread::hardware_concurrency());
  ProgressBar bar("simulating studies");
  for (long first = range.from; first < range.to; first += side_by_side) {
    std::vector<std::future<Rejected>> running;
    for (long study = first; study < std::min(first + side_by_side, range.to); ++study)
      running.push_back(std::async(std::launch::async, [&, study] {
        return test(design,
                    trials::play_study(protocol, stimuli, observer, trials::seed_of_study(seed, study)));
      }));
    for (std::future<Rejected>& one : running) {
      const Rejected rejected = one.get();
      for (std::size_t cell = 0; cell < rejected.size(); ++cell) rejections[cell] += rejected[cell] ? 1 : 0;
    }
    if (interrupted()) throw Interrupted();
    bar.show(static_cast<int>(std::min(first + side_by_side, range.to) - range.from),
             static_cast<int>(range.to - range.from));
  }
  return rejections;
}

ordered_json with_power(ordered_json result) {
  for (ordered_json& cell : result["cells"]) {
    const long rejected = cell["rejected"], studies = result["studies"];
    const double power = static_cast<double>(rejected) / static_cast<double>(studies);
    cell["power"] = power;
    cell["standard_error"] = std::sqrt(power * (1 - power) / static_cast<double>(studies));
    cell["interval"] = analysis::to_json(analysis::clopper_pearson(rejected, studies, 0.95));
  }
  return result;
}

std::string name_of_cell(const ordered_json& cell) {
  return cell.at("cell").get<std::string>();
}

bool same_simulation(const ordered_json& a, const ordered_json& b) {
  for (const char* key : {"protocol", "protocol_sha256", "observer", "seed", "studies"})
    if (a.value(key, ordered_json()) != b.value(key, ordered_json())) return false;
  return std::ranges::equal(a.at("cells"), b.at("cells"), {}, name_of_cell, name_of_cell);
}

}  // namespace

void read_shard(const std::string& text, PowerSimulation& simulation) {
  const auto shard = base::parse_shard(text);
  if (!shard)
    throw std::invalid_argument(
        fmt::format("--shard is '{}'; accepted: K/N, the Kth of N parts, such as 2/4", text));
  simulation.shard = *shard;
}

ordered_json simulate_power(const trials::Protocol& protocol, const PowerSimulation& simulation) {
  const trials::ObserverParameters observer = trials::load_observer(simulation.observer);
  trials::check_observer(protocol, observer);
  sim::ComplianceCache cache = user_cache();
  const trials::Stimuli stimuli = trials::compile_stimuli(protocol, cache);
  trials::check_clamping(protocol, stimuli, observer);
  catch_interrupts();
  const Range range = range_of(simulation);
  const std::vector<long> rejections = play(protocol, observer, stimuli, simulation.seed, range);
  ordered_json result = {{"kind", "power simulation"},
                         {"protocol", protocol.name},
                         {"protocol_sha256", protocol.sha256},
                         {"observer", ordered_json::parse(trials::to_json(observer))},
                         {"seed", simulation.seed},
                         {"studies", simulation.studies},
                         {"from", range.from},
                         {"to", range.to},
                         {"cells", ordered_json::array()}};
  for (std::size_t cell = 0; cell < rejections.size(); ++cell)
    result["cells"].push_back({{"cell", protocol.cells[cell].name}, {"rejected", rejections[cell]}});
  return simulation.shard.n == 1 ? with_power(result) : result;
}

void check_power_part(const ordered_json& part) {
  for (const char* key : {"protocol", "protocol_sha256"}) part.at(key).get_ref<const std::string&>();
  part.at("observer").get_ref<const ordered_json::object_t&>();
  part.at("seed").get<std::uint64_t>();
  const long from = part.at("from"), to = part.at("to"), studies = part.at("studies");
  if (from < 0 || from > to || to > studies || studies < 1) {
    throw std::invalid_argument(
        fmt::format("studies {} to {} of {} contradict each other", from + 1, to, studies));
  }
  if (part.at("cells").get_ref<const ordered_json::array_t&>().empty())
    throw std::invalid_argument("no cells");
  for (const ordered_json& cell : part.at("cells")) {
    const std::string name = name_of_cell(cell);
    const long rejected = cell.at("rejected");
    if (rejected >= 0 && rejected <= to - from) continue;
    throw std::invalid_argument(fmt::format("{} of {} studies reject in cell {}", rejected, to - from, name));
  }
}

ordered_json merge_power(const std::vector<ordered_json>& parts) {
  std::vector<ordered_json> sorted = parts;
  std::ranges::sort(sorted, {}, [](const ordered_json& part) { return part.at("from").get<long>(); });
  ordered_json whole = sorted.at(0);
  long next = 0;
  for (const ordered_json& part : sorted) {
    if (!same_simulation(whole, part))
      throw std::invalid_argument(
          "the parts are of different simulations: protocol, observer, seed and number of studies must be "
          "the same");
    if (part.at("from") != next)
      throw std::invalid_argument(fmt::format("study {} is {}; accepted: every part once",
                                              std::min(next, part.at("from").get<long>()) + 1,
                                              part.at("from") > next ? "in no part" : "in two parts"));
    next = part.at("to");
  }
  if (next != whole.at("studies").get<long>())
    throw std::invalid_argument(fmt::format("study {} is in no part; accepted: every part once", next + 1));
  for (std::size_t k = 1; k < sorted.size(); ++k)
    for (std::size_t cell = 0; cell < whole["cells"].size(); ++cell)
      whole["cells"][cell]["rejected"] = whole["cells"][cell]["rejected"].get<long>() +
                                         sorted[k].at("cells")[cell].at("rejected").get<long>();
  whole["to"] = next;
  return with_power(whole);
}

std::string power_in_words(const ordered_json& result) {
  const bool whole = result["cells"].at(0).contains("power");
  std::string text =
      fmt::format("{}, observer {}, seed {}: studies {} to {} of {}\n", result["protocol"].get<std::string>(),
                  result["observer"].value("name", "?"), result["seed"].get<std::uint64_t>(),
                  result["from"].get<long>() + 1, result["to"].get<long>(), result["studies"].get<long>());
  for (const ordered_json& cell : result["cells"]) {
    text += fmt::format("{}: the primary test rejects guessing in {}", cell["cell"].get<std::string>(),
                        analysis::counted(cell["rejected"].get<long>(), "study", "studies"));
    if (whole)
      text += fmt::format(": power {}, standard error {}", analysis::decimals(cell["power"], 4),
                          analysis::decimals(cell["standard_error"], 4));
    text += "\n";
  }
  if (!whole) text += "A part of the simulation: palpate stats merge joins the parts' JSON.\n";
  return text;
}

}  // namespace palpate::app
