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

TEST_F(PlotTest, CurvesRunWhereTheNumbersAre) {
  // y = x: equal steps along both axes, so the path's points lie on one line. gnuplot writes "M x,y L x,y".
  const auto file = folder_ / "line.svg";
  draw_plot({.title = "t", .x_label = "x", .y_label = "y", .series = {{"line", {0, 1, 2, 4}, {0, 1, 2, 4}}}},
            file);
  const std::string svg = read(file);
  const auto coloured = svg.find("rgb(  0, 114, 178)");
  ASSERT_NE(coloured, std::string::npos);
  // The last path of this colour before the marks that has four points.
  bool found = false;
  for (auto at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) {
    const auto d = svg.find("d='M", at) + 4;
    double x[4], y[4];
    if (std::sscanf(svg.c_str() + d, "%lf,%lf L%lf,%lf L%lf,%lf L%lf,%lf", &x[0], &y[0], &x[1], &y[1], &x[2],
                    &y[2], &x[3], &y[3]) != 8)
      continue;
    if (x[3] <= x[0] || y[3] >= y[0]) continue;  // a frame or a mark, not a rising line
    found = true;
    for (const int k : {1, 2}) {
      const double share = k / 4.0;
      EXPECT_NEAR((x[k] - x[0]) / (x[3] - x[0]), share, 0.005);  // gnuplot rounds to a tenth of a pixel
      EXPECT_NEAR((y[k] - y[0]) / (y[3] - y[0]), share, 0.005);
    }
  }
  EXPECT_TRUE(found);
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
