#include "analysis/statistics/bradley_terry/bradley_terry.hpp"

#include <fmt/core.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <stdexcept>

#include "analysis/mixed/link.hpp"
#include "analysis/numerics/standard_normal.hpp"
#include "analysis/statistics/bradley_terry/comparison_graph.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

Link link_of(ScaleModel model) {
  return model == ScaleModel::BradleyTerry ? Link::Logit : Link::Probit;
}

struct At {
  double log_likelihood = 0.0;
  Eigen::VectorXd scores{};
  Eigen::MatrixXd observed{}, expected{};  // information; the values' common shift is in their null space
};

// What one win would say of the difference, in the mean over its two outcomes.
double expected_curvature(Link link, double difference) {
  const BinaryLikelihood win = likelihood(link, difference, 1, 1), loss = likelihood(link, difference, 0, 1);
  return std::exp(win.log) * win.curvature + std::exp(loss.log) * loss.curvature;
}

At evaluate(const ComparisonGraph& graph, Link link, const Eigen::VectorXd& values) {
  const Eigen::Index count = values.size();
  At at{.scores = Eigen::VectorXd::Zero(count),
        .observed = Eigen::MatrixXd::Zero(count, count),
        .expected = Eigen::MatrixXd::Zero(count, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = i + 1; j < count; ++j) {
      const std::size_t a = i, b = j;
      const double wins = graph.wins[a][b], trials = wins + graph.wins[b][a];
      if (trials == 0) continue;
      const double difference = values[i] - values[j];
      const BinaryLikelihood pair = likelihood(link, difference, wins, trials);
      at.log_likelihood += pair.log;
      at.scores[i] += pair.score, at.scores[j] -= pair.score;
      const auto add = [&](Eigen::MatrixXd& information, double weight) {
        information(i, i) += weight, information(j, j) += weight;
        information(i, j) -= weight, information(j, i) -= weight;
      };
      add(at.observed, pair.curvature);
      add(at.expected, trials * expected_curvature(link, difference));
    }
  }
  return at;
}

// The inverse on the values whose sum is 0: adding 1 to each entry fills the null space.
Eigen::MatrixXd centred_inverse(const Eigen::MatrixXd& information) {
  const auto n = static_cast<double>(information.rows());
  const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(information.rows(), information.cols());
  return (information + ones).inverse() - ones / (n * n);
}

struct Scale {
  Eigen::VectorXd values{};
  At at{};
  bool converged = false;
};

// Newton's method: the likelihood is concave in the differences. Steps that lower it are halved.
Scale maximise(const ComparisonGraph& graph, Link link) {
  Scale scale{.values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(graph.names.size()))};
  scale.at = evaluate(graph, link, scale.values);
  for (int steps = 0; steps < 100 && !scale.converged; ++steps) {
    Eigen::VectorXd step = centred_inverse(scale.at.observed) * scale.at.scores;
    scale.converged = step.norm() < 1e-7;  // after it the error is its square
    At next = evaluate(graph, link, scale.values + step);
    for (int halvings = 0; next.log_likelihood < scale.at.log_likelihood && !scale.converged && halvings < 50;
         ++halvings) {
      step /= 2;
      next = evaluate(graph, link, scale.values + step);
    }
    scale.values += step;
    scale.at = next;
  }
  return scale;
}

ChiSquaredTest chi_squared_test(double value, long degrees) {
  ChiSquaredTest test{.chi_squared = std::max(0.0, value), .degrees_of_freedom = degrees};
  if (degrees > 0) {
    test.p = cdf(complement(boost::math::chi_squared(static_cast<double>(degrees)), test.chi_squared));
  }
  return test;
}

void judge(PairedScaling& result, const ComparisonGraph& graph) {
  const auto x_log = [](double x, double share) { return x > 0 ? x * std::log(share) : 0.0; };
  double saturated = 0.0, trials = 0.0;
  long pairs = 0;
  const std::size_t count = graph.names.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const double wins = graph.wins[i][j], losses = graph.wins[j][i], n = wins + losses;
      if (n == 0) continue;
      ++pairs, trials += n;
      saturated += x_log(wins, wins / n) + x_log(losses, losses / n);
    }
  }
  const long free = static_cast<long>(count) - 1;
  result.comparisons = std::lround(trials);
  result.goodness_of_fit = chi_squared_test(2 * (saturated - result.log_likelihood), pairs - free);
  result.equality = chi_squared_test(2 * (result.log_likelihood + trials * std::log(2)), free);
}

Eigen::Index index_of(const ComparisonGraph& graph, const std::string& name) {
  const auto found = std::ranges::find(graph.names, name);
  if (found == graph.names.end()) {
    throw std::invalid_argument(fmt::format("reference is '{}'; accepted: {}", name, listed(graph.names)));
  }
  return found - graph.names.begin();
}

}  // namespace

ScaleModel scale_model_from_name(std::string_view name) {
  if (name == "bradley-terry") return ScaleModel::BradleyTerry;
  if (name == "thurstone") return ScaleModel::ThurstoneV;
  throw std::invalid_argument(fmt::format("model is '{}'; accepted: bradley-terry, thurstone", name));
}

std::string_view name_of(ScaleModel model) {
  return model == ScaleModel::BradleyTerry ? "bradley-terry" : "thurstone";
}

PairedScaling paired_scaling(const std::vector<Comparison>& comparisons, ScaleModel model,
                             const std::optional<std::string>& reference, double level) {
  require_level(level, "confidence level");
  const ComparisonGraph graph = comparison_graph(comparisons);
  const auto count = static_cast<Eigen::Index>(graph.names.size());
  Eigen::MatrixXd shift = Eigen::MatrixXd::Identity(count, count);  // from centred values to the reference's
  if (reference) shift.col(index_of(graph, *reference)).array() -= 1;
  const Scale scale = maximise(graph, link_of(model));
  const Eigen::VectorXd values = shift * scale.values;
  const Eigen::MatrixXd covariance = shift * centred_inverse(scale.at.expected) * shift.transpose();
  PairedScaling result{.model = model, .reference = reference, .converged = scale.converged};
  result.log_likelihood = scale.at.log_likelihood;
  judge(result, graph);
  const double z = critical_z(level);
  for (Eigen::Index i = 0; i < count; ++i) {
    ScaledItem item{.name = graph.names[i], .value = values[i]};
    for (const Comparison& one : comparisons) {
      if (one.winner == item.name) item.wins += one.count;
      if (one.loser == item.name) item.losses += one.count;
    }
    item.standard_error = std::sqrt(std::max(0.0, covariance(i, i)));
    const double half = z * item.standard_error;
    item.interval = {
        .lower = item.value - half, .upper = item.value + half, .level = level, .method = "Wald"};
    result.items.push_back(item);
    const Eigen::VectorXd row = covariance.row(i);
    result.covariance.emplace_back(row.begin(), row.end());
  }
  result.method = model == ScaleModel::BradleyTerry
                      ? Method{.name = "Bradley-Terry model, maximum likelihood",
                               .source = "Bradley & Terry 1952; Agresti 2002, section 10.6"}
                      : Method{.name = "Thurstone's case V, maximum likelihood", .source = "Thurstone 1927"};
  return result;
}

}  // namespace palpate::analysis
