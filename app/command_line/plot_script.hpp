#pragma once

#include <string>

#include "app/command_line/plot.hpp"

namespace palpate::app {

/// What gnuplot reads to draw the plot. @param svg  else PNG
std::string plot_script(const Plot& plot, bool svg);

}  // namespace palpate::app
