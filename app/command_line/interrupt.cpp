#include "app/command_line/interrupt.hpp"

#include <csignal>

namespace palpate::app {
namespace {

volatile std::sig_atomic_t raised = 0;

extern "C" void raise_flag(int) {
  raised = 1;
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = raise_flag;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return raised != 0;
}

}  // namespace palpate::app
