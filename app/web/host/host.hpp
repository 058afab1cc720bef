#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/web/pages/examinee/sitting.hpp"
#include "trials/session/session.hpp"

namespace palpate::app {

struct HostOptions {
  std::uint16_t port = 0;  // 0: the operating system chooses
  bool open_browser = true;
  /// Where the page's link is kept while its sitting is unfinished, and whose that is.
  std::filesystem::path kept_link{};
  std::string sitting{};
};

enum class HostEnd { Complete, Stopped };

/// A page that is served and not yet led: holds the port, so that a port that cannot be had is known before
/// anything is written.
class Host {
 public:
  /// Throws std::runtime_error that names the port when it cannot be had.
  explicit Host(const HostOptions& options);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Leads the examinee through `session`, until every question is answered or the technician stops (Ctrl-C:
  /// what was being felt is stored as cut off). The hand is `device`'s.
  HostEnd lead(trials::Session& session, const trials::Protocol& protocol, const Organs& organs,
               devices::OpenDevice device);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace palpate::app
