// How sure every pixel's depth is, and why.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/depth/local_depth.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/reference/reference_library.h"

#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Standard deviations of one pixel's depth, mm along z, by cause; independent of each other.
struct DepthCauses {
  /// Noise of the picture and of its reference: f M'(x) sd / I_ref sqrt(1 + (1 - x)^2 gain^2).
  double noise = 0;
  double mapping = 0;  ///< what the calibration leaves open (Mapping::depth_sd_mm at the place)
  /// What references of this recording are off by here (reference_error.h): the pose, the skin that
  /// is not followed to a hair, blemishes: f M'(x) (1 - x) sd_ref / I_ref.
  double reference = 0;
  double light = 0;  ///< how well the light's change is known: f M'(x) (1 - x) sd(q) / q
  /// Where depth changes fast: a quarter of a pixel sideways, and what smoothing takes off a bend.
  double lateral = 0;
  /// No cause of its own: what the depth changes by from a pixel to the next, mm. 0: within noise.
  double per_px = 0;

  [[nodiscard]] double total() const;
};

/// Of a pixel that nothing presses: what averages out over a region (noise) and what does not
/// (reference and light), mm.
struct UntouchedSd {
  double noise = 0, systematic = 0;
};

/// Of one frame; what it is made from must live as long.
class DepthError {
 public:
  DepthError(const DepthMap& depth,
             const Reference& reference,
             const FaceShape& shape,
             const Mapping& mapping);

  /// Calls put(u, causes) for each pixel of row v that has a depth.
  template <class Put>
  void row(int v, Put put);

  /// How far off untouched skin may be told at a pixel.
  [[nodiscard]] UntouchedSd untouched(int u, int v);

  /// The same of a depth that is told there; `lateral` is that of the depths around it.
  [[nodiscard]] DepthCauses of_depth(int u, int v, double depth_mm);

 private:
  struct At {
    double x, slope_mm;
  };
  void know_curve();
  [[nodiscard]] At curve_at(double depth_mm) const;
  [[nodiscard]] At single_at(double depth_mm) const;
  [[nodiscard]] double reference_sd(int u, int v);
  void add_lateral(int u, int v, DepthCauses& causes) const;
  [[nodiscard]] double level_at(int u, int v);
  using ReadCurve = At (DepthError::*)(double depth_mm) const;
  [[nodiscard]] DepthCauses causes(int u, int v, double level, double depth_mm, ReadCurve read);

  const DepthMap& depth_;
  const Reference& reference_;
  const FaceShape& shape_;
  const Mapping& mapping_;
  ReferencePicture::Reader reader_;
  std::vector<float> along_z_;
  double step_mm_;
  std::vector<double> x_, slope_mm_;  // of the mapping, by depth
};

/// The causes together: CV_32FC1, mm along z, NaN where there is no depth. As dear as the depth
/// itself, so not made for every live frame.
[[nodiscard]] cv::Mat depth_sd_mm(const DepthMap& depth,
                                  const Reference& reference,
                                  const FaceShape& shape,
                                  const Mapping& mapping);

/// Each cause apart, named as in DepthCauses.
struct NamedPicture {
  const char* name;
  cv::Mat sd_mm;
};
[[nodiscard]] std::vector<NamedPicture> depth_sd_by_cause(const DepthMap& depth,
                                                          const Reference& reference,
                                                          const FaceShape& shape,
                                                          const Mapping& mapping);

template <class Put>
void DepthError::row(int v, Put put) {
  know_curve();
  const FaceRun whole{v, 0, depth_.depth_mm.cols, 0};
  const std::int16_t* grey = reader_.row(v, {&whole, 1});
  const float* depth = depth_.depth_mm.ptr<float>(v);
  for (int u = 0; u < depth_.depth_mm.cols; ++u)
    if (depth[u] == depth[u] && grey[u] > 0) {
      DepthCauses all = causes(u,
                               v,
                               static_cast<double>(grey[u]) / 64.0,
                               static_cast<double>(depth[u]),
                               &DepthError::curve_at);
      add_lateral(u, v, all);
      put(u, all);
    }
}

}  // namespace alltact
