#include "sim/compile/combinations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "sim/contact/laws.hpp"
#include "sim/effects/effects.hpp"
#include "sim/probe/kinds.hpp"
#include "sim/scene/accepted.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

/// Where a scene calls for something.
struct Call {
  std::string key{};   // "contact.model"
  std::string said{};  // "contact.model = \"kuroda\""
};

/// Nothing where the scene does not call for it.
std::optional<Call> call_for(const Scene& scene, Choice choice, std::string_view name,
                             std::span<const Effect* const> effects) {
  if (choice == Choice::ContactModel) {
    if (scene.contact.model != name) return std::nullopt;
    return Call{"contact.model", fmt::format("contact.model = \"{}\"", name)};
  }
  if (choice == Choice::ProbeKind) {
    const auto probe = std::ranges::find(scene.probes, name, &ProbeSpec::kind);
    if (probe == scene.probes.end()) return std::nullopt;
    const std::string key = fmt::format("probes.{}.kind", probe->name);
    return Call{key, fmt::format("{} = \"{}\"", key, name)};
  }
  for (const Effect* effect : effects)
    if (effect->name == name) {
      EffectState state = effect->state(scene);
      if (state.on) return Call{state.key, fmt::format("{} ({})", name, state.reason)};
    }
  return std::nullopt;
}

bool are_apart(const std::vector<Combination>& table, Choice a, std::string_view name_of_a, Choice b,
               std::string_view name_of_b) {
  return std::ranges::any_of(table, [&](const Combination& row) {
    const auto is = [](Choice choice, std::string_view name, Choice wanted, std::string_view wanted_name) {
      return choice == wanted && name == wanted_name;
    };
    const Exclusion& other = row.other;
    return (is(row.choice, row.name, a, name_of_a) && is(other.choice, other.name, b, name_of_b)) ||
           (is(row.choice, row.name, b, name_of_b) && is(other.choice, other.name, a, name_of_a));
  });
}

/// What a scene may have in place of `called` beside the other side, which it keeps.
std::string instead_of(const Call& called, Choice choice, Choice kept, std::string_view kept_name,
                       const std::vector<Combination>& table, std::span<const ProbeKind* const> kinds) {
  std::vector<std::string> names;
  const auto add = [&](std::string_view name) {
    if (!are_apart(table, choice, name, kept, kept_name)) names.push_back(fmt::format("\"{}\"", name));
  };
  if (choice == Choice::ContactModel)
    for (const ContactLaw* law : contact_laws()) add(law->name);
  if (choice == Choice::ProbeKind)
    for (const ProbeKind* kind : kinds) add(kind->keys.name);
  if (names.empty()) return fmt::format("the scene without {}", called.key);
  return fmt::format("{} = {}", called.key, fmt::join(names, " or "));
}

std::string in_words(Choice choice, std::string_view name) {
  switch (choice) {
    case Choice::ContactModel:
      return fmt::format("the contact model `{}`", name);
    case Choice::ProbeKind:
      return fmt::format("probes of kind `{}`", name);
    default:
      return std::string(name);
  }
}

}  // namespace

std::vector<Combination> unsupported_combinations(std::span<const Effect* const> effects,
                                                  std::span<const ProbeKind* const> kinds) {
  std::vector<Combination> table;
  for (const Effect* effect : effects)
    for (const Exclusion& other : effect->excludes) table.push_back({Choice::Effect, effect->name, other});
  for (const ProbeKind* kind : kinds)
    for (const Exclusion& other : kind->excludes)
      table.push_back({Choice::ProbeKind, kind->keys.name, other});
  return table;
}

void refuse_combinations(const Scene& scene, std::span<const Effect* const> effects,
                         std::span<const ProbeKind* const> kinds) {
  const std::vector<Combination> table = unsupported_combinations(effects, kinds);
  for (const Combination& row : table) {
    const std::optional<Call> one = call_for(scene, row.choice, row.name, effects);
    const std::optional<Call> other = call_for(scene, row.other.choice, row.other.name, effects);
    if (!one || !other) continue;
    refuse_key(
        one->key,
        fmt::format("{} cannot be combined with {}: {}; accepted: {}, or {}", one->said, other->said,
                    row.other.why, instead_of(*other, row.other.choice, row.choice, row.name, table, kinds),
                    instead_of(*one, row.choice, row.other.choice, row.other.name, table, kinds)));
  }
}

std::vector<std::string> combinations_in_words() {
  std::vector<std::string> rows;
  for (const auto& [choice, name, other] : unsupported_combinations(effects(), probe_kinds()))
    rows.push_back(
        fmt::format("{} and {}: {}", in_words(choice, name), in_words(other.choice, other.name), other.why));
  return rows;
}

}  // namespace palpate::sim
