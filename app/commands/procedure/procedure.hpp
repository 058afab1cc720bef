#pragma once

#include "app/command_line/command.hpp"

namespace palpate::app {

/// palpate procedure: which levels an adaptive procedure asks for, given the answers.
extern const Command procedure_command;

}  // namespace palpate::app
