#include "core/camera/camera.h"

#include "tests/support/cameras.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

namespace alltact {
namespace {

CameraParameters brown(std::vector<double> distortion) {
  CameraParameters p = pinhole();
  p.model = CameraModel::kBrown;
  p.distortion = std::move(distortion);
  return p;
}

CameraParameters fisheye(std::vector<double> distortion) {
  CameraParameters p = pinhole();
  p.model = CameraModel::kFisheye;
  p.fx_px = 284.3, p.fy_px = 285.1;
  p.distortion = std::move(distortion);
  return p;
}

CameraParameters orthographic() {
  CameraParameters p = pinhole();
  p.model = CameraModel::kOrthographic;
  p.fx_px = p.fy_px = 0;
  p.mm_per_px = 0.051015;
  return p;
}

/// Lenses of all models, strong ones and random ones, that do not fold over.
std::vector<Camera> lenses() {
  std::vector<CameraParameters> parameters{pinhole(),
                                           orthographic(),
                                           brown({}),
                                           brown({-0.3, 0.1}),
                                           brown({-0.35, 0.12, 0, 0, -0.02}),
                                           brown({0.3, 0.1}),
                                           brown({-0.2, 0.06, 0.003, -0.002, -0.01}),
                                           brown({0.15, 0, -0.004, 0.005}),
                                           fisheye({}),
                                           fisheye({-0.02, 0.005, -0.003, 0.0004}),
                                           fisheye({0.08, 0.01, 0.002, 0.001})};
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 60; ++i) {
    CameraParameters p = i % 2 == 0
                             ? brown({0.3 * unit(random), 0.1 * unit(random), 0.005 * unit(random),
                                      0.005 * unit(random), 0.02 * unit(random)})
                             : fisheye({0.1 * unit(random), 0.05 * unit(random),
                                        0.01 * unit(random), 0.002 * unit(random)});
    p.fx_px *= 1 + 0.2 * unit(random);
    p.cx_px += 40 * unit(random);
    p.cy_px += 40 * unit(random);
    parameters.push_back(p);
  }
  std::vector<Camera> result;
  for (const CameraParameters& p : parameters)
    if (auto camera = Camera::create(p)) result.push_back(*camera);
  return result;
}

TEST(Camera, PixelToRayToPixelIsTheSamePixelOverTheWholePicture) {
  const auto cameras = lenses();
  ASSERT_GE(cameras.size(), 40U);  // most of them do not fold over
  double worst_px = 0;
  for (const Camera& camera : cameras) {
    const CameraParameters& p = camera.parameters();
    for (double v = 0; v < p.height_px; v += 38.5)
      for (double u = 0; u < p.width_px; u += 41.130434782608695) {
        const Eigen::Vector2d pixel(u, v);
        const auto ray = camera.unproject(pixel);
        if (!ray) {
          ASSERT_EQ(p.model, CameraModel::kFisheye);  // its dark corners
          continue;
        }
        const auto back = camera.project(ray->point_at(37.5));
        ASSERT_TRUE(back);
        worst_px = std::max(worst_px, (*back - pixel).norm());
      }
  }
  RecordProperty("worst_px", fmt::format("{:.3g}", worst_px));
  EXPECT_LT(worst_px, 1e-9);
}

TEST(Camera, RayToPixelToRayIsTheSameRay) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const Camera& camera : lenses())
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d point(25 * unit(random), 15 * unit(random), 40 + 10 * unit(random));
      const auto pixel = camera.project(point);
      if (!pixel ||
          !cv::Rect2d({0, 0}, cv::Size2d(camera.size())).contains({pixel->x(), pixel->y()}))
        continue;
      const auto ray = camera.unproject(*pixel);
      ASSERT_TRUE(ray);
      EXPECT_LT((ray->point_at(point.z()) - point).norm(), 1e-8);
    }
}

