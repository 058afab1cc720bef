#include "base/machine/cache_folder.hpp"

#include "base/machine/environment.hpp"

namespace palpate::base {

std::filesystem::path cache_folder() {
  if (const auto own = environment("PALPATE_CACHE")) return *own;
  const std::filesystem::path shared = environment("XDG_CACHE_HOME").value_or("");
  if (shared.is_absolute()) return shared / "palpate";  // the XDG rule: ignore relative ones
  if (const auto home = environment("HOME")) return std::filesystem::path(*home) / ".cache" / "palpate";
  return {};
}

}  // namespace palpate::base
