// How noisy a real camera's pictures are, for the scene's shot and read noise and fixed pattern.
#pragma once

#include "core/message.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// A picture and which of its pixels count.
struct NoisyPicture {
  cv::Mat grey;  ///< CV_8UC1
  cv::Mat used;  ///< CV_8UC1, 0: not used
};

struct TwinNoise {
  double read_sd = 0;    ///< grey levels; 0: below what whole grey levels hide
  double shot_gain = 0;  ///< grey levels; 0: none that could be told from read noise
  double prnu = 0;       ///< share; 0: none, or not told
  std::optional<double> read_sd_sd, shot_gain_sd, prnu_sd;
  double sd = 0;  ///< of one picture in time, at its mean brightness
  Message from;   ///< what it was told from, a sentence without full stop
};

/// Noise is told from second differences along both axes, which what is smooth leaves alone: of the
/// difference of two pictures that show the same (noise in time), and of the picture itself (noise
/// in time and fixed pattern).
///   alike: pictures that show the same where both are used; two or more tell noise in time
///   alone: pictures of any kind; used where there are not two alike
[[nodiscard]] TwinNoise measure_noise(const std::vector<NoisyPicture>& alike,
                                      const std::vector<NoisyPicture>& alone,
                                      const Message& what_is_alike);

}  // namespace alltact
