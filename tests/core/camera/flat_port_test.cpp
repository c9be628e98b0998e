#include "core/camera/camera.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// Light followed through both surfaces with Snell's law written with angles.
Eigen::Vector3d followed(const FlatPort& port, const Eigen::Vector3d& direction, double z_mm) {
  const double way = std::atan2(direction.y(), direction.x());
  const double air = std::atan2(direction.head<2>().norm(), direction.z());
  const double plate = std::asin(std::sin(air) / port.plate_index);
  const double medium = std::asin(std::sin(air) / port.medium_index);
  const double r = port.gap_mm * std::tan(air) + port.plate_mm * std::tan(plate) +
                   (z_mm - port.gap_mm - port.plate_mm) * std::tan(medium);
  return {r * std::cos(way), r * std::sin(way), z_mm};
}

TEST(FlatPort, FollowsLightBothWays) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const FlatPort port{10 * unit(random), 5 * unit(random), 1 + unit(random),
                        1 + 0.8 * unit(random)};
    const double off = 1.4 * unit(random), way = 2 * M_PI * unit(random);
    const Eigen::Vector3d direction(std::tan(off) * std::cos(way), std::tan(off) * std::sin(way),
                                    1);
    const double z_mm = port.gap_mm + port.plate_mm + 0.1 + 100 * unit(random);
    const Eigen::Vector3d truth = followed(port, direction, z_mm);
    const auto ray = ray_through(port, direction);
    ASSERT_TRUE(ray);
    EXPECT_LT((ray->point_at(z_mm) - truth).norm(), 1e-11 * (1 + truth.norm()));
    const auto back = direction_to(port, truth);
    ASSERT_TRUE(back);
    EXPECT_LT((*back - direction).norm(), 1e-11 * direction.norm() * direction.norm());
  }
}

TEST(FlatPort, AirAllTheWayIsNoPort) {
  const FlatPort air{7, 3, 1, 1};
  const Eigen::Vector3d point(12, -30, 55);
  EXPECT_LT((*direction_to(air, point) - point / point.z()).norm(), 1e-15);
  const auto ray = ray_through(air, point);
  EXPECT_LT(ray->origin_mm.norm(), 1e-14);
  EXPECT_LT((ray->direction - point / point.z()).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(apparent_distance_mm(air, 55), 55);
}

TEST(FlatPort, SiliconeTakenForAirMakesDistancesAQuarterTooSmall) {
  for (const double gap_mm : {1.0, 5.0, 10.0})
    for (const double z_mm : {40.0, 70.0, 100.0}) {
      const double part = apparent_distance_mm({gap_mm, 3, 1.49, 1.41}, z_mm) / z_mm;
      EXPECT_GT(part, 0.69) << gap_mm << " " << z_mm;
      EXPECT_LT(part, 0.79) << gap_mm << " " << z_mm;
    }
}

TEST(FlatPort, SaysWhatCannotBeSeen) {
  const FlatPort port{5, 3, 1.49, 1.41};
  EXPECT_FALSE(direction_to(port, {1, 1, 8}));  // on the plate
  EXPECT_FALSE(direction_to(port, {1, 1, -20}));
  EXPECT_FALSE(direction_to({0, 0, 1.49, 1.41}, {50, 0, 10}));  // beyond the critical angle
  EXPECT_TRUE(direction_to(port, {50, 0, 10}));                 // an air gap lets it in, very flat
  EXPECT_FALSE(ray_through(port, {1, 0, 0}));
  EXPECT_EQ(check_port({-1, 3, 1.49, 1.41}).error().where.english(), "gap_mm");
  EXPECT_EQ(check_port({1, 3, 0.9, 1.41}).error().where.english(), "plate_index");
  EXPECT_TRUE(check_port(port));
}

}  // namespace
}  // namespace alltact
