#pragma once

#include <span>
#include <string_view>

#include "sim/model/probe_kind.hpp"

namespace palpate::sim {

/// Every kind of probe, in the order in which users see them.
std::span<const ProbeKind* const> probe_kinds();

/// The kind of a name that the scene reader has accepted. Throws std::invalid_argument for any other.
const ProbeKind& probe_kind(std::string_view name);

}  // namespace palpate::sim
