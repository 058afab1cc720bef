#include "app/command_line/user_cache.hpp"

#include <spdlog/spdlog.h>

namespace palpate::app {

sim::ComplianceCache user_cache() {
  return sim::ComplianceCache(
      sim::ComplianceCache::default_folder(),
      [](const std::string& sentence) { spdlog::warn("compliance cache: {}", sentence); },
      sim::ComplianceCache::size_asked_for());
}

}  // namespace palpate::app
