#include "app/study/look_log.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <string>

namespace palpate::app {
namespace {

// What stands in `text` between `before` and the next one of `ends`; empty where it does not.
std::string_view between(std::string_view text, std::string_view before, std::string_view ends) {
  const std::size_t at = text.find(before);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = text.substr(at + before.size());
  return rest.substr(0, rest.find_first_of(ends));
}

std::string complete_of_planned(const analysis::StudyReport& report) {
  return fmt::format("{} of {} planned examinees complete", report.complete_examinees,
                     report.planned_examinees);
}

}  // namespace

std::optional<analysis::LookEvent> look_of(const trials::EventRow& event) {
  if (event.kind != kInterimLook && event.kind != kPlannedLook) return std::nullopt;
  analysis::LookEvent look{
      .run_mode = std::string(between(event.text, "run mode ", ",")), .utc = event.utc, .text = event.text};
  if (event.kind == kPlannedLook) {
    const std::string_view number = between(event.text, ", look ", " ");
    std::from_chars(number.data(), number.data() + number.size(), look.planned);
  }
  return look;
}

std::optional<trials::EventRow> look_to_log(const analysis::StudyReport& report,
                                            const std::vector<analysis::LookEvent>& logged) {
  if (report.look) {
    const auto same = [&](const analysis::LookEvent& look) {
      return look.run_mode == report.run_mode && look.planned == report.look->number;
    };
    if (std::ranges::any_of(logged, same)) return std::nullopt;
    return trials::EventRow{
        .kind = std::string(kPlannedLook),
        .text = fmt::format("run mode {}, look {} of {}, {}", report.run_mode, report.look->number,
                            report.look->of, complete_of_planned(report)),
        .utc = report.options.written_utc};
  }
  if (report.complete || !report.options.interim) return std::nullopt;
  return trials::EventRow{
      .kind = std::string(kInterimLook),
      .text = fmt::format("run mode {}, {}", report.run_mode, complete_of_planned(report)),
      .utc = report.options.written_utc};
}

void log_look(const std::filesystem::path& study, const trials::EventRow& event) {
  const trials::Protocol protocol = trials::read_study(study).protocol();
  trials::open_study(study, protocol, PALPATE_VERSION).add_event(event);
}

}  // namespace palpate::app
