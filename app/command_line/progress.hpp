#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace palpate::app {

/// A bar on stderr while long work goes on; nothing where stderr is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what) : what_(std::move(what)), shown_(::isatty(STDERR_FILENO) == 1) {}
  ~ProgressBar() {
    if (drawn_) std::fputs("\n", stderr);
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(int done, int total) {
    if (!shown_ || total <= 0) return;
    constexpr int kWidth = 40;
    const int filled = kWidth * done / total;
    fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {}/{}", what_, "", filled, "", kWidth - filled, done, total);
    std::fflush(stderr);
    drawn_ = true;
  }

 private:
  std::string what_;
  bool shown_;
  bool drawn_ = false;
};

}  // namespace palpate::app
