// A picture of what was found, what was expected, and why that is not enough.
#pragma once

#include "core/sensing/reference/pose_places.h"

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Something to point at in the picture.
struct ProblemMark {
  enum class Kind {
    kUsed = 1,  ///< found and taken: a circle
    kRefused,   ///< found and not taken: crossed out
    kExpected,  ///< not found where it should be: a broken circle
    kDarker,    ///< darker than the untouched face: a square
  };
  Kind kind = Kind::kUsed;
  double u = 0, v = 0, radius_px = 0;
  int number = -1;  ///< written beside it; -1: none
};

struct ProblemScene {
  cv::Mat grey;      ///< CV_8UC1, not empty
  EdgeCurves edges;  ///< of the face; empty where it was not found
  std::vector<ProblemMark> marks;
  /// Sentences below the picture, in English: its letters are all that can be drawn.
  std::vector<std::string> words;
  /// CV_8UC1, not 0 where the untouched face is brighter; outlined. May be empty.
  cv::Mat darker = {};
};

/// CV_8UC3, the picture at one or two times its size (so that a small one can be read) with edges
/// and marks drawn on it, a key to these and the words below. What has no finite place is left out.
[[nodiscard]] cv::Mat problem_picture(const ProblemScene& scene);

}  // namespace alltact
