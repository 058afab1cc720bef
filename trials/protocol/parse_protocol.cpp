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

std::vector<Condition> read_conditions(TomlReader all) {
  std::vector<Condition> conditions;
  for (const std::string& name : all.keys()) {
    check_name(all, name, name);
    TomlReader table = all.table(name, condition_keys());
    Condition condition{.name = name, .overrides = {}, .line = all.line_of(name)};
    for (const std::string& key : table.keys())
      condition.overrides.push_back({key, as_toml(table, key, table.other(key))});
    conditions.push_back(std::move(condition));
  }
  return conditions;
}

Factor read_factor(TomlReader& reader, const std::string& key) {
  Factor factor{.key = key, .levels = {}, .values = {}, .line = reader.line_of(key)};
  for (const toml::node& item : reader.as_array(key, reader.other(key))) {
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
  task.refuse_unknown();
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

/// Looks at the results before the sample is complete, by how many examinees are complete then.
void read_looks(TomlReader& reader, Protocol& protocol) {
  AnalysisPlan& plan = protocol.analysis;
  if (protocol.interval_order != IntervalOrder::Coin)
    reader.refuse("looks",
                  "are planned for the exact binomial test; accepted with order.interval = \"coin\" only");
  if (plan.side == Side::TwoSided)
    reader.refuse("looks", "are planned for one-sided tests; accepted with side = \"greater\" or \"less\"");
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
  if (reader.has("between_models")) {
    plan.between_models = reader.word("between_models");
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
