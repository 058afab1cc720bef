#include "app/command_line/plot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "base/files/atomic_file.hpp"
#include "base/files/folder_of.hpp"

namespace palpate::app {
namespace {

// Source: [OkabeIto2008].
constexpr std::array<const char*, 7> kColours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                 "#E69F00", "#56B4E9", "#000000"};
constexpr std::array<int, 7> kMarks = {7, 5, 9, 13, 6, 4, 8};  // gnuplot's filled and open shapes

/// As gnuplot reads a text between single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += c == '\n' ? ' ' : c;
  }
  return result + "'";
}

/// A logarithmic x axis that ends shortly beyond the data: gnuplot's own would go on to the next decades.
std::string log_range(const Plot& plot) {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const PlotSeries& series : plot.series) {
    for (const double x : series.x) {
      least = std::min(least, x);
      most = std::max(most, x);
    }
  }
  return fmt::format("set logscale x\nset xrange [{:g}:{:g}]\n", least / 1.3, most * 1.3);
}

std::string script(const Plot& plot, bool svg) {
  std::string text = "set encoding utf8\n";
  text += svg ? "set terminal svg size 760,500 dynamic noenhanced font 'sans-serif,13' background '#ffffff'\n"
              : "set terminal pngcairo size 1140,750 noenhanced font 'sans,18' linewidth 1.4\n";
  // gnuplot gives a title of two lines one font, so the note is a label of its own.
  text += fmt::format("set title {} offset 0,{}\n", quoted(plot.title), plot.note.empty() ? 0 : 0.8);
  if (!plot.note.empty())
    text += fmt::format("set label 1 {} at screen 0.5,graph 1.035 center font ',{}' textcolor '#555555'\n",
                        quoted(plot.note), svg ? 10 : 14);
  text += fmt::format("set xlabel {}\nset ylabel {}\n", quoted(plot.x_label), quoted(plot.y_label));
  text += "set border 3 linecolor '#444444'\nset tics nomirror\nset grid linecolor '#e4e4e4' linetype 1\n";
  text += plot.series.size() == 1 ? "unset key\n" : "set key below Left reverse width 1 height 1\n";
  if (plot.log_x) text += log_range(plot);
  text += plot.log_y ? "set logscale y\n" : "set yrange [0:*]\n";
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const PlotSeries& series = plot.series[i];
    assert(series.x.size() == series.y.size());
    text += fmt::format("$s{} << end_of_series\n", i);
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      if (std::isfinite(series.x[k]) && std::isfinite(series.y[k]))
        text += fmt::format("{:.17g} {:.17g}\n", series.x[k], series.y[k]);
      else
        text += "\n";  // an empty line breaks the curve
    }
    text += "end_of_series\n";
  }
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const std::size_t points_a_mark = 1 + plot.series[i].x.size() / 25;
    text += fmt::format(
        "{} $s{} using 1:2 with linespoints linecolor '{}' pointtype {} pointinterval {} pointsize 0.6 "
        "linewidth 2 {} title {}",
        i == 0 ? "plot" : ",", i, kColours[i % kColours.size()], kMarks[i % kMarks.size()], points_a_mark,
        plot.series[i].dashed ? "dashtype 2" : "", quoted(plot.series[i].name));
  }
  return text + "\n";
}

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
  base::write_atomically(file, run_gnuplot(script(plot, file.extension() == ".svg")));
}

}  // namespace palpate::app
