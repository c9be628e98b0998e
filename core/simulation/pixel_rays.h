// The rays of a camera's pixels, arranged for image rows.
#pragma once

#include "core/camera/camera.h"
#include "core/camera/ray.h"
#include "core/simulation/row_view.h"

#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// The rays of one row of a perspective camera, indexed by column.
struct RayRow {
  const float* direction_x = nullptr;
  const float* direction_y = nullptr;
  const float* step_y = nullptr;  ///< d(direction_y)/dv
};

/// Built once per plan. A ray is origin + z * direction, of which only x and y are stored.
class PixelRays {
 public:
  explicit PixelRays(const Camera& camera);

  [[nodiscard]] const Camera& camera() const { return camera_; }

  /// True: all rays of a perspective camera start at its centre, or those of an orthographic one
  /// run along z. False behind a window.
  [[nodiscard]] bool are_simple() const { return origins_.empty(); }
  [[nodiscard]] Ray ray(int u, int v) const;
  /// The ray of the next pixel to the right, or below; at the image's edge, of the previous one.
  [[nodiscard]] Ray right_of(int u, int v) const {
    return ray(u + 1 < camera_.size().width ? u + 1 : u - 1, v);
  }
  [[nodiscard]] Ray below(int u, int v) const {
    return ray(u, v + 1 < camera_.size().height ? v + 1 : v - 1);
  }

  /// True: the ray's x depends on the column only, its y on the row only.
  [[nodiscard]] bool linear() const { return map_.empty(); }
  // For a linear camera:
  [[nodiscard]] float origin_x(int u) const { return origin_x_[static_cast<std::size_t>(u)]; }
  [[nodiscard]] float direction_x(int u) const { return direction_x_[static_cast<std::size_t>(u)]; }
  struct RowRay {
    float origin_y, direction_y;
  };
  [[nodiscard]] RowRay row_ray(int v) const { return rows_[static_cast<std::size_t>(v)]; }

  // For a perspective camera:
  [[nodiscard]] RayRow row(int v, RowScratch& scratch) const;
  /// Minimum and maximum direction_x in the image, for a camera with distortion.
  [[nodiscard]] std::pair<float, float> direction_x_range() const;

 private:
  Camera camera_;
  std::vector<float> origin_x_, direction_x_;
  std::vector<RowRay> rows_;
  cv::Mat_<cv::Vec2f> map_;      // directions, of a camera with distortion or behind a window
  cv::Mat_<cv::Vec2f> origins_;  // behind a window
};

}  // namespace alltact
