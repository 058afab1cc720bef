#pragma once

#include "app/command_line/command.hpp"

namespace palpate::app {

extern const Command press_command;

}  // namespace palpate::app
