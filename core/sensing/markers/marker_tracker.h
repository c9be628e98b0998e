// Tracks the markers from frame to frame.
#pragma once

#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/sensing/markers/marker_detector.h"
#include "core/sensing/markers/marker_model.h"
#include "core/sensing/markers/markers.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Numbers the dots of one image by the model. nullopt when they fit no recorded pose; `problem` is
/// then set, where it is not null.
[[nodiscard]] std::optional<Markers> numbered(const FoundDots& found, const MarkerModel& model,
                                              Message* problem);

/// Tracks the markers from frame to frame: searches near their last positions, and detects anew
/// only when that fails. Stores the last frame.
class MarkerTracker : public MarkerFinder {
 public:
  MarkerTracker(MarkerRows rows, MarkerModel model);

  [[nodiscard]] std::optional<Markers> operator()(const cv::Mat& grey, const FaceShape& shape,
                                                  Message* problem) override;
  void forget() override { last_.reset(); }

 private:
  [[nodiscard]] std::optional<Markers> follow(const cv::Mat& grey, const FaceShape& shape);

  MarkerDetector detector_;
  MarkerModel model_;
  std::optional<Markers> last_;
  std::vector<Dot> last_dots_;  // each marker when it was last tracked
};

// Selectable methods of finding a finger's markers.

/// network: an ONNX file, or kBuiltInNetwork. Errors: those of DotNetwork::load, where a network is
/// used.
[[nodiscard]] Result<std::unique_ptr<MarkerFinder>> make_marker_finder(MarkerMethod method,
                                                                       const std::string& network,
                                                                       const Finger& finger,
                                                                       const MarkerModel& model);

/// The network that comes with the program.
inline constexpr const char* kBuiltInNetwork = "own";

// Markers of a finger before its reference recording: two even rows, tracked from frame to frame.

/// Searches each dot near its last position, and detects anew only when one is not found or the
/// rows are no longer even. Stores the last frame's rows and, once they were even, the polarity of
/// the dots. Used by one thread.
class EvenRows {
 public:
  explicit EvenRows(MarkerRows rows) : rows_(rows) {}

  /// The markers where both rows are even (marker_detector.h), else nullopt; `dots` are then those
  /// found.
  [[nodiscard]] std::optional<Markers> operator()(const cv::Mat& grey, const FaceShape& shape,
                                                  std::vector<Dot>& dots);
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

// Numbering of dots by the source paper: two rows, each sorted along the image, hidden markers
// estimated from their neighbours. Reference method for MarkerModel, without a model of the
// bending.

/// Sorts the dots of each side face (Dot::upper) from base to tip and numbers them in that order.
/// Of more than `per_row` dots in a row those of the largest |contrast| are selected; the paper's
/// detector has scores instead. Of fewer, the numbers are those whose steps between neighbours
/// change least relative to `before` (the markers of the frame before, or at rest). With nullptr
/// the numbers are those with the most even steps. The tip's markers then count as hidden where
/// nothing else decides. Perspective makes steps uneven too, so that rows with hidden inner markers
/// may be numbered wrongly.
///
/// Hidden markers are interpolated evenly between the seen ones on both sides, or extrapolated from
/// the last two. Their sd_px is the deviation of a straight line from a curve with the bending of
/// the seen ones. That is half the second difference times the distances, in numbers, to those two;
/// at least 1 px.
///
/// nullopt where a row shows fewer than two dots (none, of a finger with one a row).
[[nodiscard]] std::optional<Markers> paper_rows(const std::vector<Dot>& dots, int per_row,
                                                bool base_at_low_u,
                                                const Markers* before = nullptr);

}  // namespace alltact
