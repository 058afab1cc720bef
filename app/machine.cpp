#include "app/machine.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <thread>

namespace palpate::app {

std::string describe_machine() {
  utsname system{};
  if (::uname(&system) != 0) return "unknown";
  return fmt::format("{} {} {}, {} processors", system.sysname, system.release, system.machine,
                     std::thread::hardware_concurrency());
}

}  // namespace palpate::app
