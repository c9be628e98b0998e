// Reference image of the face without contact: one image, or a weighted sum of recorded faces that
// is warped to the skin's current position.
#pragma once

#include "core/sensing/reference/face_image.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Recorded faces and their weights.
struct FaceMix {
  std::vector<const FaceImage*> faces;  ///< not empty
  /// one per face; sum to 1, magnitudes to at most 3 (or sums overflow)
  std::vector<float> weights;
  /// Columns of the grid that all of them show: first, end.
  [[nodiscard]] std::pair<int, int> shown(const FaceGrid& grid) const;
};

/// Copies share their data; safe to read from any thread.
class ReferenceImage {
 public:
  ReferenceImage() = default;
  /// One image, CV_32FC1, stored to 1/64 grey level; NaN where it has no value.
  explicit ReferenceImage(const cv::Mat& grey);
  /// Sum of weights[i] * faces[i] of the first mix all of whose faces show the skin. `warp` maps
  /// each pixel of the frame to the grid (bilinear). At least one mix.
  ReferenceImage(const FaceGrid& grid,
                 const std::vector<FaceMix>& mixes,
                 ChartWarp warp,
                 const cv::Size& size);

  [[nodiscard]] const cv::Size& size() const { return size_; }
  /// Of the one image; mixes are not counted.
  [[nodiscard]] std::size_t memory_bytes() const { return single_.total() * single_.elemSize(); }
  /// The full image: CV_32FC1, NaN where it has no value.
  [[nodiscard]] cv::Mat grey() const;

  /// Maps each pixel of `columns()` to the grid of the recording.
  [[nodiscard]] const ChartWarp& warp() const { return warp_; }
  [[nodiscard]] cv::Point origin() const { return origin_; }  ///< of the grid
  /// Whether a column comes from the first mix entirely.
  [[nodiscard]] bool is_first_mix(int u) const { return u >= inner_first_ && u < inner_end_; }
  [[nodiscard]] bool is_single() const { return !single_.empty(); }

  /// Reads rows in any order.
  class Reader {
   public:
    /// The image must outlive the reader.
    explicit Reader(const ReferenceImage& image);
    /// size().width grey levels in steps (grey_steps.h), valid within the runs only: kNoGrey where
    /// there is none. Valid until the next call.
    const std::int16_t* row(int v, std::span<const FaceRun> runs);

   private:
    /// Clears pixels of row v whose skin the mixes do not show.
    void clear_hidden(int v, int first, int end);

    const ReferenceImage& image_;
    std::vector<float> u_, v_;
    std::vector<std::int16_t> buffer_;
  };

 private:
  struct MixedColumns;
  void mix_and_warp(const FaceGrid& grid, std::vector<MixedColumns>& parts);
  [[nodiscard]] std::pair<int, int> columns_within(int first, int end) const;
  [[nodiscard]] std::pair<int, int> columns_overlapping(int first, int end) const;

  cv::Mat single_;  // CV_16SC1 in steps; empty for a sum
  // CV_16SC1 in steps: the grid's rows with the frame's columns; rows of the frame are interpolated
  // across them. One more row and further columns prevent reads outside.
  cv::Mat warped_;
  int warped_rows_ = 0;
  cv::Point origin_;
  int first_ = 0, end_ = 0;              // columns of the frame that the mixes show in part
  int full_first_ = 0, full_end_ = 0;    // from edge to edge
  int inner_first_ = 0, inner_end_ = 0;  // and the first of the mixes alone
  float min_u_ = 0, max_u_ = 0;          // columns of the grid that the mixes show
  ChartWarp warp_;
  cv::Size size_;
};

}  // namespace alltact
