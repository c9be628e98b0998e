// What the ways of finding dots and markers have in common.
#pragma once

#include "core/finger/finger.h"
#include "core/message.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/dot.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Dots of one picture, not yet numbered: each with its place in px of the oriented picture, the
/// standard deviation of u and of v, and a score.
struct FoundDots {
  std::vector<Dot> dots;
  Polarity polarity = Polarity::kBright;  ///< that was told, or, with kAuto, that was found
  Message problem;                        ///< why none could be looked for; empty: they were
};

/// Finds every plausible dot of a picture, also false ones: numbering them is for MarkerModel or
/// paper_rows. Remembers nothing between pictures; used by one thread.
class DotFinder {
 public:
  virtual ~DotFinder() = default;
  [[nodiscard]] virtual FoundDots operator()(const cv::Mat& grey, const FaceShape& shape) const = 0;
};

/// Finds the numbered markers of each frame of a source. May remember the last frame.
class MarkerFinder {
 public:
  virtual ~MarkerFinder() = default;
  /// nullopt with `problem` set, where it is not null, when the markers could not be found.
  [[nodiscard]] virtual std::optional<Markers> operator()(const cv::Mat& grey,
                                                          const FaceShape& shape,
                                                          Message* problem) = 0;
  /// Forgets the last frame: the next one is looked at as if it were the first.
  virtual void forget() = 0;
};

}  // namespace alltact
