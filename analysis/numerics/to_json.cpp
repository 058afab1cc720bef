#include "analysis/numerics/to_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace palpate::analysis {

using nlohmann::ordered_json;

ordered_json to_json(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json optional_json(const std::optional<long>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json to_json(const Interval& interval) {
  return {{"lower", to_json(interval.lower)},
          {"upper", to_json(interval.upper)},
          {"level", interval.level},
          {"method", interval.method}};
}

ordered_json to_json(const PValues& p) {
  return {{"greater", p.greater}, {"less", p.less}, {"two_sided", p.two_sided}};
}

ordered_json to_json(const Method& method) {
  return {{"name", method.name}, {"source", method.source}};
}

}  // namespace palpate::analysis
