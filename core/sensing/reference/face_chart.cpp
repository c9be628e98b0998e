#include "core/sensing/reference/face_chart.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/median.h"
#include "core/numerics/vector_loops.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kMinColumns = 16;
constexpr double kMarkerSdMm = 0.05;  // of the skin below a marker, along the finger
constexpr double kBaseSdMm = 1.0;
constexpr double kStretchSd = 0.02;  // of the length
constexpr double kTiltSdMm = 1.0;
constexpr double kHuber = 2.0;  // sds
constexpr int kRounds = 6;
constexpr double kMinWidthPx = 4.0;  // of a continued face

/// Index of the entry before a value in an ascending list, and the fraction towards the next.
struct Between {
  std::size_t left;
  double part;
};
Between find(const std::vector<double>& ascending, double value) {
  const auto above = std::upper_bound(ascending.begin(), ascending.end(), value);
  const auto last = static_cast<std::ptrdiff_t>(ascending.size()) - 2;
  const auto left = std::clamp<std::ptrdiff_t>(above - ascending.begin() - 1, 0, last);
  const auto l = static_cast<std::size_t>(left);
  const double step = ascending[l + 1] - ascending[l];
  return {l, step > 0.0 ? (value - ascending[l]) / step : 0.0};
}

/// The middle of the face in the x-z plane, and the arc length there.
struct Profile {
  std::vector<Eigen::Vector2d> at_mm;
  std::vector<double> s_mm;

  Profile(const FaceChart& chart, const FaceShape& shape) {
    for (std::size_t i = 0; i < chart.along_mm.size(); ++i) {
      const double middle = 0.5 * (chart.upper_v[i] + chart.lower_v[i]);
      const auto local = shape.at(chart.first + static_cast<int>(i), middle);
      if (!local) continue;
      at_mm.emplace_back(local->view_point_mm.x(), local->view_point_mm.z());
      s_mm.push_back(chart.along_mm[i]);
    }
  }

  /// The entry nearest to a point: coarse search first, since the curve is smooth.
  [[nodiscard]] std::size_t nearest(const Eigen::Vector2d& point_mm) const {
    constexpr std::size_t kEvery = 16;
    const std::size_t rough = nearest_of(point_mm, 0, at_mm.size(), kEvery);
    return nearest_of(point_mm, rough - std::min(rough, kEvery),
                      std::min(at_mm.size(), rough + kEvery + 1), 1);
  }
  struct Foot {
    double s_mm;
    Eigen::Vector2d at_mm, tangent;  ///< x and z; unit vector towards greater s
  };
  /// Foot of a point on the profile near entry i; nullopt beyond the ends.
  [[nodiscard]] std::optional<Foot> foot(const Eigen::Vector2d& point_mm, std::size_t i) const {
    if (i == 0 || i + 1 == at_mm.size()) return std::nullopt;
    const Eigen::Vector2d along = at_mm[i + 1] - at_mm[i - 1];
    const double part = along.dot(point_mm - at_mm[i - 1]) / along.squaredNorm();
    return Foot{s_mm[i - 1] + part * (s_mm[i + 1] - s_mm[i - 1]), at_mm[i - 1] + part * along,
                along.normalized()};
  }

 private:
  [[nodiscard]] std::size_t nearest_of(const Eigen::Vector2d& point_mm, std::size_t first,
                                       std::size_t end, std::size_t every) const {
    std::size_t best = first;
    double best_square = (at_mm[first] - point_mm).squaredNorm();
    for (std::size_t i = first + every; i < end; i += every) {
      const double square = (at_mm[i] - point_mm).squaredNorm();
      if (square < best_square) best_square = square, best = i;
    }
    return best;
  }
};

ALLTACT_WIDE void columns_of_row(const float* __restrict t_at_0, const float* __restrict t_per_v,
                                 const float* __restrict u0, const float* __restrict tilt, float v,
                                 int count, float* __restrict to_u) {
  for (int i = 0; i < count; ++i) {
    const float t = t_at_0[i] + t_per_v[i] * v;
    to_u[i] = u0[i] + (2.0F * t - 1.0F) * tilt[i];
  }
}

