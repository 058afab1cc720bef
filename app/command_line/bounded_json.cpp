#include "app/command_line/bounded_json.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace palpate::app {

nlohmann::ordered_json parse_bounded_json(const std::string& text) {
  using nlohmann::ordered_json;
  static constexpr int kDeepest = 32;
  return ordered_json::parse(text, [](int depth, ordered_json::parse_event_t, const ordered_json&) {
    if (depth <= kDeepest) return true;
    throw std::invalid_argument(fmt::format("brackets more than {} deep; accepted: fewer", kDeepest));
  });
}

}  // namespace palpate::app
