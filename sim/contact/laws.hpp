#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/model/contact_law.hpp"

namespace palpate::sim {

/// Every contact law, in the order in which users see them.
std::span<const ContactLaw* const> contact_laws();

/// The law of a name that the scene reader has accepted. Throws std::invalid_argument for any other.
const ContactLaw& contact_law(std::string_view name);

/// "none, sibille or kuroda".
std::string choice_of_contact_models();

}  // namespace palpate::sim