ALLTACT_WIDE void rows_of_row(const float* __restrict constant, const float* __restrict slope,
                              const float* __restrict bow, float v, int count,
                              float* __restrict to_v) {
  for (int i = 0; i < count; ++i) to_v[i] = constant[i] + v * (slope[i] + v * bow[i]);
}

void put(double constant, double slope, double bow, std::size_t i, ColumnQuadratics& positions) {
  positions.constant[i] = static_cast<float>(constant);
  positions.slope[i] = static_cast<float>(slope);
  positions.bow[i] = static_cast<float>(bow);
}

}  // namespace

void ColumnQuadratics::finish() {
  columns = static_cast<int>(constant.size());
  for (std::vector<float> RowQuadratics::*of :
       {&RowQuadratics::constant, &RowQuadratics::slope, &RowQuadratics::bow}) {
    std::vector<float>&all = this->*of, &some = nodes.*of;
    some.clear();
    for (std::size_t i = 0; i < all.size(); i += kNodeStep) some.push_back(all[i]);
    for (std::vector<float>* values : {&all, &some})
      values->insert(values->end(), kBeyond, values->empty() ? 0.0F : values->back());
  }
}

std::optional<FaceChart> chart_of(const FaceShape& shape) {
  const auto& columns = shape.columns();
  const auto usable = [](const FaceColumn& column) {
    return column.valid && column.lower_v - column.upper_v > kMinWidthPx;
  };
  const auto begin = std::find_if(columns.begin(), columns.end(), usable);
  const auto end = std::find_if(columns.rbegin(), columns.rend(), usable).base();
  if (end - begin < kMinColumns) return std::nullopt;
  FaceChart chart;
  chart.first = static_cast<int>(begin - columns.begin());
  chart.base_at_low_u = shape.base_at_low_u();
  const double sign = chart.base_at_low_u ? 1.0 : -1.0;
  for (auto column = begin; column != end; ++column) {
    const auto u = static_cast<double>(column - columns.begin());
    double upper = column->upper_v, lower = column->lower_v, s_mm = sign * shape.length_at(u);
    if (!usable(*column)) {
      // Linear over a gap.
      const auto next = std::find_if(column, end, usable);
      const double part = 1.0 / static_cast<double>(next - column + 1);
      upper = chart.upper_v.back() + part * (next->upper_v - chart.upper_v.back());
      lower = chart.lower_v.back() + part * (next->lower_v - chart.lower_v.back());
    }
    // Strictly ascending, as the lookup requires.
    constexpr double kMinStepMm = 1e-6;
    if (!chart.along_mm.empty()) s_mm = std::max(s_mm, chart.along_mm.back() + kMinStepMm);
    chart.along_mm.push_back(s_mm);
    chart.upper_v.push_back(upper);
    chart.lower_v.push_back(lower);
  }
  chart.middle_mm = 0.5 * (chart.along_mm.front() + chart.along_mm.back());
  chart.half_mm = 0.5 * (chart.along_mm.back() - chart.along_mm.front());
  return chart;
}

