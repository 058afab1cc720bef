#pragma once

#include <string>

namespace palpate::base {

/// The present moment in UTC, ISO 8601 with milliseconds: "2026-11-28T18:52:28.000Z".
std::string utc_now();

}  // namespace palpate::base
