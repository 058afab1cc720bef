#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "base/files/sha256.hpp"
#include "base/text/toml_reader.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials {
namespace {

using base::Dimension;
using base::TomlReader;
using Words = std::initializer_list<std::string_view>;

constexpr std::int64_t kMostTrials = 1000;  // of one cell in one sitting: more is a slip of the keyboard
constexpr std::int64_t kMostExaminees = 100000;
constexpr double kLeastTime = 0.5;  // of an interval [s]

TomlReader section(TomlReader& reader, std::string_view key, std::string_view accepted) {
  reader.required(key, accepted);
  return *reader.table(key);
}

/// One word of `accepted`; words of `later` are known to the design but not to this version.
std::string word(TomlReader& reader, std::string_view key, Words accepted, Words later = {}) {
  reader.required(key, fmt::format("accepted: {}", fmt::join(accepted, ", ")));
  std::string found = *reader.text(key);
  if (std::ranges::find(accepted, found) != accepted.end()) return found;
  const bool known = std::ranges::find(later, found) != later.end();
  reader.refuse(key, fmt::format("found \"{}\"{}, accepted: {}", found,
                                 known ? ", which is not in this version" : "", fmt::join(accepted, ", ")));
}

int whole_number(TomlReader& reader, std::string_view key, std::int64_t least, std::int64_t most) {
  reader.required(key, fmt::format("accepted: a whole number from {} to {}", least, most));
  const std::int64_t found = *reader.integer(key);
  if (found < least || found > most)
    reader.refuse(key, fmt::format("found {}, accepted: a whole number from {} to {}", found, least, most));
  return static_cast<int>(found);
}

void check_name(const TomlReader& reader, std::string_view key, std::string_view name) {
  constexpr std::string_view kAccepted = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  if (name.empty() || name.find_first_not_of(kAccepted) != std::string_view::npos)
    reader.refuse(
        key, fmt::format("found the name \"{}\", accepted: letters, digits, hyphen and underscore", name));
}

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

/// A value as an override takes it.
std::string as_toml(const TomlReader& reader, std::string_view key, const toml::node& node) {
  if (node.is_table())
    reader.refuse(
        key,
        "found a table, accepted: a scene's key in quotes, such as \"bodies.prostate.young_modulus\" = "
        "\"5 MPa\"");
  std::ostringstream text;
  node.visit([&](const auto& value) { text << toml::toml_formatter{value}; });
  return text.str();
}

std::vector<Condition> read_conditions(TomlReader& reader) {
  TomlReader all = section(reader, "conditions", "accepted: one table [conditions.NAME] a condition");
  std::vector<Condition> conditions;
  for (const std::string& name : all.keys()) {
    check_name(all, name, name);
    TomlReader table = *all.table(name);
    Condition condition{.name = name, .overrides = {}, .line = line_of(*all.node(name))};
    for (const std::string& key : table.keys())
      condition.overrides.push_back({key, as_toml(table, key, *table.node(key))});
    conditions.push_back(std::move(condition));
  }
  return conditions;
}

Factor read_factor(TomlReader& reader, const std::string& key) {
  const toml::node& node = *reader.node(key);
  Factor factor{.key = key, .levels = {}, .values = {}, .line = line_of(node)};
  for (const toml::node& item :
       reader.as_array(key, node, "the levels as an array, such as [\"kuroda\", \"sibille\"]")) {
    const std::string value = as_toml(reader, key, item);
    const std::string level = item.is_string() ? *item.value<std::string>() : value;
    if (std::ranges::find(factor.levels, level) != factor.levels.end())
      reader.refuse(key, fmt::format("holds {} twice; accepted: every level once", value));
    factor.levels.push_back(level);
    factor.values.push_back(value);
  }
  if (factor.levels.size() < 2)
    reader.refuse(key,
                  "has fewer than 2 levels; accepted: 2 or more (what does not vary belongs into the scene)");
  return factor;
}

std::size_t condition_index(TomlReader& reader, std::string_view key, const Protocol& protocol,
                            const std::string& name) {
  const auto found = std::ranges::find(protocol.conditions, name, &Condition::name);
  if (found != protocol.conditions.end())
    return static_cast<std::size_t>(found - protocol.conditions.begin());
  std::vector<std::string> names;
  for (const Condition& condition : protocol.conditions) names.push_back(condition.name);
  reader.refuse(key, fmt::format("\"{}\" is no condition of this protocol; accepted: {}", name,
                                 fmt::join(names, ", ")));
}

void read_task(TomlReader task, Protocol& protocol) {
  protocol.task =
      word(task, "kind", {"2IFC"},
           {"2AFC", "yes/no", "same-different", "ABX", "oddity", "magnitude estimation", "rating"});
  task.required("pair", "accepted: two conditions such as [\"soft\", \"hard\"]");
  const auto pair = *task.texts("pair");
  if (pair.size() != 2 || pair[0] == pair[1])
    task.refuse("pair", "accepted: two different conditions such as [\"soft\", \"hard\"]");
  for (std::size_t i = 0; i < 2; ++i) protocol.pair[i] = condition_index(task, "pair", protocol, pair[i]);
  const std::string correct = task.required_text("correct");
  protocol.correct = condition_index(task, "correct", protocol, correct);
  if (std::ranges::find(pair, correct) == pair.end())
    task.refuse("correct",
                fmt::format("\"{}\" is not in the pair; accepted: {}", correct, fmt::join(pair, ", ")));
  task.refuse_unknown();
}

void read_procedure_and_order(TomlReader procedure, TomlReader order, Protocol& protocol) {
  protocol.procedure = word(procedure, "kind", {"constant"}, {"staircase", "QUEST+"});
  protocol.trials_per_examinee_per_cell =
      whole_number(procedure, "trials_per_examinee_per_cell", 1, kMostTrials);
  procedure.refuse_unknown();
  protocol.cell_order = word(order, "cells", {"shuffled"}, {"blocked", "balanced"});
  protocol.interval_order = word(order, "interval", {"coin", "balanced"});
  if (protocol.interval_order == "balanced" && protocol.trials_per_examinee_per_cell % 2 != 0)
    order.refuse("interval", fmt::format("balances the two orders, and {} trials of a cell cannot be halved; "
                                         "accepted: an even trials_per_examinee_per_cell, or \"coin\"",
                                         protocol.trials_per_examinee_per_cell));
  order.refuse_unknown();
}

void read_exploration(TomlReader reader, Exploration& rule) {
  const auto& presses = reader.as_array(
      "presses", reader.required("presses", "accepted: the least and the most, such as [1, 5]"),
      "the least and the most");
  const bool numbers = presses.size() == 2 && presses[0].is_integer() && presses[1].is_integer();
  const std::int64_t least = numbers ? *presses[0].value<std::int64_t>() : 0;
  const std::int64_t most = numbers ? *presses[1].value<std::int64_t>() : 0;
  if (least < 1 || most < least || most > kMostTrials)
    reader.refuse(
        "presses",
        fmt::format("{}; accepted: the least and the most, 1 <= least <= most, such as [1, 5]",
                    numbers ? fmt::format("found [{}, {}]", least, most) : "found no two whole numbers"));
  rule.least_presses = static_cast<int>(least);
  rule.most_presses = static_cast<int>(most);
  rule.min_depth = reader.required_quantity("min_depth", Dimension::Length, "\"3 mm\"");
  if (rule.min_depth < 0.0)
    reader.refuse("min_depth", "is negative; accepted: a depth >= 0 such as \"3 mm\"");
  rule.max_time = reader.required_quantity("max_time", Dimension::Time, "\"10 s\"");
  if (rule.max_time < kLeastTime)
    reader.refuse(
        "max_time",
        fmt::format("is too short for a press; accepted: {:g} s or more, such as \"10 s\"", kLeastTime));
  reader.refuse_unknown();
}

/// Looks at the results before the sample is complete, by how many examinees are complete then.
void read_looks(TomlReader& reader, Protocol& protocol) {
  AnalysisPlan& plan = protocol.analysis;
  if (protocol.interval_order != "coin")
    reader.refuse("looks",
                  "are planned for the exact binomial test; accepted with order.interval = \"coin\" only");
  if (plan.side == "two-sided")
    reader.refuse("looks", "are planned for one-sided tests; accepted with side = \"greater\" or \"less\"");
  int before = 0;
  for (const toml::node& item : reader.as_array("looks", *reader.node("looks"), "numbers of examinees")) {
    const std::int64_t at = item.is_integer() ? *item.value<std::int64_t>() : 0;
    if (at <= before || at > protocol.planned_examinees)
      reader.refuse("looks",
                    fmt::format("accepted: ascending numbers of examinees, at most the {} planned, the last "
                                "of them all planned ones, such as [5, 10, 15]",
                                protocol.planned_examinees));
    plan.looks.push_back(before = static_cast<int>(at));
  }
  if (before != protocol.planned_examinees)
    reader.refuse("looks", fmt::format("ends with {}; accepted: the last look is at all {} planned examinees",
                                       before, protocol.planned_examinees));
  plan.spending = word(reader, "spending", {"obrien-fleming", "pocock"});
}

void read_analysis(TomlReader reader, Protocol& protocol) {
  AnalysisPlan& plan = protocol.analysis;
  plan.primary = word(reader, "primary", {"paired-comparison", "order-randomisation"});
  const bool coin = protocol.interval_order == "coin";
  if (coin != (plan.primary == "paired-comparison"))
    reader.refuse(
        "primary",
        coin ? "found \"order-randomisation\", which is for balanced orders; accepted with order.interval "
               "= \"coin\": \"paired-comparison\", which is the same test there"
             : "found \"paired-comparison\", which holds for coin flips only; accepted with "
               "order.interval = \"balanced\": \"order-randomisation\"");
  plan.alpha = reader.required_number("alpha");
  if (!(plan.alpha > 0.0 && plan.alpha < 1.0))
    reader.refuse("alpha", fmt::format("found {}, accepted: greater than 0 and less than 1", plan.alpha));
  plan.side = word(reader, "side", {"greater", "less", "two-sided"});
  if (reader.has("between_models")) {
    plan.between_models = word(reader, "between_models", {"sign-flip", "wilcoxon"});
    if (protocol.cells.size() != 2)
      reader.refuse(
          "between_models",
          fmt::format("compares two cells, and the factors of this protocol make {}; accepted: one factor "
                      "with two levels, or no between_models",
                      protocol.cells.size()));
  }
  if (reader.has("looks")) read_looks(reader, protocol);
  reader.refuse_unknown();
}

DuringInterval read_display(TomlReader reader) {
  const std::string found = word(reader, "during_interval", {"hidden", "probe", "organs"});
  reader.refuse_unknown();
  for (const DuringInterval display : {DuringInterval::Probe, DuringInterval::Organs})
    if (to_string(display) == found) return display;
  return DuringInterval::Hidden;
}

}  // namespace

