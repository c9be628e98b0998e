#include "core/numerics/readable_numbers.h"

#include <limits>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(SdText, SaysWhatItIs) {
  EXPECT_EQ(value_and_sd(1.2345, 0.0539, 3), "1.234 +- 0.054");
  EXPECT_EQ(value_and_sd(17.549, 0.0004, 3), "17.549 +- under 0.001");
  EXPECT_EQ(value_and_sd(17.549, 0, 3), "17.549 +- unknown");
  EXPECT_EQ(value_and_sd(17.549, -1, 3), "17.549 +- unknown");
  EXPECT_EQ(value_and_sd(17.549, std::numeric_limits<double>::infinity(), 3), "17.549 +- unknown");
  EXPECT_EQ(value_and_sd(17.549, std::nan(""), 3), "17.549 +- unknown");
}

TEST(SdText, IsNeverNought) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> exponent(-12, 2);
  for (int i = 0; i < 5000; ++i) {
    const double sd = std::pow(10, exponent(random));
    const int decimals = i % 5;
    const std::string text = value_and_sd(1, sd, decimals);
    EXPECT_FALSE(text.ends_with("+- " + fmt::format("{:.{}f}", 0.0, decimals))) << text;
  }
}

}  // namespace
}  // namespace alltact
