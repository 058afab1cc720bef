#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "trials/study/clock_steps.hpp"
#include "trials/study/merged_part.hpp"
#include "trials/study/receipt.hpp"

namespace palpate::trials {

/// What `palpate verify` found.
struct VerifyReport {
  std::vector<std::string> problems{};  // empty: the file is whole
  std::vector<std::string> notes{};     // what to know of a file that is: a log that belongs to it
  Receipt receipt{};
  int sessions = 0, answers = 0, presentations = 0, voided = 0;
  std::vector<MergedPart> parts{};       // of a joined file
  std::vector<ClockStep> clock_steps{};  // back; the file is whole all the same
};

/// What verify_study() looks at. `Answers`: all but the database's pages and the traces' contents, which take
/// time in a large file.
enum class VerifyScope { Answers, Everything };

/// Integrity of the database, its schema, every hash, the chain, answers against the plan, every trace. With
/// a receipt, whether the chain still holds the entry that the receipt was printed for; in a joined file, the
/// receipts of its parts hold as well. The head beside the file (head_file.hpp) is compared as a receipt is. A
/// table that is missing or a protocol that cannot be read is a problem
/// in the report; throws std::invalid_argument for what is no study file, or too damaged to be read as one.
VerifyReport verify_study(const std::filesystem::path& path, const std::optional<Receipt>& receipt = {},
                          VerifyScope scope = VerifyScope::Everything);

/// Throws std::invalid_argument, with the number of problems and the first of them, unless answers, orders
/// and chain fit together (VerifyScope::Answers).
void require_whole(const std::filesystem::path& study);

}  // namespace palpate::trials
