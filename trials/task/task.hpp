#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/text/key.hpp"

namespace palpate::base {
class TomlReader;
}

namespace palpate::trials {

class Generator;
struct Observer;
struct Protocol;
struct Trial;

/// One answer that the page offers.
struct Choice {
  std::string_view label;                  // "First turn": examinees know an interval as a turn
  std::span<const std::string_view> keys;  // that give it, as browsers name them: "1", "ArrowLeft"
};

/// What a question is. All that is particular to one way of asking stands in a folder of tasks/, and the rest
/// of the program asks it here. An answer is a number from 1, the place of its choice.
struct Task {
  std::string_view name;               // "2IFC": task.kind in a protocol, and a column
  int intervals;                       // presentations of a question
  double chance;                       // share correct of the best rule that feels nothing
  std::span<const Choice> choices;     // what can be answered, in order
  std::string_view answer_is;          // what an answer's number is: "the number of an interval"
  std::string_view hint, spoken_hint;  // how to answer, as the page shows it and as a screen reader says it

  std::string_view meaning{};  // what is asked, a clause, for the reference
  // The design. `keys` are those of [task] apart from kind and answer, `order_keys` of [order] apart from
  // cells; their examples fit conditions "soft" and "hard". What is refused throws std::invalid_argument, as
  // TomlReader::refuse() does.
  std::span<const base::Key> keys{}, order_keys{};
  void (*read)(base::TomlReader& task, Protocol& protocol);         // [task], all but kind
  void (*read_order)(base::TomlReader& order, Protocol& protocol);  // [order], all but cells
  /// Refuses a primary analysis that does not hold for questions drawn so.
  void (*check_primary)(const base::TomlReader& analysis, const Protocol& protocol);

  /// Draws what each question presents and which answer is correct; cells and numbers are given. Orders that
  /// are balanced are so over `trials`.
  void (*draw)(const Protocol& protocol, std::span<Trial> trials, Generator& generator);
  /// Draws an interrupted question again.
  void (*redraw)(const Protocol& protocol, Trial& trial, Generator& generator);
  /// The answer that what a question presents makes correct. Drawing stores it in the trial; `verify` asks
  /// again. 0: nothing that is presented makes any answer correct (a damaged file).
  int (*correct_answer)(const Protocol& protocol, const Trial& trial);

  /// What a simulated person answers to what each interval felt like (see perceive(); nothing: no force),
  /// asked for Protocol::answer, which is known.
  int (*decide)(const Protocol& protocol, std::span<const std::optional<double>> percepts,
                const Observer& observer, Generator& generator);

  /// Sensitivity d' that this share of correct answers stands for, without bias. 0 < `correct` < `trials`.
  double (*d_prime)(long correct, long trials);

  // Words for readers.
  std::string (*question_in_words)(const Protocol& protocol);  // "soft against hard; ..."
  std::string (*order_in_words)(const Protocol& protocol);     // how predictable a question is
  std::string (*course_in_words)(const Protocol& protocol);    // of a question, for a data set's reader
  std::string (*task_means)(const Protocol& protocol);         // columns of the codebook:
  std::string (*correct_answer_means)(const Protocol& protocol);
  std::string_view response_means;
};

/// Every task that there is. The list stands in tasks/tasks.cpp, above this module: only tasks know what it
/// is that they ask.
std::span<const Task* const> tasks();

}  // namespace palpate::trials
