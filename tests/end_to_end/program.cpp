#include "tests/end_to_end/program.hpp"

#include <fcntl.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "tests/support/places.hpp"

namespace palpate::test {
namespace {

int code_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

pid_t start(const std::vector<std::string>& arguments, int out, int err) {
  std::vector<char*> argv{const_cast<char*>(program_file().c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t pid = ::fork();
  if (pid < 0) throw std::runtime_error("cannot fork");
  if (pid == 0) {
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    ::execv(program_file().c_str(), argv.data());
    ::_exit(127);
  }
  return pid;
}

/// A temporary file without a name, for the program's output.
class Capture {
 public:
  Capture() : file_(std::tmpfile()) {
    if (!file_) throw std::runtime_error("no temporary file");
  }
  ~Capture() { std::fclose(file_); }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  int descriptor() const { return ::fileno(file_); }
  std::string text() const {
    std::string text;
    std::rewind(file_);
    for (int c = std::fgetc(file_); c != EOF; c = std::fgetc(file_)) text += static_cast<char>(c);
    return text;
  }

 private:
  std::FILE* file_;
};

}  // namespace

Outcome run(const std::vector<std::string>& arguments) {
  const Capture out, err;
  const pid_t pid = start(arguments, out.descriptor(), err.descriptor());
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return {.exit_code = code_of(status), .out = out.text(), .err = err.text()};
}

Outcome run_on_terminal(const std::vector<std::string>& arguments) {
  int mine = -1, its = -1;
  if (::openpty(&mine, &its, nullptr, nullptr, nullptr) != 0) throw std::runtime_error("no pseudo-terminal");
  const Capture err;
  const pid_t pid = start(arguments, its, err.descriptor());
  ::close(its);
  std::string out;
  char part[4096];
  for (ssize_t got = ::read(mine, part, sizeof part); got > 0; got = ::read(mine, part, sizeof part))
    out.append(part,
               static_cast<std::size_t>(got));  // ends with an error once the program has closed its side
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  ::close(mine);
  return {.exit_code = code_of(status), .out = out, .err = err.text()};
}

Running::Running(const std::vector<std::string>& arguments) {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  pid_ = start(arguments, nowhere, nowhere);
  ::close(nowhere);
}

Running::~Running() {
  if (status_ >= 0) return;
  send(SIGKILL);
  wait();
}

void Running::send(int signal) {
  ::kill(pid_, signal);
}

int Running::wait() {
  if (status_ < 0)
    while (::waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
    }
  return code_of(status_);
}

bool Running::is_over() {
  if (status_ >= 0) return true;
  int status = 0;
  if (::waitpid(pid_, &status, WNOHANG) != pid_) return false;
  status_ = status;
  return true;
}

}  // namespace palpate::test
