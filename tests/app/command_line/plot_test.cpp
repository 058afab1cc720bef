#include "app/command_line/plot.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
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
          .panels = {{.series = {{.name = "soft", .x = {0, 1, 2}, .y = {0, 0.5, 1.5}},
                                 {.name = "hard", .x = {0, 1, 2}, .y = {0, NAN, 3}}}}}};
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

using Points = std::array<std::array<double, 2>, 4>;  // on the page, y downwards

/// The one rising curve of four points: an SVG path writes it as "Mx,y Lx,y Lx,y Lx,y". Frames and ticks have
/// fewer points, or come back.
std::optional<Points> rising_curve(const std::string& svg) {
  for (auto at = svg.find('M'); at != std::string::npos; at = svg.find('M', at + 1)) {
    Points p{};
    const int numbers = std::sscanf(svg.c_str() + at, "M%lf,%lf L%lf,%lf L%lf,%lf L%lf,%lf", &p[0][0],
                                    &p[0][1], &p[1][0], &p[1][1], &p[2][0], &p[2][1], &p[3][0], &p[3][1]);
    if (numbers == 8 && p[3][0] > p[0][0] && p[3][1] < p[0][1]) return p;
  }
  return std::nullopt;
}

TEST_F(PlotTest, CurvesRunWhereTheNumbersAre) {
  const auto file = folder_ / "curve.svg";
  draw_plot({.title = "t",
             .x_label = "x",
             .y_label = "y",
             .panels = {{.series = {{.name = "square", .x = {0, 1, 2, 4}, .y = {0, 1, 4, 16}}}}}},
            file);
  const std::optional<Points> curve = rising_curve(read(file));
  ASSERT_TRUE(curve.has_value());
  const Points& p = *curve;
  for (const std::size_t k : {1U, 2U}) {
    const double x = static_cast<double>(k) / 4.0;  // share of the way to the last point; y is its square
    // gnuplot writes hundredths of a pixel, and the picture is some hundreds high.
    EXPECT_NEAR((p[k][0] - p[0][0]) / (p[3][0] - p[0][0]), x, 2e-4);
    EXPECT_NEAR((p[k][1] - p[0][1]) / (p[3][1] - p[0][1]), x * x, 2e-4);
  }
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
