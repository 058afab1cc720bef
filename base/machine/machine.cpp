#include "base/machine/machine.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <fstream>
#include <thread>

namespace palpate::base {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string system_name() {
  utsname system{};
  if (::uname(&system) != 0) return "unknown system";
  return fmt::format("{} {} {}", system.sysname, system.release, system.machine);
}

}  // namespace

std::string describe_machine() {
  return fmt::format("{}, {}, {} processors", processor(), system_name(),
                     std::thread::hardware_concurrency());
}

}  // namespace palpate::base
