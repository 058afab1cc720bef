#pragma once

#include "sim/model/contact_law.hpp"

namespace palpate::sim {

/// Sibille et al. 2002, as Kuroda et al. 2003 section 2 tells it: the colliding nodes of both bodies are
/// projected to the plane through their barycentre and perpendicular to their average normal. No stiffness
/// enters. Its scratch is a PrescribedScratch. Source: [Sibille2002].
extern const ContactLaw kSibille;

}  // namespace palpate::sim
