// One row of an image during rendering.
#pragma once

#include "core/camera/camera.h"

#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Memory that begins with a cache line, so that wide loads from it never straddle two.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t kLine{64};
  CacheLineAllocator() = default;
  template <class U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>&) {}
  [[nodiscard]] T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new(n * sizeof(T), kLine));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, kLine); }
  bool operator==(const CacheLineAllocator&) const = default;
};
using AlignedFloats = std::vector<float, CacheLineAllocator<float>>;

/// Rows of floats for one thread, handed out anew for every image row.
class RowScratch {
 public:
  explicit RowScratch(int width) : width_(static_cast<std::size_t>(width)) {}
  void rewind() { next_ = 0; }
  /// `width` floats with any content.
  [[nodiscard]] float* floats() {
    if (next_ == rows_.size()) rows_.emplace_back(width_);
    return rows_[next_++].data();
  }

 private:
  std::size_t width_, next_ = 0;
  std::vector<AlignedFloats> rows_;
};

/// Value where rays miss the face; before its base by more than any length.
inline constexpr float kNoHit_mm = -1e6F;

/// Margin for coverage: so many pixels within its edges a face covers a pixel fully, and so many
/// beyond them not at all, at any slant.
inline constexpr double kEdgeMargin_px = 50;

/// The view face along one row, for the columns [first, last). All arrays are indexed by column;
/// off the face they hold finite numbers and coverage is 0.
struct FaceRow {
  int first = 0, last = 0;
  const float *x_mm = nullptr, *y_mm = nullptr, *z_mm = nullptr;  ///< points of the view face
  const float *sin_incline = nullptr, *cos_incline = nullptr;
  const float* luf_mm = nullptr;    ///< layer's thickness along z, t0: LUF is z_mm + luf_mm
  const float* shift_mm = nullptr;  ///< y of the face's middle line
  const float* s_mm = nullptr;      ///< arc length from the base; kNoHit_mm
  const float* coverage = nullptr;  ///< fraction of the pixel that the face covers, 0..1
};

/// A light-emitting surface in this row: points, normals on the visible side, and the light that
/// leaves it, which starts as 1.
struct Surface {
  int first = 0, last = 0;
  const float *x_mm = nullptr, *y_mm = nullptr, *z_mm = nullptr;
  const float *normal_x = nullptr, *normal_y = nullptr, *normal_z = nullptr;
  const float* coverage = nullptr;
  float* light = nullptr;
};

struct RowView {
  RowView(int width_px, RowScratch& rows) : width(width_px), scratch(rows) {}

  int v = 0;
  int width;
  RowScratch& scratch;
  FaceRow face;
  /// Press depth along z in columns [press_first, press_last); 0 outside.
  int press_first = 0, press_last = 0;
  const float* press_depth_mm = nullptr;
  /// Hollow part of the layer's thickness along its normal, in the face's columns; null: none.
  float* hollow_mm = nullptr;
  std::vector<Surface> surfaces;    ///< the first is the view face
  float* value = nullptr;           ///< grey levels, once the light is summed
  int lit_first = 0, lit_last = 0;  ///< columns in which `value` is set; it is dark outside
  std::uint8_t* bytes = nullptr;    ///< output of the sensor, if it outputs bytes
};

// The rays of a camera's pixels, arranged for image rows.

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