Protocol parse_protocol(std::string text, const std::filesystem::path& file) {
  const toml::table root = base::parse_toml(text, file.string());
  TomlReader reader(root, file.string());
  Protocol protocol;
  protocol.file = file;
  protocol.sha256 = base::sha256_hex(text);
  protocol.text = std::move(text);
  protocol.name = reader.required_text("name");
  check_name(reader, "name", protocol.name);
  protocol.scene_file = file.parent_path() / reader.required_text("scene");
  protocol.question = reader.required_text("question");
  if (protocol.question.empty()) reader.refuse("question", "is empty; accepted: what the examinee is asked");
  protocol.conditions = read_conditions(reader);
  if (auto factors = reader.table("factors"))
    for (const std::string& key : factors->keys()) protocol.factors.push_back(read_factor(*factors, key));
  expand(protocol);
  read_task(section(reader, "task", "accepted: a table [task]"), protocol);
  read_procedure_and_order(section(reader, "procedure", "accepted: a table [procedure]"),
                           section(reader, "order", "accepted: a table [order]"), protocol);
  read_exploration(section(reader, "exploration", "accepted: a table [exploration]"), protocol.exploration);
  protocol.during_interval = read_display(section(reader, "display", "accepted: a table [display]"));
  TomlReader sample = section(reader, "sample", "accepted: a table [sample]");
  protocol.planned_examinees = whole_number(sample, "planned_examinees", 1, kMostExaminees);
  sample.refuse_unknown();
  read_analysis(section(reader, "analysis", "accepted: a table [analysis]"), protocol);
  reader.refuse_unknown();
  return protocol;
}

}  // namespace palpate::trials
