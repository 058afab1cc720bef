#pragma once

namespace palpate::app {

/// Thrown by a command that was stopped by Ctrl-C, once everything is safe: exit code 130.
struct Interrupted {};

/// From here on Ctrl-C (SIGINT) and SIGTERM only raise a flag, so that work can stop where everything is on
/// the disk.
void catch_interrupts();
bool interrupted();

}  // namespace palpate::app
