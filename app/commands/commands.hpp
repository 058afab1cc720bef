#pragma once

#include <span>

#include "app/command_line/command.hpp"

namespace palpate::app {

/// Every command, in the order of the help.
std::span<const Command* const> commands();

}  // namespace palpate::app
