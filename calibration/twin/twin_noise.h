// Noise of a real camera's images: the scene's shot and read noise and fixed pattern.
#pragma once

#include "core/message.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// An image and a mask of its valid pixels.
struct NoisyImage {
  cv::Mat grey;  ///< CV_8UC1
  cv::Mat used;  ///< CV_8UC1, 0: not used
};

struct TwinNoise {
  double read_sd = 0;    ///< grey levels; 0: below the rounding to integer grey levels
  double shot_gain = 0;  ///< grey levels; 0: not distinguishable from read noise
  double prnu = 0;       ///< fraction; 0: none, or not determined
  std::optional<double> read_sd_sd, shot_gain_sd, prnu_sd;
  double sd = 0;  ///< of one image in time, at its mean brightness
  Message from;   ///< source of the estimate, a sentence without full stop
};

/// Noise is estimated from second differences along both axes, which cancel smooth content. The
/// difference of two images of the same view gives noise in time. A single image gives noise in
/// time and fixed pattern.
///   alike: images of the same view where both are used; two or more give noise in time
///   alone: images of any kind; used without two of the same view
[[nodiscard]] TwinNoise measure_noise(const std::vector<NoisyImage>& alike,
                                      const std::vector<NoisyImage>& singles,
                                      const Message& what_is_alike);

}  // namespace alltact
