#include "core/sensing/face/edge_reader.h"

#include "core/numerics/dispatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace alltact {
namespace {

// Rows of a transition on each side of its middle; the levels are measured between the near and the
// far row.
constexpr int kNear = 3, kFar = 8;
constexpr int kNearBlurred = 6, kFarBlurred = 11;
constexpr double kBlurred = 3.2;  // contrast over slope, rows: a wider transition is blurred
// Noise of the crossing's level, relative to the noise of one row. It combines the two rows around
// the crossing and half the sum of two lines through kFar - kNear + 1 rows, extrapolated to the
// step.
constexpr double kCrossingNoise = 1.2;

constexpr int kStepMargin =
    // Rows beyond a step that it reads on each side
    kNearBlurred + kFarBlurred + 1;
constexpr int kReach =
    EdgeReader::kMaxReach + kStepMargin;  // rows of the band on each side of its middle

/// Adds to `sums` the interpolation between two neighbouring rows at each of `count` positions.
/// `part`: where the edge's own row lies between them. `column` has one value more than `count`.
ALLTACT_WIDE void add_column(const std::uint8_t* __restrict column,
                             float part,
                             int count,
                             float* __restrict sums) {
  for (int i = 0; i < count; ++i) {
    const auto here = static_cast<float>(column[i]), next = static_cast<float>(column[i + 1]);
    sums[i] += here + part * (next - here);
  }
}

/// Brightness across the edge: the mean of several columns along its slope, bilinear across it. Row
/// kReach is the middle. Rows are read on demand.
class Profile {
 public:
  Profile(const cv::Mat& grey, double u, double v, double slope, int columns)
      : grey_(grey),
        u_(u),
        v_(v),
        slope_(slope),
        columns_(columns),
        first_column_(static_cast<int>(std::lround(u - 0.5 * (columns - 1)))) {}

  [[nodiscard]] bool is_in_image() const {
    if (first_column_ < 0 || first_column_ + columns_ > grey_.cols) return false;
    for (int k = 0; k < columns_; ++k)
      if (const double middle = middle_of(k); middle < 0 || middle >= grey_.rows) return false;
    return true;
  }
  /// Reads the rows [first, last], unless they are available; within [0, 2 kReach].
  void ensure_rows(int first, int last) {
    if (last_ < first_) {
      read(first, last);
      first_ = first, last_ = last;
      return;
    }
    if (first < first_) read(first, first_ - 1);
    if (last > last_) read(last_ + 1, last);
    first_ = std::min(first, first_), last_ = std::max(last, last_);
  }
  [[nodiscard]] float operator[](std::size_t i) const { return values_[i]; }

 private:
  /// Predicted row of the edge in a column.
  [[nodiscard]] double middle_of(int k) const { return v_ + slope_ * (first_column_ + k - u_); }

  void read(int first, int last) {
    float* const begin = values_.data() + first;
    const int count = last - first + 1;
    std::fill_n(begin, count, 0.0F);
    std::array<std::uint8_t, 2 * kReach + 2> column;
    for (int k = 0; k < columns_; ++k) {
      const double middle = middle_of(k), floor = std::floor(middle);
      const int row = static_cast<int>(floor) + first - kReach;
      copy_column(first_column_ + k, row, count + 1, column.data());
      add_column(column.data(), static_cast<float>(middle - floor), count, begin);
    }
    for (int i = 0; i < count; ++i) begin[i] /= static_cast<float>(columns_);
  }

  void copy_column(int u, int row, int count, std::uint8_t* column) const {
    if (row >= 0 && row + count <= grey_.rows) {
      const std::uint8_t* pixel = grey_.ptr<std::uint8_t>(row) + u;
      for (int i = 0; i < count; ++i, pixel += grey_.step[0]) column[i] = *pixel;
      return;
    }
    // Beyond the border of the image its last row is repeated, so that no step appears.
    for (int i = 0; i < count; ++i)
      column[i] = grey_.at<std::uint8_t>(std::clamp(row + i, 0, grey_.rows - 1), u);
  }

