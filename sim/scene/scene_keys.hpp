#pragma once

#include <span>

#include "base/text/file_format.hpp"

namespace palpate::sim {

// The keys of a scene file, apart from what effects bring (effect_keys()).
std::span<const base::Key> scene_keys();  // of the file's top
std::span<const base::Key> body_keys();
std::span<const base::Key> region_keys();
std::span<const base::Key> box_keys();
std::span<const base::Key> contact_keys();
std::span<const base::Key> probe_keys();
/// [bodies], [probes] and [bodies.NAME.regions]: a table a name.
std::span<const base::Key> tables_by_name();

/// All of them, with what the lists of effects, contact models and probe kinds bring.
base::FileFormat scene_format();

}  // namespace palpate::sim
