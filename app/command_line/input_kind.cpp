#include "app/command_line/input_kind.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/text/toml_reader.hpp"

namespace palpate::app {

InputKind input_kind(const SceneOptions& options) {
  const toml::table file = base::read_toml(options.file);
  if (file.contains("bodies")) return InputKind::Scene;
  if (!file.contains("task") && !file.contains("conditions") && !file.contains("scene"))
    throw std::invalid_argument(fmt::format(
        "{}: neither a scene ([bodies.NAME]) nor a protocol ([conditions.NAME], [task])", options.file));
  if (!options.set.empty() || !options.model.empty())
    throw std::invalid_argument(
        fmt::format("{}: --set and --model belong to a scene, and this is a protocol, whose conditions and "
                    "factors say what is replaced; accepted: the protocol alone, or the scene that it names",
                    options.file));
  return InputKind::Protocol;
}

}  // namespace palpate::app
