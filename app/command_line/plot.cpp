#include "app/command_line/plot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "app/command_line/plot_script.hpp"
#include "base/files/atomic_file.hpp"
#include "base/files/folder_of.hpp"

namespace palpate::app {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;  // with no name in any folder: nothing is left behind

File temporary_file() {
  File file(std::tmpfile());
  if (!file) throw std::system_error(errno, std::generic_category(), "cannot make a temporary file");
  return file;
}

std::string contents(std::FILE* file) {
  std::string text;
  std::array<char, 65536> block{};
  std::rewind(file);
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file))
    text.append(block.data(), count);
  return text;
}

/// What gnuplot writes when it reads `commands`.
std::string run_gnuplot(const std::string& commands) {
  const File in = temporary_file(), out = temporary_file(), errors = temporary_file();
  if (std::fwrite(commands.data(), 1, commands.size(), in.get()) != commands.size() ||
      std::fflush(in.get()) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot write a temporary file");
  std::rewind(in.get());

  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_adddup2(&streams, fileno(in.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&streams, fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&streams, fileno(errors.get()), STDERR_FILENO);
  std::string name = "gnuplot";
  std::array<char*, 2> arguments = {name.data(), nullptr};
  pid_t child = 0;
  const int refused = posix_spawnp(&child, "gnuplot", &streams, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  if (refused == ENOENT)
    throw std::runtime_error("gnuplot is not installed, which draws plots: apt-get install gnuplot-nox");
  if (refused != 0) throw std::system_error(refused, std::generic_category(), "cannot start gnuplot");

  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  std::string picture = contents(out.get());
  if (status != 0 || picture.empty())
    throw std::runtime_error(fmt::format("gnuplot fails: {}", contents(errors.get())));
  return picture;
}

}  // namespace

void check_plot_file(const std::filesystem::path& file) {
  if (file.extension() != ".svg" && file.extension() != ".png")
    throw std::invalid_argument(
        fmt::format("--plot {}: accepted: a file name that ends in .svg or .png", file.string()));
  base::require_folder_of(file);
}

void draw_plot(const Plot& plot, const std::filesystem::path& file) {
  check_plot_file(file);
  base::write_atomically(file, run_gnuplot(plot_script(plot, file.extension() == ".svg")));
}

}  // namespace palpate::app
