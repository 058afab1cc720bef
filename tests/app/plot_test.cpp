#include "app/plot.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace palpate::app {
namespace {

using testing::HasSubstr;

/// A folder that goes with the test.
class PlotTest : public testing::Test {
 protected:
  PlotTest() : folder_(testing::TempDir() + "palpate_plot_" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
  }
  ~PlotTest() override { std::filesystem::remove_all(folder_); }
  std::string read(const std::filesystem::path& file) const {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::filesystem::path folder_;
};

Plot two_lines() {
  return {.title = "Reaction force at the finger's tip",
          .note = "{no_markup}",
          .x_label = "depth [mm]",
          .y_label = "force [N]",
          .series = {{"soft", {0, 1, 2}, {0, 0.5, 1.5}}, {"hard", {0, 1, 2}, {0, NAN, 3}, true}}};
}

TEST_F(PlotTest, SvgHoldsEveryWordAndTwoCurves) {
  const auto file = folder_ / "plot.svg";
  draw_plot(two_lines(), file);
  const std::string svg = read(file);
  EXPECT_EQ(svg.rfind("<?xml", 0), 0U);
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  for (const char* word : {"finger", "tip", "{no_markup}", "depth [mm]", "force [N]", "soft", "hard"})
    EXPECT_THAT(svg, HasSubstr(word));
  EXPECT_THAT(svg, HasSubstr("stroke-dasharray"));
}

TEST_F(PlotTest, PngIsPng) {
  const auto file = folder_ / "plot.png";
  draw_plot(two_lines(), file);
  EXPECT_EQ(read(file).rfind("\x89PNG\r\n", 0), 0U);
}

TEST_F(PlotTest, RefusesOtherFileNames) {
  try {
    draw_plot(two_lines(), folder_ / "plot.pdf");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr(".svg or .png"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "plot.pdf"));
}

TEST_F(PlotTest, SaysHowToInstallGnuplot) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder_.c_str(), 1);
  try {
    draw_plot(two_lines(), folder_ / "plot.svg");
    ADD_FAILURE() << "drawn without gnuplot";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("apt-get install gnuplot-nox"));
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "plot.svg"));
}

}  // namespace
}  // namespace palpate::app
