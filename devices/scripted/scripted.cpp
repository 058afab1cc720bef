#include "devices/scripted/scripted.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/files/read_file.hpp"
#include "devices/scripted/path.hpp"

namespace palpate::devices {
namespace {

struct Script : Handle {
  ProbePath path;
};

std::unique_ptr<Handle> open_script(const std::string& file) {
  std::vector<ProbePath> paths = parse_path(base::read_file(file, "a path (.csv)"), file);
  if (paths.size() != 1)
    throw std::invalid_argument(
        fmt::format("{}: {} probes; a scripted hand moves one, with the columns time_s, NAME.x_m, NAME.y_m, "
                    "NAME.z_m",
                    file, paths.size()));
  if (!paths.front().rotations.empty())
    throw std::invalid_argument(fmt::format(
        "{0}:{1}: {2}.rx_rad: a scripted hand does not turn; accepted: the file without {2}.rx_rad, "
        "{2}.ry_rad, {2}.rz_rad",
        file, paths.front().line, paths.front().probe));
  auto script = std::make_unique<Script>();
  script->path = std::move(paths.front());
  return script;
}

Reading read_script(Handle& handle, const Moment& moment) {
  return {.position = place_at(static_cast<Script&>(handle).path, moment.since_begin),
          .measured = moment.now,
          .known = true};
}

void move_by_script(DrivenProbe& probe, const Vec3& target, double, double step) {
  hold_probe(probe, target, step);
}

}  // namespace

const Device& scripted() {
  static const Device device{.name = "scripted",
                             .in_words = "a path from a file",
                             .notice = "No person moves this session's hand: a file does.",
                             .argument = "FILE",
                             .facts = {.moved_by_a_person = false, .rate = 1000.0},
                             .open = open_script,
                             .read = read_script,
                             .move = move_by_script};
  return device;
}

}  // namespace palpate::devices
