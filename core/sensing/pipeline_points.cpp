#include "core/sensing/pipeline.h"

#include <cmath>
#include <limits>

namespace alltact {

cv::Mat contact_face_points_mm(const FrameResult& result, const Face& face) {
  const cv::Mat& depth = result.depth->depth_mm;
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  cv::Mat points(depth.size(), CV_32FC3, cv::Scalar(kNaN, kNaN, kNaN));
  for (int row = 0; row < depth.rows; ++row) {
    const float* d = depth.ptr<float>(row);
    auto* point = points.ptr<cv::Vec3f>(row);
    for (int u = 0; u < depth.cols; ++u) {
      if (!std::isfinite(d[u])) continue;
      const auto local = result.shape->at(u, row);
      if (!local) continue;
      const Eigen::Vector3d p = untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ);
      point[u] = {
          static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()) - d[u]};
    }
  }
  return points;
}

FaceVertices contact_face_vertices(const FrameResult& result, const Face& face) {
  const FaceVertices full{contact_face_points_mm(result, face), result.depth->depth_mm};
  const int step = result.mesh_step_px;
  if (step == 1) return full;
  const cv::Size size((full.depth_mm.cols + step - 1) / step,
                      (full.depth_mm.rows + step - 1) / step);
  FaceVertices sampled{cv::Mat(size, CV_32FC3), cv::Mat(size, CV_32FC1)};
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column) {
      sampled.points_mm.at<cv::Vec3f>(row, column) =
          full.points_mm.at<cv::Vec3f>(step * row, step * column);
      sampled.depth_mm.at<float>(row, column) = full.depth_mm.at<float>(step * row, step * column);
    }
  return sampled;
}

}  // namespace alltact
