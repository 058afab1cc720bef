#include "trials/study/lost_answers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace palpate::trials {
namespace {

bool in_ledger(const StudyFile::Stores& stores, const Receipt& receipt) {
  const auto ledger = stores.ledger.all();
  const auto entry = std::ranges::find(ledger, receipt.entries, &LedgerEntry::entry);
  return receipt.entries == 0 || (entry != ledger.end() && entry->hash == receipt.head);
}

}  // namespace

std::optional<std::string> lost_after_head(const StudyFile::Stores& stores, const HeadFile& beside) {
  const std::string study = stores.path.string(), head = head_path(stores.path).string();
  if (beside.state == HeadFile::State::Damaged)
    return fmt::format(
        "{}: {}, which tells how far it was saved, is damaged; compare with the last receipt that was "
        "written down (--receipt of `palpate verify`), then remove {}",
        study, head, head);
  if (!beside.newest || beside.newest->uuid != stores.study.uuid) return std::nullopt;
  const Receipt& saved = beside.newest->receipt;
  if (in_ledger(stores, saved)) return std::nullopt;
  const std::int64_t holds = stores.ledger.head(stores.study).entries;
  if (holds >= saved.entries)
    return fmt::format(
        "{}: entry {} of the chain is not the one that was saved, as {} tells: the file was rewritten, or a "
        "copy was gone on with in its place",
        study, saved.entries, head);
  return fmt::format(
      "{}: {} entries of the chain were saved, as {} tells, and {} are there: the others were lost with the "
      "write-ahead log {}-wal (cut, damaged, or left behind by a copy), or an older copy was put in its "
      "place; accepted: the file with all of them, from a backup; to go on with what is left, remove {}",
      study, saved.entries, head, holds, study, head);
}

}  // namespace palpate::trials
