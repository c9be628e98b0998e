#include "core/sensing/markers/twist_model.h"

#include "tests/support/cameras.h"

#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// A finger that bends, twists and sways, by its own formulas: cross-sections of width 24 mm along
/// e, dots `setback_mm` before the ends of some.
struct TwistingFinger {
  double curl = 0.25, twist = 0.0, sway_mm = 0.0;
  double yaw_per_slope = 1.0;
  static constexpr double kLength = 80.0, kHalf = 12.0, kSetback = 5.0;

  struct Section {
    Eigen::Vector3d middle, across, normal;
  };
  [[nodiscard]] Section at(double s) const {
    constexpr int kSteps = 400;
    double x = -22.0, z = 38.0;
    for (int i = 0; i < kSteps; ++i) {
      const double angle = angle_at(s * (i + 0.5) / kSteps);
      x += std::cos(angle) * s / kSteps, z += std::sin(angle) * s / kSteps;
    }
    const double angle = angle_at(s), t = s / kLength;
    const Eigen::Vector3d along(std::cos(angle), 0, std::sin(angle));
    const Eigen::Vector3d outward(-std::sin(angle), 0, std::cos(angle));
    const double yaw = yaw_per_slope * 2.0 * sway_mm * t / kLength;
    const double turn = twist * t * (0.4 + 0.6 * t);
    const Eigen::Vector3d e =
        (Eigen::Vector3d::UnitY() - yaw * along).normalized() * std::cos(turn) +
        outward * std::sin(turn);
    return {{x, sway_mm * t * t, z}, e.normalized(), along.cross(e).normalized()};
  }
  [[nodiscard]] double angle_at(double s) const { return 0.55 + curl * s / kLength; }

  [[nodiscard]] FaceEdges edges(const Camera& camera) const {
    FaceEdges edges;
    for (const double side : {-1.0, 1.0}) {
      std::vector<Eigen::Vector2d> seen;
      for (double s = -4; s <= kLength + 4; s += 0.5) {
        const Section section = at(s);
        seen.push_back(*camera.project(section.middle + side * kHalf * section.across));
      }
      Edge& edge = side < 0 ? edges.upper : edges.lower;
      for (double u = 3.5; u < camera.size().width; u += 8.0) {
        if (side < 0) edges.u.push_back(u);
        const auto right = std::find_if(seen.begin() + 1, seen.end() - 1,
                                        [&](const auto& p) { return p.x() > u; });
        const Eigen::Vector2d a = *(right - 1), b = *right;
        edge.v.push_back(a.y() + (b.y() - a.y()) * (u - a.x()) / (b.x() - a.x()));
        edge.sd.push_back(0.03);
        edge.valid.push_back(u > seen[8].x() && u < seen[seen.size() - 9].x());
      }
    }
    return edges;
  }
  /// The second row's dots sit `askew_mm` further out.
  [[nodiscard]] Markers markers(const Camera& camera, double askew_mm, std::mt19937& random) const {
    std::normal_distribution<double> noise(0.0, 0.05);
    Markers markers;
    for (const double side : {-1.0, 1.0})
      for (int i = 0; i < 6; ++i) {
        const Section section = at(6.0 + 13.0 * i + (side > 0 ? askew_mm : 0.0));
        const Eigen::Vector2d pixel = *camera.project(
            section.middle + side * kHalf * section.across - kSetback * section.normal);
        markers.push_back({pixel.x() + noise(random), pixel.y() + noise(random), true, 0.05});
      }
    return markers;
  }
};

Face fin_ray() {
  Face face;
  face.width_mm = 24.0;
  face.layer_mm = 1.5;
  return face;
}

struct Recording {
  std::vector<TwistingFinger> fingers;
  std::vector<TwistModel::Pose> poses;
};

Recording recording(const Camera& camera, double yaw_per_slope) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  Recording made;
  for (int i = 0; i < 41; ++i) {
    TwistingFinger finger;
    finger.yaw_per_slope = yaw_per_slope;
    finger.curl += 0.2 * part(random);
    if (i % 4 == 1 || i % 4 == 3) finger.twist = 0.2 * part(random);
    if (i % 4 >= 2) finger.sway_mm = 5.0 * part(random);
    made.fingers.push_back(finger);
    made.poses.push_back({finger.markers(camera, 0.4, random),
                          FaceShape::fit(finger.edges(camera), camera, fin_ray(), 7).value()});
  }
  return made;
}

/// Mean and greatest distance in z of the shape from the finger, over the face.
std::pair<double, double> errors(const FaceShape& shape, const TwistingFinger& finger) {
  double sum = 0, most = 0;
  int count = 0;
  for (double s = 4; s <= 76; s += 4)
    for (const double h : {-11.0, -5.0, 0.0, 5.0, 11.0}) {
      const auto section = finger.at(s);
      const Eigen::Vector3d point = section.middle + h * section.across;
      const auto pixel = shape.camera().project(point);
      const auto here = shape.at(pixel->x(), pixel->y());
      if (!here) continue;
      const double off = std::abs(here->view_point_mm.z() - point.z());
      sum += off, ++count, most = std::max(most, off);
    }
  EXPECT_GT(count, 60);
  return {sum / count, most};
}

