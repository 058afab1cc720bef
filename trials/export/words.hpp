#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trials/export/datasets.hpp"

namespace palpate::trials {

/// Letters and digits of a name: what both formats take as part of a file's name. Throws
/// std::invalid_argument when none are left.
std::string label_of(std::string_view name);

/// What the data are, in a few sentences: the study, its sittings by run mode, whether any of it counts.
std::string describe_dataset(const StudyFile& study);

/// What the examinee does and is told, in a sentence or two.
std::string describe_course(const Protocol& protocol);

/// A table's codebook as Markdown.
std::string codebook_markdown(const Table& table);

/// "- Exported ...", as the CPAN change log has it, for CHANGES.
std::string changes_text(const StudyFile& study, const ExportFacts& facts);

/// Throws std::runtime_error that lists the first of `problems`, unless there are none.
void refuse_problems(std::string_view what, const std::vector<std::string>& problems);

}  // namespace palpate::trials
