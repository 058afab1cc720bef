#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/enum_words.hpp"
#include "sim/scene/scene.hpp"
#include "trials/procedure/procedure.hpp"
#include "trials/task/task.hpp"

namespace palpate::trials {

/// A named set of scene overrides: `soft`, `hard`.
struct Condition {
  std::string name{};
  std::vector<sim::Override> overrides{};
  int line = 0;  // in the protocol file
};

/// A named set of scene overrides, one of a factor's: `near`, `far`.
struct FactorLevel {
  std::string name{};
  std::vector<sim::Override> overrides{};
};

/// What is varied between trials; every combination of the factors' levels is a cell.
struct Factor {
  std::string name{};  // "gap"; where nothing else is varied, the scene key: "contact.model"
  std::vector<FactorLevel> levels{};
  int line = 0;  // in the protocol file
};

/// One combination of factor levels.
struct Cell {
  std::string name;                 // "kuroda"; "all" where the protocol has no factor
  std::vector<std::size_t> levels;  // index into each factor's levels
};

/// One thing that can be felt: a condition in a cell. The overrides are those of the cell, then of the
/// condition.
struct Stimulus {
  std::size_t cell = 0;
  std::size_t condition = 0;
  std::vector<sim::Override> overrides;
};

/// A file that the outcome depends on, as it was when the protocol was read.
struct FileHash {
  std::string name;            // "scene", or the body whose mesh it is
  std::filesystem::path file;  // as found from the working directory
  std::string sha256;          // 64 hexadecimal digits
};

enum class DuringInterval { Hidden, Probe, Organs };
inline constexpr base::EnumWords<DuringInterval, 3> kDuringIntervalWords{
    {{DuringInterval::Hidden, "hidden",
      "nothing of the organs; with a mouse its pointer and the line of the skin"},
     {DuringInterval::Probe, "probe", "the probe alone"},
     {DuringInterval::Organs, "organs", "the organs, as they are pressed"}}};

/// What is asked for: the interval that felt so beside the others.
enum class Answer { Stiffest, Softest };
inline constexpr base::EnumWords<Answer, 2> kAnswerWords{
    {{Answer::Stiffest, "stiffest", "the interval that felt stiffest"},
     {Answer::Softest, "softest", "the interval that felt softest"}}};

/// In which order the cells of a sitting come.
enum class CellOrder { Shuffled };
inline constexpr base::EnumWords<CellOrder, 1> kCellOrderWords{
    {{CellOrder::Shuffled, "shuffled", "every trial of every cell in one random order"}}};

/// How it is drawn what the intervals of a question hold: by independent coin flips, or every order equally
/// often within a cell.
enum class IntervalOrder { Coin, Balanced };
inline constexpr base::EnumWords<IntervalOrder, 2> kIntervalOrderWords{
    {{IntervalOrder::Coin, "coin", "an independent fair coin for each trial"},
     {IntervalOrder::Balanced, "balanced",
      "either order in half of each cell's trials, whose number is even"}}};

enum class PrimaryAnalysis { PairedComparison, OrderRandomisation };
inline constexpr base::EnumWords<PrimaryAnalysis, 2> kPrimaryAnalysisWords{
    {{PrimaryAnalysis::PairedComparison, "paired-comparison",
      "the exact binomial test, for `interval = \"coin\"`"},
     {PrimaryAnalysis::OrderRandomisation, "order-randomisation",
      "the randomisation test over the orders that could have been drawn, for `interval = \"balanced\"`"}}};

/// On which side of chance the primary test looks.
enum class Side { Greater, Less, TwoSided };
inline constexpr base::EnumWords<Side, 3> kSideWords{
    {{Side::Greater, "greater", "more correct answers than guessing gives"},
     {Side::Less, "less", "fewer of them"},
     {Side::TwoSided, "two-sided", "either"}}};

/// How the p values of the cells' primary tests are adjusted for there being several.
enum class Adjust { None, Holm, Hochberg, BenjaminiHochberg };
inline constexpr base::EnumWords<Adjust, 4> kAdjustWords{
    {{Adjust::None, "none", "each cell at alpha by itself"},
     {Adjust::Holm, "holm", "alpha holds for all cells together"},
     {Adjust::Hochberg, "hochberg",
      "the same, where the cells' tests do not depend on each other or rise together"},
     {Adjust::BenjaminiHochberg, "benjamini-hochberg",
      "at most alpha of the rejections are expected to be false"}}};

/// How long the page says whether an answer was right, the same for every answer [s]: about what a screen reader
/// takes for its nine words (175 a minute where eSpeak NG is not told otherwise; its manual, option -s).
inline constexpr double kFeedbackTime = 3.0;

/// What an examinee must do in an interval before it counts.
struct Exploration {
  int least_presses = 1;
  int most_presses = 1;
  double min_depth = 0.0;  // with contact, in every interval [m]
  double max_time = 0.0;   // [s]
};

/// What the protocol decides about its analysis beforehand; texts are the words of the file.
struct AnalysisPlan {
  PrimaryAnalysis primary = PrimaryAnalysis::PairedComparison;
  double alpha = 0.05;  // in (0, 1)
  Side side = Side::Greater;
  Adjust adjust = Adjust::None;
  std::optional<std::string> between_models;  // "sign-flip", "wilcoxon"
  std::vector<int> looks{};  // complete examinees at each planned look; empty: at the end only
  std::string spending{};    // of alpha over the looks: "obrien-fleming", "pocock"
};

/// A study's design, read and validated.
struct Protocol {
  std::string name;
  std::filesystem::path file;        // where it was read
  std::string text;                  // the file, byte for byte
  std::string sha256;                // of text
  int scene_line = 0;                // of the protocol: where it names the scene
  std::filesystem::path scene_file;  // as found from the working directory
  std::string scene_text;
  std::vector<FileHash> files;  // the scene, then each body's mesh

