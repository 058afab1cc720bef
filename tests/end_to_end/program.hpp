#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace palpate::test {

struct Outcome {
  int exit_code = -1;  // 128 + n when killed by signal n
  std::string out, err;
};

/// Runs the palpate that was built, as a user would.
Outcome run(const std::vector<std::string>& arguments);

/// The same with a terminal as standard output.
Outcome run_on_terminal(const std::vector<std::string>& arguments);

/// The same in the background, its output thrown away.
class Running {
 public:
  explicit Running(const std::vector<std::string>& arguments);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void send(int signal);
  int wait();  // exit code, or 128 + signal
  bool is_over();

 private:
  pid_t pid_ = -1;
  int status_ = -1;
};

}  // namespace palpate::test
