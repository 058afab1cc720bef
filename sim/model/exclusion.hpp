#pragma once

#include <string_view>

namespace palpate::sim {

/// What a scene chooses by name.
enum class Choice { Effect, ContactModel, ProbeKind };

/// Something that a scene cannot call for together with what states this.
struct Exclusion {
  Choice choice = Choice::Effect;
  std::string_view name{};  // of the effect, the contact model or the probe kind
  std::string_view why{};   // a clause, for the message and the reference
};

}  // namespace palpate::sim