namespace {

/// The skin below a marker.
struct SkinBelow {
  double s_mm = std::numeric_limits<double>::quiet_NaN();  ///< NaN: unknown
  double per_tilt = 1;  ///< its change over that of the chart's tilt on this side, of opposite sign
};

/// The two markers of a pair (numbers m and m + n) lie off the face, towards the camera: the
/// distance of their image gives their common z, and the nearest point of the profile is the skin
/// below their middle. One lies as far before the middle, along its own line of sight, as the other
/// behind it, which is exact where the pair is skew. Where the face twists, the markers, which are
/// nearer to the camera, move more in the image than its edges: per_tilt.
std::vector<SkinBelow> skin_below(const FaceChart& chart, const FaceShape& shape,
                                  const Markers& markers) {
  std::vector<SkinBelow> below(markers.size());
  const Profile profile(chart, shape);
  if (profile.at_mm.size() < 3) return below;
  const std::size_t pairs = markers.size() / 2;
  for (std::size_t m = 0; m < pairs; ++m) {
    const Marker &upper = markers[m], &lower = markers[m + pairs];
    const auto upper_ray = shape.camera().unproject({upper.u, upper.v});
    const auto lower_ray = shape.camera().unproject({lower.u, lower.v});
    if (!upper_ray || !lower_ray) continue;
    const Eigen::Vector3d up = upper_ray->point_at(1.0), low = lower_ray->point_at(1.0);
    const double z_mm = shape.face().width_mm / (low.y() - up.y());
    if (!(z_mm > 0.0) || !std::isfinite(z_mm)) continue;
    const Eigen::Vector2d middle_mm = z_mm * Eigen::Vector2d(0.5 * (up.x() + low.x()), 1.0);
    const auto foot = profile.foot(middle_mm, profile.nearest(middle_mm));
    if (!foot) continue;
    // Distances of face and markers' middle from the camera, along the normal.
    const Eigen::Vector2d normal(-foot->tangent.y(), foot->tangent.x());
    const double face_mm = normal.dot(foot->at_mm), markers_mm = normal.dot(middle_mm);
    constexpr double kMinPart = 0.1;  // of z: nearly along the line of sight nothing is known
    if (!(std::abs(markers_mm) > kMinPart * z_mm) || !(face_mm * markers_mm > 0.0)) continue;
    const double half_mm = 0.5 * (low.x() - up.x()) * z_mm * z_mm / markers_mm;
    const double twist_part =
        std::clamp(foot->at_mm.x() / middle_mm.x() * markers_mm / face_mm, 0.25, 1.0);
    const double per_tilt = 1.0 / (std::isfinite(twist_part) ? twist_part : 1.0);
    if (upper.seen) below[m] = {foot->s_mm - half_mm, per_tilt};
    if (lower.seen) below[m + pairs] = {foot->s_mm + half_mm, per_tilt};
  }
  return below;
}

std::optional<SkinPositions::Tip> tip_of(const FaceChart& chart, const FaceShape& shape) {
  const auto end = shape.tip_end();
  if (!end) return std::nullopt;
  const auto last = static_cast<std::size_t>(chart.base_at_low_u ? chart.end() - 1 : chart.first);
  // The chart's lengths are those of the shape, shifted and stretched: extended from the last
  // column on.
  const double beyond_mm = end->length_mm - shape.length_at(static_cast<double>(last));
  const double along_mm =
      chart.base_at_low_u ? chart.along_mm.back() + beyond_mm : chart.along_mm.front() - beyond_mm;
  // Of the columns next to the end.
  constexpr std::size_t kOver = 4;
  const std::vector<double>& along = chart.along_mm;
  const double mm_per_px = (chart.base_at_low_u ? along.back() - along[along.size() - 1 - kOver]
                                                : along[kOver] - along.front()) /
                           static_cast<double>(kOver);
  return SkinPositions::Tip{.along_mm = along_mm,
                            .column_sd_mm = end->sd_mm,
                            .shape_sd_mm = shape.columns()[last].z_sd_mm,
                            .lean_mm = mm_per_px * end->lean_px};
}

}  // namespace

SkinPositions skin_positions(const FaceChart& rest, const FaceShape& shape,
                             const Markers& markers) {
  SkinPositions positions;
  for (const SkinBelow& below : skin_below(rest, shape, markers))
    positions.marker_mm.push_back(below.s_mm);
  positions.base_u = rest.base_at_low_u ? rest.first : rest.end() - 1;
  positions.base_mm = rest.base_at_low_u ? rest.along_mm.front() : rest.along_mm.back();
  positions.tip = tip_of(rest, shape);
  return positions;
}

namespace {

/// Registers a chart to the positions of the skin.
class ChartFit {
 public:
  ChartFit(const SkinPositions& positions, const FaceShape& shape, const Markers& markers,
           FaceChart& chart)
      : positions_(positions),
        shape_(shape),
        chart_(chart),
        below_(skin_below(chart, shape, markers)),
        now_(positions.tip ? tip_of(chart, shape) : std::nullopt) {}

  void operator()() {
    add_markers();
    add_base();
    const Eigen::Vector4d terms = solve();
    if (!terms.allFinite()) return;
    for (double& s_mm : chart_.along_mm) s_mm += shift_mm(terms, s_mm);
    if (now_) now_->along_mm += shift_mm(terms, now_->along_mm);
    chart_.middle_mm += terms[0];
    chart_.half_mm += terms[1];
    chart_.tilt_mm = terms[2];
    chart_.tilt_slope_mm = terms[3];
    chart_.tail_from_mm = last_marker_mm();
    chart_.tail_over_mm = to_tip();  // any length: without an end nothing grows along the tail
    const bool has_end = now_ && is_end_shown();
    if (has_end) chart_.tail_over_mm = now_->along_mm - chart_.tail_from_mm;
    find_sd(has_end);
    if (has_end) fit_tip();
  }

