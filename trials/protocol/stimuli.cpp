#include "trials/protocol/stimuli.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sim/compile/compile.hpp"

namespace palpate::trials {

sim::Model compile_stimulus(const Protocol& protocol, const Stimulus& stimulus, sim::ComplianceCache& cache) {
  try {
    return sim::compile(sim::load_scene(protocol.scene_file, stimulus.overrides), cache);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: condition {} with {}: {}", protocol.file.string(),
                                            protocol.conditions[stimulus.condition].name,
                                            protocol.cells[stimulus.cell].name, error.what()));
  }
}

Stimuli compile_stimuli(const Protocol& protocol, sim::ComplianceCache& cache) {
  Stimuli models(protocol.stimuli.size());
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Stimulus& stimulus = protocol.stimuli[i];
    if (std::ranges::find(protocol.presented, stimulus.condition) != protocol.presented.end())
      models[i] = std::make_shared<const sim::Model>(compile_stimulus(protocol, stimulus, cache));
  }
  return models;
}

}  // namespace palpate::trials
