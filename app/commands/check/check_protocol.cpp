#include "app/commands/check/check_protocol.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/words/words.hpp"
#include "app/command_line/user_cache.hpp"
#include "app/commands/check/body_warnings.hpp"
#include "app/study/study_table.hpp"
#include "trials/protocol/stimuli.hpp"

namespace palpate::app {

using nlohmann::ordered_json;

namespace {

/// "37 or more correct of 60 in a cell"
std::string region_in_words(const analysis::CriticalNumber& critical) {
  std::string numbers;
  if (critical.at_least) numbers += fmt::format("{} or more", *critical.at_least);
  if (critical.at_least && critical.at_most) numbers += ", or ";
  if (critical.at_most) numbers += fmt::format("{} or fewer", *critical.at_most);
  if (numbers.empty())
    return fmt::format("none: {} in a cell, too few to reject guessing",
                       analysis::counted(critical.trials, "trial", "trials"));
  return fmt::format("{} correct of {} in a cell", numbers, critical.trials);
}

void print_regions(const ProtocolCheck& check) {
  const StudyPlan& regions = check.regions;
  if (!regions.critical)
    fmt::print("  critical value  depends on how often either interval is answered; it is in the report\n");
  else if (regions.looks.empty())
    fmt::print("  critical value  {} (size {:.4f}){}\n", region_in_words(*regions.critical),
               regions.critical->size, regions.critical_at_best ? ", whatever the other cells give" : "");
  if (regions.critical_at_best)
    fmt::print("  critical value  {}, if all other cells reject\n",
               region_in_words(*regions.critical_at_best));
  for (const analysis::PlannedLook& look : regions.looks)
    fmt::print("  critical value  at {}: {} (size by then {:.4f})\n",
               analysis::counted(look.critical.trials / check.protocol.trials_per_examinee_per_cell,
                                 "examinee", "examinees"),
               region_in_words(look.critical), look.size);
}

ordered_json critical_json(const analysis::CriticalNumber& critical, double size) {
  ordered_json json = {{"trials", critical.trials}, {"size", size}};
  if (critical.at_least) json["at_least"] = *critical.at_least;
  if (critical.at_most) json["at_most"] = *critical.at_most;
  return json;
}

/// Of every scene that is presented, each warning once.
void add_body_warnings(const trials::Stimuli& stimuli, std::vector<std::string>& warnings) {
  for (const auto& model : stimuli) {
    if (!model) continue;
    for (const sim::Body& body : model->bodies)
      for (const std::string& warning : body_warnings(*model, body)) {
        const std::string told = fmt::format("{}: {}", body.name, warning);
        if (std::ranges::find(warnings, told) == warnings.end()) warnings.push_back(told);
      }
  }
}

}  // namespace

ProtocolCheck check_protocol(const std::string& file) {
  ProtocolCheck check{.protocol = trials::load_protocol(file)};
  sim::ComplianceCache cache = user_cache();
  const trials::Stimuli stimuli = trials::compile_stimuli(check.protocol, cache);
  check.stimuli = check_stimuli(check.protocol, stimuli);
  check.warnings = stimulus_warnings(check.protocol, check.stimuli);
  add_body_warnings(stimuli, check.warnings);
  check.plan = trials::describe(check.protocol);
  check.regions = planned_regions(check.protocol);
  const double certain = check.protocol.analysis.side == trials::Side::Less ? 0.0 : 1.0;
  const double half_way = 0.5 * (check.protocol.task->chance + certain);
  check.power = analysis::primary_power(design_of(check.protocol), half_way);
  return check;
}

void print_text(const ProtocolCheck& check) {
  const trials::PlanSummary& plan = check.plan;
  fmt::print("{}: a sound protocol\n\n", check.protocol.name);
  fmt::print("  question        {}\n", check.protocol.question);
  const trials::Task& task = *check.protocol.task;
  fmt::print("  task            {}, {}\n", task.name, task.question_in_words(check.protocol));
  if (check.protocol.feedback)
    fmt::print(
        "  feedback        after each answer, for {:g} s: whether it was right, and which answer was\n",
        trials::kFeedbackTime);
  fmt::print("  cells           {}\n",
             fmt::join(plan.cells, plan.cells.front().find(',') == std::string::npos ? ", " : "; "));
  fmt::print("  trials          {} an examinee, {} planned: {} in each cell\n", plan.trials_per_session,
             analysis::counted(plan.planned_examinees, "examinee", "examinees"), plan.trials_per_cell);
  fmt::print("{}", analysis::wrapped(plan.order, "  order           ", "                  "));
  fmt::print("  predictability  the best rule that feels nothing is right in {:.0f} % of trials\n",
             100 * plan.best_guess);
  const trials::AnalysisPlan& analysis = check.protocol.analysis;
  fmt::print("  primary test    {}, {}, alpha {}{}\n", to_string(analysis.primary), to_string(analysis.side),
             analysis.alpha,
             analysis.adjust == trials::Adjust::None
                 ? ""
                 : fmt::format(", p adjusted over the cells: {}", to_string(analysis.adjust)));
  print_regions(check);
  fmt::print("  power           {:.4f} when {:.0f} % of answers are correct ({})\n", check.power.power,
             100 * check.power.probability,
             check.power.studies > 0 ? fmt::format("{} simulated studies", check.power.studies) : "exact");
  fmt::print("  duration        about {} an examinee\n",
             analysis::counted(trials::minutes_of(check.protocol), "minute", "minutes"));
  print_text(check.protocol, check.stimuli);
  for (const std::string& warning : check.warnings)
    fmt::print("{}", analysis::wrapped(warning, "warning: ", "         "));
}

ordered_json to_json(const ProtocolCheck& check) {
  const StudyPlan& regions = check.regions;
  ordered_json looks = ordered_json::array(), critical;  // null where it depends on the answers
  for (const analysis::PlannedLook& look : regions.looks)
    looks.push_back(critical_json(look.critical, look.size));
  if (regions.critical)
    critical = critical_json(*regions.critical,
                             regions.looks.empty() ? regions.critical->size : regions.looks.back().size);
  return {{"protocol", check.protocol.name},
          {"sha256", check.protocol.sha256},
          {"trials_per_examinee", check.plan.trials_per_session},
          {"planned_examinees", check.plan.planned_examinees},
          {"trials_per_cell", check.plan.trials_per_cell},
          {"cells", check.plan.cells},
          {"order", check.plan.order},
          {"best_guess", check.plan.best_guess},
          {"feedback", check.protocol.feedback},
          {"primary", to_string(check.protocol.analysis.primary)},
          {"alpha", check.protocol.analysis.alpha},
          {"side", to_string(check.protocol.analysis.side)},
          {"critical", critical},
          {"looks", looks},
          {"power",
           {{"probability", check.power.probability},
            {"power", check.power.power},
            {"simulated_studies", check.power.studies}}},
          {"minutes", trials::minutes_of(check.protocol)},
          {"stimuli", to_json(check.stimuli)},
          {"warnings", check.warnings}};
}

}  // namespace palpate::app
