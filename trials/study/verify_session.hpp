#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "trials/study/chain_parts.hpp"
#include "trials/study/stores.hpp"
#include "trials/study/verify.hpp"

namespace palpate::trials {

/// What is wrong with a study file, the first of it.
class FirstProblems {
 public:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    constexpr std::size_t kMost = 100;  // enough to see what happened
    if (found_.size() < kMost) found_.push_back(fmt::format(format, std::forward<Values>(values)...));
  }
  std::vector<std::string> take() { return std::move(found_); }

 private:
  std::vector<std::string> found_{};
};

/// A sitting, and where it is looked up.
struct SittingInFile {
  const StudyFile::Stores& stores;
  const ChainParts& chains;
  const std::vector<EventRow>& events;
  const SessionRow& session;
};

/// Checks one sitting (its facts and orders against what was hashed when it began, answers against orders and
/// presentations, traces) and gathers the text of each of its answers, by entry of the chain.
void check_session(const SittingInFile& sitting, VerifyScope scope,
                   std::map<std::int64_t, std::string>& texts, VerifyReport& report, FirstProblems& problems);

}  // namespace palpate::trials
