// Depth of each pixel from its brightness against the reference.
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

/// x = (I_ref - q I) / I_ref after smoothing, with q the requested correction of the light.
/// CV_32FC1, NaN where there is no measurement; `flags` hold the reason.
struct Difference {
  cv::Mat x;
  cv::Mat flags;  ///< CV_8UC1 of PixelFlag
  FaceRuns face;  ///< every pixel outside is kOffFace
  /// Noise of both images after smoothing, grey levels. sd(x) of a contact-free pixel is grey_sd /
  /// I_ref.
  double grey_sd = 0;
  double blur_px2 = 0;  ///< variance of the blur of x, see Smoothing
  LightGain light;      ///< change of the light, if requested
};

struct DepthMap {
  cv::Mat depth_mm;  ///< CV_32FC1 along z, < 0 where skin bulges, NaN where flags require it
  cv::Mat flags;     ///< CV_8UC1 of PixelFlag
  cv::Mat cells_mm;  ///< CV_32FC1: mean depth over each cell (depth_cells.h)
  /// Standard deviation of a pixel's depth at light pressure, at the face's mean brightness.
  double noise_mm = 0;
  double live_sd = 0;             ///< noise of the image alone after smoothing, grey levels
  LightGain light;                ///< change of the light, if requested
  bool is_light_unknown = false;  ///< it was requested, but too little of the face shows it
};

struct DifferenceOptions {
  Smoothing smoothing = smoothing_of(1.0);
  double edge_margin_px = 1.0;           ///< pixels this near the face's edges are off the face
  cv::Range columns = cv::Range::all();  ///< all others are off the face
  /// Noise of the image, grey levels. It weights pixels for the light, sets the level below which
  /// the reference is too dark, and determines standard deviations unless measured.
  double noise_sd = 1.0;
  /// Computes standard deviations, and nothing else, from the noise against the reference
  /// (reference_noise.h). Falls back to noise_sd where too few pixels qualify.
  bool measure_noise = false;
  bool correct_light = false;  ///< correct for the change of the light (light_gain.h)
};

/// Compares an image with its reference on the face.
[[nodiscard]] Difference difference(const cv::Mat& grey,
                                    const Reference& reference,
                                    const FaceShape& shape,
                                    const DifferenceOptions& options);

/// Applies the mapping: depth < 0 where x < 0 (bulge), with flags beyond the calibrated domain. The
/// layer's thickness limits depths of both signs (along z: layer / cos(incline), incline at most 75
/// degrees). Noise of contact-free skin has both signs, so means of depth are unbiased. Depths of a
/// mapping along the normal are converted to depths along z (depth_along_z.h).
[[nodiscard]] DepthMap depth_map(const Difference& difference,
                                 const Mapping& mapping,
                                 const FaceShape& shape);

/// Both in one pass, without storing the differences: the same bytes at half the memory traffic.
[[nodiscard]] DepthMap depth_map(const cv::Mat& grey,
                                 const Reference& reference,
                                 const FaceShape& shape,
                                 const DifferenceOptions& options,
                                 const Mapping& mapping);

}  // namespace alltact
