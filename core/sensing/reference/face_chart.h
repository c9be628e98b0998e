// Maps each pixel of a frame to a point of the skin, so that frames of a bending finger can be
// registered to each other.
#pragma once

#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Coordinates of the skin in one frame: along it, in mm of arc from the base, and across it, t = 0
/// at the upper and 1 at the lower edge. On the middle of the face the length is that of the shape,
/// shifted and stretched to fit the markers. The rows of markers also show how lines across the
/// finger tilt in the image when it twists:
///   along(u, t) = s(u) + (2 t - 1) (k0 + k1 m(s) + k2 n(s)^2),   m(s) = (s - middle) / half,
/// n(s) from 0 at the last marker to 1 at the tip end.
struct FaceChart {
  int first = 0;                         ///< column of the first entries below
  std::vector<double> along_mm;          ///< s by column, increasing with u (see base_at_low_u)
  std::vector<double> upper_v, lower_v;  ///< edges, px
  /// Standard deviations of s that the last marker and the tip end leave; empty: not registered.
  std::vector<double> along_sd_mm;
  double tilt_mm = 0, tilt_slope_mm = 0, middle_mm = 0, half_mm = 1;  ///< k0, k1, middle, half
  double end_tilt_mm = 0;                                             ///< k2
  double tail_from_mm = 0, tail_over_mm = 1;  ///< n(s) = (s - from) / over, at least 0
  double tip_stretch_mm = 0;  ///< by which register_chart moved the tip end, part of along_mm
  bool base_at_low_u = true;  ///< false: lengths count from the tip's side, negative

  [[nodiscard]] int end() const { return first + static_cast<int>(along_mm.size()); }
  [[nodiscard]] double tilt_at(double s_mm) const {
    const double tail = tail_at(s_mm);
    return tilt_mm + tilt_slope_mm * (s_mm - middle_mm) / half_mm + end_tilt_mm * tail * tail;
  }
  /// n(s), at least 0.
  [[nodiscard]] double tail_at(double s_mm) const {
    const double tail = (s_mm - tail_from_mm) / tail_over_mm;
    return tail > 0 ? tail : 0;
  }
};

/// Standard deviation of each column's skin position along the finger, px, of an image of width_px
/// columns; 0 off the chart.
[[nodiscard]] std::vector<float> registration_sd_px(const FaceChart& chart, int width_px);

/// The chart of a frame from its own shape alone; nullopt where the face has fewer than 16 columns.
[[nodiscard]] std::optional<FaceChart> chart_of(const FaceShape& shape);

/// Marker positions on the skin in the rest frame, to which charts of other frames are registered.
struct SkinPositions {
  /// s of the skin below each marker; NaN where it was not seen or lies beyond the face's ends.
  std::vector<double> marker_mm;
  int base_u = 0;      ///< a column at the base, which hardly moves
  double base_mm = 0;  ///< the length there
  /// The tip end of a face.
  struct Tip {
    double along_mm;      ///< length there
    double column_sd_mm;  ///< its standard deviation by the end's column
    double shape_sd_mm;   ///< by the shape, which is least certain there
    /// An end that is missing by more is not used: something hides it.
    double max_missing_mm = std::numeric_limits<double>::infinity();
    double lean_mm;  ///< of the end line: length in the end's column at t = 1 less that at 1/2
  };
  std::optional<Tip> tip;  ///< no value: the end is not seen
};
[[nodiscard]] SkinPositions skin_positions(const FaceChart& rest, const FaceShape& shape,
                                           const Markers& markers);

/// Shifts, stretches and tilts a chart so that the seen markers fit their positions, by robust
/// least squares with a prior on stretch and tilt around 0. Without markers the base is held fixed.
/// Beyond the last seen marker, where the shape is least certain, lengths and tilt grow by the
/// square of the distance from it, until the line of the tip end fits its position.
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

  /// By how much the tip end of a registered chart may be missing without being hidden: 3 sd of the
  /// recorded ends before register_chart() moved them, at least 0.5 mm. Infinite where it is
  /// unknown.
  [[nodiscard]] double tip_tolerance_mm(bool base_at_low_u) const;

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
