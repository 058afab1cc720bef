#include <fmt/format.h>

#include "trials/procedure/procedure.hpp"
#include "trials/protocol/protocol_keys.hpp"
#include "trials/task/task.hpp"

namespace palpate::trials {
namespace {

using base::Key;

constexpr std::string_view kIntroduction =
    "A protocol is a study's design: the scene, the conditions that are compared, what is asked, how often, in "
    "which order, of how many people, and which test is made of the answers. Its text and hash are stored with "
    "every session, so that what was planned can be shown.";

std::vector<Key> listed(std::span<const Key> keys) {
  return {keys.begin(), keys.end()};
}

std::string quoted(std::string_view word) {
  return fmt::format("\"{}\"", word);
}

/// A table that a word of `kind` chooses the further keys of.
void add_kind(const std::string& path, std::string_view meaning, std::span<const Key> common,
              std::string_view first, base::FileFormat& format) {
  format.tables.push_back({.path = path,
                           .meaning = meaning,
                           .keys = listed(common),
                           .shown = {{.path = path, .examples = {{"kind", quoted(first)}}}}});
}

void add_room(const std::string& path, std::string_view kind, std::string_view name,
              std::span<const Key> keys, bool shown, base::FileFormat& format) {
  if (keys.empty()) return;
  format.tables.push_back(
      {.path = path, .called = fmt::format("{} = \"{}\"", kind, name), .keys = listed(keys), .shown = {}});
  if (shown) format.tables.back().shown = {{.path = path}};
}

void add_table(const std::string& path, std::string_view meaning, std::span<const Key> keys,
               base::FileFormat& format) {
  format.tables.push_back(
      {.path = path, .meaning = meaning, .keys = listed(keys), .shown = {{.path = path}}});
}

}  // namespace

base::FileFormat protocol_format(std::span<const Task* const> tasks,
                                 std::span<const Procedure* const> procedures) {
  base::FileFormat format{.name = "protocol", .introduction = kIntroduction};
  format.tables.push_back({.path = "", .keys = listed(protocol_keys()), .shown = {{}}});
  format.tables.push_back(
      {.path = "conditions.NAME",
       .meaning =
           "A condition: a named set of changes to the scene. A condition that no question presents may "
           "stand here, too, for `palpate press` to compare with.",
       .keys = listed(condition_keys()),
       .shown = {{.path = "conditions.soft"},
                 {.path = "conditions.hard",
                  .examples = {{base::kAnyName, "\"bodies.prostate.young_modulus\" = \"5.0 MPa\""}}}}});
  add_table(
      "factors",
      "What else is varied: every combination of the factors' levels is a cell, with trials and a test of "
      "its own. A study without factors leaves this table out.",
      factors_keys(), format);
  add_kind("task", "What the examinee is asked, and what the correct answer is.", task_keys(),
           tasks.front()->name, format);
  for (const Task* task : tasks)
    add_room("task", "kind", task->name, task->keys, task == tasks.front(), format);
  add_kind("procedure", "How many trials there are, and what each presents.", procedure_keys(),
           procedures.front()->name, format);
  for (const Procedure* procedure : procedures)
    add_room("procedure", "kind", procedure->name, procedure->keys, procedure == procedures.front(), format);
  add_table("order", "In which order things come. It is drawn anew for each examinee.", order_keys(), format);
  for (const Task* task : tasks)
    add_room("order", "task.kind", task->name, task->order_keys, task == tasks.front(), format);
  add_table("exploration", "What an examinee may and must do in an interval.", exploration_keys(), format);
  add_table("display", "What is on the screen.", display_keys(), format);
  add_table("sample", "How many people there are to be.", sample_keys(), format);
  add_table("analysis", "What is made of the answers, decided before the first of them.", analysis_keys(),
            format);
  format.later.assign(later_keys().begin(), later_keys().end());
  for (const std::string_view key : later_procedure_keys())
    format.later.push_back(fmt::format("procedure.{}", key));
  return format;
}

}  // namespace palpate::trials
