#include "calibration/twin/twin_image.h"

#include "core/simulation/plan.h"

namespace alltact {

Result<cv::Mat> twin_image(const TwinScene& scene, int frame) {
  const auto parsed = Scene::parse(scene.to_yaml(false), "the twin's scene");
  if (!parsed) return parsed.error();
  const auto plan = Plan::compile(*parsed, 1);
  if (!plan) return plan.error();
  return plan->render(frame);
}

CameraParameters cropped_camera(const CameraParameters& camera, const cv::Rect& part) {
  CameraParameters cropped = camera;
  cropped.width_px = part.width;
  cropped.height_px = part.height;
  cropped.cx_px = camera.cx_px - part.x;
  cropped.cy_px = camera.cy_px - part.y;
  return cropped;
}

CameraParameters downsampled_camera(const CameraParameters& camera, int side) {
  CameraParameters thin = camera;
  thin.width_px = camera.width_px / side;
  thin.height_px = camera.height_px / side;
  thin.fx_px = camera.fx_px / side;
  thin.fy_px = camera.fy_px / side;
  thin.cx_px = (camera.cx_px - 0.5 * (side - 1)) / side;
  thin.cy_px = (camera.cy_px - 0.5 * (side - 1)) / side;
  thin.mm_per_px = camera.mm_per_px * side;
  return thin;
}

cv::Mat downsampled_image(const cv::Mat& grey, int side) {
  cv::Mat_<float> thin(grey.rows / side, grey.cols / side);
  for (int v = 0; v < thin.rows; ++v)
    for (int u = 0; u < thin.cols; ++u) {
      double sum = 0;
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) sum += grey.at<float>(v * side + i, u * side + j);
      thin(v, u) = static_cast<float>(sum / (side * side));
    }
  return thin;
}

}  // namespace alltact
