#include "analysis/statistics/stevens/stevens.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "base/text/counted.hpp"

namespace palpate::analysis {
namespace {

// Of the sum of squares: what of it rounding leaves about a line on which all estimates lie.
constexpr double kRounding = 1e-14;

struct Point {
  double x, y;  // logarithms of level and estimate
};
using ByExaminee = std::map<std::string, std::vector<Point>>;

// Sums of squares and products about an examinee's own means, which takes the factor c_i out.
struct CentredSums {
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

CentredSums within(const std::vector<Point>& points) {
  const double n = static_cast<double>(points.size());
  double x = 0.0, y = 0.0;
  for (const Point& point : points) x += point.x / n, y += point.y / n;
  CentredSums sums;
  for (const Point& point : points) {
    sums.xx += (point.x - x) * (point.x - x);
    sums.xy += (point.x - x) * (point.y - y);
    sums.yy += (point.y - y) * (point.y - y);
  }
  return sums;
}

bool has_two_levels(const std::vector<Point>& points) {
  for (const Point& point : points) {
    if (point.x != points.front().x) return true;
  }
  return false;
}

ByExaminee group(const std::vector<MagnitudeEstimate>& estimates) {
  ByExaminee grouped;
  for (const MagnitudeEstimate& one : estimates) {
    validate(one);
    grouped[one.examinee].push_back({.x = std::log(one.level), .y = std::log(one.estimate)});
  }
  return grouped;
}

// Each examinee's mean log estimate at each level, then the mean over examinees.
std::vector<LevelMean> level_means(const std::vector<MagnitudeEstimate>& estimates) {
  struct Sum {
    double logs = 0.0;
    std::size_t count = 0;
  };
  std::map<double, std::map<std::string, Sum>> sums;
  for (const MagnitudeEstimate& one : estimates) {
    Sum& sum = sums[one.level][one.examinee];
    sum.logs += std::log(one.estimate);
    ++sum.count;
  }
  std::vector<LevelMean> means;
  for (const auto& [level, people] : sums) {
    LevelMean mean{.level = level, .examinees = people.size()};
    double logs = 0.0;
    for (const auto& [name, sum] : people) {
      logs += sum.logs / static_cast<double>(sum.count);
      mean.estimates += sum.count;
    }
    mean.geometric_mean = std::exp(logs / static_cast<double>(people.size()));
    means.push_back(mean);
  }
  return means;
}

Interval t_interval(double centre, double error, double degrees, double level) {
  const double half = quantile(complement(boost::math::students_t(degrees), (1 - level) / 2)) * error;
  return {.lower = centre - half, .upper = centre + half, .level = level, .method = "Student's t"};
}

std::optional<ExponentsOfExaminees> exponents_of(const ByExaminee& grouped, double level) {
  std::vector<double> exponents;
  for (const auto& [name, points] : grouped) {
    if (!has_two_levels(points)) continue;
    const CentredSums sums = within(points);
    exponents.push_back(sums.xy / sums.xx);
  }
  if (exponents.size() < 2) return std::nullopt;
  const double n = static_cast<double>(exponents.size());
  ExponentsOfExaminees result{.examinees = exponents.size()};
  for (const double exponent : exponents) result.mean += exponent / n;
  double squares = 0.0;
  for (const double exponent : exponents) squares += (exponent - result.mean) * (exponent - result.mean);
  result.deviation = std::sqrt(squares / (n - 1));
  result.interval = t_interval(result.mean, result.deviation / std::sqrt(n), n - 1, level);
  return result;
}

}  // namespace

void validate(const MagnitudeEstimate& one) {
  require_finite(one.level, "level");
  require_finite(one.estimate, "estimate");
  if (one.level > 0 && one.estimate > 0) return;
  throw std::invalid_argument(
      fmt::format("level {} was judged {} by '{}'; a power law needs both above 0: say beforehand what is "
                  "done about estimates of 0",
                  one.level, one.estimate, one.examinee));
}

StevensFit stevens_fit(const std::vector<MagnitudeEstimate>& estimates, double level) {
  require_level(level, "confidence level");
  const ByExaminee grouped = group(estimates);
  CentredSums sums;
  for (const auto& [name, points] : grouped) {
    const CentredSums own = within(points);
    sums.yy += own.yy;
    if (has_two_levels(points)) sums.xx += own.xx, sums.xy += own.xy;  // else they are round-off
  }
  if (sums.xx == 0) throw std::invalid_argument("no examinee judged two levels; an exponent needs them");
  StevensFit fit{.examinees = grouped.size(), .estimates = estimates.size()};
  fit.degrees_of_freedom = static_cast<long>(estimates.size()) - static_cast<long>(grouped.size()) - 1;
  if (fit.degrees_of_freedom < 1) {
    throw std::invalid_argument(
        fmt::format("{} of {}; after a factor for each and the exponent none is left over to "
                    "judge the line by",
                    base::counted(static_cast<long>(fit.estimates), "estimate", "estimates"),
                    base::counted(static_cast<long>(fit.examinees), "examinee", "examinees")));
  }
  const double degrees = static_cast<double>(fit.degrees_of_freedom);
  fit.exponent = sums.xy / sums.xx;
  double left = std::max(0.0, sums.yy - fit.exponent * sums.xy);
  fit.perfect = left <= kRounding * sums.yy;
  if (fit.perfect) left = 0.0;
  fit.residual_deviation = std::sqrt(left / degrees);
  fit.standard_error = fit.residual_deviation / std::sqrt(sums.xx);
  if (fit.perfect) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    fit.t = fit.p = kNone;
    fit.interval = {.lower = kNone, .upper = kNone, .level = level, .method = "none"};
  } else {
    fit.interval = t_interval(fit.exponent, fit.standard_error, degrees, level);
    fit.t = fit.exponent / fit.standard_error;
    fit.p = 2 * cdf(complement(boost::math::students_t(degrees), std::abs(fit.t)));
  }
  fit.r_squared = sums.yy > 0 ? 1 - left / sums.yy : 0.0;
  fit.levels = level_means(estimates);
  for (const LevelMean& mean : fit.levels) fit.balanced = fit.balanced && mean.examinees == fit.examinees;
  fit.by_examinee = exponents_of(grouped, level);
  fit.method = {.name = "power law by least squares on logarithms, a factor for each examinee",
                .source = "Stevens 1957"};
  return fit;
}

}  // namespace palpate::analysis
