#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trials/study/event.hpp"

namespace palpate::trials {

/// The text of the event that a sitting was taken up again: by which version of the program, on which machine.
std::string resumed_text(std::string_view software_version, std::string_view machine);

/// The version that took a sitting up again, where the event tells of that.
std::optional<std::string> version_resumed_by(const EventRow& event);

/// Every such version of one sitting, each once, in the order of the events.
std::vector<std::string> versions_that_resumed(const std::vector<EventRow>& events, std::int64_t session);

}  // namespace palpate::trials
