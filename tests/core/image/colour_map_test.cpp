#include "core/image/colour_map.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(ColourScale, LabelsAreWrittenAsTheyAre) {
  for (const double top_mm : {0.01, 0.02, 0.05, 0.1, 0.16, 0.3, 0.5, 1.0, 1.5, 2.0, 3.0})
    for (const ColourScale& scale : {depth_scale(top_mm), difference_scale(top_mm)})
      for (const int labels : {scale.steps + 1, 2 * scale.steps + 1}) {
        const int decimals = scale.label_decimals(labels);
        EXPECT_GE(decimals, 2);
        for (int i = 0; i < labels; ++i) {
          const double mm = scale.low_mm + i * (scale.top_mm - scale.low_mm) / (labels - 1);
          EXPECT_NEAR(std::stod(fmt::format("{:.{}f}", mm, decimals)), mm, 1e-9)
              << top_mm << ", " << labels << " labels";
        }
      }
  EXPECT_EQ(difference_scale(0.05).label_decimals(5), 3) << "0.025";
  EXPECT_EQ(difference_scale(0.05).label_decimals(3), 2);
  EXPECT_EQ(depth_scale(1.0).label_decimals(6), 2);
}

TEST(ColourScale, ValuesBeyondItHaveColoursOfTheirOwn) {
  const auto is = [](const MapColour& a, const MapColour& b) {
    return a.red == b.red && a.green == b.green && a.blue == b.blue;
  };
  for (const ColourScale& scale : {depth_scale(1.5), difference_scale(0.05)}) {
    const ColourTable table(scale);
    const double range_mm = scale.top_mm - scale.low_mm;
    const auto expect = [&](double mm, const MapColour& colour) {
      EXPECT_TRUE(is(scale.colour_at(mm), colour)) << mm;
      EXPECT_TRUE(is(table(static_cast<float>(mm)), colour)) << mm;
    };
    expect(scale.top_mm + 0.01 * range_mm, kAboveScale);
    expect(1000, kAboveScale);
    expect(scale.low_mm - 0.01 * range_mm, kBelowScale);
    expect(scale.top_mm, scale.colour(1));
    expect(scale.low_mm, scale.colour(0));
    for (int i = 0; i <= 100; ++i)
      for (const MapColour& beyond : {kBelowScale, kAboveScale}) {
        const MapColour c = scale.colour(0.01 * i);
        EXPECT_GT(std::hypot(c.red - beyond.red, c.green - beyond.green, c.blue - beyond.blue), 75)
            << i;
      }
  }
}

/// Relative luminance of sRGB, 0 to 1.
double luminance(const MapColour& colour) {
  const auto linear = [](std::uint8_t level) {
    const double part = level / 255.0;
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

TEST(DepthColour, UntouchedSkinIsNeutralAndTheDarkest) {
  const MapColour untouched = depth_colour(0);
  EXPECT_LT(std::max({untouched.red, untouched.green, untouched.blue}) -
                std::min({untouched.red, untouched.green, untouched.blue}),
            6);
  for (const double sign : {1.0, -kBulgeFraction}) {
    double before = luminance(untouched);
    for (int i = 1; i <= 100; ++i) {
      const double here = luminance(depth_colour(0.01 * i * sign));
      EXPECT_GT(here, before - 0.004) << 0.01 * i * sign;
      EXPECT_GT(here, luminance(untouched) - 0.004) << 0.01 * i * sign;
      before = here;
    }
  }
  EXPECT_GT(luminance(depth_colour(1)), 0.7);
}

}  // namespace
}  // namespace alltact
