#include "analysis/report/rows_picture.hpp"

#include <fmt/core.h>

#include <cmath>

namespace palpate::analysis {
namespace {

constexpr double kPlot = 520, kMargin = 30, kTop = 22, kRow = 44, kBox = 16;

std::string row_marks(const PictureRow& row, const Axis& axis, double y) {
  const double from = axis.at(row.from), to = axis.at(row.to);
  std::string marks =
      label(axis.pixel_low - 12, y + (row.note.empty() ? 4 : -2), "end", row.name, "class=\"row\"");
  if (!row.note.empty()) marks += label(axis.pixel_low - 12, y + 14, "end", row.note, "class=\"tick\"");
  marks += line(from, y, to, y, "class=\"whisker\"") + line(from, y - 6, from, y + 6, "class=\"whisker\"") +
           line(to, y - 6, to, y + 6, "class=\"whisker\"");
  const std::string fill = fmt::format("fill=\"{}\" class=\"bar\"", colour(row.colour));
  if (row.box_to > row.box_from) {
    marks += rectangle(axis.at(row.box_from), y - kBox / 2, axis.at(row.box_to) - axis.at(row.box_from), kBox,
                       fill);
    return marks +
           line(axis.at(row.mark), y - kBox / 2, axis.at(row.mark), y + kBox / 2, "class=\"critical\"");
  }
  return marks + circle(axis.at(row.mark), y, 5.5, fill);
}

}  // namespace

std::string rows_picture(const std::string& id, const std::string& title, const std::string& description,
                         const std::vector<PictureRow>& rows, Axis axis, double reference) {
  std::vector<std::string> names;
  for (const PictureRow& row : rows) names.insert(names.end(), {row.name, row.note});
  axis.pixel_low = room_for(names, 170);
  axis.pixel_high = axis.pixel_low + kPlot;
  const double bottom = kTop + kRow * static_cast<double>(rows.size());
  std::string marks = horizontal_axis(axis, bottom, kTop - 10);
  if (!std::isnan(reference))
    marks += line(axis.at(reference), bottom, axis.at(reference), kTop - 10, "class=\"chance\"");
  for (std::size_t i = 0; i < rows.size(); ++i)
    marks += row_marks(rows[i], axis, kTop + kRow * (static_cast<double>(i) + 0.5));
  return picture(id, axis.pixel_high + kMargin, bottom + 52, title, description, marks);
}

}  // namespace palpate::analysis
