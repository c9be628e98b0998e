#include "widgets/report/experiment_pages.h"

#include "core/image/colour_map.h"
#include "widgets/report/document.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

Message shown(const char* words) { return Message::typed(words); }

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++count;
  return count;
}

std::size_t pages_of_paper(const Document& document) {
  const auto pdf = document.pdf("2026-01-31T12:00:00Z");
  EXPECT_TRUE(pdf);
  return count_of(*pdf, "/Type /Page\n");
}

/// A ramp from -0.2 to 1.2 mm of depth, and its difference from one that is 0.05 mm higher.
ExperimentMaps ramps() {
  cv::Mat_<float> ramp(30, 141), higher(30, 141);
  for (int v = 0; v < ramp.rows; ++v)
    for (int u = 0; u < ramp.cols; ++u) {
      ramp(v, u) = 0.01F * static_cast<float>(u - 20);
      higher(v, u) = ramp(v, u) + 0.05F;
    }
  ExperimentMaps maps;
  maps.caption = en::say("a ramp");
  maps.depths = {{en::say("truth"), ramp}, {en::say("ours"), higher}};
  maps.differences = {{en::say("ours, error"), higher - ramp}};
  maps.top_mm = 1.0;
  return maps;
}

ExperimentReport some_report() {
  ExperimentReport report;
  report.date = "2026-01-31T12:34:56Z";
  report.program_version = "0.1.0";
  const auto all = experiments_named({"pose", "thread"}).value();
  ExperimentDone pose{all[0], {}, 1.5};
  pose.outcome.frames = 12;
  pose.outcome.figures = {{en::say("angle <mean>, within +-20"), "degrees", 0.0204, 12.06, 1.0},
                          {en::say("angle, greatest"), "degrees", 1.5, {}, 1.0},
                          {en::say("told"), "%", 99.96, {}, {}, true}};
  ExperimentPlot bars =
      compared_bars(shown("bars"), shown("N"), {shown("a"), shown("b")}, {1, 2}, {3, 4});
  bars.series.push_back(level_line(shown("target"), ExperimentSeries::Style::kAim, 2.5, -0.5, 1.5));
  pose.outcome.plots = {bars};
  pose.outcome.remarks = {en::say("what a figure does not say")};
  ExperimentDone thread{all[1], {}, 0.5};
  thread.outcome.maps = {ramps()};
  report.done = {pose, thread};
  return report;
}

TEST(ExperimentPages, PutOursBesideThePapers) {
  const auto files = make_experiment_pages(some_report(), "x");
  ASSERT_TRUE(files);
  EXPECT_EQ(files->at(0).name, "x.html");
  const std::string& html = files->at(0).content;
  for (const char* words :
       {"Our values are simulated", "the paper's were measured", "1 of 2 figures with an aim",
        "Angle &lt;mean&gt;, within ±20", ">0.020<", ">12.06<", ">missed<", ">100.0<",
        "What a figure does not say.", "12 frames of experiment_pose in 1.5 s",
        "alltact experiments pose --seed 1", "A ramp."})
    EXPECT_TRUE(html.find(words) != std::string::npos) << words;  // nobody reads its pictures
  // In the overview too, where what has neither is not.
  EXPECT_EQ(count_of(html, "Angle &lt;mean&gt;"), 2U);
  EXPECT_EQ(count_of(html, ">Told<"), 1U);
  EXPECT_EQ(count_of(html, "<img src=\"data:image/png;base64,"), 2U);
  for (const char* outside : {"http:", "https:", "file:", "picture:"})
    EXPECT_TRUE(html.find(outside) == std::string::npos) << outside;
}

TEST(ExperimentPages, AreTheSameBytesForTheSameReport) {
  const auto one = make_experiment_pages(some_report(), "x");
  const auto two = make_experiment_pages(some_report(), "x");
  ASSERT_TRUE(one && two);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(one->at(i).content == two->at(i).content) << i;
  EXPECT_THAT(one->at(1).content, testing::StartsWith("%PDF"));
}

