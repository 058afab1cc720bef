#pragma once

#include "analysis/psychometric/fit.hpp"

namespace palpate::analysis {

// What a psychometric function says of a person, from its two parameters (alpha, beta on the scale u).

/// The level x at which F = p. For a step its place, NaN where flat.
double level_at(Shape shape, double alpha, double beta, double p);

/// dF/dx at the level where F = p: of F itself, not scaled by 1 - guess - lapse. Infinite for a step, 0 where
/// flat.
double slope_at(Shape shape, double alpha, double beta, double p);

/// Half the distance between the levels at which F = 0.25 and F = 0.75: the just noticeable difference where
/// answers tell which of two felt more. 0 for a step, infinite where flat.
double half_distance(Shape shape, double alpha, double beta);

}  // namespace palpate::analysis
