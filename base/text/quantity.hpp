#pragma once

#include <string>
#include <string_view>

namespace palpate::base {

enum class Dimension { Length, Pressure, Time, Force, Angle, Stiffness, Fraction };

/// A quantity written with its unit, in SI: ("5 mm", Length) -> 0.005. A decimal point, one unit, finite.
/// Throws std::invalid_argument that names what was found and the units that are accepted.
double parse_quantity(std::string_view text, Dimension dimension);

/// The units that a quantity may have: "m, cm, mm, um".
std::string unit_names(Dimension dimension);

/// What a quantity is one of, for people: "length".
std::string_view in_words(Dimension dimension);

/// "m"; empty for a fraction.
std::string_view si_unit(Dimension dimension);

/// Metres of one unit of length by its name alone: "mm" -> 0.001.
double metres_per_unit(std::string_view unit);

}  // namespace palpate::base
