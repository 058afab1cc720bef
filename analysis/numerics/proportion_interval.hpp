#pragma once

#include "analysis/numerics/result.hpp"

namespace palpate::analysis {

/// Interval for a proportion that covers it with at least `level`, whatever it is: the proportions that the
/// exact binomial tests of both sides, each at (1 - level)/2, do not reject. Source: [ClopperPearson1934].
Interval clopper_pearson(long correct, long trials, double level = 0.95);

/// Score interval for a proportion: shorter, with a mean coverage near `level` and a least one below it.
/// Source: [Wilson1927], without continuity correction.
Interval wilson(long correct, long trials, double level = 0.95);

/// Equal-tailed interval of the posterior Beta(k + 1/2, n - k + 1/2), with the ends 0 at k = 0 and 1 at k =
/// n: mean coverage near `level`, like Wilson's. Source: [BrownCaiDasGupta2001] section 3.1.2 and 4.1.2.
Interval jeffreys(long correct, long trials, double level = 0.95);

/// One-sided exact bounds: the interval that belongs to a one-sided test at 1 - level. Greater gives
/// (lower, 1), Less (0, upper), TwoSided the same as clopper_pearson.
Interval clopper_pearson_bound(long correct, long trials, Side side, double level = 0.95);

}  // namespace palpate::analysis
