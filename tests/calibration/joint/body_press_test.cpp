// Bodies of known shape in random poses on tilted faces. Depth comes from the formulas of ball, rod
// and ridge, the meshes only from their corners.
#include "calibration/joint/body_press.h"

#include "core/mesh/mesh_distance.h"
#include "tests/support/made_meshes.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kA = 2.0, kB = 1.2;  // true mapping: d = kA x / (1 + kB x)
constexpr double kNoise = 0.002;      // of x

/// How far a body reaches over a point in the direction +z of its frame, by its formula.
using Height = double (*)(double x, double y);
double ball_height(double x, double y) {
  const double root = 16 - x * x - y * y;
  return root > 0 ? std::sqrt(root) - 4 : -99;
}
double rod_height(double /*x*/, double y) {
  return std::abs(y) < 2 ? std::sqrt(4 - y * y) - 2 : -99;
}
double ridge_height(double /*x*/, double y) { return -0.35 * std::abs(y); }

struct Body {
  const char* name;
  TriangleMesh (*mesh)();
  double top_mm;  ///< z of the mesh's top, where the height is 0
  Height height;
};

const Body kBodies[] = {{"ball", [] { return ball(4); }, 4, ball_height},
                        {"rod", [] { return rod(2, 25); }, 2, rod_height},
                        {"ridge", [] { return ridge(0.35); }, 0, ridge_height}};

/// Samples of a tilted plane face of 18 x 18 mm, pressed by a body that is turned and tilted a
/// little against it.
PressSamples pressed_face(const Body& body, double depth_mm, std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  std::normal_distribution<double> noise(0, kNoise);
  const Vector3d normal = Vector3d(0.4 * any(random), 0.4 * any(random), 1).normalized();
  const Vector3d along = normal.cross(Vector3d::UnitY()).normalized(), across = normal.cross(along);
  const double turn = M_PI * any(random), tilt = 0.03 * any(random);
  const Eigen::Vector2d middle(2 * any(random), 2 * any(random));
  PressSamples press;
  press.block_px = 2;
  press.x_sd = kNoise;
  constexpr int kSide = 150;
  constexpr double kPitchMm = 0.12;
  for (int v = 0; v < kSide; ++v)
    for (int u = 0; u < kSide; ++u) {
      const Eigen::Vector2d on_face(kPitchMm * (u - 0.5 * kSide), kPitchMm * (v - 0.5 * kSide));
      const Eigen::Vector2d off = on_face - middle;
      const double x = std::cos(turn) * off.x() + std::sin(turn) * off.y(),
                   y = -std::sin(turn) * off.x() + std::cos(turn) * off.y();
      Sample sample;
      sample.pixel = {2 * u, 2 * v};
      sample.untouched_n = sample.untouched_z =
          Vector3d(0, 0, 60) + on_face.x() * along + on_face.y() * across;
      sample.normal = normal;
      sample.cos_incline = normal.z();
      sample.by_u = 0.5 * kPitchMm * along;
      sample.by_v = 0.5 * kPitchMm * across;
      sample.position_mm = on_face;
      const double depth = std::max(0.0, depth_mm + body.height(x, y) + tilt * x);
      sample.x = depth / (kA - kB * depth) + noise(random);
      press.samples.push_back(sample);
    }
  return press;
}

MappingCurve curve(double scale) {
  MappingCurve curve({MappingKind::kMoebius, 2}, 1.0);
  curve.values() << scale * kA, kB;
  return curve;
}

MeshDistance shape_of(const TriangleMesh& mesh) { return MeshDistance::create(mesh).value(); }

