#pragma once

#include <optional>
#include <string>

#include "trials/study/head_file.hpp"
#include "trials/study/stores.hpp"

namespace palpate::trials {

/// What to say of a study that no longer holds what the head beside it (read before the study) was written
/// for: answers that were called saved are lost. Nothing when it does, or when there is no head to compare
/// with: none, another study's, or one that this user may not read.
std::optional<std::string> lost_after_head(const StudyFile::Stores& stores, const HeadFile& beside);

}  // namespace palpate::trials
