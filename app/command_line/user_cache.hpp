#pragma once

#include "sim/compliance/cache.hpp"

namespace palpate::app {

/// The compliances that this user's runs share, on disk. Troubles with it are told on stderr, as words about
/// the work: they cost time, never the run.
sim::ComplianceCache user_cache();

}  // namespace palpate::app
