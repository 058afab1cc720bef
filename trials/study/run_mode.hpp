#pragma once

#include <string_view>

namespace palpate::trials {

enum class RunMode { Study, Pilot, Practice, Simulated };
std::string_view to_string(RunMode mode);
RunMode run_mode_from(std::string_view name);  // throws std::invalid_argument, lists what is accepted

}  // namespace palpate::trials
