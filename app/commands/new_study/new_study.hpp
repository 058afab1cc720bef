#pragma once

#include "app/command_line/command.hpp"

namespace palpate::app {

/// palpate new: a protocol and a scene to start from, and the reference of the files' keys.
extern const Command new_command;

}  // namespace palpate::app
