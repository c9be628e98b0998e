// Real pictures of a rigid sensor of the same principle: the one outside yardstick there is.
#include "tests/support/program.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

const fs::path kData = fs::path(ALLTACT_SOURCE_DIR) / ".." / "shared" / "data" / "dtact_sensor_1";
constexpr double kMmPerPx = 0.051015;

struct Sphere {
  double u, v, top_mm, radius_mm;  // depth = top - r + sqrt(r^2 - distance^2)
  double residual_mm;              // mean absolute
  int pixels;
};

/// Least squares of a sphere to a depth map by Gauss-Newton, written out here so that it shares
/// nothing with the program.
Sphere fit_sphere(const cv::Mat& depth_mm, double above_mm) {
  Eigen::Vector4d p(243, 188, 0.8, 4.0);
  Sphere sphere{};
  for (int step = 0; step < 100; ++step) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    double sum = 0;
    int count = 0;
    for (int row = 0; row < depth_mm.rows; ++row) {
      for (int column = 0; column < depth_mm.cols; ++column) {
        const double d = depth_mm.at<float>(row, column);
        const double x = kMmPerPx * (column - p[0]), y = kMmPerPx * (row - p[1]);
        const double below = p[3] * p[3] - x * x - y * y;
        if (!(d > above_mm) || below < 1.0) continue;
        const double root = std::sqrt(below);
        const double error = d - (p[2] - p[3] + root);
        const Eigen::Vector4d slope(kMmPerPx * x / root, kMmPerPx * y / root, 1.0,
                                    p[3] / root - 1.0);
        normal += slope * slope.transpose();
        right += slope * error;
        sum += std::abs(error);
        ++count;
      }
    }
    sphere = {p[0], p[1], p[2], p[3], sum / std::max(count, 1), count};
    const Eigen::Vector4d move = normal.ldlt().solve(right);
    p += move;
    if (move.norm() < 1e-10) break;
  }
  return sphere;
}

TEST(RealPress, ABallComesOutRoundAndOfItsSize) {
  if (!fs::exists(kData / "press_rectified_sample.png"))
    GTEST_SKIP() << "the real pictures are not beside the project (../shared/data)";
  const TemporaryFolder folder;
  write_text(folder / "camera.yaml",
             "model: orthographic\nsize: [460, 345]\nmm_per_px: 0.051015\ncx: 229.5\ncy: 172.0\n"
             "distortion: []\norientation: none\n");
  const std::string finger = (folder / "finger").string(), out = (folder / "out").string();
  const std::string press = (kData / "press_rectified_sample.png").string();
  ASSERT_EQ(run_alltact({"new", finger, "--kind", "flat", "--layer-mm", "3", "--camera",
                         (folder / "camera.yaml").string()})
                .status,
            0);
  const ProgramRun calibration =
      run_alltact({"calibrate", finger, press, "--ball-radius-mm", "4.0", "--reference",
                   (kData / "press_rectified_ref.png").string()});
  ASSERT_EQ(calibration.status, 0) << calibration.errors;
  const ProgramRun run = run_alltact({"reconstruct", finger, press, "-o", out});
  ASSERT_EQ(run.status, 0) << run.errors;

  const cv::Mat depth =
      cv::imread(out + "/press_rectified_sample.depth.tiff", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(depth.type(), CV_32FC1);
  const Sphere sphere = fit_sphere(depth, 0.15);
  std::printf(
      "sphere: radius %.4f mm, top %.4f mm at (%.2f, %.2f), mean residual %.4f mm over %d pixels\n",
      sphere.radius_mm, sphere.top_mm, sphere.u, sphere.v, sphere.residual_mm, sphere.pixels);
  EXPECT_GT(sphere.pixels, 3000);
  EXPECT_NEAR(sphere.radius_mm, 4.0, 0.03 * 4.0);
  EXPECT_LT(sphere.residual_mm, 0.0305);  // 0.030
  EXPECT_NEAR(sphere.u, 243, 4);
  EXPECT_NEAR(sphere.v, 188, 4);

  // The bright halo and what nobody touched: further than 4.2 mm from the ball's axis. The skin
  // bulges there, which is no press.
  double pressed = 0, bulged = 0;
  int count = 0;
  for (int row = 0; row < depth.rows; ++row) {
    for (int column = 0; column < depth.cols; ++column) {
      if (kMmPerPx * std::hypot(column - sphere.u, row - sphere.v) < 4.2) continue;
      if (!std::isfinite(depth.at<float>(row, column))) continue;
      const double depth_mm = depth.at<float>(row, column);
      (depth_mm > 0 ? pressed : bulged) += depth_mm;
      ++count;
    }
  }
  std::printf("untouched: mean %.4f mm pressed, %.4f mm bulged over %d pixels\n", pressed / count,
              bulged / count, count);
  EXPECT_GT(count, 50000);
  EXPECT_LT(pressed / count, 0.03);
  EXPECT_LT(bulged / count, -0.03);  // the halo is bright in the image
}

}  // namespace
}  // namespace alltact::test
