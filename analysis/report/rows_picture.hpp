#pragma once

#include <string>
#include <vector>

#include "analysis/report/svg.hpp"

namespace palpate::analysis {

// Pictures with a row for each thing that is compared: one layout for what the report shows of interval
// orders, response times and the loop's timing.

struct PictureRow {
  std::string name{};                   // at the left
  std::string note{};                   // below it, small
  double from = 0.0, to = 0.0;          // a thin line, e.g. an interval or the whole range
  double box_from = 0.0, box_to = 0.0;  // a box, e.g. the quartiles; none where they are equal
  double mark = 0.0;                    // a dot, e.g. the estimate
  std::size_t colour = 0;
};

/// @param reference  value with a dashed line, within the axis; NaN: none
std::string rows_picture(const std::string& id, const std::string& title, const std::string& description,
                         const std::vector<PictureRow>& rows, Axis axis, double reference);

}  // namespace palpate::analysis
