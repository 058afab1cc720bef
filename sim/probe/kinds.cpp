#include "sim/probe/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "sim/probe/fingertip/fingertip.hpp"
#include "sim/probe/pad/pad.hpp"
#include "sim/probe/point/point.hpp"
#include "sim/probe/region/region.hpp"
#include "sim/scene/accepted.hpp"

namespace palpate::sim {
namespace {

constexpr std::array kKinds{
    &kPoint,
    &kPad,
    &kFingertip,
    &kRegion,
};

}  // namespace

std::span<const ProbeKind* const> probe_kinds() {
  return kKinds;
}

const ProbeKind& probe_kind(std::string_view name) {
  const auto found = std::ranges::find(kKinds, name, [](const ProbeKind* kind) { return kind->keys.name; });
  if (found == kKinds.end())
    throw std::invalid_argument(
        fmt::format("kind: found \"{}\", accepted: {}", name, base::accepted(probe_kind_words())));
  return **found;
}

base::Words probe_kind_words() {
  base::Words words;
  for (const ProbeKind* kind : kKinds) words.now.push_back({kind->keys.name, kind->keys.meaning});
  return words;
}

std::span<const ProbeKindKeys> probe_kind_keys() {
  static const std::vector<ProbeKindKeys> keys = [] {
    std::vector<ProbeKindKeys> all;
    all.reserve(kKinds.size());
    for (const ProbeKind* kind : kKinds) all.push_back(kind->keys);
    return all;
  }();
  return keys;
}

}  // namespace palpate::sim
