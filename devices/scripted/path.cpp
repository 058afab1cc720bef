#include "devices/scripted/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "base/text/csv.hpp"

namespace palpate::devices {
namespace {

using base::CsvRow;

constexpr std::string_view kAccepted =
    "a path has the columns time_s and, for each probe NAME, NAME.x_m, NAME.y_m, NAME.z_m and, where it turns, "
    "NAME.rx_rad, NAME.ry_rad, NAME.rz_rad";

constexpr std::array<std::string_view, 6> kEndings{".x_m", ".y_m", ".z_m", ".rx_rad", ".ry_rad", ".rz_rad"};

[[noreturn]] void refuse(const std::string& file, long line, std::string_view what) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", file, line, what));
}

/// What a column holds: a component of which probe's displacement (0 to 2) or rotation (3 to 5).
struct Column {
  std::string_view probe{};
  std::size_t component = 0;

  bool operator==(const Column&) const = default;
};

std::vector<Column> read_names(const CsvRow& names, const std::string& file) {
  if (names.fields.front() != "time_s")
    refuse(file, names.line, fmt::format("the first column is \"{}\"; {}", names.fields.front(), kAccepted));
  if (names.fields.size() == 1) refuse(file, names.line, fmt::format("1 column; {}", kAccepted));
  std::vector<Column> columns;
  for (std::size_t i = 1; i < names.fields.size(); ++i) {
    const std::string_view name = names.fields[i];
    const auto ending = std::ranges::find_if(kEndings, [&](auto one) { return name.ends_with(one); });
    if (ending == kEndings.end() || name.size() == ending->size())
      refuse(file, names.line, fmt::format("column {} is \"{}\"; {}", i + 1, name, kAccepted));
    const Column column{name.substr(0, name.size() - ending->size()),
                        static_cast<std::size_t>(ending - kEndings.begin())};
    if (std::ranges::find(columns, column) != columns.end())
      refuse(file, names.line, fmt::format("the column \"{}\" is there twice; accepted: once", name));
    columns.push_back(column);
  }
  return columns;
}

/// The probes that the columns name. Refuses a displacement or a rotation of which a component is missing.
std::vector<ProbePath> probes_of(const std::vector<Column>& columns, long line, const std::string& file) {
  std::vector<ProbePath> paths;
  for (const Column& column : columns)
    if (std::ranges::find(paths, column.probe, &ProbePath::probe) == paths.end())
      paths.push_back({.probe = std::string(column.probe), .line = line});
  for (const ProbePath& path : paths) {
    const auto has = [&](std::size_t component) {
      return std::ranges::find(columns, Column{path.probe, component}) != columns.end();
    };
    const bool turns = has(3) || has(4) || has(5);
    for (std::size_t component = 0; component < (turns ? 6U : 3U); ++component)
      if (!has(component))
        refuse(file, line,
               fmt::format("the column \"{}{}\" is missing; {}", path.probe, kEndings[component], kAccepted));
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

void add_sample(std::vector<ProbePath>& paths, const std::vector<Column>& columns, const CsvRow& row,
                const CsvRow& names, const std::string& file) {
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
  for (ProbePath& path : paths) {
    path.times.push_back(time);
    path.places.emplace_back(sim::Vec3::Zero());
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    ProbePath& path = *std::ranges::find(paths, columns[i].probe, &ProbePath::probe);
    const std::size_t component = columns[i].component;
    if (component >= 3) path.rotations.resize(path.times.size(), sim::Vec3(sim::Vec3::Zero()));
    (component < 3 ? path.places : path.rotations).back()[static_cast<Eigen::Index>(component % 3)] =
        number(i + 1);
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
  const CsvRow& names = rows.front();
  const std::vector<Column> columns = read_names(names, file);
  std::vector<ProbePath> paths = probes_of(columns, names.line, file);
  for (std::size_t k = 1; k < rows.size(); ++k) add_sample(paths, columns, rows[k], names, file);
  return paths;
}

}  // namespace palpate::devices
