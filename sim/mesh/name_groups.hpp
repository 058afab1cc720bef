#pragma once

#include <string_view>

namespace palpate::sim {

// How a file gives a group the name by which a scene asks for it, for messages.

inline constexpr std::string_view kHowToNameGroups =
    "in Gmsh, Physical Surface(\"NAME\") = {...} names one; in VTU, an integer point array group.NAME, not 0 "
    "at its nodes";
inline constexpr std::string_view kHowToNameRegions =
    "in Gmsh, Physical Volume(\"NAME\") = {...} names one; in VTU, the values of an integer cell array region";

}  // namespace palpate::sim
