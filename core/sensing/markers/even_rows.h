// Markers of a finger before its reference recording: two even rows, tracked from frame to frame.
#pragma once

#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Searches each dot near its last position, and detects anew only when one is not found or the
/// rows are no longer even. Stores the last frame's rows and, once they were even, the polarity of
/// the dots. Used by one thread.
class EvenRows {
 public:
  explicit EvenRows(MarkerRows rows) : rows_(rows) {}

  /// `markers` where both rows are even (core/sensing/markers/marker_rows.h), else the `dots`
  /// found.
  struct Seen {
    std::optional<Markers> markers;
    std::vector<Dot> dots;
  };
  [[nodiscard]] Seen operator()(const cv::Mat& grey, const FaceShape& shape);
  /// Call before a frame that does not follow the last one in time.
  void forget();

 private:
  [[nodiscard]] std::optional<std::vector<Dot>> follow(const cv::Mat& grey,
                                                       const FaceShape& shape) const;
  [[nodiscard]] Polarity polarity();

  MarkerRows rows_;
  std::optional<Polarity> known_polarity_;  // polarity in which the rows were even
  int failures_ = 0;                        // consecutive failures since then
  std::vector<Dot> last_;                   // by marker; empty: detection is needed
};

}  // namespace alltact