 private:
  /// One observation: by * (shift, stretch, tilt, its slope) = off.
  struct Row {
    Eigen::Vector4d by;
    double off, sd;
  };

  [[nodiscard]] double scaled(double s_mm) const {
    return (s_mm - chart_.middle_mm) / chart_.half_mm;
  }
  [[nodiscard]] double shift_mm(const Eigen::Vector4d& terms, double s_mm) const {
    return terms[0] + terms[1] * scaled(s_mm);
  }

  void add_markers() {
    for (std::size_t m = 0; m < std::min(below_.size(), positions_.marker_mm.size()); ++m) {
      if (!std::isfinite(below_[m].s_mm) || !std::isfinite(positions_.marker_mm[m])) continue;
      const double along = scaled(below_[m].s_mm);
      const double side = (m < below_.size() / 2 ? -1.0 : 1.0) * below_[m].per_tilt;
      rows_.push_back({{1.0, along, side, along * side},
                       positions_.marker_mm[m] - below_[m].s_mm,
                       kMarkerSdMm});
    }
  }
  void add_base() {
    // Clamped: the base may lie a column outside of what this frame shows of it.
    const int base = std::clamp(positions_.base_u, chart_.first, chart_.end() - 1);
    const double base_mm = chart_.along_mm[static_cast<std::size_t>(base - chart_.first)];
    rows_.push_back({{1.0, scaled(base_mm), 0.0, 0.0}, positions_.base_mm - base_mm, kBaseSdMm});
  }
  [[nodiscard]] Eigen::Vector4d solve() const {
    Eigen::Vector4d terms = Eigen::Vector4d::Zero();
    for (int round = 0; round < kRounds; ++round) {
      Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
      Eigen::Vector4d pull = Eigen::Vector4d::Zero();
      const double stretch_sd_mm = kStretchSd * chart_.half_mm;
      normal.diagonal() << 0.0, 1.0 / (stretch_sd_mm * stretch_sd_mm),
          1.0 / (kTiltSdMm * kTiltSdMm), 1.0 / (kTiltSdMm * kTiltSdMm);
      for (const Row& row : rows_) {
        const double z = round == 0 ? 0.0 : std::abs(row.off - row.by.dot(terms)) / row.sd;
        const double weight = (z > kHuber ? kHuber / z : 1.0) / (row.sd * row.sd);
        normal += weight * row.by * row.by.transpose();
        pull += weight * row.off * row.by;
      }
      terms = normal.ldlt().solve(pull);
    }
    return terms;
  }

  static double square(double value) { return value * value; }

  /// An object over the end makes the face seem shorter.
  [[nodiscard]] bool is_end_shown() const {
    return to_tip() * (positions_.tip->along_mm - now_->along_mm) <
               positions_.tip->max_missing_mm &&
           to_tip() * (now_->along_mm - chart_.tail_from_mm) > 0;
  }

  /// Length of the outermost seen marker; of the base where there is none.
  [[nodiscard]] double last_marker_mm() const {
    double last_mm = positions_.base_mm;
    for (std::size_t m = 0; m < std::min(below_.size(), positions_.marker_mm.size()); ++m)
      if (std::isfinite(below_[m].s_mm) && to_tip() * (positions_.marker_mm[m] - last_mm) > 0)
        last_mm = positions_.marker_mm[m];
    return last_mm;
  }
  [[nodiscard]] double to_tip() const { return chart_.base_at_low_u ? 1.0 : -1.0; }

