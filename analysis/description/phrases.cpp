#include "analysis/description/phrases.hpp"

#include <fmt/core.h>

#include "analysis/words/words.hpp"

namespace palpate::analysis {

std::string method_line(const Method& method) {
  return fmt::format("Method: {} ({}).\n", method.name, method.source);
}

std::string p_line(const PValues& p, Side side) {
  return fmt::format("{} (side {}; greater {}, less {}, two-sided {})\n", p_in_words(p.of(side)),
                     name_of(side), number(p.greater), number(p.less), number(p.two_sided));
}

void put_side(nlohmann::ordered_json& json, Side side) {
  json["side"] = name_of(side);
  json["p"] = json["p_values"][side == Side::TwoSided ? "two_sided" : std::string(name_of(side))];
}

}  // namespace palpate::analysis
