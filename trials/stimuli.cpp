#include "trials/stimuli.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace palpate::trials {

Stimuli compile_stimuli(const Protocol& protocol, sim::ComplianceCache& cache) {
  Stimuli models(protocol.stimuli.size());
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Stimulus& stimulus = protocol.stimuli[i];
    if (std::ranges::find(protocol.pair, stimulus.condition) == protocol.pair.end()) continue;
    try {
      const sim::Scene scene = sim::load_scene(protocol.scene_file, stimulus.overrides);
      models[i] = std::make_shared<const sim::Model>(sim::compile(scene, cache));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: condition {} with {}: {}", protocol.file.string(),
                                              protocol.conditions[stimulus.condition].name,
                                              protocol.cells[stimulus.cell].name, error.what()));
    }
  }
  return models;
}

}  // namespace palpate::trials