TEST(ReliefPicture, ShowsDepthsAndDifferencesInTheirOwnScales) {
  constexpr int kWidth = 600;
  const ExperimentMaps maps = ramps();
  const QImage image = relief_image(maps, kWidth, 2);
  ASSERT_EQ(image.width(), 2 * kWidth);
  const auto colour_at = [&](double x, double y) {
    return image.pixelColor(qRound(2 * x), qRound(2 * y));
  };
  const auto is_near = [](const QColor& seen, const MapColour& wanted) {
    return std::abs(seen.red() - wanted.red) + std::abs(seen.green() - wanted.green) +
               std::abs(seen.blue() - wanted.blue) <
           12;
  };
  // Two maps beside each other with 8 px between them, below a line of 18 px.
  const double map_width = (kWidth - 8 - 1) / 2.0, height = map_width * 30 / 141;
  const double row = 18 + 0.5 * height, next_row = row + 18 + height + 8;
  for (const double mm : {0.1, 0.3, 0.6, 0.9}) {
    const double x = map_width * (100 * mm + 20.5) / 141;
    EXPECT_TRUE(is_near(colour_at(x, row), depth_colour(mm))) << mm;
    EXPECT_TRUE(is_near(colour_at(map_width + 8 + x, row), depth_colour(mm + 0.05))) << mm;
    EXPECT_TRUE(is_near(colour_at(map_width + 8 + x, next_row), cool_to_warm(0.5))) << mm;
  }
}

TEST(ReliefPicture, IsGreyWhereNothingIsTold) {
  ExperimentMaps maps = ramps();
  maps.depths[0].mm.setTo(std::nan(""));
  const QImage image = relief_image(maps, 600, 1);
  EXPECT_EQ(image.pixelColor(100, 18 + 20), QColor(128, 128, 128));
}

// Ours are a hundredth of the paper's: on an axis from 0 they would stand on it, all alike.
TEST(ExperimentFigure, ShowsSmallErrorsApartWhereItIsLogarithmic) {
  ExperimentPlot plot{shown("small and large"),
                      shown("x"),
                      shown("y"),
                      {{shown("ours"), ExperimentSeries::Style::kDots, {0, 1, 2}, {0.01, 0.1, 0.0}},
                       {shown("paper"), ExperimentSeries::Style::kPaper, {0, 2}, {10, 10}}},
                      {}};
  const auto blue_rows = [&](bool logarithmic) {
    plot.logarithmic_y = logarithmic;
    ExperimentFigurePlot drawn;
    drawn.set_plot(plot);
    const QImage image = drawn.image({600, 300}, 1).convertToFormat(QImage::Format_RGB32);
    int first = image.height(), last = 0;
    for (int y = 60; y < image.height(); ++y)  // below the legend
      for (int x = 0; x < image.width(); ++x) {
        const QColor c = image.pixelColor(x, y);
        if (c.blue() - c.red() > 100) first = std::min(first, y), last = std::max(last, y);
      }
    return last - first;
  };
  EXPECT_LT(blue_rows(false), 20);
  EXPECT_GT(blue_rows(true), 50);
}

TEST(Document, KeepsSectionsWhole) {
  const auto three_sections = [](bool whole) {
    Document document("three");
    if (whole) document.keep_sections_together();
    for (int section = 0; section < 3; ++section) {
      document.heading("section");
      for (int line = 0; line < 21; ++line) document.paragraph("a line of it");
    }
    return pages_of_paper(document);
  };
  // Each is more than half a page long.
  EXPECT_EQ(three_sections(false), 2U);
  EXPECT_EQ(three_sections(true), 3U);
}

TEST(Document, ASectionThatFitsBeginsNoPage) {
  Document document("short");
  document.keep_sections_together();
  for (int section = 0; section < 4; ++section) {
    document.heading("section");
    for (int line = 0; line < 4; ++line) document.paragraph("a line of it");
    document.figure(QImage(300, 30, QImage::Format_RGB32), 300, "a caption");
  }
  EXPECT_EQ(pages_of_paper(document), 1U);
}

}  // namespace
}  // namespace alltact
