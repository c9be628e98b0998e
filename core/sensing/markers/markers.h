// Engraved dots on the two side faces: detection, numbering and tracking.
//
// Numbers: 0..n-1 along the upper row (small v) from base to tip, n..2n-1 along the lower row. Dots
// that a finger lacks (MarkerRows::missing) have numbers too and are never seen.
#pragma once

#include "core/base/message.h"
#include "core/finger/finger.h"
#include "core/sensing/face/face_shape.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

// Markers (numbered) and dots (detected, not yet numbered).

struct Marker {
  double u = 0, v = 0;  ///< px, oriented image; an estimate when not seen
  bool seen = false;
  double sd_px = 0;  ///< expected standard deviation of u and of v
};

/// 2n markers, indexed by number.
using Markers = std::vector<Marker>;

[[nodiscard]] inline int seen_count(const Markers& markers) {
  return static_cast<int>(
      std::count_if(markers.begin(), markers.end(), [](const Marker& m) { return m.seen; }));
}
[[nodiscard]] inline bool are_all_seen(const Markers& markers) {
  return seen_count(markers) == static_cast<int>(markers.size());
}

/// A dot detected in the image, not yet numbered.
struct Dot {
  double u = 0, v = 0;
  double radius_px = 0;  ///< of the disc with the same area
  double contrast = 0;   ///< grey levels relative to the surroundings; the sign is the polarity
  double sd_px = 0;
  bool upper = false;   ///< on the side face at small v
  double along_mm = 0;  ///< length of the face from its base to the dot's foot on it
  double face_px = 0;   ///< width of the face at the dot's distance from the camera
  double off_face = 0;  ///< distance from the face, as a fraction of its width
  double half_u_px = 0, half_v_px = 0;  ///< half extents at half height; 0: not known
  double score = 1;                     ///< confidence, 0 to 1; 1 from finders without scores
};

// Interfaces of the methods of finding dots and markers.

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

/// Methods of finding a finger's markers (make_marker_finder).
enum class MarkerMethod {
  /// Bright or dark spots of the side faces, numbered by the recorded motion of the finger and then
  /// followed from frame to frame.
  kBlobs = 1,
  /// The source paper's method: sorts each frame's dots into two rows and estimates hidden ones
  /// from their neighbours. The dots are those of kBlobs, or of a network where one
  /// is named.
  kPaper,
  /// A convolutional network in every frame. Its dots are numbered like those of kBlobs.
  kNetwork,
};

/// As text: "blobs", "paper", "network".
[[nodiscard]] const char* to_string(MarkerMethod method);

}  // namespace alltact
