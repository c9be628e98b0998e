#include "core/sensing/reference/recorded_poses.h"

#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// A face of 50 mm whose base lies at the picture's right, seen from column `tip`.
EdgeCurves curves(int tip, bool base_at_low_u = false) {
  EdgeCurves face;
  face.base_at_low_u = base_at_low_u;
  for (int u = tip; u <= 448; u += 8) {
    face.u.push_back(static_cast<float>(u));
    face.upper.push_back(70.0F);
    face.lower.push_back(230.0F);
    const float from_right_mm = 50.0F * static_cast<float>(448 - u) / 300.0F;
    const float length_mm = 50.0F * static_cast<float>(448 - tip) / 300.0F;
    face.along_mm.push_back(base_at_low_u ? length_mm - from_right_mm : from_right_mm);
  }
  return face;
}

// A frame in which the tip seemed nearer than the base has no say in where all are counted from,
// wherever in the recording it stands.
TEST(EdgePositions, AreCountedFromTheBaseThatMostFramesSee) {
  std::vector<EdgeCurves> faces;
  for (int i = 0; i < 30; ++i) faces.push_back(curves(144 + 8 * (i % 3)));
  const auto without = choose_edge_positions(faces);
  ASSERT_TRUE(without.has_value());
  EXPECT_EQ(without->from_u_px, 448.0);
  for (const std::size_t where : {0U, 15U, 30U}) {
    std::vector<EdgeCurves> some = faces;
    some.insert(some.begin() + static_cast<std::ptrdiff_t>(where), curves(152, true));
    const auto places = choose_edge_positions(some);
    ASSERT_TRUE(places.has_value());
    EXPECT_EQ(places->from_u_px, without->from_u_px);
    EXPECT_EQ(places->step_mm, without->step_mm);
  }
}

}  // namespace
}  // namespace alltact
