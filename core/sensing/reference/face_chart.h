// Which point of the skin each pixel of a frame shows, so that one frame can be laid over another
// although the finger has bent in between.
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
/// shifted and stretched by what the markers tell; the rows of markers tell also how lines across
/// the finger tilt in the picture when it twists:
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

/// The chart of a frame by its own shape alone; nullopt where the face has less than 16 columns.
[[nodiscard]] std::optional<FaceChart> chart_of(const FaceShape& shape);

/// s of the skin below each marker; NaN for those that are not seen or lie beyond the face's ends.
/// Markers sit on the side faces, off the view face: the distance of the two of a pair (numbers m
/// and m + n) in the picture tells how far away they are, and the nearest point of the face's
/// profile is the skin below.
[[nodiscard]] std::vector<double> marker_lengths_mm(const FaceChart& chart,
                                                    const FaceShape& shape,
                                                    const Markers& markers);

/// Where the skin that a rest frame shows lies: what charts of other frames are fitted to.
struct SkinPlaces {
  std::vector<double> marker_mm;  ///< marker_lengths_mm of the rest frame
  int base_u = 0;                 ///< a column at the base, which hardly moves
  double base_mm = 0;             ///< the length there
};
[[nodiscard]] SkinPlaces skin_places(const FaceChart& rest,
                                     const FaceShape& shape,
                                     const Markers& markers);

/// Shifts, stretches and tilts a chart so that the markers that are seen lie at their places, by
/// robust least squares with stretch and tilt held near nothing. Without markers the base holds
/// still.
void lay_on(const SkinPlaces& places,
            const FaceShape& shape,
            const Markers& markers,
            FaceChart* chart);

/// Continues a chart straight beyond its ends by a part of its length, as far as its edges do not
/// meet: other frames may show more of the skin.
[[nodiscard]] FaceChart widened(const FaceChart& chart, double part);

/// A place that changes with the row: constant + row (slope + row bow), of many side by side.
struct PlacesByRow {
  std::vector<float> constant, slope, bow;
};

/// Of every column such a place.
struct PlacesByColumn : PlacesByRow {
  static constexpr int kBeyond = 32;  ///< copies of the last, for loops over whole pieces
  static constexpr int kNodeStep = 16;

  /// Once all columns stand there: the copies, and every 16th column apart (with kBeyond copies).
  void finish();

  int columns = 0;  ///< without the copies
  PlacesByRow nodes;
};

/// From pixels of one frame to the pixels of another that show the same skin. By column of the
/// first: with t = t_at_0 + t_per_v v and the shift h = (2 t - 1) tilt,
///   u' = u0 + h,   v' = v0 + t width + h (slope + t width_slope).
/// Columns [first, end) show skin that the other frame shows as well, at least in a part of them;
/// the inner ones do so from edge to edge.
class ChartWarp {
 public:
  ChartWarp() = default;
  ChartWarp(const FaceChart& from, const FaceChart& to);

  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int end() const { return end_; }
  [[nodiscard]] int inner_first() const { return inner_first_; }
  [[nodiscard]] int inner_end() const { return inner_end_; }
  /// The places of the pixels of row v from column `begin` on, `count` of them, all within
  /// [first, end).
  void places(int v, int begin, int count, float* to_u, float* to_v) const;
  /// v' by v: of column `origin` and those after it.
  [[nodiscard]] const PlacesByColumn& rows() const { return rows_; }
  /// u' by v', so that one picture can be laid over another first along its rows, then across them:
  /// within 1/1000 px, as long as lines across the finger tilt by less than their length.
  [[nodiscard]] const PlacesByColumn& columns() const { return columns_; }
  [[nodiscard]] int origin() const { return origin_; }
  /// The columns in [first, end) whose u' comes into [least, most] somewhere on the face.
  [[nodiscard]] std::pair<int, int> columns_into(float least, float most) const;
  /// Least and greatest u' within a column of the face.
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
  float most_tilt_ = 0;
  std::vector<float> t_at_0_, t_per_v_, u0_, tilt_;
  PlacesByColumn rows_, columns_;
};

}  // namespace alltact
