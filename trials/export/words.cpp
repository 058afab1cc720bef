#include "trials/export/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "trials/export/check_values.hpp"

namespace palpate::trials {
namespace {

std::string counted_words(std::size_t count, std::string_view one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

std::string in_a_row(const Column& column) {
  std::string text = column.description;
  if (!column.unit.empty()) text += fmt::format(" [{}]", column.unit);
  if (column.levels.size() > 1 && column.kind == Kind::Text) {
    text += ". Values:";
    for (const Level& level : column.levels)
      text += fmt::format("{} `{}` ({})", &level == &column.levels.front() ? "" : ",", level.value,
                          level.meaning);
  }
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

}  // namespace

std::string label_of(std::string_view name) {
  std::string label;
  for (const char c : name)
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')) label += c;
  if (label.empty())
    throw std::invalid_argument(
        fmt::format("\"{}\" has neither letter nor digit, and so no name in this format; accepted: --as csv "
                    "or json",
                    name));
  return label;
}

std::string describe_course(const Protocol& protocol) {
  return protocol.task->course_in_words(protocol) +
         (protocol.feedback ? " After each answer the examinee is told whether it was right." : "");
}

std::string describe_dataset(const StudyFile& study) {
  const Protocol& protocol = study.protocol();
  std::set<std::string> examinees;
  std::map<RunMode, std::size_t> sittings;
  std::size_t answers = 0;
  bool pseudo_haptic = false;
  for (const SessionRow& session : study.sessions()) {
    examinees.insert(session.facts.examinee);
    ++sittings[session.facts.run_mode];
    answers += study.answers(session.id).size();
    pseudo_haptic |= session.facts.pseudo_haptic;
  }
  std::vector<std::string> by_mode;
  by_mode.reserve(sittings.size());
  for (const auto& [mode, count] : sittings) by_mode.push_back(fmt::format("{} {}", count, to_string(mode)));
  std::string text = fmt::format(
      "Answers of a forced-choice study of touch on simulated elastic bodies, protocol {} ({}): {}, {} ({}), "
      "{}.",
      protocol.name, protocol.task->name, counted_words(examinees.size(), "examinee"),
      counted_words(study.sessions().size(), "sitting"),
      by_mode.empty() ? "none" : fmt::format("{}", fmt::join(by_mode, ", ")),
      counted_words(answers, "answer"));
  if (!sittings.contains(RunMode::Study))
    text += " NO RESULT OF A STUDY: there is no sitting of run mode study in it.";
  else if (sittings.size() > 1)
    text += " Only sittings of run mode study are results; the column run_mode marks every row.";
  if (sittings.contains(RunMode::Simulated))
    text += " Simulated sittings were answered by a program, not by people.";
  if (pseudo_haptic)
    text += " Some sittings were pseudo-haptic: no force reached the hand (column pseudo_haptic).";
  return text;
}

std::string codebook_markdown(const Table& table) {
  std::string text = "| column | meaning |\n|---|---|\n";
  for (const Column& column : table.columns)
    text += fmt::format("| {} | {} |\n", column.name, in_a_row(column));
  return text;
}

std::string changes_text(const StudyFile& study, const ExportFacts& facts) {
  return fmt::format("1.0.0 {}\n  - Exported by palpate {} from the study file {}, receipt {}.\n",
                     facts.exported_utc.substr(0, 10), facts.software_version, study.study().uuid,
                     to_string(study.receipt()));
}

void refuse_problems(std::string_view what, const std::vector<std::string>& problems) {
  constexpr std::size_t kShown = 5;
  if (problems.empty()) return;
  const std::vector<std::string> first(
      problems.begin(), problems.begin() + static_cast<long>(std::min(kShown, problems.size())));
  throw std::runtime_error(
      fmt::format("{} would not be valid, and nothing was written: {}{}", what, fmt::join(first, "; "),
                  problems.size() > kShown ? fmt::format(" (and {} more)", problems.size() - kShown) : ""));
}

std::vector<Table> checked_tables(const StudyFile& study, const std::vector<AnsweredTrial>& answered,
                                  const std::vector<Exposure>& exposures) {
  const Protocol& design = study.protocol();
  std::vector<Table> tables{trial_table(design, answered), interval_table(design, answered),
                            exposure_table(design, exposures), event_table(study.sessions(), study.events())};
  std::vector<std::string> problems;
  for (const Table& table : tables) check_table(table, problems);
  refuse_problems("the tables", problems);
  return tables;
}

}  // namespace palpate::trials
