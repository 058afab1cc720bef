#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "base/files/sha256.hpp"
#include "trials/protocol/reading.hpp"

namespace palpate::trials {
namespace {

using base::Dimension;
using base::TomlReader;
using Words = std::vector<std::string_view>;

constexpr std::int64_t kMostPresses = 1000;  // in an interval: more is a slip of the keyboard
constexpr std::int64_t kMostExaminees = 100000;
constexpr double kLeastTime = 0.5;  // of an interval [s]

// Keys of later versions, in whichever table they stand; those of a procedure in its table only.
constexpr std::array<std::string_view, 14> kLaterKeys{
    "level",   "levels", "trials_per_level", "practice", "language",    "participants", "instructions",
    "consent", "tracks", "confidence",       "feedback", "force_scale", "device",       "questionnaire"};
constexpr std::array<std::string_view, 30> kLaterProcedureKeys{
    "start",    "steps",    "step_type",  "up",      "down",        "initial_one_up_one_down",
    "min",      "max",      "stop",       "step_up", "step_down",   "first_step",
    "min_step", "max_step", "target",     "wald",    "guess_level", "guess_sd",
    "alpha",    "beta",     "delta",      "gamma",   "grain",       "range",
    "next",     "function", "parameters", "prior",   "lapse",       "task"};

TomlReader section(TomlReader& reader, std::string_view key, std::string_view accepted) {
  reader.required(key, accepted);
  TomlReader table = *reader.table(key);
  table.refuse_later(kLaterKeys);
  return table;
}

void check_name(const TomlReader& reader, std::string_view key, std::string_view name) {
  constexpr std::string_view kAccepted = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  if (name.empty() || name.find_first_not_of(kAccepted) != std::string_view::npos)
    reader.refuse(
        key, fmt::format("found the name \"{}\", accepted: letters, digits, hyphen and underscore", name));
}

/// Of a factor's level, which stands in tables and plots.
void check_level_name(const TomlReader& reader, std::string_view name) {
  if (name.empty() || std::ranges::any_of(name, [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
    reader.refuse(name, "a level's name is empty or holds a control character; accepted: any words");
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

/// The scene overrides that a table of a condition or of a factor's level holds.
std::vector<sim::Override> read_overrides(TomlReader& table) {
  std::vector<sim::Override> overrides;
  for (const std::string& key : table.keys())
    overrides.push_back({key, as_toml(table, key, *table.node(key))});
  return overrides;
}

std::vector<Condition> read_conditions(TomlReader& reader) {
  reader.required("conditions", "accepted: one table [conditions.NAME] a condition");
  TomlReader all = *reader.table("conditions");  // whose keys are names
  std::vector<Condition> conditions;
  for (const std::string& name : all.keys()) {
    check_name(all, name, name);
    TomlReader table = *all.table(name);
    conditions.push_back(
        {.name = name, .overrides = read_overrides(table), .line = line_of(*all.node(name))});
  }
  return conditions;
}

/// Levels without names, `"contact.model" = ["kuroda", "sibille"]`: each is called as its value reads.
std::vector<FactorLevel> read_values(TomlReader& reader, const std::string& key) {
  std::vector<FactorLevel> levels;
  for (const toml::node& item : *reader.node(key)->as_array()) {
    const std::string value = as_toml(reader, key, item);
    levels.push_back({.name = item.is_string() ? *item.value<std::string>() : value,
                      .overrides = {{.key = key, .value = value}}});
  }
  return levels;
}

/// Levels with names: a value of the scene's key that the factor is called after, or, where the factor has a
/// name of its own, a table of scene keys.
std::vector<FactorLevel> read_named_levels(TomlReader& reader, const std::string& key) {
  TomlReader table = *reader.table(key);  // whose keys are names
  const bool is_scene_key = key.find('.') != std::string::npos;
  std::vector<FactorLevel> levels;
  for (const std::string& name : table.keys()) {
    check_level_name(table, name);
    const toml::node& node = *table.node(name);
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
    TomlReader level = *table.table(name);
    levels.push_back({.name = name, .overrides = read_overrides(level)});
  }
  return levels;
}

Factor read_factor(TomlReader& reader, const std::string& key) {
  const toml::node& node = *reader.node(key);
  if (!node.is_array() && !node.is_table())
    reader.refuse(key,
                  fmt::format("found {}, accepted: the levels, such as [\"kuroda\", \"sibille\"], or with "
                              "names: {{ near = [..], far = [..] }}",
                              TomlReader::describe(node)));
  Factor factor{.name = key,
                .levels = node.is_array() ? read_values(reader, key) : read_named_levels(reader, key),
                .line = line_of(node)};
  if (factor.levels.empty()) reader.refuse(key, "has no level; accepted: one or more");
  for (const FactorLevel& level : factor.levels)
    if (std::ranges::count(factor.levels, level.name, &FactorLevel::name) > 1)
      reader.refuse(key, fmt::format("holds \"{}\" twice; accepted: every level once", level.name));
  return factor;
}

/// The member of a kind that the table's key `kind` names; those of `later` are not in this version.
template <class Member>
const Member* named(TomlReader& table, std::span<const Member* const> members, const Words& later) {
  Words names;
  for (const Member* member : members) names.push_back(member->name);
  const std::string found = word(table, "kind", names, later);
  return *std::ranges::find(members, found, &Member::name);
}

void read_task(TomlReader task, Protocol& protocol) {
  protocol.task = named(
      task, tasks(), {"2AFC", "yes/no", "same-different", "ABX", "oddity", "magnitude estimation", "rating"});
  protocol.task->read(task, protocol);
  if (task.has("answer"))
    protocol.answer =
        word(task, "answer", kAnswerWords, Words{"roughest", "smoothest", "largest", "smallest"});
  task.refuse_unknown();
}

void read_procedure_and_order(TomlReader procedure, TomlReader order, Protocol& protocol) {
  protocol.procedure = named(procedure, procedures(),
                             {"staircase", "weighted", "pest", "quest", "QUEST+", "questplus", "psi"});
  procedure.refuse_later(kLaterProcedureKeys);
  protocol.procedure->read(procedure, protocol);
  procedure.refuse_unknown();
  protocol.cell_order = word(order, "cells", kCellOrderWords, Words{"blocked", "balanced"});
  protocol.task->read_order(order, protocol);
  order.refuse_unknown();
}

void read_exploration(TomlReader reader, Exploration& rule) {
  const auto& presses = reader.as_array(
      "presses", reader.required("presses", "accepted: the least and the most, such as [1, 5]"),
      "the least and the most");
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
  plan.spending = word(reader, "spending", Words{"obrien-fleming", "pocock"});
}

void read_analysis(TomlReader reader, Protocol& protocol) {
  AnalysisPlan& plan = protocol.analysis;
  plan.primary = word(reader, "primary", kPrimaryAnalysisWords);
  protocol.task->check_primary(reader, protocol);
  plan.alpha = reader.required_number("alpha");
  if (!(plan.alpha > 0.0 && plan.alpha < 1.0))
    reader.refuse("alpha", fmt::format("found {}, accepted: greater than 0 and less than 1", plan.alpha));
  plan.side = word(reader, "side", kSideWords);
  if (reader.has("adjust")) plan.adjust = word(reader, "adjust", kAdjustWords);
  if (reader.has("between_models")) {
    plan.between_models = word(reader, "between_models", Words{"sign-flip", "wilcoxon"});
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
  const DuringInterval found = word(reader, "during_interval", kDuringIntervalWords);
  reader.refuse_unknown();
  return found;
}

}  // namespace

Protocol parse_protocol(std::string text, const std::filesystem::path& file) {
  const toml::table root = base::parse_toml(text, file.string());
  TomlReader reader(root, file.string());
  reader.refuse_later(kLaterKeys);
  Protocol protocol;
  protocol.file = file;
  protocol.sha256 = base::sha256_hex(text);
  protocol.text = std::move(text);
  protocol.name = reader.required_text("name");
  check_name(reader, "name", protocol.name);
  protocol.scene_file = file.parent_path() / reader.required_text("scene");
  protocol.scene_line = line_of(*reader.node("scene"));
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
