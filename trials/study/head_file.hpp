#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "trials/study/receipt.hpp"

namespace palpate::trials {

/// The second trace of a study's answers: a small file beside it, STUDY.head, that holds where the chain
/// stood when something was last called saved. A write-ahead log that is cut, damaged or left behind loses
/// its last answers in silence; the head beside the file tells. Two lines of one length, each with a
/// checksum, written in turn: a line that a power cut tears leaves the other.
struct ChainHead {
  std::string uuid{};  // of the study
  Receipt receipt{};

  bool operator==(const ChainHead&) const = default;
};

/// What the file beside a study says.
struct HeadFile {
  enum class State { Missing, Unreadable, Damaged, Good };
  State state = State::Missing;
  std::optional<ChainHead> newest{};  // of Good: of the lines that are whole, the one with more entries
  std::size_t newest_line = 0;
};

/// "study.db.head" of "study.db".
std::filesystem::path head_path(const std::filesystem::path& study);

/// Never throws for what the file holds: that is its state.
HeadFile read_head(const std::filesystem::path& study);

/// Writes where the chain stands, on the disk when this returns (mode 0600). Another study's head, or one
/// that is damaged, is replaced. Throws std::system_error that names the file when the drive refuses.
void write_head(const std::filesystem::path& study, const ChainHead& head);

}  // namespace palpate::trials
