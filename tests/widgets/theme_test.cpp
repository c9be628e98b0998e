// Contrast as WCAG 2.1 defines it (relative luminance of sRGB).
#include "widgets/theme.h"

#include "tests/support/program.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace alltact {
namespace {

double luminance(const QColor& colour) {
  const auto linear = [](double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
         0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double first = luminance(a), second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

class EveryTheme : public testing::TestWithParam<Theme> {};
INSTANTIATE_TEST_SUITE_P(Theme, EveryTheme,
                         testing::Values(Theme::kLight, Theme::kDark, Theme::kHighContrast));

TEST_P(EveryTheme, TextCanBeRead) {
  const QPalette palette = theme_palette(GetParam());
  const double wanted = GetParam() == Theme::kHighContrast ? 7 : 4.5;
  using P = QPalette;
  EXPECT_GE(contrast(palette.color(P::WindowText), palette.color(P::Window)), wanted);
  EXPECT_GE(contrast(palette.color(P::Text), palette.color(P::Base)), wanted);
  EXPECT_GE(contrast(palette.color(P::ButtonText), palette.color(P::Button)), wanted);
  EXPECT_GE(contrast(palette.color(P::HighlightedText), palette.color(P::Highlight)), wanted);
  EXPECT_GE(contrast(palette.color(P::Link), palette.color(P::Window)), wanted);
  EXPECT_GE(contrast(palette.color(P::Disabled, P::Text), palette.color(P::Base)), 3);
}

TEST_P(EveryTheme, LinesAndSymbolsCanBeSeen) {
  const QPalette palette = theme_palette(GetParam());
  for (int i = 0; i < 6; ++i)
    EXPECT_GE(contrast(series_colour(i, palette), palette.color(QPalette::Base)), 3) << i;
  using R = ColourRole;
  const std::array roles{R::kMeasured, R::kExpected, R::kLeftOut, R::kContact};
  for (const R role : roles) {
    EXPECT_GE(contrast(role_colour(role, palette), palette.color(QPalette::Base)), 3);
    for (const R other : roles)
      EXPECT_EQ(role_colour(role, palette) == role_colour(other, palette), role == other);
  }
  for (const Meaning meaning : {Meaning::kGood, Meaning::kDoubtful, Meaning::kBad})
    EXPECT_GE(contrast(meaning_colour(meaning, palette), palette.color(QPalette::Window)), 3);
}

/// The same thing has the same colour everywhere: nobody picks a colour by its number, but for
/// series without a role (axes of a force, curves of an experiment) and a drawing.
TEST(Theme, ColoursStandForRoles) {
  const std::set<std::string> numbered{"theme.cpp", "force_box.cpp", "experiment_pages.cpp",
                                       "finger_drawing.cpp", "calibration_plots.cpp"};
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           std::filesystem::path(ALLTACT_SOURCE_DIR) / "widgets")) {
    if (entry.path().extension() != ".cpp") continue;
    ++files;
    const std::string text = test::text_of(entry.path());
    if (numbered.count(entry.path().filename().string()) == 0) {
      EXPECT_EQ(text.find("series_colour("), std::string::npos) << entry.path();
    }
    EXPECT_EQ(text.find("series_colour(0, palette())"), std::string::npos) << entry.path();
  }
  EXPECT_GT(files, 50);
}

TEST(Theme, KnowsDarkFromLight) {
  EXPECT_FALSE(is_dark(theme_palette(Theme::kLight)));
  EXPECT_TRUE(is_dark(theme_palette(Theme::kDark)));
  EXPECT_TRUE(is_dark(theme_palette(Theme::kHighContrast)));
}

}  // namespace
}  // namespace alltact
