#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/procedures/procedure.hpp"

namespace palpate::app {

// A procedure's description in the forms that its users read.

/// One line for `palpate stats --help`: "Are more answers correct than guessing gives? (exact binomial test)"
std::string summary_of(const analysis::Procedure& procedure);

/// For `palpate stats NAME --help`, below its options: what it tests, its data, an example.
std::string teaching_of(const analysis::Procedure& procedure);

/// All of them: a list for a terminal, the page docs/procedures.md, and an object for programs.
std::string procedures_as_text();
std::string procedures_as_markdown();
nlohmann::ordered_json procedures_as_json();

}  // namespace palpate::app
