#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/key.hpp"

namespace palpate::base {
class TomlReader;
}

namespace palpate::sim {

// What a scene may name stands in lists of rooms above this one. The reader needs of them no more than words
// and keys, which are declared here and defined beside each list.

/// What contact.model accepts. Defined in sim/contact/laws.cpp.
base::Words contact_model_words();

/// What probes.NAME.kind accepts. Defined in sim/probe/kinds.cpp.
base::Words probe_kind_words();

/// What the scene reader knows of a kind of probe.
struct ProbeKindKeys {
  std::string_view name{};     // as probes.NAME.kind says it
  std::string_view meaning{};  // what it presses with, a clause, for the reference
  bool takes_radius = false;   // true: radius is required; false: refused
  bool takes_reach = false;    // true: reach is accepted
  bool holds_mean = false;     // true: it holds a mean of nodes, across its direction as `tangential` says
  bool takes_group = false;    // true: group is required, in place of at and node; false: refused
};

/// Every kind. Defined in sim/probe/kinds.cpp.
std::span<const ProbeKindKeys> probe_kind_keys();

/// A key that calls for an effect.
struct EffectKey {
  std::string_view table{};      // "bodies" (of each body) or "contact"
  base::Key key{};               // of a key that this version refuses, the name alone
  std::string_view calls_for{};  // "viscosity"
  /// The numbers that the key's value stands for; refuses as TomlReader does. Null: this version does not
  /// simulate what the key calls for, and refuses it.
  std::vector<double> (*read)(base::TomlReader& table, std::string_view key) = nullptr;
};

/// Every such key. Defined in sim/effects/effects.cpp.
std::span<const EffectKey> effect_keys();

/// What one scene cannot have together, and why: a clause each. Defined in sim/compile/combinations.cpp.
std::vector<std::string> combinations_in_words();

}  // namespace palpate::sim
