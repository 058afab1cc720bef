#pragma once

#include <optional>

#include "sim/view/image.hpp"
#include "sim/view/paint.hpp"
#include "sim/view/picture.hpp"

namespace palpate::sim {

/// Width of the strip beside a picture that a legend takes [pixel].
int legend_width(int height);

/// The drawn picture with its words: the length at the scale bar and, in a strip on the right, the legend.
/// Throws std::runtime_error as Lettering does.
Image annotated(const Image& drawn, const Picture& picture, const std::optional<Legend>& legend);

}  // namespace palpate::sim
