#pragma once

#include "sim/view/picture.hpp"

namespace palpate::sim {

/// Matplotlib's viridis: equal steps look equal, and lightness rises throughout, so that it reads in black and
/// white and by colour-blind people. Source: Smith and van der Walt 2015, bids.github.io/colormap.
/// @param share  from 0 (dark violet) to 1 (yellow); beyond them the nearer end
Colour viridis(double share);

}  // namespace palpate::sim
