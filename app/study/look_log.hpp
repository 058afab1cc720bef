#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "analysis/report/report.hpp"
#include "trials/study/study_file.hpp"

namespace palpate::app {

/// Kinds of the events that record a look at the results before the study was over: one that nobody planned,
/// and one of those that the protocol plans.
constexpr std::string_view kInterimLook = "interim look";
constexpr std::string_view kPlannedLook = "planned look";

/// The look that an event records; empty for events of other kinds.
std::optional<analysis::LookEvent> look_of(const trials::EventRow& event);

/// The event that must be in the study file before `report` is shown to anybody: a planned look the first
/// time it is taken, an unplanned one every time. Empty where nothing is to be logged.
/// @param logged  the looks that the file holds already
std::optional<trials::EventRow> look_to_log(const analysis::StudyReport& report,
                                            const std::vector<analysis::LookEvent>& logged);

/// Writes it into the study file. Throws what open_study() throws.
void log_look(const std::filesystem::path& study, const trials::EventRow& event);

}  // namespace palpate::app
