#pragma once

#include "app/command_line/scene_options.hpp"

namespace palpate::app {

enum class InputKind { Scene, Protocol };

/// Which of the two a TOML file is. Throws std::invalid_argument for a file that is neither, and for --set or
/// --model beside a protocol, whose conditions and factors say what is replaced.
InputKind input_kind(const SceneOptions& options);

}  // namespace palpate::app
