// The markers of a finger before its reference recording: two plain rows, followed from frame to
// frame.
#pragma once

#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Looks for each dot near where it was, and detects anew only when one is not there or the rows
/// are no longer plain. Remembers the last frame's rows and, once they were plain, whether the dots
/// are bright or dark. Used by one thread.
class PlainRows {
 public:
  explicit PlainRows(MarkerRows rows) : rows_(rows) {}

  /// `markers` where both rows are plain (core/sensing/markers/marker_rows.h), else the `dots`
  /// found.
  struct Seen {
    std::optional<Markers> markers;
    std::vector<Dot> dots;
  };
  [[nodiscard]] Seen operator()(const cv::Mat& grey, const FaceShape& shape);
  /// The next frame is not the neighbour of the last one in time.
  void forget();

 private:
  [[nodiscard]] std::optional<std::vector<Dot>> follow(const cv::Mat& grey,
                                                       const FaceShape& shape) const;
  [[nodiscard]] Polarity polarity();

  MarkerRows rows_;
  std::optional<Polarity> plain_as_;  // polarity in which the rows were plain
  int failures_ = 0;                  // in a row since
  std::vector<Dot> last_;             // by marker; empty: to be detected
};

}  // namespace alltact
