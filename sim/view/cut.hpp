#pragma once

#include <span>

#include "sim/model/loads.hpp"
#include "sim/view/picture.hpp"

namespace palpate::sim {

/// Opens the bodies of a picture: takes away the tetrahedra whose middle lies, at rest, before the plane that
/// holds the first probe's press and faces the camera. Bodies become solid. Tetrahedra stay whole, so that each
/// is seen with the stress that it has. @param bodies  under the loads that the picture shows
/// Throws std::invalid_argument where the camera looks along the press: there is no such plane.
void cut_open(Picture& picture, const Model& model, std::span<const WholeBody> bodies);

}  // namespace palpate::sim