  const cv::Mat& grey_;
  double u_, v_, slope_;
  int columns_, first_column_;
  int first_ = 0, last_ = -1;  // rows in values_
  std::array<float, 2 * kReach + 1> values_;
};

/// Row before the step that is the face's edge: the innermost of all steps of the right sign that
/// are steep enough. The outer border of a narrow side face and the dots on it are as steep, but
/// further out. Dots may even be steeper than the expected edge.
std::optional<std::pair<int, float>> innermost_step(
    Profile& profile, float sign, bool face_below, int reach, float expected_rise) {
  constexpr float kMinSteepness = 0.4F;  // fraction of the steepest
  const int first = kReach - reach, last = kReach + reach - 1;
  profile.ensure_rows(first - 2, last + 3);
  const auto rise = [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    return sign * (profile[k + 2] + profile[k + 1] - profile[k] - profile[k - 1]);
  };
  float max_rise = 0;
  for (int i = first; i <= last; ++i) max_rise = std::max(max_rise, rise(i));
  if (!(max_rise > 0)) return std::nullopt;
  max_rise = std::min(max_rise, expected_rise);
  for (int n = 0; n <= last - first; ++n) {
    const int i = face_below ? last - n : first + n;
    if (rise(i) >= kMinSteepness * max_rise && rise(i) >= rise(i - 1) && rise(i) >= rise(i + 1))
      return std::pair(i, rise(i));
  }
  return std::nullopt;
}

/// Brightness on one side of a step, as a line.
struct Level {
  float mean, slope, middle;  // slope: per row; middle: row of the mean
  [[nodiscard]] float at(int i) const { return mean + slope * (static_cast<float>(i) - middle); }
};

Level level_of(const Profile& profile, int from, int to) {
  float sum = 0, moment = 0, square = 0;
  const float middle = 0.5F * static_cast<float>(from + to);
  for (int i = from; i <= to; ++i) {
    const float x = static_cast<float>(i) - middle, y = profile[static_cast<std::size_t>(i)];
    sum += y, moment += x * y, square += x * x;
  }
  return {sum / static_cast<float>(to - from + 1), moment / square, middle};
}

/// The crossing nearest to row `twice_middle` / 2 of the mean of both sides' levels. Brightness
/// changes along both sides, so that the levels are lines extrapolated to the step. Constants would
/// bias the crossing towards the side that changes more. `outside`: the level outside the face,
/// where a dot hides it.
std::optional<EdgeCrossing> crossing_between_levels(Profile& profile,
                                                    float sign,
                                                    bool face_below,
                                                    int twice_middle,
                                                    bool blurred,
                                                    double noise,
                                                    std::optional<float> outside) {
  const int near = blurred ? kNearBlurred : kNear, far = blurred ? kFarBlurred : kFar;
  const int inner = (twice_middle + 2 * near) / 2;  // first row of the far side
  const int outer = (twice_middle + 2 * far - 1) / 2;
  profile.ensure_rows(twice_middle - outer, outer);
  Level before = level_of(profile, twice_middle - outer, twice_middle - inner);
  Level after = level_of(profile, inner, outer);
  if (outside) (face_below ? before : after) = {*outside, 0.0F, 0.0F};
  const float contrast = sign * (after.mean - before.mean);
  if (contrast < std::max(3.0, 8.0 * noise)) return std::nullopt;
  const auto above = [&](int i) {
    return sign * (profile[static_cast<std::size_t>(i)] - 0.5F * (before.at(i) + after.at(i)));
  };
  const int middle = twice_middle / 2;
  for (int away = 0; away < near; ++away)
    for (const int i : {middle - away, middle + away}) {
      const float a = above(i), b = above(i + 1);
      if (a > 0.0F || b <= 0.0F) continue;
      const double slope = static_cast<double>(b - a);
      // A dot in contact with the edge hides the level outside it.
      constexpr int kGap = 2;
      constexpr float kContrastFraction = 0.2F;
      const int gap = face_below ? i - kGap : i + 1 + kGap;
      if (outside && std::abs(profile[static_cast<std::size_t>(gap)] - *outside) >
                         kContrastFraction * contrast)
        return std::nullopt;
      return EdgeCrossing{i + static_cast<double>(-a) / slope - kReach,
                          std::hypot(kCrossingNoise * noise / slope, 0.02),
                          static_cast<double>(contrast),
                          static_cast<double>(face_below ? before.mean : after.mean),
                          slope};
    }
  return std::nullopt;
}

/// sign: +1 when brightness rises with v; face_below: the face is at larger v.
std::optional<EdgeCrossing> mid_level_crossing(Profile& profile,
                                               float sign,
                                               bool face_below,
                                               int reach,
                                               double noise_sd,
                                               int columns,
                                               const ExpectedEdge& expected) {
  const auto step = innermost_step(profile, sign, face_below, reach, expected.rise);
  if (!step) return std::nullopt;
  const double noise = noise_sd / std::sqrt(static_cast<double>(columns));
  std::optional<EdgeCrossing> crossing;
  int twice_middle = 2 * step->first + 1;  // the step is between this row and the next
  // Blur reaches the rows that the levels are measured in. It cancels only where both sides are
  // equally far from the crossing, so the crossing is searched again.
  bool blurred = false;
  for (int round = 0; round < 2; ++round) {
    crossing = crossing_between_levels(
        profile, sign, face_below, twice_middle, blurred, noise, expected.outside);
    if (!crossing) return std::nullopt;
    blurred = crossing->contrast > kBlurred * crossing->slope;
    twice_middle = static_cast<int>(std::lround(2.0 * (crossing->offset + kReach)));
  }
  crossing->rise = step->second;
  return crossing;
}

/// The steepest step between two pixels of one column.
std::optional<EdgeCrossing> integer_step(
    const cv::Mat& grey, double u, double v, float sign, int reach) {
  const int column = static_cast<int>(std::lround(u));
  const int centre = static_cast<int>(std::lround(v));
  int best_row = -1, best = 0;
  for (int row = std::max(centre - reach, 1); row <= std::min(centre + reach, grey.rows - 1);
       ++row) {
    const int step = static_cast<int>(sign) *
                     (grey.at<std::uint8_t>(row, column) - grey.at<std::uint8_t>(row - 1, column));
    if (step > best) best = step, best_row = row;
  }
  if (best_row < 0 || best < 3) return std::nullopt;
  return EdgeCrossing{best_row - v, 0.29, static_cast<double>(best)};
}

}  // namespace

std::optional<EdgeCrossing> EdgeReader::at(
    double u, double v, double slope, int reach, const ExpectedEdge& expected) const {
  if (options_.method == EdgeMethod::kInteger) return integer_step(grey_, u, v, sign_, reach);
  Profile profile(grey_, u, v, slope, options_.columns);
  if (!profile.is_in_image()) return std::nullopt;
  return mid_level_crossing(
      profile, sign_, face_below_, reach, noise_sd_, options_.columns, expected);
}

}  // namespace alltact
