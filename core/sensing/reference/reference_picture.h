// What the face would look untouched: one picture, or a weighted sum of recorded faces laid over
// the skin as it lies now.
#pragma once

#include "core/sensing/reference/face_picture.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Recorded faces and what each counts.
struct FaceMix {
  std::vector<const FacePicture*> faces;  ///< at least one
  std::vector<float> weights;  ///< as many; sum to 1, magnitudes to at most 3 (or sums overflow)
  /// Columns of the grid that all of them show: first, end.
  [[nodiscard]] std::pair<int, int> shown(const FaceGrid& grid) const;
};

/// Copies share what they are made from; safe to read from any thread.
class ReferencePicture {
 public:
  ReferencePicture() = default;
  /// One picture, CV_32FC1, kept to 1/64 grey level; NaN where it tells nothing.
  explicit ReferencePicture(const cv::Mat& grey);
  /// sum of weights[i] * faces[i] of the first mix all of whose faces show the skin, each pixel of
  /// the frame looked up where `warp` says that its skin lies in the grid (bilinear). At least one
  /// mix.
  ReferencePicture(const FaceGrid& grid,
                   const std::vector<FaceMix>& mixes,
                   ChartWarp warp,
                   const cv::Size& size);

  [[nodiscard]] const cv::Size& size() const { return size_; }
  /// Of the one picture; what was mixed is not counted.
  [[nodiscard]] std::size_t memory_bytes() const { return single_.total() * single_.elemSize(); }
  /// The whole of it: CV_32FC1, NaN where it tells nothing.
  [[nodiscard]] cv::Mat grey() const;

  /// Where each of a row's pixels lies in the grid of the recording, for pixels of `columns()`.
  [[nodiscard]] const ChartWarp& warp() const { return warp_; }
  [[nodiscard]] cv::Point origin() const { return origin_; }  ///< of the grid
  /// Whether all of a column comes from the first mix.
  [[nodiscard]] bool is_first_mix(int u) const { return u >= inner_first_ && u < inner_end_; }
  [[nodiscard]] bool is_single() const { return !single_.empty(); }

  /// Gives rows in any order.
  class Reader {
   public:
    /// The picture must live as long.
    explicit Reader(const ReferencePicture& picture);
    /// size().width grey levels in steps (grey_steps.h), of which only those of the runs tell
    /// something: kNoGrey where there is none. Valid until the next call.
    const std::int16_t* row(int v, std::span<const FaceRun> runs);

   private:
    /// Pixels of row v whose skin the mixes do not show.
    void clear_hidden(int v, int first, int end);

    const ReferencePicture& picture_;
    std::vector<float> u_, v_;
    std::vector<std::int16_t> buffer_;
  };

 private:
  struct MixedColumns;
  void lay(const FaceGrid& grid, std::vector<MixedColumns>& parts);
  [[nodiscard]] std::pair<int, int> columns_within(int first, int end) const;
  [[nodiscard]] std::pair<int, int> columns_touching(int first, int end) const;

  cv::Mat single_;  // CV_16SC1 in steps; empty for a sum
  // CV_16SC1 in steps: the grid's rows with the frame's columns, so that a row of the frame is
  // looked up across them. A row and columns more keep reads inside.
  cv::Mat laid_;
  int laid_rows_ = 0;
  cv::Point origin_;
  int first_ = 0, end_ = 0;              // columns of the frame that the mixes show in part
  int whole_first_ = 0, whole_end_ = 0;  // from edge to edge
  int inner_first_ = 0, inner_end_ = 0;  // and the first of the mixes alone
  float least_u_ = 0, most_u_ = 0;       // what the mixes show, in the grid's picture
  ChartWarp warp_;
  cv::Size size_;
};

}  // namespace alltact
