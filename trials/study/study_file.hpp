#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "trials/protocol/protocol.hpp"
#include "trials/study/event.hpp"
#include "trials/study/receipt.hpp"
#include "trials/study/rows.hpp"
#include "trials/trace/trace.hpp"

namespace palpate::trials {

/// An open study file: one SQLite database. All SQL is in the stores behind it.
/// Every function throws std::runtime_error that names the file when the disk refuses; what was committed
/// stays.
class StudyFile {
 public:
  ~StudyFile();
  StudyFile(StudyFile&&) noexcept;
  StudyFile& operator=(StudyFile&&) noexcept;

  const std::filesystem::path& path() const;
  StudyRow study() const;
  const Protocol& protocol() const;          // the design that the file holds; scene and meshes not looked at
  std::vector<SessionRow> sessions() const;  // in the order in which they began
  std::vector<DrawnTrial> trials(std::int64_t session) const;              // by number, then draw
  std::vector<PresentationRow> presentations(std::int64_t session) const;  // in the order of time
  std::vector<AnswerRow> answers(std::int64_t session) const;              // by trial
  std::vector<EventRow> events() const;
  Trace load_trace(std::int64_t presentation) const;  // throws std::invalid_argument when it is damaged
  Receipt receipt() const;

  /// Voids a trial (or answers to it later), with the reason; the answer stays.
  void add_event(const EventRow& event);

  /// Keeps other programs from leading a session in this study until this file is closed, or the process
  /// dies. Throws std::runtime_error when one does already, with its process id where the system tells it.
  void lock_for_sessions();

  struct Stores;
  Stores& stores() { return *stores_; }  // for Session only

 private:
  friend StudyFile open_study(const std::filesystem::path&, const Protocol&, std::string_view);
  friend StudyFile read_study(const std::filesystem::path&);
  explicit StudyFile(std::unique_ptr<Stores> stores);
  std::unique_ptr<Stores> stores_;
};

/// Refuses what open_study() would refuse, and writes nothing: a file that is no study file (foreign,
/// truncated, empty, of a newer version), a study of another protocol, scene or mesh, a folder that is
/// missing or cannot be written, a network drive. A file that does not exist is fine.
void check_study(const std::filesystem::path& path, const Protocol& protocol);

/// Opens the study of `protocol`, or makes it (whole or not at all) where there is no file yet. Checks first,
/// as check_study() does. Call it when nothing else can fail any more.
StudyFile open_study(const std::filesystem::path& path, const Protocol& protocol,
                     std::string_view software_version);

/// Opens an existing study file for reading only. Throws std::invalid_argument for a file that is none.
StudyFile read_study(const std::filesystem::path& path);

}  // namespace palpate::trials