  /// A length moves with the face's z: beyond the marker by its error there less that at the
  /// marker. The tip end fixes the lengths near it.
  void find_sd(bool has_end) {
    double from_sd_mm = std::numeric_limits<double>::infinity();  // of z next to the marker
    for (std::size_t i = 0; i < chart_.along_mm.size(); ++i)
      if (chart_.tail_at(chart_.along_mm[i]) > 0) from_sd_mm = std::min(from_sd_mm, z_sd_mm(i));
    // Of the outer parts of both end lines: twice that of their middles.
    const double end_sd_mm =
        has_end ? 2.0 * std::hypot(now_->column_sd_mm, positions_.tip->column_sd_mm) : 0.0;
    chart_.along_sd_mm.assign(chart_.along_mm.size(), 0.0);
    for (std::size_t i = 0; i < chart_.along_mm.size(); ++i) {
      const double tail = chart_.tail_at(chart_.along_mm[i]);
      if (!(tail > 0)) continue;
      const double sd_mm = std::sqrt(std::max(0.0, square(z_sd_mm(i)) - square(from_sd_mm)));
      const double part = has_end ? std::min(tail, 1.0) : 0.0;
      chart_.along_sd_mm[i] = std::hypot(sd_mm * (1.0 - part * part), part * end_sd_mm);
    }
  }
  /// Of the chart's entry i.
  [[nodiscard]] double z_sd_mm(std::size_t i) const {
    return shape_.columns()[static_cast<std::size_t>(chart_.first) + i].z_sd_mm;
  }

  /// The end line is the same skin in both frames, along the finger and in its lean.
  void fit_tip() {
    const double over_mm = std::abs(chart_.tail_over_mm);
    const auto limited = [&](double off_mm, double most) {
      return std::clamp(off_mm, -most * over_mm, most * over_mm);
    };
    constexpr double kMostStretch = 0.4, kMostTilt = 0.5;  // of the tail: lengths must ascend
    chart_.end_tilt_mm = limited(
        positions_.tip->lean_mm - now_->lean_mm - chart_.tilt_at(now_->along_mm), kMostTilt);
    const double variance_mm2 = square(now_->shape_sd_mm) + square(positions_.tip->shape_sd_mm);
    const double column_mm2 = square(now_->column_sd_mm) + square(positions_.tip->column_sd_mm);
    const double off_mm = positions_.tip->along_mm - now_->along_mm;
    chart_.tip_stretch_mm =
        limited(off_mm * variance_mm2 / (variance_mm2 + column_mm2), kMostStretch);
    for (double& s_mm : chart_.along_mm)
      s_mm += chart_.tip_stretch_mm * square(chart_.tail_at(s_mm));
  }

  const SkinPositions& positions_;
  const FaceShape& shape_;
  FaceChart& chart_;
  std::vector<SkinBelow> below_;  // by marker
  std::optional<SkinPositions::Tip> now_;
  std::vector<Row> rows_;
};

}  // namespace

void register_chart(const SkinPositions& positions, const FaceShape& shape, const Markers& markers,
                    FaceChart* chart) {
  ChartFit(positions, shape, markers, *chart)();
}

std::vector<float> registration_sd_px(const FaceChart& chart, int width_px) {
  std::vector<float> sd_px(static_cast<std::size_t>(width_px), 0.0F);
  const std::size_t size = std::min(chart.along_mm.size(), chart.along_sd_mm.size());
  for (std::size_t i = 0; i + 1 < size; ++i) {
    const double mm_per_px = chart.along_mm[i + 1] - chart.along_mm[i];
    const std::ptrdiff_t u = chart.first + static_cast<std::ptrdiff_t>(i);
    if (u < 0 || u + 1 >= width_px) continue;
    const auto sd = static_cast<float>(chart.along_sd_mm[i] / std::max(1e-6, mm_per_px));
    sd_px[static_cast<std::size_t>(u)] = sd;
    sd_px[static_cast<std::size_t>(u) + 1] = sd;
  }
  return sd_px;
}

