#include "devices/scripted/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "base/text/counted.hpp"
#include "base/text/csv.hpp"

namespace palpate::devices {
namespace {

using base::CsvRow;

constexpr std::string_view kAccepted =
    "a path has the columns time_s and, for each probe NAME, NAME.x_m, NAME.y_m, NAME.z_m";

[[noreturn]] void refuse(const std::string& file, long line, std::string_view what) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", file, line, what));
}

/// The probe's name in "NAME.x_m"; empty where a column is not called so.
std::string_view probe_of(std::string_view column, std::string_view axis) {
  return column.ends_with(axis) ? column.substr(0, column.size() - axis.size()) : std::string_view{};
}

std::vector<ProbePath> read_names(const CsvRow& names, const std::string& file) {
  if (names.fields.front() != "time_s")
    refuse(file, names.line, fmt::format("the first column is \"{}\"; {}", names.fields.front(), kAccepted));
  if (names.fields.size() % 3 != 1 || names.fields.size() == 1)
    refuse(file, names.line,
           fmt::format("{}; {}", base::counted(std::ssize(names.fields), "column", "columns"), kAccepted));
  std::vector<ProbePath> paths;
  for (std::size_t first = 1; first < names.fields.size(); first += 3) {
    const std::string probe(probe_of(names.fields[first], ".x_m"));
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const std::string& column = names.fields[first + axis];
          probe.empty() || column != fmt::format("{}.{}_m", probe, "xyz"[axis]))
        refuse(file, names.line, fmt::format("column {} is \"{}\"; {}", first + axis + 1, column, kAccepted));
    if (std::ranges::find(paths, probe, &ProbePath::probe) != paths.end())
      refuse(file, names.line, fmt::format("the probe \"{}\" is there twice", probe));
    paths.push_back({.probe = probe});
  }
  return paths;
}

double read_number(const std::string& field, const CsvRow& names, std::size_t column, long line,
                   const std::string& file) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || !std::isfinite(value))
    refuse(
        file, line,
        fmt::format("{} is \"{}\"; a finite number is accepted, e.g. 0.0025", names.fields[column], field));
  return value;
}

void add_sample(std::vector<ProbePath>& paths, const CsvRow& row, const CsvRow& names,
                const std::string& file) {
  if (row.fields.size() != names.fields.size())
    refuse(file, row.line,
           fmt::format("{} fields; the first line has {}", row.fields.size(), names.fields.size()));
  const auto number = [&](std::size_t column) {
    return read_number(row.fields[column], names, column, row.line, file);
  };
  const double time = number(0);
  if (!paths.front().times.empty() && time <= paths.front().times.back())
    refuse(file, row.line,
           fmt::format("time_s is {:g} after {:g}; times must ascend", time, paths.front().times.back()));
  for (std::size_t k = 0; k < paths.size(); ++k) {
    paths[k].times.push_back(time);
    paths[k].places.emplace_back(number(3 * k + 1), number(3 * k + 2), number(3 * k + 3));
  }
}

}  // namespace

sim::Vec3 place_at(const ProbePath& path, double time) {
  const auto after = std::ranges::upper_bound(path.times, time);
  if (after == path.times.begin()) return path.places.front();
  if (after == path.times.end()) return path.places.back();
  const auto k = after - path.times.begin();
  const double share = (time - path.times[k - 1]) / (path.times[k] - path.times[k - 1]);
  return path.places[k - 1] + share * (path.places[k] - path.places[k - 1]);
}

std::vector<ProbePath> parse_path(std::string_view text, const std::string& file) {
  const std::vector<CsvRow> rows = base::split_csv(text, file);
  if (rows.size() < 2) throw std::invalid_argument(fmt::format("{}: no samples; {}", file, kAccepted));
  std::vector<ProbePath> paths = read_names(rows.front(), file);
  for (std::size_t k = 1; k < rows.size(); ++k) add_sample(paths, rows[k], rows.front(), file);
  return paths;
}

}  // namespace palpate::devices
