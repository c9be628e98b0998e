// The published picture of a ball of radius 4 mm pressed into a real sensor of the same principle.
#include "calibration/joint/calibrate.h"

#include <cmath>
#include <filesystem>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kBallRadiusMm = 4.0;
const std::filesystem::path kFolder =
    std::filesystem::path(ALLTACT_SOURCE_DIR) / ".." / "shared" / "data" / "dtact_sensor_1";

/// Sphere of least squared distance to points (x, y, z): linear start, Gauss-Newton.
struct Sphere {
  Eigen::Vector3d centre;
  double radius, mean_absolute;
};

Sphere fit_sphere(const std::vector<Eigen::Vector3d>& points) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd a(n, 4);
  Eigen::VectorXd b(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& p = points[static_cast<std::size_t>(i)];
    a.row(i) << 2.0 * p.transpose(), 1.0;
    b[i] = p.squaredNorm();
  }
  const Eigen::Vector4d start = a.colPivHouseholderQr().solve(b);
  Sphere sphere{start.head<3>(), std::sqrt(start[3] + start.head<3>().squaredNorm()), 0.0};
  for (int round = 0; round < 50; ++round) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Vector3d d = points[static_cast<std::size_t>(i)] - sphere.centre;
      a.row(i) << -d.normalized().transpose(), -1.0;
      b[i] = sphere.radius - d.norm();
    }
    const Eigen::Vector4d step = a.colPivHouseholderQr().solve(b);
    sphere.centre += step.head<3>();
    sphere.radius += step[3];
  }
  for (const auto& p : points)
    sphere.mean_absolute += std::abs((p - sphere.centre).norm() - sphere.radius) / points.size();
  return sphere;
}

class RealPress : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kFolder))
      GTEST_SKIP() << "the published pictures are not beside the project: " << kFolder;
    CameraParameters parameters;
    parameters.model = CameraModel::kOrthographic;
    parameters.width_px = 460;
    parameters.height_px = 345;
    parameters.mm_per_px = 0.051015;
    camera_ = Camera::create(parameters).value();
    face_.kind = FaceKind::kFlat;
    face_.layer_mm = 2.0;
    face_.plane_z_mm = 10.0;
  }

  Press press() const {
    const cv::Mat sample =
        cv::imread((kFolder / "press_rectified_sample.png").string(), cv::IMREAD_GRAYSCALE);
    const cv::Mat untouched =
        cv::imread((kFolder / "press_rectified_ref.png").string(), cv::IMREAD_GRAYSCALE);
    Reference reference;
    cv::Mat levels;
    untouched.convertTo(levels, CV_32FC1);
    reference.image = ReferenceImage(levels);
    FaceShape shape = FaceShape::plane(*camera_, face_);
    Difference x = difference(sample, reference, shape, {});
    return {"press", std::move(x), std::move(shape), kBallRadiusMm};
  }

  struct Judged {
    Sphere sphere;
    double halo_mm = 0, far_mm = 0;
  };
  /// The relief of the press itself by a mapping.
  Judged judge(const Press& press, const MappingParameters& parameters, double threshold) const {
    const Mapping mapping = Mapping::create(parameters).value();
    const DepthMap map = depth_map(press.difference, mapping, press.shape);
    const Eigen::Vector2d middle(244.0, 189.0);
    std::vector<Eigen::Vector3d> points;
    double halo = 0, far = 0;
    int n_halo = 0, n_far = 0;
    for (int v = 0; v < map.depth_mm.rows; ++v) {
      for (int u = 0; u < map.depth_mm.cols; ++u) {
        const double d = static_cast<double>(map.depth_mm.at<float>(v, u));
        if (!std::isfinite(d)) continue;
        const double r = 0.051015 * (Eigen::Vector2d(u, v) - middle).norm();
        if (d > threshold && r < 4.2) points.emplace_back(0.051015 * u, 0.051015 * v, -d);
        if (r > 3.7 && r < 4.7) halo += d, ++n_halo;
        if (r > 5.0) far += d, ++n_far;
      }
    }
    return {fit_sphere(points), halo / n_halo, far / n_far};
  }

  std::optional<Camera> camera_;
  Face face_;
};

TEST_F(RealPress, BallIsFoundByItself) {
  const auto ball = find_ball(press(), face_);
  ASSERT_TRUE(ball.ok()) << ball.error().sentence();
  const auto pixel = camera_->project(ball->centre_mm);
  EXPECT_NEAR(pixel->x(), 244.0, 3.0);
  EXPECT_NEAR(pixel->y(), 189.0, 3.0);
  EXPECT_GT(ball->rim_arc_deg, 340.0);
  EXPECT_FALSE(ball->cut_by_edge);
  EXPECT_NEAR(ball->contact_radius_mm, 3.4, 0.4);
}

TEST_F(RealPress, ReliefIsTheBall) {
  const Press p = press();
  const auto calibration = calibrate({p}, *camera_, face_, CalibrationSettings{}, Job{});
  ASSERT_TRUE(calibration.ok()) << calibration.error().sentence();
  for (const double threshold : {0.05, 0.1, 0.2, 0.3}) {
    const Judged judged = judge(p, calibration->mapping, threshold);
    EXPECT_NEAR(judged.sphere.radius, 4.0, 0.12) << "depth above " << threshold;
    EXPECT_LE(judged.sphere.mean_absolute, 0.03) << "depth above " << threshold;
    EXPECT_LT(judged.halo_mm, 0.03);
    EXPECT_LT(judged.far_mm, 0.03);
  }
  // One press cannot tell its ball's depth from the mapping, and the user must hear it.
  EXPECT_FALSE(calibration->remarks.empty());
}

TEST_F(RealPress, PaperMethodGivesAComparableRelief) {
  const Press p = press();
  CalibrationSettings settings;
  settings.method = CalibrationMethod::kPaper;
  const auto calibration = calibrate({p}, *camera_, face_, settings, Job{});
  ASSERT_TRUE(calibration.ok()) << calibration.error().sentence();
  const Judged judged = judge(p, calibration->mapping, 0.1);
  EXPECT_NEAR(judged.sphere.radius, 4.0, 0.6);
  RecordProperty("paper_radius_mm", fmt::format("{:.3f}", judged.sphere.radius));
  RecordProperty("paper_residual_mm", fmt::format("{:.3f}", judged.sphere.mean_absolute));
}

}  // namespace
}  // namespace alltact
