#include "app/command_line/plot_layout.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "app/command_line/plot_script.hpp"

namespace palpate::app {
namespace {

using testing::ElementsAre;

TEST(Wrapped, BreaksAtSpacesAndWithinAWordOnlyWhereItIsLonger) {
  EXPECT_THAT(wrapped("kuroda, 0.3", 20), ElementsAre("kuroda, 0.3"));
  EXPECT_THAT(wrapped("kuroda, 0.3, low", 12), ElementsAre("kuroda, 0.3,", "low"));
  EXPECT_THAT(wrapped("abcdefgh", 3), ElementsAre("abc", "def", "gh"));
  EXPECT_THAT(wrapped("µµµµ", 2), ElementsAre("µµ", "µµ"));
  EXPECT_THAT(wrapped("", 3), ElementsAre());
}

Plot with_panels(std::size_t panels) {
  Plot plot{.title = "t", .note = std::string(300, 'n'), .x_label = "x", .y_label = "y"};
  for (std::size_t i = 0; i < panels; ++i)
    plot.panels.push_back(
        {.title = std::string(20 * (i + 1), 'c'), .series = {{.name = "a", .x = {0, 1}, .y = {0, 1}}}});
  return plot;
}

bool apart(const PlotBox& a, const PlotBox& b) {
  return a.right < b.left || b.right < a.left || a.top < b.bottom || b.top < a.bottom;
}

TEST(LayoutOf, NothingOverlapsOrLeavesThePage) {
  for (std::size_t panels = 1; panels <= 12; ++panels) {
    const PlotLayout page = layout_of(with_panels(panels), {"soft", "hard", std::string(200, 'n')});
    ASSERT_EQ(page.panels.size(), panels);
    const double titles = page.note_at - 14.0 * static_cast<double>(page.note.size()) / page.height;
    for (std::size_t i = 0; i < panels; ++i) {
      const PlotBox& box = page.panels[i];
      const double own_title = 18.0 * static_cast<double>(page.panel_titles[i].size()) / page.height;
      EXPECT_LT(box.top + own_title, titles) << panels;
      EXPECT_GT(box.left * page.width, 50.0);  // room for numbers and the axis' name
      EXPECT_LT(box.right, 1.0);
      EXPECT_GT((box.bottom - page.key.top) * page.height, 40.0);
      for (std::size_t k = 0; k < i; ++k) EXPECT_TRUE(apart(box, page.panels[k])) << panels;
    }
    EXPECT_GE(page.key.bottom, 0.0);
    EXPECT_EQ(page.key_columns, 1U);  // for a name that is as long
  }
}

TEST(PlotScript, AxesAreTheSameInEveryPanelAndHoldBandsAndLimits) {
  Plot plot = with_panels(2);
  plot.panels[1].series = {{.name = "a", .x = {0, 4}, .y = {0, 10}, .high = {0, 20}}};
  plot.limits = {{"limit", 100.0}};
  const std::string script = plot_script(plot, true);
  EXPECT_THAT(script, testing::HasSubstr("set xrange [0:4]\nset yrange [0:106]\n"));
  EXPECT_EQ(script.find("yrange"), script.rfind("yrange")) << "a range for one panel alone";
}

TEST(PlotScript, ASeriesLooksTheSameInEveryPanel) {
  Plot plot = with_panels(2);
  plot.panels[0].series = {{.name = "soft", .x = {0, 1}, .y = {0, 1}},
                           {.name = "hard", .x = {0, 1}, .y = {0, 2}}};
  plot.panels[1].series = {{.name = "hard", .x = {0, 1}, .y = {0, 3}}};
  const std::string script = plot_script(plot, true);
  const auto look_of = [&](const std::string& data) {
    const auto at = script.find(data + " using") + data.size();
    return script.substr(at, script.find(" notitle", at) - at);
  };
  EXPECT_EQ(look_of("$p0s1"), look_of("$p1s0"));
  EXPECT_NE(look_of("$p0s0"), look_of("$p1s0"));
}

}  // namespace
}  // namespace palpate::app
