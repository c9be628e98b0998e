// Reference image of the face without contact: one image, or a weighted sum of recorded faces that
// is warped to the skin's current position.
#pragma once

#include "core/sensing/face/face_pixels.h"
#include "core/sensing/reference/face_chart.h"
#include "core/sensing/reference/recorded_poses.h"

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

// The skin of one recorded frame, warped to the common grid of all frames.

/// The common image grid to which all frames of a recording are warped: the face of the rest frame,
/// extended a little at both ends. Its pixel (0, 0) is the rest frame's `origin`.
struct FaceGrid {
  FaceChart chart;  ///< in the rest frame's pixels
  cv::Point origin;
  cv::Size size;
  FaceRuns runs;  ///< of this grid, 2 px wider than the face on both sides
};

/// `part`: fraction of the rest frame's face by which the grid extends beyond each end.
[[nodiscard]] FaceGrid face_grid(const FaceChart& rest, double part);

struct FaceImage {
  int first = 0, end = 0;          ///< columns of the grid that the frame shows
  std::vector<std::uint8_t> grey;  ///< the grid's runs one after the other; 0 off those columns

  [[nodiscard]] std::size_t bytes() const { return grey.size(); }
};

/// Samples a frame (CV_8UC1) at the skin of each of the grid's pixels (CubicSampler).
[[nodiscard]] FaceImage warp_face(const cv::Mat& grey, const FaceChart& chart,
                                  const FaceGrid& grid);

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
  /// Sum of weights[i] * faces[i] of the first mix whose faces show the skin; further ones are
  /// scaled to continue it. `warp` maps each pixel to the grid (bilinear). At least one mix.
  ReferenceImage(const FaceGrid& grid, const std::vector<FaceMix>& mixes, ChartWarp warp,
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
    /// size().width grey levels in steps (image_warp.h), valid within the runs only: kNoGrey where
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

/// How the reference of a frame is computed from the recording.
enum class ReferenceMethod {
  /// The recording's rest frame for all poses, pixel by pixel, as sensors on a rigid base do it
  /// (DTact): for comparison.
  kSingle = 1,
  kNearest,  ///< the one frame with the nearest markers, warped to the skin's current position
  kLocal,    ///< local linear regression over the nearest frames: several times closer
};

/// The reference image of a frame.
struct Reference {
  ReferenceImage image;    ///< grey levels; NaN where a frame used shows no face
  int frame = -1;          ///< number of the nearest frame in the recording
  double distance_px = 0;  ///< mean distance of the seen markers to that frame's
  bool known_pose = true;  ///< false: further away than the recording's own frames are apart
  bool by_shape = false;  ///< no marker was seen: the pose is estimated from the face's shape alone
  double noise_gain = 1;  ///< standard deviation of the reference's noise / that of one frame
  /// Relative error of references by the recording, over cells of its grid;
  /// empty for a single image.
  cv::Mat relative_sd;
  double error_factor = 1;  ///< factor of relative_sd in this pose
  /// The same where not all of the nearest frames show the skin, and others replace them.
  double outer_error_factor = 1;
  /// By column: standard deviation of the skin's position along the finger, px, where this frame's
  /// shape decides it, beyond the last marker. Empty for a single image.
  std::vector<float> registration_sd_px;
  std::vector<HiddenColumn> hidden;  ///< columns of the face that the frame does not show

  /// Few recorded frames are near this pose.
  [[nodiscard]] bool is_sparse() const {
    constexpr double kFarBeyond = 3.0;  // times what is typical of the recording
    return error_factor > kFarBeyond;
  }
};

// Drift of a recording's light, and the error of references that are computed from the recording.

constexpr int kErrorCellPx = 4;  ///< a side, in pixels of the grid

/// Error of references, estimated by leave-one-out: recorded frames are computed from their
/// neighbours.
struct ReferenceError {
  /// CV_32FC1 over cells of the grid: sd of the reference's brightness relative to it. Excludes
  /// noise and what the correction of the light removes. Applies to a pose at the typical distance
  /// of a recorded frame from its neighbours.
  cv::Mat relative_sd;
  double typical_reach_px2 = 0;  ///< median of PoseNeighbours::reach_px2 over the recorded frames

  /// Factor of relative_sd for a frame of another reach. Half of it (in squares) remains however
  /// near the neighbours are, because the skin is never registered perfectly.
  [[nodiscard]] double factor(double reach_px2) const;
};

/// Removes the drift of lamps: the light of every recorded face is corrected to a smooth function
/// of the pose (`modes`, a row per frame, largest variance first). Requires 12 frames; with fewer
/// nothing changes.
void remove_drift(const FaceGrid& grid, const Eigen::MatrixXd& modes,
                  std::vector<FaceImage>& faces);

/// `neighbours_of` frame i, without itself, must be thread safe.
[[nodiscard]] ReferenceError reference_error(
    const FaceGrid& grid, const std::vector<FaceImage>& faces,
    const std::function<PoseNeighbours(int)>& neighbours_of);

}  // namespace alltact