TEST(TwistModel, TellsTwistFromSwayForFingersThatTurnAlongAndThatDoNot) {
  const Camera camera = Camera::create(pinhole()).value();
  for (const double yaw_per_slope : {0.0, 1.0}) {
    const Recording made = recording(camera, yaw_per_slope);
    const auto model = TwistModel::learn(made.poses);
    ASSERT_TRUE(model);
    EXPECT_NEAR(model->yaw_per_slope(), yaw_per_slope, 0.15);
    double without = 0;
    for (std::size_t i = 0; i < made.poses.size(); ++i) {
      const auto& [markers, shape] = made.poses[i];
      const auto twisted = model->twisted(markers, shape);
      const auto [mean, most] = errors(twisted ? *twisted : shape, made.fingers[i]);
      without = std::max(without, errors(shape, made.fingers[i]).first);
      EXPECT_LT(mean, 0.15) << "frame " << i << " twist " << made.fingers[i].twist << " sway "
                            << made.fingers[i].sway_mm;
      EXPECT_LT(most, 0.8) << "frame " << i;
    }
    EXPECT_GT(without, 0.3) << "the edges alone would do";
  }
}

TEST(TwistModel, AFaceBehindAWindowTurnsAsWell) {
  // Silicone behind glass bends rays together: the face ends at other columns than it would.
  CameraParameters parameters = pinhole();
  parameters.fx_px = parameters.fy_px = 370.0;
  parameters.port = FlatPort{2.5, 2.4, 1.5, 1.41};
  const Camera camera = Camera::create(parameters).value();
  const Recording made = recording(camera, 1.0);
  const auto model = TwistModel::learn(made.poses);
  ASSERT_TRUE(model);
  double without = 0;
  for (std::size_t i = 0; i < made.poses.size(); ++i) {
    const auto& [markers, shape] = made.poses[i];
    const auto twisted = model->twisted(markers, shape);
    const auto [mean, most] = errors(twisted ? *twisted : shape, made.fingers[i]);
    without = std::max(without, errors(shape, made.fingers[i]).first);
    EXPECT_LT(mean, 0.2) << "frame " << i << " twist " << made.fingers[i].twist << " sway "
                         << made.fingers[i].sway_mm;
    EXPECT_LT(most, 1.0) << "frame " << i;
  }
  EXPECT_GT(without, 0.3) << "the edges alone would do";
}

TEST(TwistModel, TheNormalTurnsWithTheFace) {
  const Camera camera = Camera::create(pinhole()).value();
  const Recording made = recording(camera, 1.0);
  const auto model = TwistModel::learn(made.poses);
  ASSERT_TRUE(model);
  std::mt19937 random(42);
  TwistingFinger finger;
  finger.twist = 0.2;
  const FaceShape edges = FaceShape::fit(finger.edges(camera), camera, fin_ray(), 7).value();
  const auto shape = model->twisted(finger.markers(camera, 0.4, random), edges);
  ASSERT_TRUE(shape);
  for (const double s : {20.0, 40.0, 60.0})
    for (const double h : {-8.0, 0.0, 8.0}) {
      // By differences of the finger's own points.
      const auto point = [&](double along, double across) {
        const auto section = finger.at(along);
        return Eigen::Vector3d(section.middle + across * section.across);
      };
      const Eigen::Vector3d normal = (point(s + 0.1, h) - point(s - 0.1, h))
                                         .cross(point(s, h + 0.1) - point(s, h - 0.1))
                                         .normalized();
      const auto pixel = camera.project(point(s, h));
      const auto local = shape->at(pixel->x(), pixel->y());
      ASSERT_TRUE(local);
      EXPECT_LT((local->normal - normal).norm(), 0.03) << s << ' ' << h;
      EXPECT_DOUBLE_EQ(local->cos_incline, local->normal.z());
      // Whole columns are known beforehand: the same between them.
      const double u = std::round(pixel->x());
      const auto exact = shape->at(u, 270.0), beside = shape->at(u + 1e-7, 270.0);
      ASSERT_TRUE(exact && beside);
      EXPECT_NEAR(exact->view_point_mm.z(), beside->view_point_mm.z(), 1e-5);
    }
}

TEST(TwistModel, AFingerWithoutTwistKeepsTheShapeOfItsEdges) {
  const Camera camera = Camera::create(pinhole()).value();
  const Recording made = recording(camera, 1.0);
  const auto model = TwistModel::learn(made.poses);
  ASSERT_TRUE(model);
  std::mt19937 random(43);
  int told = 0;
  for (int i = 0; i < 20; ++i) {
    const TwistingFinger finger;
    const FaceShape shape = FaceShape::fit(finger.edges(camera), camera, fin_ray(), 7).value();
    told += model->twisted(finger.markers(camera, 0.4, random), shape).has_value();
  }
  EXPECT_LE(told, 1);
}

TEST(TwistModel, FewPairsTellNothing) {
  const Camera camera = Camera::create(pinhole()).value();
  Recording made = recording(camera, 1.0);
  const auto model = TwistModel::learn(made.poses);
  ASSERT_TRUE(model);
  TwistModel::Pose pose = made.poses[1];
  for (std::size_t m = 3; m < 6; ++m) pose.markers[m].seen = false;
  EXPECT_FALSE((*model)(pose.markers, pose.shape));
  for (TwistModel::Pose& other : made.poses)
    for (std::size_t m = 2; m < 6; ++m) other.markers[m].seen = false;
  EXPECT_FALSE(TwistModel::learn(made.poses));
  EXPECT_FALSE(TwistModel::learn({}));
}

}  // namespace
}  // namespace alltact
