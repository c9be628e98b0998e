// Mapping between pixels and positions on the face.
#include "core/sensing/face/face_shape.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

/// -1 at the base end of the face, 1 at the tip end.
double length_position(const FaceShape& shape, double u) {
  const double all_mm = shape.length_at(shape.base_at_low_u() ? shape.width_px() - 1.0 : 0.0);
  return all_mm > 0.0 ? 2.0 * shape.length_at(u) / all_mm - 1.0 : 0.0;
}

}  // namespace
namespace {

/// Narrows rows [first, last] of column u to those on the face's side of an end, `margin_px` off.
/// Where a bent end leaves rows at both edges, the larger group remains.
void stop_at(const FaceEnd& end, int outwards, int u, double margin_px, int& first, int& last) {
  // outwards (end.at(v) - u) >= 0.5 + margin_px, with x = v - v_px: a + b x + c x^2 >= 0
  const double a = outwards * (end.u_px - u) - 0.5 - margin_px;
  const double b = outwards * end.slope, c = outwards * end.bow_per_px;
  const auto raise_first = [&](double x) {
    first = std::max(first, static_cast<int>(std::ceil(std::clamp(end.v_px + x, -1e6, 1e6))));
  };
  const auto lower_last = [&](double x) {
    last = std::min(last, static_cast<int>(std::floor(std::clamp(end.v_px + x, -1e6, 1e6))));
  };
  constexpr double kUpright = 1e-9, kStraight = 1e-12;
  if (std::abs(c) < kStraight) {
    if (std::abs(b) < kUpright) {
      if (a < 0.0) last = first - 1;
    } else if (b > 0.0) {
      raise_first(-a / b);
    } else {
      lower_last(-a / b);
    }
    return;
  }
  const double square = b * b - 4.0 * a * c;
  if (!(square > 0.0)) {
    if (c < 0.0) last = first - 1;
    return;
  }
  // Adds terms of equal sign first, which loses no digits.
  const double sum = -0.5 * (b + std::copysign(std::sqrt(square), b));
  const auto [low, high] = std::minmax({sum / c, sum != 0.0 ? a / sum : 0.0});
  if (c < 0.0) {
    raise_first(low);
    lower_last(high);
  } else if (end.v_px + low - first >= last - end.v_px - high) {
    lower_last(low);
  } else {
    raise_first(high);
  }
}

}  // namespace

FaceShape::Rows FaceShape::rows(int u, double margin_px) const {
  const FaceColumn& column = columns_[static_cast<std::size_t>(u)];
  if (!column.valid) return {0, -1};
  if (full_image_) return {0, camera_.size().height - 1};
  // A pixel is on the face when all of it is: its centre is inside by half a pixel and the margin.
  int first = std::max(0, static_cast<int>(std::ceil(column.upper_v + 0.5 + margin_px)));
  int last = std::min(camera_.size().height - 1,
                      static_cast<int>(std::floor(column.lower_v - 0.5 - margin_px)));
  if (ends_.first) stop_at(*ends_.first, -1, u, margin_px, first, last);
  if (ends_.last) stop_at(*ends_.last, 1, u, margin_px, first, last);
  return {first, last};
}

// v is taken from the nearest valid column: an end is steep.
std::optional<double> FaceShape::end_column(bool at_base) const {
  const std::optional<FaceEnd>& end = at_base == base_at_low_u_ ? ends_.first : ends_.last;
  if (!end) return std::nullopt;
  const auto is_valid = [](const FaceColumn& c) { return c.valid; };
  const long first = std::find_if(columns_.begin(), columns_.end(), is_valid) - columns_.begin();
  const long last =
      columns_.rend() - std::find_if(columns_.rbegin(), columns_.rend(), is_valid) - 1;
  double u = end->u_px;
  for (int step = 0; step < 3; ++step) {
    const FaceColumn& column =
        columns_[static_cast<std::size_t>(std::clamp(std::lround(u), first, last))];
    u = end->at(0.5 * (column.upper_v + column.lower_v));
  }
  // Far from trusted columns the length to an end is not known.
  constexpr double kNear_px = 2.0;
  if (u < static_cast<double>(first) - kNear_px || u > static_cast<double>(last) + kNear_px)
    return std::nullopt;
  return u;
}

void FaceShape::compute_lengths() {
  struct Sample {
    std::size_t u;
    double length_mm;
  };
  std::vector<Sample> samples;  // of the valid columns, from base to tip
  samples.reserve(columns_.size());
  const bool x_by_column = camera_.is_linear() && camera_.is_perspective();
  std::optional<Eigen::Vector2d> before;  // x and z, mm
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::size_t u = base_at_low_u_ ? i : columns_.size() - 1 - i;
    const FaceColumn& column = columns_[u];
    if (!column.valid) continue;
    Eigen::Vector2d here;
    if (x_by_column) {
      here = {column.z_mm * x_of_column(static_cast<double>(u)), column.z_mm};
    } else {
      const auto ray =
          camera_.unproject({static_cast<double>(u), 0.5 * (column.upper_v + column.lower_v)});
      if (!ray) continue;
      const Eigen::Vector3d point_mm = ray->point_at(column.z_mm);
      here = {point_mm.x(), point_mm.z()};
    }
    const double step_mm = before ? (here - *before).norm() : 0.0;
    samples.push_back({u, samples.empty() ? 0.0 : samples.back().length_mm + step_mm});
    before = here;
  }
  length_mm_.assign(columns_.size(), 0.0);
  if (samples.size() < 2) return;
  // An end lies between columns. Lengths are extrapolated with the slope of the outermost two
  // columns.
  const double direction = base_at_low_u_ ? 1.0 : -1.0;
  const auto length_to = [&](double u) {
    const auto part = [&](const Sample& a, const Sample& b) {
      return a.length_mm + (b.length_mm - a.length_mm) * (u - static_cast<double>(a.u)) /
                               (static_cast<double>(b.u) - static_cast<double>(a.u));
    };
    std::size_t i = 1;
    while (i + 1 < samples.size() && direction * (u - static_cast<double>(samples[i].u)) > 0) ++i;
    return part(samples[i - 1], samples[i]);
  };
  const auto base = end_column(true), tip = end_column(false);
  const double zero_mm = base ? length_to(*base) : 0.0;
  const double first_mm = std::min(zero_mm, 0.0);
  const double last_mm = std::max(tip ? length_to(*tip) : 0.0, samples.back().length_mm);
  std::size_t next = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::size_t u = base_at_low_u_ ? i : columns_.size() - 1 - i;
    if (next < samples.size() && samples[next].u == u) ++next;
    const double length_mm = next == 0 ? first_mm
                             : next == samples.size() && samples.back().u != u
                                 ? last_mm
                                 : samples[next - 1].length_mm;
    length_mm_[u] = length_mm - zero_mm;
  }
}

