#include "app/commands/cost/band_from.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <set>
#include <stdexcept>

#include "app/study/study_table.hpp"
#include "sim/cost/reference.hpp"

namespace palpate::app {
namespace {

constexpr double kShareCorrect = 0.75;  // of the difference that is told apart
constexpr double kMostSensitive = 1e4;  // k: a difference of a hundredth of a per cent

/// Log likelihood of P = Phi(k difference) over all cells.
double log_likelihood(double k, const std::vector<double>& differences, const std::vector<long>& correct,
                      const std::vector<long>& trials) {
  const boost::math::normal normal;
  double sum = 0.0;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const double z = k * differences[i];
    if (correct[i] > 0) sum += static_cast<double>(correct[i]) * std::log(cdf(normal, z));
    if (trials[i] > correct[i])
      sum += static_cast<double>(trials[i] - correct[i]) *
             std::log(std::max(1e-300, cdf(complement(normal, z))));
  }
  return sum;
}

/// Relative difference of the mean force curves of the two conditions of a cell; over the depths that both have.
double difference_in(const analysis::StudyTable& table, std::size_t cell, const std::string& run_mode) {
  const auto curve_of = [&](const std::string& condition) {
    const auto found = std::ranges::find_if(table.curves, [&](const analysis::ForceCurve& curve) {
      return curve.cell == cell && curve.condition == condition && curve.run_mode == run_mode;
    });
    if (found == table.curves.end())
      throw std::invalid_argument(fmt::format("it holds no force of the condition {}", condition));
    return *found;
  };
  const std::vector<std::string>& conditions = table.design.conditions;
  const analysis::ForceCurve a = curve_of(conditions[0]), b = curve_of(conditions[1]);
  const bool first_is_reference = conditions[0] == table.design.correct_condition;
  std::vector<double> reference, other;
  for (std::size_t i = 0; i < a.depth_m.size(); ++i) {
    const auto same = std::ranges::find(b.depth_m, a.depth_m[i]);
    if (same == b.depth_m.end()) continue;
    const double there = b.mean_force_n[static_cast<std::size_t>(same - b.depth_m.begin())];
    if (!std::isfinite(there) || !std::isfinite(a.mean_force_n[i])) continue;
    reference.push_back(first_is_reference ? a.mean_force_n[i] : there);
    other.push_back(first_is_reference ? there : a.mean_force_n[i]);
  }
  if (reference.empty()) throw std::invalid_argument("no depth was reached under both conditions");
  return sim::rms_difference(reference, other) / sim::rms(reference);
}

/// Which sittings count: those of people, or where there are none those of simulated examinees.
std::string run_mode_of(const analysis::StudyTable& table) {
  for (const char* mode : {"study", "simulated"})
    if (std::ranges::any_of(table.sessions, [&](const auto& session) { return session.run_mode == mode; }))
      return mode;
  throw std::invalid_argument("nobody has sat, nor was anybody simulated");
}

/// Before its sample is complete a study tells nothing.
std::size_t examinees_in(const analysis::StudyTable& table, const std::string& run_mode) {
  std::set<std::string> complete;
  for (const analysis::ReportedSession& session : table.sessions)
    if (session.run_mode == run_mode && session.finished) complete.insert(session.examinee);
  if (std::ssize(complete) < table.design.planned_examinees)
    throw std::invalid_argument(
        fmt::format("{} of its {} planned examinees are complete; accepted: a study whose sample is",
                    complete.size(), table.design.planned_examinees));
  return complete.size();
}

StudyBand band_of_table(const analysis::StudyTable& table) {
  if (table.design.task != "2IFC" || table.design.conditions.size() != 2)
    throw std::invalid_argument("it asks something else; accepted: 2IFC between two conditions");
  const std::string run_mode = run_mode_of(table);
  const std::size_t examinees = examinees_in(table, run_mode);
  std::vector<double> differences;
  std::vector<long> correct(table.design.cells.size(), 0), trials(table.design.cells.size(), 0);
  for (std::size_t cell = 0; cell < table.design.cells.size(); ++cell)
    differences.push_back(difference_in(table, cell, run_mode));
  for (const analysis::TrialRow& trial : table.trials) {
    if (trial.voided || !trial.correct || table.sessions[trial.session].run_mode != run_mode) continue;
    ++trials[trial.cell];
    correct[trial.cell] += *trial.correct ? 1 : 0;
  }
  std::string cells;
  for (std::size_t cell = 0; cell < differences.size(); ++cell)
    cells += fmt::format("{}{} of {} correct at a difference of {:.2g} %", cells.empty() ? "" : ", ",
                         correct[cell], trials[cell], 100 * differences[cell]);
  return {.band = band_of(differences, correct, trials),
          .source = fmt::format(
              "{}, {} {} examinees: {}; the 95 % interval of the difference that 75 % tell apart",
              table.design.protocol_name, examinees, run_mode == "study" ? "real" : "SIMULATED", cells)};
}

}  // namespace

sim::Band band_of(const std::vector<double>& differences, const std::vector<long>& correct,
                  const std::vector<long>& trials) {
  const auto log_of = [&](double log_k) {
    return log_likelihood(std::exp(log_k), differences, correct, trials);
  };
  // k from 1/1000, where a difference as large as the force is not told, to where anything is.
  const double low = std::log(1e-3), high = std::log(kMostSensitive);
  const double best =
      boost::math::tools::brent_find_minima([&](double log_k) { return -log_of(log_k); }, low, high, 40)
          .first;
  const double least = log_of(best) - 0.5 * quantile(boost::math::chi_squared(1.0), 0.95);
  const auto excess = [&](double log_k) { return log_of(log_k) - least; };
  const auto root = [&](double a, double b) {
    std::uintmax_t most = 200;
    const auto found =
        boost::math::tools::toms748_solve(excess, a, b, boost::math::tools::eps_tolerance<double>(40), most);
    return std::exp(0.5 * (found.first + found.second));
  };
  const double z = quantile(boost::math::normal(), kShareCorrect);
  sim::Band band{.lower = 0.0, .upper = 1.0};
  band.lower = excess(high) < 0.0 ? z / root(best, high) : z / kMostSensitive;
  if (excess(low) < 0.0) band.upper = std::min(1.0, z / root(low, best));
  return band;
}

StudyBand band_from(const std::filesystem::path& study) {
  try {
    return band_of_table(read_study_table(trials::read_study(study)));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("--band-from {}: {}", study.string(), error.what()));
  }
}

}  // namespace palpate::app