FaceChart widened(const FaceChart& chart, double part) {
  const std::size_t size = chart.along_mm.size();
  const auto max_columns = static_cast<std::size_t>(part * static_cast<double>(size));
  // columns from which the slope is estimated
  const std::size_t over = std::min<std::size_t>(size - 1, 24);
  const auto beyond = [&](const std::vector<double>& values, std::size_t k, bool at_end) {
    const double step =
        (at_end ? values[size - 1] - values[size - 1 - over] : values[0] - values[over]) /
        static_cast<double>(over);
    return (at_end ? values.back() : values.front()) + step * static_cast<double>(k);
  };
  const auto room = [&](bool at_end) {
    std::size_t columns = 0;
    while (columns < max_columns &&
           beyond(chart.lower_v, columns + 1, at_end) - beyond(chart.upper_v, columns + 1, at_end) >
               kMinWidthPx)
      ++columns;
    return columns;
  };
  const std::size_t before = room(false), after = room(true);
  FaceChart wide = chart;
  wide.first -= static_cast<int>(before);
  for (std::vector<double> FaceChart::*values :
       {&FaceChart::along_mm, &FaceChart::upper_v, &FaceChart::lower_v}) {
    std::vector<double> all;
    for (std::size_t k = before; k > 0; --k) all.push_back(beyond(chart.*values, k, false));
    all.insert(all.end(), (chart.*values).begin(), (chart.*values).end());
    for (std::size_t k = 1; k <= after; ++k) all.push_back(beyond(chart.*values, k, true));
    wide.*values = std::move(all);
  }
  return wide;
}

ChartWarp::ChartWarp(const FaceChart& from, const FaceChart& to)
    : origin_(from.first),
      first_(from.end()),
      end_(from.end()),
      inner_first_(from.end()),
      inner_end_(from.end()) {
  const std::size_t size = from.along_mm.size();
  if (size == 0) {  // a face without a valid column, as a stiff curve may produce: nothing is shown
    for (ColumnQuadratics* positions : {&rows_, &columns_}) positions->finish();
    return;
  }
  for (auto* values : {&t_at_0_, &t_per_v_, &u0_, &tilt_}) values->resize(size);
  for (ColumnQuadratics* positions : {&rows_, &columns_})
    for (auto* values : {&positions->constant, &positions->slope, &positions->bow})
      values->resize(size);
  const auto take = [](int u, int* first, int* end) {
    if (*first == *end) *first = u;
    *end = u + 1;
  };
  for (std::size_t i = 0; i < size; ++i) {
    const double s_mm = from.along_mm[i];
    const auto [l, part] = find(to.along_mm, s_mm);
    const double step_mm = std::max(1e-6, to.along_mm[l + 1] - to.along_mm[l]);
    const double upper = to.upper_v[l], lower = to.lower_v[l];
    const double slope = to.upper_v[l + 1] - upper;
    const double width_slope = to.lower_v[l + 1] - lower - slope;
    const double u0 = to.first + static_cast<double>(l) + part;
    const double tilt = (from.tilt_at(s_mm) - to.tilt_at(s_mm)) / step_mm;
    const double t_per_v = 1.0 / (from.lower_v[i] - from.upper_v[i]);
    const double t_at_0 = -from.upper_v[i] * t_per_v;
    t_at_0_[i] = static_cast<float>(t_at_0);
    t_per_v_[i] = static_cast<float>(t_per_v);
    u0_[i] = static_cast<float>(u0);
    tilt_[i] = static_cast<float>(tilt);
    max_tilt_ = std::max(max_tilt_, std::abs(tilt_[i]));
    // v' = a + b t + c t^2.
    const double a = upper + part * slope - tilt * slope, c = 2.0 * tilt * width_slope;
    const double b = lower - upper + part * width_slope + 2.0 * tilt * slope - tilt * width_slope;
    put(a + t_at_0 * (b + t_at_0 * c), t_per_v * (b + 2.0 * t_at_0 * c), t_per_v * t_per_v * c, i,
        rows_);
    // t = r - (c / b) r^2 with r = (v' - a) / b, as long as c is small against b.
    constexpr double kMinPerT = 1.0;
    const double per_v = 1.0 / std::max(b, kMinPerT), r_at_0 = -a * per_v, bow = c * per_v;
    put(u0 + tilt * (2.0 * r_at_0 * (1.0 - bow * r_at_0) - 1.0),
        2.0 * tilt * per_v * (1.0 - 2.0 * bow * r_at_0), -2.0 * tilt * bow * per_v * per_v, i,
        columns_);
    const double reach = std::abs(tilt);
    const int u = origin_ + static_cast<int>(i), last = to.end() - 1;
    if (u0 + reach >= to.first && u0 - reach <= last) take(u, &first_, &end_);
    if (u0 - reach >= to.first && u0 + reach <= last) take(u, &inner_first_, &inner_end_);
  }
  for (ColumnQuadratics* positions : {&rows_, &columns_}) positions->finish();
}

