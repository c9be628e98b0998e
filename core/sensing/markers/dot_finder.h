// Interfaces of the methods of finding dots and markers.
#pragma once

#include "core/finger/finger.h"
#include "core/message.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/dot.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Unnumbered dots of one image: each with its position in px of the oriented image, the standard
/// deviation of u and of v, and a score.
struct FoundDots {
  std::vector<Dot> dots;
  Polarity polarity = Polarity::kBright;  ///< as specified or, with kAuto, as detected
  Message problem;                        ///< reason why no search was possible; empty: it was
};

/// Finds every plausible dot of an image, including false ones: MarkerModel or paper_rows numbers
/// them. Stateless between images; used by one thread.
class DotFinder {
 public:
  virtual ~DotFinder() = default;
  [[nodiscard]] virtual FoundDots operator()(const cv::Mat& grey, const FaceShape& shape) const = 0;
};

/// Finds the numbered markers of each frame of a source. May use the last frame.
class MarkerFinder {
 public:
  virtual ~MarkerFinder() = default;
  /// nullopt when the markers are not found; `problem` is then set, where it is not null.
  [[nodiscard]] virtual std::optional<Markers> operator()(const cv::Mat& grey,
                                                          const FaceShape& shape,
                                                          Message* problem) = 0;
  /// Forgets the last frame: the next one is analysed as if it were the first.
  virtual void forget() = 0;
};

}  // namespace alltact