  std::string question;
  std::vector<Condition> conditions;  // in the order of the file
  std::vector<Factor> factors;
  const Task* task = nullptr;
  std::vector<std::size_t> presented{};  // conditions that questions present, in the order of the file
  std::size_t correct = 0;               // the one of them that the correct answer points at
  /// What the question asks for: as the file says, else as the conditions tell. Nothing where neither does: a
  /// person can be asked, a simulated one would not know what to answer.
  std::optional<Answer> answer{};
  bool feedback = false;  // whether the examinee is told if an answer was right, once it is saved
  const Procedure* procedure = nullptr;
  int trials_per_examinee_per_cell = 0;
  CellOrder cell_order = CellOrder::Shuffled;
  IntervalOrder interval_order = IntervalOrder::Coin;
  Exploration exploration{};
  DuringInterval during_interval = DuringInterval::Hidden;
  int planned_examinees = 0;
  AnalysisPlan analysis{};

  std::vector<Cell> cells;        // every combination of factor levels, the last factor fastest
  std::vector<Stimulus> stimuli;  // cell-major: stimulus_index() finds one
};

/// Trials in one sitting: cells times trials per cell.
int trials_per_session(const Protocol& protocol);

/// About how long the questions take an examinee: the way into an interval, eight seconds or less within, an
/// answer, and its feedback where there is any [min].
int minutes_of(const Protocol& protocol);

/// Index into Protocol::stimuli.
std::size_t stimulus_index(const Protocol& protocol, std::size_t cell, std::size_t condition);

/// Fills cells and stimuli from conditions and factors.
void expand(Protocol& protocol);

/// Reads a protocol file and everything that it names: the scene is loaded with the overrides of every
/// stimulus and each mesh is hashed (not condensed). Writes nothing. Throws std::invalid_argument,
/// "FILE:LINE: KEY: what was found, what is accepted": an unknown key or value, a missing or wrong unit, a
/// plan that cannot be run, conditions that would feel alike, a scene or mesh that is not there, and what the
/// design knows but this version does not ("not in this version").
Protocol load_protocol(const std::filesystem::path& file);

/// A protocol by its text alone: validated in itself, but neither scene nor meshes are looked at (scene_text
/// and files stay empty). For reading the design that a study file holds. Throws as load_protocol() does.
Protocol parse_protocol(std::string text, const std::filesystem::path& file);

/// Whether a protocol or a condition may be called so, and what may.
bool is_name(std::string_view name);
inline constexpr std::string_view kNamesAccepted = "letters, digits, hyphen and underscore";

/// The plan in words, for `palpate check`.
struct PlanSummary {
  int trials_per_session = 0;
  int planned_examinees = 0;
  int trials_per_cell = 0;  // over all planned examinees: what the critical number is for
  std::vector<std::string> cells;
  double best_guess =
      0.0;            // share correct of the best rule that feels nothing, knowing how the order is drawn
  std::string order;  // how the order is drawn and how predictable it is, a sentence or two
};
PlanSummary describe(const Protocol& protocol);

std::string_view to_string(DuringInterval display);
std::string_view to_string(CellOrder order);
std::string_view to_string(IntervalOrder order);
std::string_view to_string(PrimaryAnalysis analysis);
std::string_view to_string(Side side);
std::string_view to_string(Adjust adjust);

}  // namespace palpate::trials
