#include "trials/study/run_mode.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/text/enum_words.hpp"

namespace palpate::trials {
namespace {

constexpr base::EnumWords<RunMode, 4> kRunModes{{{RunMode::Study, "study"},
                                                 {RunMode::Pilot, "pilot"},
                                                 {RunMode::Practice, "practice"},
                                                 {RunMode::Simulated, "simulated"}}};

}  // namespace

std::string_view to_string(RunMode mode) {
  return base::word_of(kRunModes, mode);
}

RunMode run_mode_from(std::string_view name) {
  if (const auto mode = base::value_of(kRunModes, name)) return *mode;
  throw std::invalid_argument(
      fmt::format("run mode: found \"{}\", accepted: {}", name, base::accepted_words(kRunModes)));
}

}  // namespace palpate::trials
