#include "analysis/description/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "analysis/description/read_number.hpp"
#include "analysis/description/statistic.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {
namespace {

using nlohmann::json;

[[noreturn]] void refuse(const Input& input, const json& found, std::string_view accepted) {
  const std::string_view kind = found.is_array() ? "the array " : found.is_object() ? "the object " : "";
  const std::string text = found.is_string()
                               ? "'" + found.get<std::string>() + "'"
                               : found.dump(-1, ' ', false, json::error_handler_t::replace).substr(0, 60);
  throw std::invalid_argument(fmt::format("{} is {}{}; accepted: {}", input.name, kind, text, accepted));
}

// A number given as such, or as the text that a person wrote.
template <typename Read>
auto read_value(const json& value, const Read& read) -> decltype(read(std::string_view())) {
  if (value.is_string()) return read(value.get_ref<const std::string&>());
  if (value.is_number()) return read(value.dump());
  return std::nullopt;
}

template <typename Read>
json read_list(const Input& input, const json& value, const Read& read, std::string_view accepted) {
  json items = json::array();
  if (value.is_string()) {
    const std::string_view text = value.get_ref<const std::string&>();
    for (std::size_t first = 0; first <= text.size();) {
      const std::size_t comma = std::min(text.find(',', first), text.size());
      items.push_back(std::string(text.substr(first, comma - first)));
      first = comma + 1;
    }
  } else if (value.is_array()) {
    items = value;
  }
  json read_items = json::array();
  for (const json& item : items) {
    const auto number = read_value(item, read);
    if (!number) refuse(input, value, accepted);
    read_items.push_back(*number);
  }
  if (read_items.empty()) refuse(input, value, accepted);
  return read_items;
}

json read_choice(const Input& input, const json& value) {
  const bool known =
      value.is_string() && std::ranges::find(input.choices, value.get<std::string>()) != input.choices.end();
  if (!known) refuse(input, value, fmt::format("{}", fmt::join(input.choices, ", ")));
  return value;
}

template <typename Read>
json read_single(const Input& input, const json& value, const Read& read, std::string_view accepted) {
  const auto number = read_value(value, read);
  if (!number) refuse(input, value, accepted);
  return *number;
}

bool takes_several(Input::Kind kind) {
  return kind == Input::Kind::Counts || kind == Input::Kind::Numbers || kind == Input::Kind::PValues;
}

// Numbers are texts as well: lapse is free or 0.02.
json read_text(const Input& input, const json& value) {
  if (value.is_number()) return value.dump();
  if (!value.is_string()) refuse(input, value, "a text or a number");
  return value;
}

json read_input(const Input& input, const json& value) {
  if (value.is_array() && value.size() == 1 && !takes_several(input.kind))  // as R writes one value
    return read_input(input, value.front());
  switch (input.kind) {
    case Input::Kind::Count:
      return read_single(input, value, read_count, fmt::format("a whole number {}", kCountBounds));
    case Input::Kind::Seed:
      return read_single(input, value, read_seed, "a whole number from 0 to 9223372036854775807");
    case Input::Kind::Number:
      return read_single(input, value, read_number,
                         fmt::format("a finite number such as 0.25: {}", kMagnitudeBounds));
    case Input::Kind::Fraction:
      return read_single(input, value, read_fraction,
                         fmt::format("a fraction such as 1/2 or a number such as 0.5: {}", kMagnitudeBounds));
    case Input::Kind::Choice:
      return read_choice(input, value);
    case Input::Kind::Counts:
      return read_list(input, value, read_count,
                       fmt::format("whole numbers {} with commas between them", kCountBounds));
    case Input::Kind::Numbers:
      return read_list(input, value, read_number,
                       fmt::format("numbers with commas between them, each {}", kMagnitudeBounds));
    case Input::Kind::PValues:
      return read_list(input, value, read_finite, "numbers from 0 to 1 with commas between them");
    case Input::Kind::Switch:
      if (!value.is_boolean()) refuse(input, value, "true or false");
      return value;
    case Input::Kind::Text:
      break;
  }
  return read_text(input, value);
}

void refuse_unknown(const Statistic& statistic, const json& given) {
  std::vector<std::string> names;
  for (const Input& input : statistic.inputs) names.push_back(input.name);
  for (const auto& item : given.items()) {
    if (std::ranges::find(names, item.key()) != names.end()) continue;
    throw std::invalid_argument(
        fmt::format("{} takes no '{}'; accepted: {}", statistic.name, item.key(), listed(names)));
  }
}

void check_columns(const Data& data, const DataTable& table) {
  for (const InputColumn& column : data.columns) {
    if (!column.optional) text_column(table, column.name);
  }
}

void check_data(const Statistic& statistic, const DataTable& table) {
  const Data& data = statistic.data;
  if (table.columns.empty()) {
    if (data.shape == Data::Shape::None || data.optional) return;
    throw std::invalid_argument(fmt::format("{} needs data: {}", statistic.name, data.meaning));
  }
  if (data.shape == Data::Shape::None) throw std::invalid_argument(statistic.name + " takes no data");
  if (rows(table) == 0) throw std::invalid_argument(table.source + ": no rows of data");
  if (data.shape == Data::Shape::Columns) check_columns(data, table);
  if (data.shape == Data::Shape::Matrix && table.columns.size() < 2) {
    throw std::invalid_argument(
        fmt::format("{}: one column; {}{}", table.source, data.meaning, separator_hint(table)));
  }
}

}  // namespace

bool Arguments::given(std::string_view name) const {
  return values.contains(name);
}
long Arguments::count(std::string_view name) const {
  return values.at(std::string(name)).get<long>();
}
double Arguments::number(std::string_view name) const {
  return values.at(std::string(name)).get<double>();
}
std::string Arguments::text(std::string_view name) const {
  return values.at(std::string(name));
}
std::vector<long> Arguments::counts(std::string_view name) const {
  return values.at(std::string(name));
}
std::vector<double> Arguments::numbers(std::string_view name) const {
  return values.at(std::string(name));
}
bool Arguments::is_on(std::string_view name) const {
  return values.value(std::string(name), false);
}
Side Arguments::side() const {
  return side_from_name(text("side"));
}
double Arguments::level() const {
  return number("level");
}

Arguments read_arguments(const Statistic& statistic, const json& given, DataTable table) {
  refuse_unknown(statistic, given);
  Arguments arguments;
  arguments.values = json::object();
  for (const Input& input : statistic.inputs) {
    if (given.contains(input.name) && !given.at(input.name).is_null()) {
      arguments.values[input.name] = read_input(input, given.at(input.name));
    } else if (input.usual) {
      arguments.values[input.name] = read_input(input, *input.usual);
    } else if (!input.optional && input.kind != Input::Kind::Switch) {
      throw std::invalid_argument(fmt::format("{} needs {}: {}", statistic.name, input.name, input.meaning));
    }
  }
  check_data(statistic, table);
  arguments.table = std::move(table);
  return arguments;
}

}  // namespace palpate::analysis