TEST(Camera, ProjectsAsOpenCvDoes) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> unit(-1, 1);
  int compared = 0;
  for (const Camera& camera : lenses()) {
    const CameraParameters& p = camera.parameters();
    if (!camera.is_perspective()) continue;
    const cv::Matx33d k(p.fx_px, 0, p.cx_px, 0, p.fy_px, p.cy_px, 0, 0, 1);
    std::vector<double> distortion = p.distortion;
    distortion.resize(p.model == CameraModel::kFisheye ? 4 : 5);
    for (int i = 0; i < 50; ++i) {
      const std::vector<cv::Point3d> point{
          {30 * unit(random), 20 * unit(random), 40 + 10 * unit(random)}};
      const auto ours = camera.project({point[0].x, point[0].y, point[0].z});
      if (!ours) continue;
      std::vector<cv::Point2d> theirs;
      if (p.model == CameraModel::kFisheye) {
        cv::fisheye::projectPoints(point, theirs, cv::Vec3d(), cv::Vec3d(), k, distortion);
      } else {
        cv::projectPoints(point, cv::Vec3d(), cv::Vec3d(), k, distortion, theirs);
      }
      EXPECT_NEAR(ours->x(), theirs[0].x, 1e-9);
      EXPECT_NEAR(ours->y(), theirs[0].y, 1e-9);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

/// The fold of a purely radial lens by brute force: the first radius where a longer one is not
/// seen further out.
double fold_by_search(double k1, double k2, double k3) {
  const auto seen = [&](double r) {
    const double s = r * r;
    return r * (1 + s * (k1 + s * (k2 + s * k3)));
  };
  for (double r = 0; r < 10; r += 1e-5)
    if (seen(r + 1e-5) <= seen(r)) return r;
  return HUGE_VAL;
}

TEST(Camera, RefusesALensThatFoldsOverInsideThePictureAndOnlyThat) {
  std::mt19937 random(14);
  std::uniform_real_distribution<double> unit(-1, 1);
  int refused = 0, accepted = 0;
  for (int i = 0; i < 200; ++i) {
    const double k1 = 0.5 * unit(random), k2 = 0.3 * unit(random), k3 = 0.1 * unit(random);
    const double fold = fold_by_search(k1, k2, k3);
    const double s = fold * fold;
    const double furthest =
        std::isfinite(fold) ? fold * (1 + s * (k1 + s * (k2 + s * k3))) : HUGE_VAL;
    const CameraParameters p = brown({k1, k2, 0, 0, k3});
    const double corner = std::hypot(p.cx_px / p.fx_px, p.cy_px / p.fy_px);
    if (std::abs(corner - furthest) < 1e-6) continue;  // the search is not that fine
    const auto camera = Camera::create(p);
    EXPECT_EQ(camera.ok(), corner < furthest) << k1 << ' ' << k2 << ' ' << k3;
    camera.ok() ? ++accepted : ++refused;
    if (!camera.ok()) {
      EXPECT_EQ(camera.error().where.english(), "camera.distortion");
    }
  }
  EXPECT_GT(refused, 20);
  EXPECT_GT(accepted, 20);
}

TEST(Camera, WideLensWithOneCoefficientIsJudgedByItsCorner) {
  // k1 = -0.3 alone folds at r = sqrt(1 / 0.9); the corner of an 85 degree lens would lie at
  // r = 1.051, just inside, when its focal length is that of the distorted picture, and is never
  // seen when it is that of the straightened one.
  const double corner = 1.051, fold = std::sqrt(1 / 0.9);
  ASSERT_LT(corner, fold);
  const double seen_corner = corner * (1 - 0.3 * corner * corner);
  CameraParameters p = brown({-0.3});
  const double half_diagonal = std::hypot(p.cx_px, p.cy_px);
  p.fx_px = p.fy_px = half_diagonal / seen_corner;
  const auto wide = Camera::create(p);
  ASSERT_TRUE(wide.ok());
  const auto ray = wide->unproject({0, 0});
  ASSERT_TRUE(ray);
  EXPECT_NEAR(ray->direction.head<2>().norm(), corner, 1e-9);
  EXPECT_LT((*wide->project(ray->point_at(50)) - Eigen::Vector2d(0, 0)).norm(), 1e-9);

  p.fx_px = p.fy_px = half_diagonal / corner;
  EXPECT_FALSE(Camera::create(p).ok());
}

TEST(Camera, SeesNothingBeyondTheFold) {
  CameraParameters p = brown({-0.1});
  const Camera camera = *Camera::create(p);
  const double fold = std::sqrt(1 / 0.3);
  EXPECT_TRUE(camera.project({0.999 * fold, 0, 1}));
  EXPECT_FALSE(camera.project({1.001 * fold, 0, 1}));
  const double limit_px = p.fx_px * fold * (1 - 0.1 * fold * fold);
  EXPECT_TRUE(camera.unproject({p.cx_px + limit_px - 1e-3, p.cy_px}));
  EXPECT_FALSE(camera.unproject({p.cx_px + limit_px + 1e-3, p.cy_px}));
}

TEST(Camera, WhatCannotBeSeenIsAbsent) {
  for (const Camera& camera : lenses()) {
    if (camera.is_perspective()) {
      EXPECT_FALSE(camera.project({1, 1, 0}));
      EXPECT_FALSE(camera.project({1, 1, -5}));
    }
    EXPECT_FALSE(camera.project({std::nan(""), 0, 40}));
    EXPECT_FALSE(camera.project({0, 0, std::nan("")}) && camera.is_perspective());
    EXPECT_FALSE(camera.unproject({std::nan(""), 0}));
    EXPECT_FALSE(camera.unproject({HUGE_VAL, 0}));
    const auto centre = camera.unproject({camera.parameters().cx_px, camera.parameters().cy_px});
    ASSERT_TRUE(centre);
    EXPECT_EQ(centre->direction, Eigen::Vector3d::UnitZ());
  }
}

TEST(Camera, ScaleAndKindOfRays) {
  const Camera flat = *Camera::create(orthographic());
  EXPECT_EQ(flat.mm_per_px_at(12), 0.051015);
  EXPECT_FALSE(flat.is_perspective());
  EXPECT_TRUE(flat.is_linear());
  EXPECT_EQ(flat.unproject({0, 0})->direction, Eigen::Vector3d::UnitZ());
  const Camera camera = *Camera::create(pinhole());
  EXPECT_DOUBLE_EQ(camera.mm_per_px_at(523.9), 1.0);
  EXPECT_TRUE(camera.is_linear());
  EXPECT_TRUE(Camera::create(brown({0, 0, 0}))->is_linear());
  EXPECT_FALSE(Camera::create(brown({0.01}))->is_linear());
  EXPECT_FALSE(Camera::create(fisheye({}))->is_linear());
}

TEST(Camera, RefusesImpossibleParametersByKey) {
  const auto key_of = [](const CameraParameters& p) {
    const auto camera = Camera::create(p);
    return camera ? std::string("accepted") : camera.error().where.english();
  };
  const auto with = [](CameraParameters p, auto&& change) {
    change(p);
    return p;
  };
  EXPECT_EQ(key_of(pinhole()), "accepted");
  for (int side : {0, -5, 15, 16385}) {
    EXPECT_EQ(key_of(with(pinhole(), [&](auto& p) { p.width_px = side; })), "camera.size");
    EXPECT_EQ(key_of(with(pinhole(), [&](auto& p) { p.height_px = side; })), "camera.size");
  }
  for (double bad : {0.0, -1.0, std::nan(""), HUGE_VAL, 1e300}) {
    EXPECT_EQ(key_of(with(pinhole(), [&](auto& p) { p.fx_px = bad; })), "camera.fx");
    EXPECT_EQ(key_of(with(pinhole(), [&](auto& p) { p.fy_px = bad; })), "camera.fy");
    EXPECT_EQ(key_of(with(orthographic(), [&](auto& p) { p.mm_per_px = bad; })),
              "camera.mm_per_px");
  }
  for (double bad : {-961.0, 1921.0, std::nan(""), HUGE_VAL})
    EXPECT_EQ(key_of(with(pinhole(), [&](auto& p) { p.cx_px = bad; })), "camera.cx");
  EXPECT_EQ(key_of(with(pinhole(), [&](auto& p) { p.cy_px = 1081; })), "camera.cy");
  EXPECT_EQ(key_of(with(pinhole(), [](auto& p) { p.distortion = {0.1}; })), "camera.distortion");
  EXPECT_EQ(key_of(brown(std::vector<double>(13, 0.0))), "camera.distortion");
  EXPECT_EQ(key_of(fisheye({0, 0, 0, 0, 0})), "camera.distortion");
  EXPECT_EQ(key_of(brown({std::nan("")})), "camera.distortion");
  EXPECT_EQ(key_of(brown({1e300})), "camera.distortion");
}

TEST(Camera, WordsOfModelsAndOrientationsReadBack) {
  for (auto model : {CameraModel::kPinhole, CameraModel::kBrown, CameraModel::kFisheye,
                     CameraModel::kOrthographic})
    EXPECT_EQ(camera_model_from(to_string(model)), model);
  EXPECT_EQ(camera_model_from("telecentric"), std::nullopt);
  EXPECT_EQ(orientation_from("rotate_45"), std::nullopt);
}

TEST(Camera, OrientationsTurnThePictureAsTheyAreNamed) {
  const cv::Mat raw = (cv::Mat_<unsigned char>(2, 3) << 1, 2, 3, 4, 5, 6);
  const auto turned = [&](Orientation orientation) {
    const cv::Mat image = oriented(raw, orientation);
    return std::pair(image.cols,
                     std::vector<int>(image.begin<unsigned char>(), image.end<unsigned char>()));
  };
  using Expected = std::pair<int, std::vector<int>>;
  EXPECT_EQ(turned(Orientation::kNone), Expected(3, {1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(turned(Orientation::kFlipU), Expected(3, {3, 2, 1, 6, 5, 4}));
  EXPECT_EQ(turned(Orientation::kFlipV), Expected(3, {4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(turned(Orientation::kRotate180), Expected(3, {6, 5, 4, 3, 2, 1}));
  EXPECT_EQ(turned(Orientation::kRotate90), Expected(2, {4, 1, 5, 2, 6, 3}));
  EXPECT_EQ(turned(Orientation::kRotate270), Expected(2, {3, 6, 2, 5, 1, 4}));
  EXPECT_EQ(oriented(raw, Orientation::kNone).data, raw.data);
  for (auto orientation :
       {Orientation::kNone, Orientation::kFlipU, Orientation::kFlipV, Orientation::kRotate180,
        Orientation::kRotate90, Orientation::kRotate270})
    EXPECT_EQ(orientation_from(to_string(orientation)), orientation);
}

}  // namespace
}  // namespace alltact
