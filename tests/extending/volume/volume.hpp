#pragma once

#include "app/command_line/command.hpp"

namespace palpate::app {

/// palpate volume: how much a mesh holds.
extern const Command volume_command;

}  // namespace palpate::app
