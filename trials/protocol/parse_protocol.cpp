#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "base/files/sha256.hpp"
#include "base/text/toml_reader.hpp"
#include "trials/protocol/protocol.hpp"
#include "trials/protocol/protocol_keys.hpp"

namespace palpate::trials {
namespace {

using base::Dimension;
using base::TomlReader;

constexpr std::int64_t kMostPresses = 1000;  // in an interval: more is a slip of the keyboard

TomlReader section(TomlReader& reader, std::string_view key, std::span<const base::Key> keys) {
  TomlReader table = reader.table(key, keys);
  table.refuse_later(later_keys());
  return table;
}

void check_name(const TomlReader& reader, std::string_view key, std::string_view name) {
  if (!is_name(name))
    reader.refuse(key, fmt::format("found the name \"{}\", accepted: {}", name, kNamesAccepted));
}

/// Of a factor's level, which stands in tables and plots.
void check_level_name(const TomlReader& reader, std::string_view name) {
  if (name.empty() || std::ranges::any_of(name, [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
    reader.refuse(name, "a level's name is empty or holds a control character; accepted: any words");
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

/// The scene overrides that a table of a condition or of a factor's level holds.
std::vector<sim::Override> read_overrides(TomlReader table) {
  std::vector<sim::Override> overrides;
  for (const std::string& key : table.keys())
    overrides.push_back({key, as_toml(table, key, table.other(key))});
  return overrides;
}

std::vector<Condition> read_conditions(TomlReader all) {
  std::vector<Condition> conditions;
  for (const std::string& name : all.keys()) {
    check_name(all, name, name);
    conditions.push_back({.name = name,
                          .overrides = read_overrides(all.table(name, condition_keys())),
                          .line = all.line_of(name)});
  }
  return conditions;
}

/// Levels without names, `"contact.model" = ["kuroda", "sibille"]`: each is called as its value reads.
std::vector<FactorLevel> read_values(TomlReader& reader, const std::string& key) {
  std::vector<FactorLevel> levels;
  for (const toml::node& item : *reader.other(key).as_array()) {
    const std::string value = as_toml(reader, key, item);
    levels.push_back({.name = item.is_string() ? *item.value<std::string>() : value,
                      .overrides = {{.key = key, .value = value}}});
  }
  return levels;
}

/// Levels with names: a value of the scene's key that the factor is called after, or, where the factor has a
/// name of its own, a table of scene keys.
std::vector<FactorLevel> read_named_levels(TomlReader& reader, const std::string& key) {
  TomlReader table = reader.table_at(key, reader.other(key), level_keys());
  const bool is_scene_key = key.find('.') != std::string::npos;
  std::vector<FactorLevel> levels;
  for (const std::string& name : table.keys()) {
    check_level_name(table, name);
    const toml::node& node = table.other(name);
    if (is_scene_key) {
      levels.push_back({.name = name, .overrides = {{.key = key, .value = as_toml(table, name, node)}}});
      continue;
    }
    if (!node.is_table())
      table.refuse(name,
                   fmt::format("\"{}\" is no key of a scene, so each of its levels is a table of scene "
                               "keys; accepted: {} = {{ {} = {{ \"bodies.prostate.offset\" = [..] }}, "
                               ".. }}, or a scene's key in quotes: \"bodies.prostate.offset\" = {{ {} = "
                               "[..], .. }}",
                               key, key, name, name));
    levels.push_back(
        {.name = name, .overrides = read_overrides(table.table_at(name, node, condition_keys()))});
  }
  return levels;
}

Factor read_factor(TomlReader& reader, const std::string& key) {
  const toml::node& node = reader.other(key);
  if (!node.is_table()) reader.as_array(key, node);  // refuses what is neither
  Factor factor{.name = key,
                .levels = node.is_array() ? read_values(reader, key) : read_named_levels(reader, key),
                .line = reader.line_of(key)};
  if (factor.levels.empty()) reader.refuse(key, "has no level; accepted: one or more");
  for (const FactorLevel& level : factor.levels)
    if (std::ranges::count(factor.levels, level.name, &FactorLevel::name) > 1)
      reader.refuse(key, fmt::format("holds \"{}\" twice; accepted: every level once", level.name));
  return factor;
}

/// The member of a list that the table's key `kind` names.
template <class Member>
const Member* named(TomlReader& table, std::span<const Member* const> members) {
  return *std::ranges::find(members, table.word("kind"), &Member::name);
}

void read_task(TomlReader task, Protocol& protocol) {
  protocol.task = named(task, tasks());
  task.also(protocol.task->keys);
  protocol.task->read(task, protocol);
  if (task.has("answer")) protocol.answer = task.word("answer", kAnswerWords);
  protocol.feedback = task.boolean("feedback");
  task.refuse_unknown();
}

/// Who is told which answers were right knows which orders have come; of balanced ones, which are left.
void check_feedback(const TomlReader& order, const Protocol& protocol) {
  if (!protocol.feedback || protocol.interval_order == IntervalOrder::Coin) return;
  order.refuse(
      "interval",
      "found \"balanced\" with task.feedback = true: who is told which answers were right can reckon "
      "which orders are left, and is right more often than chance without feeling anything; accepted: "
      "\"coin\", or no feedback");
}

void read_procedure_and_order(TomlReader procedure, TomlReader order, Protocol& protocol) {
  protocol.procedure = named(procedure, procedures());
  procedure.also(protocol.procedure->keys);
  procedure.refuse_later(later_procedure_keys());
  protocol.procedure->read(procedure, protocol);
  procedure.refuse_unknown();
  protocol.cell_order = order.word("cells", kCellOrderWords);
  order.also(protocol.task->order_keys);
  protocol.task->read_order(order, protocol);
  check_feedback(order, protocol);
  order.refuse_unknown();
}

void read_exploration(TomlReader reader, Exploration& rule) {
  const toml::array& presses = reader.as_array("presses", reader.other("presses"));
  const bool numbers = presses.size() == 2 && presses[0].is_integer() && presses[1].is_integer();
  const std::int64_t least = numbers ? *presses[0].value<std::int64_t>() : 0;
  const std::int64_t most = numbers ? *presses[1].value<std::int64_t>() : 0;
  if (least < 1 || most < least || most > kMostPresses)
    reader.refuse(
        "presses",
        fmt::format("{}; accepted: the least and the most, 1 <= least <= most, such as [1, 5]",
                    numbers ? fmt::format("found [{}, {}]", least, most) : "found no two whole numbers"));
  rule.least_presses = static_cast<int>(least);
  rule.most_presses = static_cast<int>(most);
  rule.min_depth = reader.quantity("min_depth");
  rule.max_time = reader.quantity("max_time");
  reader.refuse_unknown();
}

/// One or two factors vary, each between two levels.
bool has_planned_comparisons(const Protocol& protocol) {
  std::size_t varied = 0;
  for (const Factor& factor : protocol.factors) {
    if (factor.levels.size() > 2) return false;
    varied += factor.levels.size() == 2 ? 1 : 0;
  }
  return varied == 1 || varied == 2;
}

std::string levels_in_words(const Protocol& protocol) {
  if (protocol.factors.empty()) return "no";
  std::vector<std::size_t> counts;
  for (const Factor& factor : protocol.factors) counts.push_back(factor.levels.size());
  return fmt::format("{}", fmt::join(counts, " x "));
}

/// Looks at the results before the sample is complete, by how many examinees are complete then.
void read_looks(TomlReader& reader, Protocol& protocol) {
  AnalysisPlan& plan = protocol.analysis;
  if (protocol.interval_order != IntervalOrder::Coin)
    reader.refuse("looks",
                  "are planned for the exact binomial test; accepted with order.interval = \"coin\" only");
  if (plan.side == Side::TwoSided)
    reader.refuse("looks", "are planned for one-sided tests; accepted with side = \"greater\" or \"less\"");
  if (plan.adjust != Adjust::None)
    reader.refuse("looks", "spend the alpha of each cell by itself; accepted without adjust only");
  int before = 0;
  for (const toml::node& item : reader.as_array("looks", reader.other("looks"))) {
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
  plan.spending = reader.word("spending");
}

void read_analysis(TomlReader reader, Protocol& protocol) {
  AnalysisPlan& plan = protocol.analysis;
  plan.primary = reader.word("primary", kPrimaryAnalysisWords);
  protocol.task->check_primary(reader, protocol);
  plan.alpha = reader.number("alpha");
  plan.side = reader.word("side", kSideWords);
  plan.adjust = reader.word("adjust", kAdjustWords);
  if (reader.has("between_models")) {
    plan.between_models = reader.word("between_models");
    if (!has_planned_comparisons(protocol))
      reader.refuse(
          "between_models",
          fmt::format("compares two cells, or two factors of two levels each (both main effects and their "
                      "interaction); the factors of this protocol have {} levels; accepted: such factors, or "
                      "no between_models",
                      levels_in_words(protocol)));
  }
  if (reader.has("looks")) read_looks(reader, protocol);
  reader.refuse_unknown();
}

DuringInterval read_display(TomlReader reader) {
  const DuringInterval found = reader.word("during_interval", kDuringIntervalWords);
  reader.refuse_unknown();
  return found;
}

}  // namespace

bool is_name(std::string_view name) {
  constexpr std::string_view kAccepted = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !name.empty() && name.find_first_not_of(kAccepted) == std::string_view::npos;
}

Protocol parse_protocol(std::string text, const std::filesystem::path& file) {
  const toml::table root = base::parse_toml(text, file.string());
  TomlReader reader(root, file.string(), protocol_keys());
  reader.refuse_later(later_keys());
  Protocol protocol;
  protocol.file = file;
  protocol.sha256 = base::sha256_hex(text);
  protocol.text = std::move(text);
  protocol.name = reader.text("name");
  check_name(reader, "name", protocol.name);
  protocol.scene_file = file.parent_path() / reader.text("scene");
  protocol.scene_line = reader.line_of("scene");
  protocol.question = reader.text("question");
  if (protocol.question.empty()) reader.refuse("question", "is empty; accepted: what the examinee is asked");
  protocol.conditions = read_conditions(reader.table("conditions", conditions_keys()));
  if (reader.has("factors")) {
    TomlReader factors = reader.table("factors", factors_keys());
    for (const std::string& key : factors.keys()) protocol.factors.push_back(read_factor(factors, key));
  }
  expand(protocol);
  read_task(section(reader, "task", task_keys()), protocol);
  read_procedure_and_order(section(reader, "procedure", procedure_keys()),
                           section(reader, "order", order_keys()), protocol);
  read_exploration(section(reader, "exploration", exploration_keys()), protocol.exploration);
  protocol.during_interval = read_display(section(reader, "display", display_keys()));
  TomlReader sample = section(reader, "sample", sample_keys());
  protocol.planned_examinees = static_cast<int>(sample.whole("planned_examinees"));
  sample.refuse_unknown();
  read_analysis(section(reader, "analysis", analysis_keys()), protocol);
  reader.refuse_unknown();
  return protocol;
}

}  // namespace palpate::trials
