// An image of what was found, what was expected, and why that is not enough.
#pragma once

#include "core/sensing/reference/recorded_poses.h"

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// A mark in the image.
struct ProblemMark {
  enum class Kind {
    kUsed = 1,  ///< found and used: a circle
    kRefused,   ///< found and not used: crossed out
    kExpected,  ///< not found at its expected position: a broken circle
    kDarker,    ///< darker than the untouched face: a square
  };
  Kind kind = Kind::kUsed;
  double u = 0, v = 0, radius_px = 0;
  int number = -1;  ///< written next to it; -1: none
};

struct ProblemScene {
  cv::Mat grey;      ///< CV_8UC1, not empty
  EdgeCurves edges;  ///< of the face; empty where it was not found
  std::vector<ProblemMark> marks;
  /// Sentences below the image, in English: the font has only its letters.
  std::vector<std::string> words;
  /// CV_8UC1, not 0 where the untouched face is brighter; outlined. May be empty.
  cv::Mat darker = {};
};

/// CV_8UC3, the image at its size or doubled (so that a small one can be read) with edges and marks
/// drawn on it, a key to these and the words below. Marks without a finite position are left out.
[[nodiscard]] cv::Mat problem_image(const ProblemScene& scene);

}  // namespace alltact
