#pragma once

namespace palpate::app {

/// From here on Ctrl-C (SIGINT) and SIGTERM only raise a flag, so that work can stop where everything is on
/// the disk.
void catch_interrupts();
bool interrupted();

}  // namespace palpate::app
