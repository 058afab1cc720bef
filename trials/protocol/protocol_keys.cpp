#include "trials/protocol/protocol_keys.hpp"

#include <array>

#include "trials/protocol/protocol.hpp"

namespace palpate::trials {
namespace {

using base::Dimension;
using base::Key;

constexpr double kMostExaminees = 100000;
constexpr double kLeastTime = 0.5;  // of an interval [s]

constexpr std::array<std::string_view, 13> kLaterKeys{
    "level",   "levels", "trials_per_level", "practice",    "language", "participants", "instructions",
    "consent", "tracks", "confidence",       "force_scale", "device",   "questionnaire"};
constexpr std::array<std::string_view, 30> kLaterProcedureKeys{
    "start",    "steps",    "step_type",  "up",      "down",        "initial_one_up_one_down",
    "min",      "max",      "stop",       "step_up", "step_down",   "first_step",
    "min_step", "max_step", "target",     "wald",    "guess_level", "guess_sd",
    "alpha",    "beta",     "delta",      "gamma",   "grain",       "range",
    "next",     "function", "parameters", "prior",   "lapse",       "task"};
constexpr std::array<std::string_view, 7> kLaterTasks{
    "2AFC", "yes/no", "same-different", "ABX", "oddity", "magnitude estimation", "rating"};
constexpr std::array<std::string_view, 7> kLaterProcedures{"staircase", "weighted",  "pest", "quest",
                                                           "QUEST+",    "questplus", "psi"};
constexpr std::array<std::string_view, 4> kLaterAnswers{"roughest", "smoothest", "largest", "smallest"};
constexpr std::array<std::string_view, 2> kLaterCellOrders{"blocked", "balanced"};

base::Words between_models_words() {
  return {.now = {{"sign-flip", "a randomisation test that flips the signs of the differences"},
                  {"wilcoxon", "Wilcoxon's signed-rank test"}},
          .later = {}};
}
base::Words spending_words() {
  return {.now = {{"obrien-fleming", "little alpha early, nearly all of it at the end"},
                  {"pocock", "about the same at every look"}},
          .later = {}};
}

constexpr base::Takes kSection = base::takes_table("a table");

constexpr std::array kProtocolKeys{
    Key{.name = "name",
        .takes = base::kText,
        .example = "\"my-study\"",
        .meaning = "What the study is called in results: letters, digits, hyphen and underscore."},
    Key{.name = "scene",
        .takes = base::kText,
        .example = "\"scene.toml\"",
        .meaning = "The scene file, seen from this file: what there is to touch."},
    Key{.name = "question",
        .takes = base::kText,
        .example = "\"In which interval did it feel harder?\"",
        .meaning = "What the examinee is asked after the last interval. It names no condition and no model."},
    Key{.name = "conditions", .takes = base::takes_table("one table [conditions.NAME] a condition")},
    Key{.name = "factors", .takes = base::takes_table("a table [factors]"), .absent = "one cell, called all"},
    Key{.name = "task", .takes = base::takes_table("a table [task]")},
    Key{.name = "procedure", .takes = base::takes_table("a table [procedure]")},
    Key{.name = "order", .takes = base::takes_table("a table [order]")},
    Key{.name = "exploration", .takes = base::takes_table("a table [exploration]")},
    Key{.name = "display", .takes = base::takes_table("a table [display]")},
    Key{.name = "sample", .takes = base::takes_table("a table [sample]")},
    Key{.name = "analysis", .takes = base::takes_table("a table [analysis]")},
};

constexpr std::array kConditionsKeys{
    Key{.name = base::kAnyName, .takes = base::takes_table("a table [conditions.NAME]")},
};

constexpr std::array kConditionKeys{
    Key{.name = base::kAnyName,
        .takes = base::takes_other("a value that the scene takes there"),
        .example = "\"bodies.prostate.young_modulus\" = \"1.0 MPa\"",
        .absent = "the scene's own",
        .meaning = "A key of the scene, in quotes, and the value that it has in this condition."},
};

constexpr std::array kFactorsKeys{
    Key{.name = base::kAnyName,
        .takes = base::takes_other(
            "the levels, such as [\"kuroda\", \"sibille\"], or with names: { near = [..], far = "
            "[..] }"),
        .example = "\"bodies.rectum.young_modulus\" = { \"soft wall\" = \"0.5 MPa\", \"stiff wall\" = "
                   "\"1.0 MPa\" }",
        .absent = "the scene's own",
        .meaning =
            "A key of the scene, in quotes, and the values that it is to have: an array, or with names for reports "
            "and plots. A factor that changes several keys has a name of its own, and each level is a table "
            "of them: `gap = { near = { \"bodies.prostate.offset\" = [..] }, far = { .. } }`."},
};

constexpr std::array kLevelKeys{
    Key{.name = base::kAnyName,
        .takes = base::takes_other("a value that the scene takes there, or a table of scene keys"),
        .absent = "no such level"},
};

constexpr std::array kTaskKeys{
    Key{.name = "kind", .takes = base::takes_word(task_words), .meaning = "The kind of question."},
    Key{.name = "answer",
        .takes = base::takes_word(base::words_of<kAnswerWords, kLaterAnswers>),
        .example = "\"stiffest\"",
        .absent = "as the conditions tell, where they differ in stiffness",
        .meaning =
            "What the question asks for. Simulated examinees answer it; it must be what makes the correct "
            "answer correct."},
    Key{.name = "feedback",
        .takes = base::kBoolean,
        .example = "true",
        .fallback = "false",
        .meaning =
            "Whether the examinee is told if an answer was right, once it is saved and before the next question. "
            "Only with `interval = \"coin\"`: who is told can reckon which of balanced orders are left."},
};

constexpr std::array kProcedureKeys{
    Key{.name = "kind", .takes = base::takes_word(procedure_words), .meaning = "How the trials are chosen."},
};

constexpr std::array kOrderKeys{
    Key{.name = "cells",
        .takes = base::takes_word(base::words_of<kCellOrderWords, kLaterCellOrders>),
        .example = "\"shuffled\"",
        .meaning = "In which order the cells come."},
};

constexpr std::array kExplorationKeys{
    Key{.name = "presses",
        .takes = base::takes_other("the least and the most, 1 <= least <= most, such as [1, 5]"),
        .example = "[1, 5]",
        .meaning = "How often the examinee may press in an interval: the least and the most, up to 1000."},
    Key{.name = "min_depth",
        .takes = base::takes_quantity(Dimension::Length, base::kNotNegative),
        .example = "\"3 mm\"",
        .meaning =
            "How deep a press must go at least once in every interval; else the question is shown again. No "
            "deeper than the probe's `depth` in the scene."},
    Key{.name = "max_time",
        .takes = base::takes_quantity(Dimension::Time, {.least = kLeastTime}),
        .example = "\"10 s\"",
        .meaning = "How long an interval lasts at most."},
};

constexpr std::array kDisplayKeys{
    Key{.name = "during_interval",
        .takes = base::takes_word(base::words_of<kDuringIntervalWords>),
        .example = "\"hidden\"",
        .meaning = "What the eye gets while the hand presses. What is seen can answer for what is felt."},
};

constexpr std::array kSampleKeys{
    Key{.name = "planned_examinees",
        .takes = base::takes_whole(1, kMostExaminees),
        .example = "15",
        .meaning =
            "How many people are to take part. Before so many are complete the report shows no test. `palpate "
            "plan` says how many are enough."},
};

constexpr std::array kAnalysisKeys{
    Key{.name = "primary",
        .takes = base::takes_word(base::words_of<kPrimaryAnalysisWords>),
        .example = "\"paired-comparison\"",
        .meaning = "The one test that the study is planned for, made in every cell."},
    Key{.name = "alpha",
        .takes = base::takes_number({.least = 0.0, .most = 1.0, .open = true}),
        .example = "0.05",
        .meaning = "How often the test may reject people who feel nothing."},
    Key{.name = "side",
        .takes = base::takes_word(base::words_of<kSideWords>),
        .example = "\"greater\"",
        .meaning = "On which side of chance the test looks."},
    Key{.name = "adjust",
        .takes = base::takes_word(base::words_of<kAdjustWords>),
        .example = "\"holm\"",
        .fallback = "\"none\"",
        .meaning = "What the tests of several cells together may do."},
    Key{.name = "between_models",
        .takes = base::takes_word(between_models_words),
        .example = "\"sign-flip\"",
        .absent = "the cells are not compared",
        .meaning =
            "Compares cells, by each examinee's difference of correct answers: two cells, or two factors of two "
            "levels each with both main effects and their interaction."},
    Key{.name = "looks",
        .takes = base::takes_other("ascending numbers of examinees such as [5, 10, 15]"),
        .example = "[5, 10, 15]",
        .absent = "one look, at the end",
        .meaning =
            "Looks at the results on the way, by how many examinees are complete then; the last is at all "
            "planned ones. For one-sided tests with coin flips, without `adjust`.",
        .along = "spending = \"obrien-fleming\""},
    Key{.name = "spending",
        .takes = base::takes_word(spending_words),
        .example = "\"obrien-fleming\"",
        .absent = "no `looks`",
        .meaning = "How alpha is spent over the looks, so that all of them together keep it.",
        .along = "looks = [5, 10, 15]"},
};

/// The words of a list of rooms, with what each is.
template <class Member>
base::Words words_of_list(std::span<const Member* const> members, std::span<const std::string_view> later) {
  base::Words words{.now = {}, .later = {later.begin(), later.end()}};
  for (const Member* member : members) words.now.push_back({member->name, member->meaning});
  return words;
}

}  // namespace

std::span<const Key> protocol_keys() {
  return kProtocolKeys;
}
std::span<const Key> conditions_keys() {
  return kConditionsKeys;
}
std::span<const Key> condition_keys() {
  return kConditionKeys;
}
std::span<const Key> factors_keys() {
  return kFactorsKeys;
}
std::span<const Key> level_keys() {
  return kLevelKeys;
}
std::span<const Key> task_keys() {
  return kTaskKeys;
}
std::span<const Key> procedure_keys() {
  return kProcedureKeys;
}
std::span<const Key> order_keys() {
  return kOrderKeys;
}
std::span<const Key> exploration_keys() {
  return kExplorationKeys;
}
std::span<const Key> display_keys() {
  return kDisplayKeys;
}
std::span<const Key> sample_keys() {
  return kSampleKeys;
}
std::span<const Key> analysis_keys() {
  return kAnalysisKeys;
}
std::span<const std::string_view> later_keys() {
  return kLaterKeys;
}
std::span<const std::string_view> later_procedure_keys() {
  return kLaterProcedureKeys;
}

base::Words task_words() {
  return words_of_list(tasks(), kLaterTasks);
}
base::Words procedure_words() {
  return words_of_list(procedures(), kLaterProcedures);
}

}  // namespace palpate::trials
