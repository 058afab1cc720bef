#pragma once

#include <span>
#include <string>

#include "sim/model/loads.hpp"
#include "sim/view/picture.hpp"

namespace palpate::sim {

/// What colours can show.
enum class Field {
  Displacement,  // its magnitude, of each node
  Stress         // von Mises, of each tetrahedron at the surface: linear ones have one stress throughout
};

/// What the colours of a picture mean: viridis from `least` to `most`.
struct Legend {
  std::string title{};
  std::string unit{};
  double least = 0.0, most = 0.0;  // of what is drawn [unit]
};

/// Colours the bodies of a picture by a field, over one scale, and makes them solid: what shines through would
/// mix colours that mean something. @param bodies  under the loads that the picture shows
Legend paint(Picture& picture, const Model& model, std::span<const WholeBody> bodies, Field field);

}  // namespace palpate::sim
