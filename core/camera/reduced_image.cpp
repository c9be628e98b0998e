#include "core/camera/reduced_image.h"

#include <opencv2/imgproc.hpp>

namespace alltact {

cv::Mat reduced_image(const cv::Mat& grey, int by) {
  CV_Assert(grey.type() == CV_8UC1 && by >= 1);
  if (by == 1) return grey;
  const cv::Size size(grey.cols / by, grey.rows / by);
  cv::Mat reduced;
  cv::resize(grey({0, 0, size.width * by, size.height * by}), reduced, size, 0, 0, cv::INTER_AREA);
  return reduced;
}

CameraParameters reduced_camera(const CameraParameters& camera, int by) {
  CameraParameters reduced = camera;
  reduced.width_px /= by;
  reduced.height_px /= by;
  reduced.fx_px /= by;
  reduced.fy_px /= by;
  reduced.cx_px = reduced_px(camera.cx_px, by);
  reduced.cy_px = reduced_px(camera.cy_px, by);
  reduced.mm_per_px *= by;
  return reduced;
}

}  // namespace alltact
