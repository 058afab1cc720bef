#include "app/command_line/stimulus_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace palpate::app {
namespace {

template <typename Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

void require_known(const trials::Protocol& protocol, const std::string& option, const std::string& name,
                   const std::vector<std::string>& known) {
  if (name.empty() || std::ranges::find(known, name) != known.end()) return;
  const bool commas =
      std::ranges::any_of(known, [](const std::string& one) { return one.find(',') != std::string::npos; });
  throw std::invalid_argument(fmt::format("{} {}: {} has no such {}; accepted: {}", option, name,
                                          protocol.file.string(), option.substr(2),
                                          fmt::join(known, commas ? "; " : ", ")));
}

}  // namespace

void add_stimulus(CLI::App& command, StimulusOptions& options) {
  command.add_option("--condition", options.condition, "Of a protocol: the condition");
  command.add_option("--cell", options.cell, "Of a protocol: the cell, such as a contact model");
}

std::vector<trials::Stimulus> chosen_stimuli(const trials::Protocol& protocol,
                                             const StimulusOptions& options) {
  require_known(protocol, "--condition", options.condition, names_of(protocol.conditions));
  require_known(protocol, "--cell", options.cell, names_of(protocol.cells));
  std::vector<trials::Stimulus> chosen;
  std::ranges::copy_if(protocol.stimuli, std::back_inserter(chosen), [&](const trials::Stimulus& stimulus) {
    return (options.condition.empty() || protocol.conditions[stimulus.condition].name == options.condition) &&
           (options.cell.empty() || protocol.cells[stimulus.cell].name == options.cell);
  });
  return chosen;
}

trials::Stimulus only_stimulus(const trials::Protocol& protocol, const StimulusOptions& options,
                               std::string_view wish) {
  const std::vector<trials::Stimulus> chosen = chosen_stimuli(protocol, options);
  if (chosen.size() == 1) return chosen.front();
  throw std::invalid_argument(fmt::format(
      "{}: a protocol, and {} shows one condition in one cell; accepted: --condition {} and "
      "--cell {}, or the scene {}",
      protocol.file.string(), wish, fmt::join(names_of(protocol.conditions), " or "),
      fmt::join(names_of(protocol.cells), " or "), protocol.scene_file.lexically_normal().string()));
}

void refuse_choice(const StimulusOptions& options, const std::string& scene) {
  if (options.condition.empty() && options.cell.empty()) return;
  throw std::invalid_argument(fmt::format(
      "{}: --condition and --cell choose from a protocol, and this is a scene; accepted here: --set "
      "and --model",
      scene));
}

}  // namespace palpate::app
