// Maps each pixel of a frame to a point of the skin, so that frames of a bending finger can be
// registered to each other.
#pragma once

#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Coordinates of the skin in one frame: along it, in mm of arc from the base, and across it, t = 0
/// at the upper and 1 at the lower edge. On the middle of the face the length is that of the shape,
/// shifted and stretched to fit the markers. The rows of markers also show how lines across the
/// finger tilt in the image when it twists:
///   along(u, t) = s(u) + (2 t - 1) (k0 + k1 m(s)),   m(s) = (s - middle) / half.
struct FaceChart {
  int first = 0;                         ///< column of the first entries below
  std::vector<double> along_mm;          ///< s by column, increasing with u (see base_at_low_u)
  std::vector<double> upper_v, lower_v;  ///< edges, px
  double tilt_mm = 0, tilt_slope_mm = 0, middle_mm = 0, half_mm = 1;  ///< k0, k1, middle, half
  bool base_at_low_u = true;  ///< false: lengths count from the tip's side, negative

  [[nodiscard]] int end() const { return first + static_cast<int>(along_mm.size()); }
  [[nodiscard]] double tilt_at(double s_mm) const {
    return tilt_mm + tilt_slope_mm * (s_mm - middle_mm) / half_mm;
  }
};

/// The chart of a frame from its own shape alone; nullopt where the face has fewer than 16 columns.
[[nodiscard]] std::optional<FaceChart> chart_of(const FaceShape& shape);

/// s of the skin below each marker; NaN for markers that are not seen or lie beyond the face's
/// ends. Markers sit on the side faces, off the view face. The image distance of the two markers of
/// a pair (numbers m and m + n) gives their distance z. The nearest point of the face's profile is
/// the skin below.
[[nodiscard]] std::vector<double> marker_lengths_mm(const FaceChart& chart, const FaceShape& shape,
                                                    const Markers& markers);

/// Marker positions on the skin in the rest frame, to which charts of other frames are registered.
struct SkinPositions {
  std::vector<double> marker_mm;  ///< marker_lengths_mm of the rest frame
  int base_u = 0;                 ///< a column at the base, which hardly moves
  double base_mm = 0;             ///< the length there
};
[[nodiscard]] SkinPositions skin_positions(const FaceChart& rest, const FaceShape& shape,
                                           const Markers& markers);

/// Shifts, stretches and tilts a chart so that the seen markers fit their positions, by robust
/// least squares with a prior on stretch and tilt around 0. Without markers the base is held fixed.
void register_chart(const SkinPositions& positions, const FaceShape& shape, const Markers& markers,
                    FaceChart* chart);

/// Extends a chart linearly beyond its ends by a fraction of its length, until its edges meet:
/// other frames may show more of the skin.
[[nodiscard]] FaceChart widened(const FaceChart& chart, double part);

/// Coefficients of constant + row (slope + row bow), for many columns.
struct RowQuadratics {
  std::vector<float> constant, slope, bow;
};

/// Such a polynomial for every column.
struct ColumnQuadratics : RowQuadratics {
  static constexpr int kBeyond = 32;  ///< copies of the last one, for loops over full chunks
  static constexpr int kNodeStep = 16;

  /// Called when all columns are set: appends the copies, and copies every 16th column to `nodes`.
  void finish();

  int columns = 0;  ///< without the copies
  RowQuadratics nodes;
};

/// Maps pixels of one frame to the pixels of another that show the same skin. By column of the
/// first frame, with t = t_at_0 + t_per_v v and the shift h = (2 t - 1) tilt,
///   u' = u0 + h,   v' = v0 + t width + h (slope + t width_slope).
/// Columns [first, end) show skin that the other frame also shows, at least in part. The inner ones
/// do so from edge to edge.
class ChartWarp {
 public:
  ChartWarp() = default;
  ChartWarp(const FaceChart& from, const FaceChart& to);

  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int end() const { return end_; }
  [[nodiscard]] int inner_first() const { return inner_first_; }
  [[nodiscard]] int inner_end() const { return inner_end_; }
  /// Mapped positions of the pixels of row v from column `begin` on, `count` of them, all within
  /// [first, end).
  void positions(int v, int begin, int count, float* to_u, float* to_v) const;
  /// v' by v, from column `origin` on.
  [[nodiscard]] const ColumnQuadratics& rows() const { return rows_; }
  /// u' by v', so that an image can be warped first along its rows, then across them. Exact to
  /// 1/1000 px as long as lines across the finger tilt by less than their length.
  [[nodiscard]] const ColumnQuadratics& columns() const { return columns_; }
  [[nodiscard]] int origin() const { return origin_; }
  /// Columns of [first, end) whose u' reaches into [min_u, max_u] somewhere on the face.
  [[nodiscard]] std::pair<int, int> columns_reaching(float min_u, float max_u) const;
  /// Smallest and largest u' within a column of the face.
  [[nodiscard]] std::pair<float, float> reach(int u) const {
    const auto i = static_cast<std::size_t>(u - origin_);
    const float shift = tilt_[i] < 0 ? -tilt_[i] : tilt_[i];
    return {u0_[i] - shift, u0_[i] + shift};
  }
  /// t of a pixel: 0 to 1 on the face.
  [[nodiscard]] double across(int u, int v) const {
    const auto i = static_cast<std::size_t>(u - origin_);
    return static_cast<double>(t_at_0_[i]) + static_cast<double>(t_per_v_[i]) * v;
  }

 private:
  int origin_ = 0, first_ = 0, end_ = 0, inner_first_ = 0, inner_end_ = 0;
  float max_tilt_ = 0;
  std::vector<float> t_at_0_, t_per_v_, u0_, tilt_;
  ColumnQuadratics rows_, columns_;
};

// Parts of the face that an object over its end hides from a frame.

/// A column in which the face continues although the frame does not show it.
struct HiddenColumn {
  int u = 0;
  double upper_v = 0, lower_v = 0;  ///< edges, extended linearly, px
};

/// Arc lengths at which recorded faces end.
class EndLengths {
 public:
  EndLengths() = default;
  /// charts: of recorded frames of width_px columns, registered to each other. An end at the image
  /// border is ignored; an end in fewer than half of the frames is unknown.
  EndLengths(const std::vector<FaceChart>& charts, int width_px);

  /// Columns after a frame's chart (registered alike) up to where the face must end, within the
  /// image. Empty where the chart ends within 0.5 mm of it, or within 6 sd of the recorded ends,
  /// and where the end is unknown.
  [[nodiscard]] std::vector<HiddenColumn> hidden_columns(const FaceChart& now, int width_px) const;

 private:
  struct End {
    double mm = 0, tolerance_mm = 0;
  };
  static std::optional<End> end_of(std::vector<double> lengths_mm, std::size_t frames);
  std::optional<End> first_, last_;  // at small and at large u
};

}  // namespace alltact
