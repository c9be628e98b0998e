#include "core/image/colour_map.h"

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

}  // namespace
}  // namespace alltact
