// Brightness against the reference becomes depth, pixel by pixel.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/depth/light_gain.h"
#include "core/sensing/depth/pixel_flags.h"
#include "core/sensing/depth/smoothing.h"
#include "core/sensing/face/face_runs.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/reference/reference_library.h"

#include <opencv2/core.hpp>

namespace alltact {

/// x = (I_ref - q I) / I_ref after smoothing, q the correction for the light's change if asked for,
/// CV_32FC1, NaN where there is no measurement; and why.
struct Difference {
  cv::Mat x;
  cv::Mat flags;  ///< CV_8UC1 of PixelFlag
  FaceRuns face;  ///< every pixel outside is kOffFace
  /// Noise of both pictures after smoothing, grey levels: sd(x) of an untouched pixel is
  /// grey_sd / I_ref.
  double grey_sd = 0;
  double blur_px2 = 0;  ///< by what x is spread, see Smoothing
  LightGain light;      ///< how the light has changed, if that was asked for
};

struct DepthMap {
  cv::Mat depth_mm;  ///< CV_32FC1 along z, < 0 where skin bulges, NaN where flags say so
  cv::Mat flags;     ///< CV_8UC1 of PixelFlag
  cv::Mat cells_mm;  ///< CV_32FC1: mean depth over each cell (depth_cells.h)
  /// Standard deviation of a pixel's depth where little presses, at the face's mean brightness.
  double noise_mm = 0;
  double live_sd = 0;             ///< noise of the picture alone after smoothing, grey levels
  LightGain light;                ///< how the light has changed, if that was asked for
  bool is_light_unknown = false;  ///< it was asked for, and too little of the face tells it
};

struct DifferenceOptions {
  Smoothing smoothing = smoothing_of(1.0);
  double edge_margin_px = 1.0;           ///< pixels this near the face's edges are off the face
  cv::Range columns = cv::Range::all();  ///< all others are taken as off the face
  /// Noise of the picture, grey levels: how pixels are weighed for the light, below which level the
  /// reference is too dark, and, unless it is measured, what standard deviations are told from.
  double noise_sd = 1.0;
  /// Tells standard deviations, and nothing else, from the noise against the reference
  /// (reference_noise.h); from noise_sd where too few pixels tell it.
  bool measure_noise = false;
  bool correct_light = false;  ///< take out what the light has changed (light_gain.h)
};

/// Compares a picture with its reference on the face.
[[nodiscard]] Difference difference(const cv::Mat& grey,
                                    const Reference& reference,
                                    const FaceShape& shape,
                                    const DifferenceOptions& options);

/// Applies the mapping: depth < 0 where x < 0 (bulge), flags beyond the calibrated domain, and
/// never more than the layer is thick, either way (along z: layer / cos(incline), incline at most
/// 75 degrees). Noise of untouched skin has both signs, so means of depth are unbiased. With a
/// mapping along the normal the depth is turned into that along z (depth_along_z.h).
[[nodiscard]] DepthMap depth_map(const Difference& difference,
                                 const Mapping& mapping,
                                 const FaceShape& shape);

/// Both in one, without keeping the differences: the same bytes in half the memory traffic.
[[nodiscard]] DepthMap depth_map(const cv::Mat& grey,
                                 const Reference& reference,
                                 const FaceShape& shape,
                                 const DifferenceOptions& options,
                                 const Mapping& mapping);

}  // namespace alltact
