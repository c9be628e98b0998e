// The factor of every pixel, against its definition.
#include "core/sensing/depth/depth_map.h"
#include "tests/support/made_press.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

MappingParameters some_mapping(MappingAlong along) {
  MappingParameters p;
  p.kind = MappingKind::kMoebius;
  p.along = along;
  p.x_max = 0.5;
  p.a_mm = 2.5;
  p.b = 0.8;
  return p;
}

TEST(DepthScale, IsOneUnlessTheMappingAsksForIt) {
  const made::MadeScene scene = made::finger_scene(40.0, 25.0);
  EXPECT_TRUE(DepthScale(some_mapping(MappingAlong::kZ), scene.shape).is_one());
  EXPECT_TRUE(DepthScale(some_mapping(MappingAlong::kNormal), scene.shape).is_one());
  EXPECT_FALSE(DepthScale(some_mapping(MappingAlong::kProjected), scene.shape).is_one());
}

TEST(DepthScale, EveryPixelGetsItsFactor) {
  std::mt19937 random(5);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int run = 0; run < 20; ++run) {
    const made::MadeScene scene = made::finger_scene(between(35, 50), between(-25, 28));
    for (const MappingAlong along :
         {MappingAlong::kZ, MappingAlong::kNormal, MappingAlong::kProjected}) {
      MappingParameters p = some_mapping(along);
      p.variation = {{between(-0.25, 0.25), run % 3 == 0 ? 0.0 : between(-0.25, 0.25)},
                     {between(20, 40), between(-2, 2)},
                     {between(5, 30), between(3, 12)}};
      const DepthScale scale(p, scene.shape);
      ASSERT_FALSE(scale.is_one());
      for (int v = 60; v < 500; v += 40) {
        std::vector<float> depth(960, 2.0F);
        scale.scale(v, 0, 960, depth.data());
        for (int u = 0; u < 960; u += 17) {
          const auto local = scene.shape.at(u, v);
          if (!local) continue;
          const double projected =
              along == MappingAlong::kProjected ? 1.0 / local->cos_incline : 1.0;
          EXPECT_NEAR(static_cast<double>(depth[static_cast<std::size_t>(u)]),
                      2.0 * projected * p.variation.at(scene.shape.position_mm(u, v)), 2e-5)
              << u << ' ' << v;
        }
      }
    }
  }
}

TEST(DepthScale, PlacesOnTheFaceAreMillimetres) {
  const made::MadeScene scene = made::finger_scene(40.0, 20.0);
  for (double u = 200; u < 800; u += 50)
    for (double v = 200; v < 350; v += 30) {
      const auto here = scene.shape.at(u, v), beside = scene.shape.at(u + 10, v);
      ASSERT_TRUE(here && beside);
      const Eigen::Vector2d place = scene.shape.position_mm(u, v);
      // The finger lies along x and is the same across y.
      EXPECT_NEAR(place.y(), here->view_point_mm.y(), 1e-3);
      const Eigen::Vector3d way = beside->view_point_mm - here->view_point_mm;
      EXPECT_NEAR(std::abs(scene.shape.position_mm(u + 10, v).x() - place.x()),
                  std::hypot(way.x(), way.z()), 2e-3);
    }
}

}  // namespace
}  // namespace alltact
