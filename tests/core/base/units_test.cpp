// Units in files, against their definitions.
#include "core/base/units.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(Units, AreConvertedByTheirDefinitions) {
  struct Example {
    Measure measure;
    const char* name;
    double value, expected;
  };
  using enum Measure;
  for (const Example& one : {Example{kTime, "ms", 8190, 8.19},
                             {kTime, "µs", 1, 1e-6},
                             {kTime, "μs", 1, 1e-6},
                             {kTime, "NS", 81234567890000, 81234.56789},
                             {kTime, "min", 1.5, 90},
                             {kTime, "毫秒", 10, 0.01},
                             {kForce, "mN", 1, 1e-3},
                             {kForce, "KN", 2, 2000},
                             {kForce, "kgf", 1, 9.80665},
                             {kForce, "g", 1, 9.80665e-3},
                             {kForce, "lbF", 1, 4.4482216152605},
                             {kLength, "in", 2, 50.8},
                             {kLength, "um", 250, 0.25},
                             {kLength, "m", 0.0025, 2.5},
                             {kTurn, "deg", 90, 0.25},
                             {kTurn, "rad", 3.14159265358979323846, 0.5}}) {
    const auto unit = measurement_unit(one.measure, one.name);
    ASSERT_TRUE(unit) << one.name;
    EXPECT_EQ(unit->convert(one.value), one.expected) << one.name;
  }
  for (const char* none : {"", "MN", "Nm", "N m", "kPa", "s"})
    EXPECT_FALSE(measurement_unit(kForce, none)) << none;
  EXPECT_EQ(measurement_units(kForce), "N, mN, kN, gf, kgf, lbf, ozf");
  EXPECT_TRUE(is_measurement_unit("px"));
  EXPECT_FALSE(is_measurement_unit("Nm"));
}

}  // namespace
}  // namespace alltact
