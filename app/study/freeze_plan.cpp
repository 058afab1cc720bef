#include "app/study/freeze_plan.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/command_line/user_cache.hpp"
#include "app/study/study_table.hpp"
#include "base/clock/utc.hpp"
#include "base/files/sha256.hpp"
#include "trials/protocol/stimuli.hpp"

namespace palpate::app {
namespace {

using nlohmann::ordered_json;

/// What was decided before the first answer. Its text is what is hashed, so the order of the keys is fixed.
ordered_json frozen_text(const trials::Protocol& protocol) {
  const analysis::StudyDesign design = design_of(protocol);
  return {{"protocol", design.protocol_name},
          {"protocol_sha256", design.protocol_sha256},
          {"primary", design.primary},
          {"alpha", design.alpha},
          {"side", design.side},
          {"adjust", design.adjust},
          {"between_models", design.between_models},
          {"planned_examinees", design.planned_examinees},
          {"trials_per_examinee_per_cell", design.trials_per_examinee_per_cell},
          {"interval_order", design.interval_order},
          {"looks", design.looks},
          {"spending", design.spending},
          {"software_version", PALPATE_VERSION}};
}

void refuse_if_late(const trials::StudyFile& study) {
  const std::string file = study.path().string();
  for (const trials::EventRow& event : study.events()) {
    if (event.kind != kPlanFrozen) continue;
    throw std::invalid_argument(fmt::format("{}: a plan was frozen on {} already, SHA-256 {}", file,
                                            event.utc, base::sha256_hex(event.text)));
  }
  for (const trials::SessionRow& session : study.sessions()) {
    if (session.facts.run_mode != trials::RunMode::Study || study.answers(session.id).empty()) continue;
    throw std::invalid_argument(fmt::format(
        "{}: examinee {} has answered already; a plan is frozen before the first answer of the study", file,
        session.facts.examinee));
  }
}

}  // namespace

std::string freeze_plan(const trials::Protocol& protocol, const std::filesystem::path& path) {
  sim::ComplianceCache cache = user_cache();
  trials::compile_stimuli(protocol, cache);  // no plan is frozen for a study that cannot run
  if (std::filesystem::exists(path)) refuse_if_late(trials::read_study(path));
  trials::StudyFile study = trials::open_study(path, protocol, PALPATE_VERSION);
  const std::string text = frozen_text(protocol).dump();
  study.add_event({.kind = std::string(kPlanFrozen), .text = text, .utc = base::utc_now()});
  return base::sha256_hex(text);
}

}  // namespace palpate::app