std::optional<double> FaceShape::base_sd_mm() const {
  if (full_image_) return 0.0;
  const auto end = end_column(true);
  if (!end) return std::nullopt;
  const double half = base_at_low_u_ ? 1.0 : -1.0;
  const double inner = std::clamp(*end + 2 * half, 0.0, width_px() - 1.0);
  const double mm_per_px = std::abs(length_at(inner + half) - length_at(inner));
  const double sd_px = (base_at_low_u_ ? ends_.first : ends_.last)->sd_px;
  // The crossing of the mean level is slightly off a blurred end.
  constexpr double kEndBias_px = 0.07;
  return mm_per_px * std::hypot(sd_px, kEndBias_px);
}

double FaceShape::length_at(double u) const {
  const double clamped = std::clamp(u, 0.0, static_cast<double>(columns_.size() - 1));
  const auto left = static_cast<std::size_t>(clamped);
  const std::size_t right = std::min(left + 1, columns_.size() - 1);
  const double part = clamped - static_cast<double>(left);
  return length_mm_[left] + part * (length_mm_[right] - length_mm_[left]);
}

Eigen::Vector2d FaceShape::position_mm(double u, double v) const {
  const auto nearest = std::clamp<long>(std::lround(u), 0, width_px() - 1);
  const FaceColumn& column = columns_[static_cast<std::size_t>(nearest)];
  const double across = column.valid ? (v - 0.5 * (column.upper_v + column.lower_v)) *
                                           camera_.mm_per_px_at(column.z_mm)
                                     : 0.0;
  return {length_at(u), across};
}

std::optional<FaceShape::Middle> FaceShape::middle_at(double u) const {
  if (full_image_) return std::nullopt;
  const auto valid = [](const FaceColumn& c) { return c.valid; };
  const auto first = std::find_if(columns_.begin(), columns_.end(), valid) - columns_.begin();
  const auto last = columns_.rend() - std::find_if(columns_.rbegin(), columns_.rend(), valid) - 1;
  return middle_within(std::clamp(u, static_cast<double>(first), static_cast<double>(last)));
}

std::optional<FaceShape::Middle> FaceShape::middle_within(double u) const {
  const auto left = static_cast<std::size_t>(u);
  const std::size_t right = std::min(left + 1, columns_.size() - 1);
  const auto middle_v = [](const FaceColumn& c) { return 0.5 * (c.upper_v + c.lower_v); };
  const double v =
      middle_v(columns_[left]) +
      (u - static_cast<double>(left)) * (middle_v(columns_[right]) - middle_v(columns_[left]));
  const auto ray = camera_.unproject({u, v});
  if (!ray) return std::nullopt;
  const double inverse_z = inverse_z_of(*ray);
  const Eigen::Vector2d seen = seen_from(*ray, inverse_z);
  const auto here = across_from(seen.x(), seen.y(), inverse_depth_at(seen.x()));
  if (!here) return std::nullopt;
  const double across_y = std::hypot(here->normal.x(), here->normal.z());
  return Middle{u,
                length_position(*this, u),
                ray->point_at(here->z_mm),
                here->normal.z() / across_y,
                -here->normal.x() / across_y};
}

std::optional<FaceShape::Middle> FaceShape::foot_of(double x_mm, double z_mm) const {
  if (full_image_) return std::nullopt;
  // The offset to the point changes from ahead to behind along the face; the foot lies between.
  const auto ahead = [&](const Middle& m) {
    return (x_mm - m.point_mm.x()) * m.tangent_x + (z_mm - m.point_mm.z()) * m.tangent_z;
  };
  auto low = middle_at(0.0), high = middle_at(static_cast<double>(columns_.size() - 1));
  if (!low || !high) return std::nullopt;
  if (ahead(*low) <= 0.0) return low;
  if (ahead(*high) >= 0.0) return high;
  constexpr double kClosePx = 0.1;
  while (high->u - low->u > kClosePx) {
    const auto between = middle_within(0.5 * (low->u + high->u));
    if (!between) return std::nullopt;
    (ahead(*between) > 0.0 ? low : high) = between;
  }
  return low;
}

std::optional<Eigen::Vector2d> FaceShape::direction_of(const Eigen::Vector2d& pixel) const {
  const auto ray = camera_.unproject(pixel);
  if (!ray) return std::nullopt;
  return seen_from(*ray, inverse_z_of(*ray));
}

}  // namespace alltact