TEST(KnownBody, GivesTheScaleOfDepthInAnyPose) {
  for (const Body& body : kBodies) {
    const auto shape = shape_of(body.mesh());
    double squares = 0, worst = 0;
    constexpr int kWorlds = 12;
    for (int seed = 0; seed < kWorlds; ++seed) {
      std::mt19937 random(static_cast<unsigned>(seed));
      std::uniform_real_distribution<double> any(-1, 1);
      const double scale = 1 + 0.25 * any(random), depth_mm = 0.7 + 0.2 * any(random);
      const MappingCurve wrong = curve(scale);
      const auto found = find_body("p", pressed_face(body, depth_mm, random), shape, wrong,
                                   MappingAlong::kNormal, {});
      ASSERT_TRUE(found.ok()) << body.name << " " << seed << ": " << found.error().sentence();
      const BodyReading reading =
          read_body(*found, wrong, wrong.values().data(), MappingAlong::kNormal);
      const double error = reading.factor * scale - 1;
      EXPECT_LT(reading.rms_mm, 0.01) << body.name << " " << seed;
      squares += std::pow(error / reading.sd, 2);
      worst = std::max(worst, std::abs(error));
    }
    const double z = std::sqrt(squares / kWorlds);
    std::printf("%s: error of the scale at most %.4f, rms of error / sd %.2f\n", body.name, worst,
                z);
    EXPECT_LT(worst, 0.01) << body.name;
    // Skin that follows a body exactly is better than kFormSdMm allows for.
    EXPECT_LT(z, 1) << body.name;
  }
}

TEST(KnownBody, DepthsOfZeroShowNothing) {
  std::mt19937 random(5);
  const MappingCurve start = curve(0.9);
  const auto found = find_body("p", pressed_face(kBodies[1], 0.7, random),
                               shape_of(kBodies[1].mesh()), start, MappingAlong::kNormal, {});
  ASSERT_TRUE(found.ok()) << found.error().sentence();
  const Eigen::VectorXd flat = Eigen::VectorXd::Zero(start.values().size());
  const BodyReading reading = read_body(*found, start, flat.data(), MappingAlong::kNormal);
  EXPECT_EQ(reading.sd, std::numeric_limits<double>::infinity());
  EXPECT_EQ(reading.factor, 1);
  EXPECT_TRUE(reading.by_values.isZero());
}

TEST(KnownBody, DerivativeIsThatOfTheReading) {
  std::mt19937 random(5);
  const auto shape = shape_of(kBodies[1].mesh());
  const MappingCurve start = curve(0.9);
  const auto found = find_body("p", pressed_face(kBodies[1], 0.7, random), shape, start,
                               MappingAlong::kNormal, {});
  ASSERT_TRUE(found.ok()) << found.error().sentence();
  const auto factor_at = [&](const Eigen::VectorXd& values) {
    return read_body(*found, start, values.data(), MappingAlong::kNormal).factor;
  };
  const BodyReading reading =
      read_body(*found, start, start.values().data(), MappingAlong::kNormal);
  for (Eigen::Index i = 0; i < 2; ++i) {
    Eigen::VectorXd low = start.values(), high = low;
    const double step = 1e-3 * low[i];
    low[i] -= step, high[i] += step;
    const double difference = (factor_at(high) - factor_at(low)) / (2 * step);
    EXPECT_NEAR(reading.by_values[i], difference, 0.02 * std::abs(difference)) << i;
  }
}

TEST(KnownBody, AFlatPunchLeavesTheScaleOpen) {
  const Body punch{
      "punch",
      [] {
        return prism({{4, 0}, {-4, 0}, {-4, -9}, {4, -9}}, 4);
      },
      0, [](double x, double y) { return std::abs(x) < 4 && std::abs(y) < 4 ? 0.0 : -99.0; }};
  std::mt19937 random(1);
  const auto found = find_body("punch", pressed_face(punch, 0.5, random), shape_of(punch.mesh()),
                               curve(1), MappingAlong::kNormal, {});
  ASSERT_FALSE(found.ok());
  EXPECT_THAT(found.error().sentence(), HasSubstr("leaves the scale of depth open"));
}

TEST(KnownBody, AnotherBodyIsRefused) {
  std::mt19937 random(2);
  const auto found = find_body("p", pressed_face(kBodies[2], 0.9, random), shape_of(ball(1.2)),
                               curve(1), MappingAlong::kNormal, {});
  ASSERT_FALSE(found.ok());
  EXPECT_THAT(found.error().sentence(), HasSubstr("off the body in its best pose"));
}

}  // namespace
}  // namespace alltact::test
