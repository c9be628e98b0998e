// A camera that was exported is read back as the same.
#include "calibration/export/export_texts.h"
#include "core/camera/camera_file.h"
#include "core/finger/finger.h"
#include "tests/support/cameras.h"

#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// Cameras of every model and orientation, with as many coefficients as a file may hold.
std::vector<CameraParameters> cameras() {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<CameraParameters> all;
  for (const std::size_t count : {0U, 1U, 2U, 4U, 5U, 6U, 8U, 9U, 12U})
    for (const CameraModel model :
         {CameraModel::kPinhole, CameraModel::kBrown, CameraModel::kFisheye}) {
      if (model == CameraModel::kPinhole && count > 0) continue;
      if (model == CameraModel::kFisheye && count > 4) continue;
      CameraParameters p = pinhole();
      p.model = model;
      p.fx_px *= 1 + 0.1 * unit(random), p.fy_px *= 1 + 0.1 * unit(random);
      p.cx_px += 20 * unit(random), p.cy_px += 20 * unit(random);
      p.orientation = static_cast<Orientation>(1 + all.size() % 6);
      do {  // until the lens folds nowhere
        p.distortion.clear();
        for (std::size_t k = 0; k < count; ++k)
          p.distortion.push_back((k == 2 || k == 3 || k > 7 ? 0.001 : 0.02) * unit(random));
      } while (!Camera::create(p));
      all.push_back(p);
    }
  return all;
}

/// Largest distance of the two cameras' pixels for rays over the image, px.
double worst_px(const CameraParameters& one, const CameraParameters& other) {
  const auto a = Camera::create(one), b = Camera::create(other);
  if (!a || !b) return 1e9;
  double worst = 0;
  for (double v = 0; v < one.height_px; v += 41.3)
    for (double u = 0; u < one.width_px; u += 43.7) {
      const auto ray = a->unproject({u, v});
      const auto seen = ray ? b->project(ray->point_at(70)) : std::nullopt;
      if (!seen) return 1e9;
      worst = std::max(worst, (*seen - Eigen::Vector2d(u, v)).norm());
    }
  return worst;
}

TEST(CameraRoundTrip, EveryExportOfACameraIsReadBackAsTheSame) {
  const auto all = cameras();
  ASSERT_EQ(all.size(), 14U);
  for (const CameraParameters& camera : all) {
    Finger finger;
    finger.name = "left";
    finger.camera = camera;
    finger.face.width_mm = 24, finger.face.layer_mm = 1.5;
    for (const auto& text : {opencv_camera(finger), ros_camera_info(finger),
                             calibration_json(finger), finger.to_yaml()}) {
      ASSERT_TRUE(text.ok()) << text.error().sentence();
      const auto read = parse_camera(*text, "camera");
      ASSERT_TRUE(read.ok()) << read.error().sentence() << "\n" << *text;
      EXPECT_LT(worst_px(camera, read->parameters), 1e-9) << *text;
      EXPECT_EQ(read->parameters.orientation, camera.orientation) << *text;
      EXPECT_TRUE(read->warnings.empty()) << *text;
    }
  }
}

TEST(CameraRoundTrip, OrthographicCamerasAndWindowsAreReadFromJson) {
  CameraParameters orthographic = pinhole();
  orthographic.model = CameraModel::kOrthographic;
  orthographic.fx_px = orthographic.fy_px = 0;
  orthographic.mm_per_px = 0.051015;
  CameraParameters behind_window = pinhole();
  behind_window.port = FlatPort{3.5, 2, 1.52, 1.33};
  for (const CameraParameters& camera : {orthographic, behind_window}) {
    Finger finger;
    finger.camera = camera;
    const auto text = calibration_json(finger);
    ASSERT_TRUE(text.ok());
    const auto read = parse_camera(*text, "calibration.json");
    ASSERT_TRUE(read.ok()) << read.error().sentence();
    EXPECT_EQ(read->parameters, camera);
  }
}

TEST(CameraRoundTrip, ParametersOfARosNodeHoldNoCamera) {
  Finger finger;
  finger.camera = pinhole();
  const auto text = ros_parameters(finger);
  ASSERT_TRUE(text.ok());
  const auto read = parse_camera(*text, "parameters.yaml");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().sentence(),
            "parameters.yaml: holds parameters of a ROS node, without focal lengths. Try: "
            "camera_info.yaml of the same export.");
}

}  // namespace
}  // namespace alltact
