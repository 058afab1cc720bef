#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "base/files/read_file.hpp"
#include "base/files/sha256.hpp"
#include "sim/scene/refuse_key.hpp"
#include "trials/protocol/felt.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials {
namespace {

[[noreturn]] void refuse(const Protocol& protocol, int line, const std::string& what) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", protocol.file.string(), line, what));
}

/// The scene with overrides in place; what it refuses is told with the line that asked for it.
sim::Scene scene_with(const Protocol& protocol, std::span<const sim::Override> overrides, int line,
                      const std::string& key) {
  try {
    return sim::load_scene(protocol.scene_file, overrides);
  } catch (const std::invalid_argument& error) {
    refuse(protocol, line, fmt::format("{}: the scene does not take it: {}", key, error.what()));
  }
}

/// The scene file's text; that it cannot be read is told with the line that names it.
std::string scene_text_of(const Protocol& protocol) {
  try {
    return base::read_file(protocol.scene_file, "a scene file");
  } catch (const std::invalid_argument& error) {
    refuse(protocol, protocol.scene_line, fmt::format("scene: {}", error.what()));
  }
}

/// Each condition and each level by itself, so that the message can say which of them is wrong.
void check_one_by_one(const Protocol& protocol) {
  for (const Condition& condition : protocol.conditions)
    scene_with(protocol, condition.overrides, condition.line, "conditions." + condition.name);
  for (const Factor& factor : protocol.factors)
    for (const FactorLevel& level : factor.levels)
      scene_with(protocol, level.overrides, factor.line, fmt::format("factors.\"{}\"", factor.name));
}

std::vector<sim::Scene> scenes_of(const Protocol& protocol) {
  std::vector<sim::Scene> scenes;
  for (const Stimulus& stimulus : protocol.stimuli) {
    const Condition& condition = protocol.conditions[stimulus.condition];
    scenes.push_back(
        scene_with(protocol, stimulus.overrides, condition.line,
                   fmt::format("conditions.{} with {}", condition.name, protocol.cells[stimulus.cell].name)));
  }
  return scenes;
}

/// Whether nothing that is simulated differs. (A scene's name is seen by readers only.)
bool feel_alike(sim::Scene a, const sim::Scene& b) {
  a.name = b.name;
  return a == b;
}

/// Nobody may be asked to press deeper than the scene's finger goes.
void check_depth(const Protocol& protocol, const std::vector<sim::Scene>& scenes) {
  for (const sim::Scene& scene : scenes)
    if (protocol.exploration.min_depth > scene.probes.front().depth)
      throw std::invalid_argument(fmt::format(
          "{}: exploration.min_depth: found {:g} mm, and probes.{} of {} presses {:g} mm deep; accepted: "
          "no more than that",
          protocol.file.string(), 1e3 * protocol.exploration.min_depth, scene.probes.front().name,
          protocol.scene_file.string(), 1e3 * scene.probes.front().depth));
}

/// Throws when the conditions are one scene in one of the cells.
void check_differ(const Protocol& protocol, const std::vector<sim::Scene>& scenes, std::size_t first,
                  std::size_t second) {
  for (std::size_t cell = 0; cell < protocol.cells.size(); ++cell)
    if (feel_alike(scenes[stimulus_index(protocol, cell, first)],
                   scenes[stimulus_index(protocol, cell, second)]))
      refuse(protocol, protocol.conditions[second].line,
             fmt::format("conditions.{}: is the same scene as \"{}\"{}; accepted: conditions that differ",
                         protocol.conditions[second].name, protocol.conditions[first].name,
                         protocol.factors.empty() ? "" : " with " + protocol.cells[cell].name));
}

void check_conditions_differ(const Protocol& protocol, const std::vector<sim::Scene>& scenes) {
  for (std::size_t b = 1; b < protocol.presented.size(); ++b)
    for (std::size_t a = 0; a < b; ++a)
      check_differ(protocol, scenes, protocol.presented[a], protocol.presented[b]);
}

void check_levels_differ(const Protocol& protocol, const std::vector<sim::Scene>& scenes) {
  for (const std::size_t condition : protocol.presented)
    for (std::size_t b = 1; b < protocol.cells.size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        if (feel_alike(scenes[stimulus_index(protocol, a, condition)],
                       scenes[stimulus_index(protocol, b, condition)]))
          refuse(
              protocol, protocol.factors.front().line,
              fmt::format(
                  "factors: \"{}\" and \"{}\" are the same scene in condition \"{}\"; accepted: levels that "
                  "differ",
                  protocol.cells[a].name, protocol.cells[b].name, protocol.conditions[condition].name));
}

/// What the question asks for must be what makes the correct answer correct.
void settle_answer(Protocol& protocol, const std::vector<sim::Scene>& scenes) {
  const std::optional<Answer> told = answer_told_by(protocol, scenes);
  if (protocol.answer && told && protocol.answer != told)
    throw std::invalid_argument(fmt::format(
        "{}: task.answer: found \"{}\", but the correct condition, \"{}\", is the {}; accepted: \"{}\", or "
        "another correct condition",
        protocol.file.string(), base::word_of(kAnswerWords, *protocol.answer),
        protocol.conditions[protocol.correct].name, base::word_of(kAnswerWords, *told),
        base::word_of(kAnswerWords, *told)));
  if (!protocol.answer) protocol.answer = told;
}

FileHash hash_of(const sim::Scene& scene, const std::string& name, const std::filesystem::path& file) {
  return sim::with_place(scene, [&]() -> FileHash {
    try {
      return {.name = name, .file = file, .sha256 = base::sha256_hex(base::read_file(file))};
    } catch (const std::invalid_argument& error) {
      sim::refuse_key(fmt::format("bodies.{}.mesh", name), error.what());
    }
  });
}

}  // namespace

Protocol load_protocol(const std::filesystem::path& file) {
  Protocol protocol = parse_protocol(base::read_file(file), file);
  protocol.scene_text = scene_text_of(protocol);
  const sim::Scene scene = sim::load_scene(protocol.scene_file);
  check_one_by_one(protocol);
  const std::vector<sim::Scene> scenes = scenes_of(protocol);
  check_conditions_differ(protocol, scenes);
  check_levels_differ(protocol, scenes);
  check_depth(protocol, scenes);
  settle_answer(protocol, scenes);

  protocol.files.push_back({"scene", protocol.scene_file, base::sha256_hex(protocol.scene_text)});
  for (const sim::BodySpec& body : scene.bodies)
    protocol.files.push_back(hash_of(scene, body.name, body.mesh));
  return protocol;
}

}  // namespace palpate::trials
