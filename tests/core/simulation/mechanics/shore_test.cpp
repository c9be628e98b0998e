#include "core/simulation/mechanics/rubber.h"

#include <limits>

#include <gtest/gtest.h>

namespace alltact {
namespace {

// Gent's relation as printed, and the figures that go with a finger's two rubbers.
TEST(Shore, GivesGentsModulus) {
  EXPECT_NEAR(modulus_from_shore_a(40).value(), 1.69, 0.01);
  EXPECT_NEAR(modulus_from_shore_a(5).value(), 0.28, 0.003);
  for (const long double s : {1.0L, 20.0L, 55.5L, 90.0L}) {
    const long double gent = 0.0981L * (56 + 7.62336L * s) / (0.137505L * (254 - 2.54L * s));
    EXPECT_NEAR(modulus_from_shore_a(static_cast<double>(s)).value() / static_cast<double>(gent), 1,
                0.006);  // he gave 7.62336, others round to 7.66
  }
}

TEST(Shore, RefusesWhatNoDurometerReads) {
  for (const double s : {0.0, -5.0, 95.0, 100.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(modulus_from_shore_a(s)) << s;
  EXPECT_EQ(modulus_from_shore_a(100).error().sentence(),
            "a hardness of 100 Shore A has no known modulus. Try: 1 to 90.");
}

}  // namespace
}  // namespace alltact
