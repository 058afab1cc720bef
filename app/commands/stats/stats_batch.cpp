#include "app/commands/stats/stats_batch.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "analysis/description/statistic.hpp"
#include "analysis/statistics/statistics.hpp"
#include "analysis/words/words.hpp"
#include "app/command_line/bounded_json.hpp"
#include "app/command_line/output.hpp"
#include "app/commands/stats/read_csv.hpp"
#include "base/text/json_words.hpp"

namespace palpate::app {
namespace {

using nlohmann::ordered_json;

std::string short_text(const ordered_json& value) {
  return json_text(value, -1).substr(0, 60);
}

std::string cell_text(const std::string& column, const ordered_json& cell) {
  if (cell.is_string()) return cell.get<std::string>();
  if (cell.is_structured())
    throw std::invalid_argument(fmt::format("data.{} holds {} {}; accepted: numbers and texts", column,
                                            cell.is_array() ? "the array" : "the object", short_text(cell)));
  return cell.dump();
}

// {"level": [1, 2], "correct": [3, 4]} as a table.
analysis::DataTable table_of(const ordered_json& data) {
  if (!data.is_object() || data.empty()) {
    throw std::invalid_argument(
        fmt::format("data is {}; accepted: an object with an array for each column", short_text(data)));
  }
  analysis::DataTable table{.source = "data"};
  for (const auto& item : data.items()) {
    if (!item.value().is_array())
      throw std::invalid_argument(fmt::format("data.{} is {}; accepted: an array of the column's values",
                                              item.key(), short_text(item.value())));
    std::vector<std::string> column;
    for (const ordered_json& cell : item.value()) column.push_back(cell_text(item.key(), cell));
    if (!table.columns.empty() && column.size() != table.columns[0].size()) {
      throw std::invalid_argument(fmt::format("data.{} has {} values, data.{} has {}", item.key(),
                                              column.size(), table.names[0], table.columns[0].size()));
    }
    table.names.push_back(item.key());
    table.columns.push_back(std::move(column));
  }
  for (std::size_t row = 0; row < table.columns[0].size(); ++row)
    table.lines.push_back(static_cast<long>(row) + 1);
  return table;
}

// A text that a line gives under a key, which may stand in an array of one, as R writes it.
std::string text_at(const ordered_json& asked, const char* key, std::string_view example) {
  const ordered_json* value = &asked[key];
  if (value->is_array() && value->size() == 1) value = &value->front();
  if (value->is_string()) return value->get<std::string>();
  throw std::invalid_argument(fmt::format("\"{}\" is {}; accepted: a text, as in \"{}\": \"{}\"", key,
                                          short_text(asked[key]), key, example));
}

// The name that a line gives under "procedure", as it has been from the first version, or under "statistic".
const analysis::Statistic& statistic_of(const ordered_json& asked) {
  if (asked.contains("procedure") && asked.contains("statistic"))
    throw std::invalid_argument("both \"procedure\" and \"statistic\"; one of them is accepted");
  const char* key = asked.contains("statistic") ? "statistic" : "procedure";
  if (asked.contains(key)) return analysis::statistic_named(text_at(asked, key, "binomial"));
  throw std::invalid_argument(
      "\"procedure\" is missing; it names what to do, as in \"procedure\": \"binomial\"");
}

// What "header" says of the line's file.
FirstLine first_line_of(const ordered_json& asked) {
  if (!asked.contains("header")) return FirstLine::Unsaid;
  const ordered_json* value = &asked["header"];
  if (value->is_array() && value->size() == 1) value = &value->front();
  if (value->is_boolean()) return value->get<bool>() ? FirstLine::Names : FirstLine::Data;
  throw std::invalid_argument(fmt::format("\"header\" is {}; accepted: true or false", short_text(*value)));
}

ordered_json answer(ordered_json asked) {
  if (!asked.is_object())
    throw std::invalid_argument(fmt::format(
        "the line is {}; accepted: an object such as {{\"procedure\": \"critical\", \"trials\": 60}}",
        short_text(asked)));
  const analysis::Statistic& statistic = statistic_of(asked);
  analysis::DataTable table;
  if (asked.contains("data") && asked.contains("file")) {
    throw std::invalid_argument("both \"data\" and \"file\"; one of them is accepted");
  }
  if (asked.contains("data")) table = table_of(asked["data"]);
  if (asked.contains("file")) {
    table = read_csv(text_at(asked, "file", "answers.csv"), first_line_of(asked));
    tell_notes(table);
  }
  ordered_json result;
  if (asked.contains("id")) result["id"] = asked["id"];
  for (const char* key : {"procedure", "statistic", "data", "file", "header", "id"}) asked.erase(key);
  result.update(statistic.run(analysis::read_arguments(statistic, asked, std::move(table))).json);
  return result;
}

// What is wrong with a line, in one line.
ordered_json refusal(long line, const ordered_json& asked, const std::string& what) {
  ordered_json result;
  result["line"] = line;
  if (asked.is_object() && asked.contains("id")) result["id"] = asked["id"];
  result["error"] = what;
  return result;
}

// Whatever is thrown over a line is said in its place: the next line is answered all the same.
ordered_json answer_or_refusal(long line, const std::string& text) {
  ordered_json asked;
  try {
    asked = parse_bounded_json(text);
    return answer(asked);
  } catch (const nlohmann::json::exception& error) {
    return refusal(line, asked, fmt::format("not as expected: {}", base::json_words(error.what())));
  } catch (const std::invalid_argument& error) {
    return refusal(line, asked, error.what());
  } catch (const std::bad_alloc&) {
    return refusal(line, asked, "more memory is needed than there is");
  } catch (const std::exception& error) {
    return refusal(line, asked, fmt::format("cannot be computed: {}", error.what()));
  }
}

long answer_all(std::istream& in, const std::string& source) {
  std::string text;
  long refused = 0;
  for (long line = 1; std::getline(in, text); ++line) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    const ordered_json result = answer_or_refusal(line, text);
    if (result.contains("error")) ++refused;
    fmt::print("{}\n", json_text(result, -1));
    std::fflush(stdout);
  }
  if (in.bad()) throw std::system_error(std::make_error_code(std::errc::io_error), source);
  return refused;
}

}  // namespace

void run_batch(const std::string& file) {
  long refused = 0;
  if (file == "-") {
    refused = answer_all(std::cin, "standard input");
  } else {
    if (std::filesystem::is_directory(file)) {
      throw std::invalid_argument(file + " is a folder; a file of JSON lines is accepted");
    }
    std::ifstream in(file);
    if (!in) throw std::invalid_argument(file + ": cannot be opened: no such file, or no right to read it");
    refused = answer_all(in, file);
  }
  if (refused > 0) {
    throw std::invalid_argument(analysis::counted(refused, "line", "lines") +
                                " could not be answered; see \"error\" in the output");
  }
}

}  // namespace palpate::app
