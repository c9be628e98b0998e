#include "core/sensing/face/face_shape.h"
#include "tests/support/cameras.h"
#include "tests/support/noisy_plane_edges.h"

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

/// Of a face whose base lies left, and of one whose base lies right.
TEST(PlacePixel, IsTheInverseOfThePlaceOnTheFace) {
  const Camera camera = Camera::create(pinhole()).value();
  for (const double slope : {0.55, -0.55}) {
    const auto shape = FaceShape::fit(plane_edges(slope, camera, 0.05, 3), camera, plane_face(), 7);
    ASSERT_TRUE(shape.ok()) << shape.error().sentence();
    EXPECT_EQ(shape->base_at_low_u(), slope > 0);
    int seen = 0;
    for (double u = 40; u < 900; u += 13.7)
      for (const double v : {200.0, 269.5, 310.25}) {
        if (!shape->at(u, v)) continue;
        ++seen;
        const auto back = pixel_of_position(*shape, shape->position_mm(u, v));
        ASSERT_TRUE(back) << u << ", " << v;
        EXPECT_NEAR(back->x(), u, 1e-6);
        EXPECT_NEAR(back->y(), v, 1e-6);
      }
    EXPECT_GT(seen, 100);
  }
}

TEST(PlacePixel, SaysWhereTheFaceIsNot) {
  const Camera camera = Camera::create(pinhole()).value();
  const FaceShape shape =
      FaceShape::fit(plane_edges(0.55, camera, 0, 1), camera, plane_face(), 7).value();
  double last_mm = 0;
  for (int u = 0; u < shape.width_px(); ++u) last_mm = std::max(last_mm, shape.length_at(u));
  EXPECT_FALSE(pixel_of_position(shape, {last_mm + 1, 0}));
  EXPECT_FALSE(pixel_of_position(shape, {-1, 0}));
  EXPECT_TRUE(pixel_of_position(shape, {0.5 * last_mm, 0}));
}

}  // namespace
}  // namespace alltact::test