void ChartWarp::positions(int v, int begin, int count, float* to_u, float* to_v) const {
  const std::ptrdiff_t i = begin - origin_;
  columns_of_row(t_at_0_.data() + i, t_per_v_.data() + i, u0_.data() + i, tilt_.data() + i,
                 static_cast<float>(v), count, to_u);
  rows_of_row(rows_.constant.data() + i, rows_.slope.data() + i, rows_.bow.data() + i,
              static_cast<float>(v), count, to_v);
}

std::pair<int, int> ChartWarp::columns_reaching(float min_u, float max_u) const {
  const auto begin = u0_.begin() + (first_ - origin_), end = u0_.begin() + (end_ - origin_);
  const auto from = std::lower_bound(begin, end, min_u - max_tilt_);
  const auto to = std::upper_bound(from, end, max_u + max_tilt_);
  return {first_ + static_cast<int>(from - begin), first_ + static_cast<int>(to - begin)};
}

namespace {

constexpr int kBorder = 12;  // columns: a face that ends there may continue outside
constexpr std::size_t kMinShowing = 8;
constexpr double kMinMm = 0.5, kScatters = 6.0;
constexpr double kFurthest = 0.4;  // of the face's length, by which it is extended

bool is_end(int u, int width_px) { return u >= kBorder && u < width_px - kBorder; }

// Lengths at both ends of a chart, as the markers give them.
double first_mm(const FaceChart& chart) {
  return chart.along_mm.front() - (chart.base_at_low_u ? 0.0 : chart.tip_stretch_mm);
}
double last_mm(const FaceChart& chart) {
  return chart.along_mm.back() - (chart.base_at_low_u ? chart.tip_stretch_mm : 0.0);
}

}  // namespace

EndLengths::EndLengths(const std::vector<FaceChart>& charts, int width_px) {
  std::vector<double> first, last;
  for (const FaceChart& chart : charts) {
    if (is_end(chart.first, width_px)) first.push_back(first_mm(chart));
    if (is_end(chart.end() - 1, width_px)) last.push_back(last_mm(chart));
  }
  first_ = end_of(std::move(first), charts.size());
  last_ = end_of(std::move(last), charts.size());
}

std::optional<EndLengths::End> EndLengths::end_of(std::vector<double> lengths_mm,
                                                  std::size_t frames) {
  if (lengths_mm.size() < kMinShowing || 2 * lengths_mm.size() < frames) return std::nullopt;
  const double middle = upper_median(lengths_mm);
  for (double& length : lengths_mm) length = std::abs(length - middle);
  constexpr double kSdOfMedian = 1.4826;  // sd over median deviation of a normal distribution
  const double sd = kSdOfMedian * upper_median(lengths_mm);
  return End{middle, std::max(kMinMm, kScatters * sd)};
}

double EndLengths::tip_tolerance_mm(bool base_at_low_u) const {
  const std::optional<End>& tip = base_at_low_u ? last_ : first_;
  constexpr double kSds = 3.0;
  return tip ? std::max(kMinMm, kSds / kScatters * tip->tolerance_mm)
             : std::numeric_limits<double>::infinity();
}

std::vector<HiddenColumn> EndLengths::hidden_columns(const FaceChart& now, int width_px) const {
  const bool before =
      first_ && now.first > kBorder && first_mm(now) > first_->mm + first_->tolerance_mm;
  const bool after =
      last_ && now.end() < width_px - kBorder && last_mm(now) < last_->mm - last_->tolerance_mm;
  std::vector<HiddenColumn> columns;
  if (!before && !after) return columns;
  const FaceChart extended = widened(now, kFurthest);
  for (int u = std::max(0, extended.first); u < std::min(width_px, extended.end()); ++u) {
    const auto i = static_cast<std::size_t>(u - extended.first);
    const double s_mm = extended.along_mm[i];
    if ((before && u < now.first && s_mm >= first_->mm) ||
        (after && u >= now.end() && s_mm <= last_->mm))
      columns.push_back({u, extended.upper_v[i], extended.lower_v[i]});
  }
  return columns;
}

}  // namespace alltact
