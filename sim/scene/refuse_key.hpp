#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "sim/scene/scene.hpp"

namespace palpate::sim {

/// A key of a scene whose value cannot be used: "KEY: WHAT". with_place() adds where it stands.
struct RefusedKey : std::invalid_argument {
  RefusedKey(std::string refused, const std::string& what)
      : std::invalid_argument(fmt::format("{}: {}", refused, what)), key(std::move(refused)) {}
  std::string key;
};

[[noreturn]] inline void refuse_key(const std::string& key, const std::string& what) {
  throw RefusedKey(key, what);
}

/// "scenes/a.toml:12": file and line of a key of a scene, or of the table that it would stand in; the file alone
/// where an override put it there.
std::string place_of(const Scene& scene, std::string_view key);

/// Does `work`; what it refuses is thrown as std::invalid_argument with the place in the scene's file.
template <class Work>
auto with_place(const Scene& scene, Work work) {
  try {
    return work();
  } catch (const RefusedKey& refused) {
    throw std::invalid_argument(fmt::format("{}: {}", place_of(scene, refused.key), refused.what()));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", scene.file.string(), error.what()));
  }
}

}  // namespace palpate::sim
