#pragma once

#include "sim/model/contact_law.hpp"

namespace palpate::sim {

/// Bodies do not act on each other: nothing is prepared, and nothing is solved.
extern const ContactLaw kNone;

}  // namespace palpate::sim
