#include "app/commands/new_study/formats.hpp"

#include <fmt/format.h>

#include "sim/scene/scene_keys.hpp"
#include "trials/observer/observer_keys.hpp"
#include "trials/protocol/protocol_keys.hpp"

namespace palpate::app {
namespace {

constexpr std::string_view kOptions =
    "Lines that begin with # and a key are options: take the # away to use one. A quantity is a text with\n"
    "its unit.";

std::string protocol_heading() {
  return fmt::format(
      "A study: is a hard prostate told from a soft one through the rectum's wall, and does it matter how\n"
      "soft that wall is? Change what your study needs; `palpate check` on this file says whether it is\n"
      "sound and what it amounts to.\n{}",
      kOptions);
}

std::string scene_heading() {
  return fmt::format(
      "What there is to touch: a finger presses the wall of the rectum towards the prostate. `palpate check`\n"
      "on this file says whether it is sound, `palpate press` how it feels, `palpate render` how it looks.\n{}",
      kOptions);
}

std::string observer_heading() {
  return "What simulated examinees are like. To use it: palpate simulate PROTOCOL --observer FILE ...";
}

}  // namespace

base::FileFormat format_of(std::string_view file) {
  if (file == "scene") return sim::scene_format();
  if (file == "observer") return trials::observer_format();
  return trials::protocol_format(trials::tasks(), trials::procedures());
}

std::string new_protocol(std::string_view name, const trials::Task& task,
                         const trials::Procedure& procedure) {
  const trials::Task* const tasks[] = {&task};
  const trials::Procedure* const procedures[] = {&procedure};
  base::FileFormat format = trials::protocol_format(tasks, procedures);
  format.tables.front().shown.front().examples = {{"name", fmt::format("\"{}\"", name)}};
  return base::example_file(format, protocol_heading());
}

std::string new_scene() {
  return base::example_file(sim::scene_format(), scene_heading());
}

std::string reference_of(std::string_view file) {
  const std::string heading = file == "scene"      ? scene_heading()
                              : file == "observer" ? observer_heading()
                                                   : protocol_heading();
  return base::reference(format_of(file), heading);
}

}  // namespace palpate::app
