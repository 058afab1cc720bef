#include "app/command_line/bounded_json.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>
#include <vector>

#include "app/command_line/output.hpp"
#include "base/text/json_words.hpp"

namespace palpate::app {

nlohmann::ordered_json parse_bounded_json(const std::string& text) try {
  using nlohmann::ordered_json;
  using Event = ordered_json::parse_event_t;
  static constexpr int kDeepest = 32;
  std::vector<std::set<std::string>> keys;  // the library would keep the last of two values of one key
  return ordered_json::parse(text, [&keys](int depth, Event event, const ordered_json& value) {
    if (depth > kDeepest)
      throw std::invalid_argument(fmt::format("brackets more than {} deep; accepted: fewer", kDeepest));
    if (event == Event::object_start) keys.emplace_back();
    if (event == Event::object_end) keys.pop_back();
    if (event == Event::key && !keys.back().insert(value.get<std::string>()).second)
      throw std::invalid_argument(
          fmt::format("the key {} is there twice; accepted: once", json_text(value, -1)));
    return true;
  });
} catch (const nlohmann::json::parse_error& error) {
  throw std::invalid_argument(base::json_words(error.what(), text, error.byte));
}

}  // namespace palpate::app
