#include "core/simulation/ruled_surface.h"

#include "core/numerics/dispatch.h"
#include "core/simulation/face_curve.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kFarthestMeeting_mm = 1e5;
constexpr int kParts = 48;  // of the curve and an eighth beyond either end, searched for a start

}  // namespace

RuledSurface RuledSurface::view_face(const FaceCurve& curve) { return {curve, Line::kAcross, 0}; }

RuledSurface RuledSurface::side_face(const FaceCurve& curve, int side, double width_mm) {
  return {curve, Line::kBack, side * width_mm / 2};
}

RuledSurface::Ruling RuledSurface::ruling_at(double s_mm) const {
  const FaceCurve::Node n = curve_->at(s_mm);
  const double c = std::cos(n.twist), s = std::sin(n.twist);
  const Eigen::Vector3d along(n.x_s, 0, n.z_s);
  const Eigen::Vector3d across(-s * n.z_s, c, s * n.x_s), normal(-c * n.z_s, -s, c * n.x_s);
  // The frame rotates by theta' about y and by twist' about the curve.
  const Eigen::Vector3d across_s = n.twist_s * normal - s * n.theta_s * along;
  const Eigen::Vector3d normal_s = -n.twist_s * across - c * n.theta_s * along;
  Ruling ruling;
  ruling.p = Eigen::Vector3d(n.x_mm, n.shift_mm, n.z_mm) + offset_mm_ * across;
  ruling.p_s = Eigen::Vector3d(n.x_s, n.shift_s, n.z_s) + offset_mm_ * across_s;
  const bool is_across = line_ == Line::kAcross;
  ruling.g = is_across ? across : Eigen::Vector3d(-normal);
  ruling.g_s = is_across ? across_s : Eigen::Vector3d(-normal_s);
  return ruling;
}

std::optional<RuledSurface::Intersection> RuledSurface::intersect(const Ray& ray,
                                                                  double near_s_mm) const {
  const Eigen::Vector3d& d = ray.direction;
  double s = near_s_mm;
  for (int i = 0; i < 20; ++i) {
    const Ruling ruling = ruling_at(s);
    const Eigen::Vector3d from_ray = ruling.p - ray.origin_mm, g_d = ruling.g.cross(d);
    const double slope = ruling.p_s.dot(g_d) + from_ray.dot(ruling.g_s.cross(d));
    if (std::abs(slope) < 1e-9) return std::nullopt;
    const double step = -from_ray.dot(g_d) / slope;
    s += step;
    if (!(std::abs(s) < kFarthestMeeting_mm)) return std::nullopt;
    if (std::abs(step) > kLastStep_mm) continue;
    // p - o = z d - r g at the step's end, to first order; the remainder is of second order.
    const Eigen::Vector3d g = ruling.g + step * ruling.g_s, end_g_d = g.cross(d);
    const Eigen::Vector3d end = from_ray + step * ruling.p_s;
    Intersection intersection;
    intersection.s_mm = s;
    intersection.r_mm = d.cross(end).dot(end_g_d) / end_g_d.squaredNorm();
    intersection.z_mm = g.cross(end).dot(end_g_d) / end_g_d.squaredNorm();
    intersection.point_s = ruling.p_s + intersection.r_mm * ruling.g_s;
    intersection.point_r = ruling.g;
    intersection.normal = intersection.point_s.cross(ruling.g).normalized();
    const bool grazes = std::abs(intersection.normal.dot(d)) <= kMinSlant * d.norm();
    if (intersection.z_mm <= 0 || grazes) return std::nullopt;
    return intersection;
  }
  return std::nullopt;
}

std::optional<RuledSurface::Intersection> RuledSurface::intersect(const Ray& ray) const {
  const auto volume = [&](double s) {
    const Ruling ruling = ruling_at(s);
    return (ruling.p - ray.origin_mm).dot(ruling.g.cross(ray.direction));
  };
  const double from = -curve_->length_mm() / 8;
  const double part = 1.25 * curve_->length_mm() / kParts;
  double before = volume(from);
  for (int i = 1; i <= kParts; ++i) {
    const double here = volume(from + i * part);
    if ((before < 0) != (here < 0)) {
      const double start = from + part * (i - 1 + before / (before - here));
      if (auto intersection = intersect(ray, start)) return intersection;
    }
    before = here;
  }
  return std::nullopt;
}

// Neighbouring rays: some are intersected one by one and give the starts for those between them.
// One step of Newton's method, many rays at a time, then suffices.

namespace {

constexpr std::size_t kKnotsApart = 16;
constexpr double kUnknown_mm = -1e6;  // no start known

/// The curve and the line that sweeps it.
struct Swept {
  const FaceCurve::Node* nodes;
  double cell_mm, length_mm, offset_mm;
  double by_across, by_normal;  ///< of the ruling's direction
};

/// Rays by column in, intersections by column out.
struct Arrays {
  const double *origin_x, *origin_y, *direction_x, *direction_y, *start_mm;
  double *s, *r, *z, *s_x, *s_y, *s_z, *r_x, *r_y, *r_z, *n_x, *n_y, *n_z;
  double* good;  ///< 1: the step converged
};

// RuledSurface::intersect() and ruling_at(), one step of them, written out by components.
ALLTACT_WIDE void intersect_stretch(int n, const Swept c, const Arrays a) {
  const double* __restrict origin_x = a.origin_x, * __restrict origin_y = a.origin_y;
  const double* __restrict direction_x = a.direction_x, * __restrict direction_y = a.direction_y;
  const double* __restrict start = a.start_mm;
  double* __restrict out_s = a.s, * __restrict out_r = a.r, * __restrict out_z = a.z;
  double* __restrict s_x = a.s_x, * __restrict s_y = a.s_y, * __restrict s_z = a.s_z;
  double* __restrict r_x = a.r_x, * __restrict r_y = a.r_y, * __restrict r_z = a.r_z;
  double* __restrict n_x = a.n_x, * __restrict n_y = a.n_y, * __restrict n_z = a.n_z;
  double* __restrict good = a.good;
#pragma GCC ivdep  // the arrays are rows of their own
  for (int i = 0; i < n; ++i) {
    const double s = start[i];
    const double on = std::min(std::max(s, 0.0), c.length_mm), beyond = s - on;
    const int cell = std::min(static_cast<int>(on / c.cell_mm), FaceCurve::kCells - 1);
    const FaceCurve::Node &p = c.nodes[cell], &q = c.nodes[cell + 1];
    const double h = c.cell_mm, t = on / h - cell;

    // The node at s; beyond the ends everything continues straight.
    const double theta_by = hermite(p.theta, p.theta_s, q.theta, q.theta_s, h, t) - p.theta;
    const double theta_s = beyond == 0 ? p.theta_s + (q.theta_s - p.theta_s) * t : 0.0;
    const double twist_s = p.twist_s + (q.twist_s - p.twist_s) * t;
    const double shift_s = p.shift_s + (q.shift_s - p.shift_s) * t;
    const double twist = hermite(p.twist, p.twist_s, q.twist, q.twist_s, h, t) + beyond * twist_s;
    const TurnedDirection along = turned(p.x_s, p.z_s, theta_by);
    const TurnedDirection section = turned(1, 0, twist);
    const double x = hermite(p.x_mm, p.x_s, q.x_mm, q.x_s, h, t) + beyond * along.cos;
    const double z = hermite(p.z_mm, p.z_s, q.z_mm, q.z_s, h, t) + beyond * along.sin;
    const double shift =
        hermite(p.shift_mm, p.shift_s, q.shift_mm, q.shift_s, h, t) + beyond * shift_s;

    const double across_x = -section.sin * along.sin, across_y = section.cos;
    const double across_z = section.sin * along.cos;
    const double normal_x = -section.cos * along.sin, normal_y = -section.sin;
    const double normal_z = section.cos * along.cos;
    const double by_along = section.sin * theta_s, back_by_along = section.cos * theta_s;
    const double across_s_x = twist_s * normal_x - by_along * along.cos;
    const double across_s_y = twist_s * normal_y;
    const double across_s_z = twist_s * normal_z - by_along * along.sin;
    const double normal_s_x = -twist_s * across_x - back_by_along * along.cos;
    const double normal_s_y = -twist_s * across_y;
    const double normal_s_z = -twist_s * across_z - back_by_along * along.sin;

    const double p_s_x = along.cos + c.offset_mm * across_s_x;
    const double p_s_y = shift_s + c.offset_mm * across_s_y;
    const double p_s_z = along.sin + c.offset_mm * across_s_z;
    const double g_x = c.by_across * across_x + c.by_normal * normal_x;
    const double g_y = c.by_across * across_y + c.by_normal * normal_y;
    const double g_z = c.by_across * across_z + c.by_normal * normal_z;
    const double g_s_x = c.by_across * across_s_x + c.by_normal * normal_s_x;
    const double g_s_y = c.by_across * across_s_y + c.by_normal * normal_s_y;
    const double g_s_z = c.by_across * across_s_z + c.by_normal * normal_s_z;
    const double from_x = x + c.offset_mm * across_x - origin_x[i];
    const double from_y = shift + c.offset_mm * across_y - origin_y[i];
    const double from_z = z + c.offset_mm * across_z;

    // The volume (p - o) . (g x d), d = (d_x, d_y, 1), and its derivative by s.
    const double d_x = direction_x[i], d_y = direction_y[i];
    const double g_d_x = g_y - g_z * d_y, g_d_y = g_z * d_x - g_x, g_d_z = g_x * d_y - g_y * d_x;
    const double g_s_d_x = g_s_y - g_s_z * d_y, g_s_d_y = g_s_z * d_x - g_s_x;
    const double g_s_d_z = g_s_x * d_y - g_s_y * d_x;
    const double volume = from_x * g_d_x + from_y * g_d_y + from_z * g_d_z;
    const double slope = p_s_x * g_d_x + p_s_y * g_d_y + p_s_z * g_d_z + from_x * g_s_d_x +
                         from_y * g_s_d_y + from_z * g_s_d_z;
    const bool flat = std::abs(slope) < 1e-9;
    const double step = -volume / (flat ? 1.0 : slope);

    const double end_g_x = g_x + step * g_s_x, end_g_y = g_y + step * g_s_y;
    const double end_g_z = g_z + step * g_s_z;
    const double end_x = from_x + step * p_s_x, end_y = from_y + step * p_s_y;
    const double end_z = from_z + step * p_s_z;
    const double turn_x = end_g_y - end_g_z * d_y, turn_y = end_g_z * d_x - end_g_x;
    const double turn_z = end_g_x * d_y - end_g_y * d_x;
    const double turn2 = turn_x * turn_x + turn_y * turn_y + turn_z * turn_z;
    const bool along_ray = turn2 < 1e-12;
    const double per_turn2 = 1 / (along_ray ? 1.0 : turn2);
    const double r = ((d_y * end_z - end_y) * turn_x + (end_x - d_x * end_z) * turn_y +
                      (d_x * end_y - d_y * end_x) * turn_z) *
                     per_turn2;
    const double hit_z = ((end_g_y * end_z - end_g_z * end_y) * turn_x +
                          (end_g_z * end_x - end_g_x * end_z) * turn_y +
                          (end_g_x * end_y - end_g_y * end_x) * turn_z) *
                         per_turn2;

    const double ds_x = p_s_x + r * g_s_x, ds_y = p_s_y + r * g_s_y, ds_z = p_s_z + r * g_s_z;
    const double m_x = ds_y * g_z - ds_z * g_y, m_y = ds_z * g_x - ds_x * g_z;
    const double m_z = ds_x * g_y - ds_y * g_x;
    const double m2 = m_x * m_x + m_y * m_y + m_z * m_z;
    const bool no_normal = m2 < 1e-12;
    const double per_m = 1 / std::sqrt(no_normal ? 1.0 : m2);
    const double slant = std::abs(m_x * d_x + m_y * d_y + m_z) * per_m;
    const bool grazes = slant <= RuledSurface::kMinSlant * std::sqrt(d_x * d_x + d_y * d_y + 1);
    const bool is_last =
        std::abs(step) <= RuledSurface::kLastStep_mm && std::abs(twist) <= kSeriesTurn;
    good[i] = is_last && !flat && !along_ray && !no_normal && !grazes && hit_z > 0 ? 1.0 : 0.0;
    out_s[i] = s + step, out_r[i] = r, out_z[i] = hit_z;
    s_x[i] = ds_x, s_y[i] = ds_y, s_z[i] = ds_z;
    r_x[i] = g_x, r_y[i] = g_y, r_z[i] = g_z;
    n_x[i] = m_x * per_m, n_y[i] = m_y * per_m, n_z[i] = m_z * per_m;
  }
}

}  // namespace

RuledSurface::IntersectionRow::IntersectionRow(std::size_t n)
    : numbers_(kNumbers * n), hit_(n, 0) {}

RuledSurface::Intersection RuledSurface::IntersectionRow::at(std::size_t i) const {
  const auto number = [&](int which) {
    return numbers_[static_cast<std::size_t>(which) * hit_.size() + i];
  };
  const auto vector = [&](int which) {
    return Eigen::Vector3d(number(which), number(which + 1), number(which + 2));
  };
  return {number(kS), number(kR), number(kZ), vector(kPointS), vector(kPointR), vector(kNormal)};
}

void RuledSurface::IntersectionRow::set(std::size_t i, const Intersection& intersection) {
  hit_[i] = 1;
  row(kS)[i] = intersection.s_mm;
  row(kR)[i] = intersection.r_mm;
  row(kZ)[i] = intersection.z_mm;
  for (int axis = 0; axis < 3; ++axis) {
    row(kPointS + axis)[i] = intersection.point_s[axis];
    row(kPointR + axis)[i] = intersection.point_r[axis];
    row(kNormal + axis)[i] = intersection.normal[axis];
  }
}

/// Fills a IntersectionRow, run by run of the requested rays.
class RuledSurface::RowSearch {
 public:
  RowSearch(const RuledSurface& surface, const std::vector<Ray>& rays, const float* near_s_mm,
            IntersectionRow& found)
      : surface_(surface), rays_(rays), near_s_mm_(near_s_mm), found_(found) {
    const FaceCurve& curve = *surface.curve_;
    in_stretches_ = !curve.nodes().empty() && curve.has_small_turns();
    if (!in_stretches_) return;
    for (auto* numbers : {&origin_x_, &origin_y_, &direction_x_, &direction_y_, &start_mm_, &good_})
      numbers->resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      origin_x_[i] = rays[i].origin_mm.x();
      origin_y_[i] = rays[i].origin_mm.y();
      direction_x_[i] = rays[i].direction.x();
      direction_y_[i] = rays[i].direction.y();
    }
  }

  void run(std::size_t first, std::size_t last) {
    if (in_stretches_) {
      begin(first, last);
      step(first, last);
    }
    std::optional<double> before;
    for (std::size_t i = first; i < last; ++i) {
      const bool is_found = in_stretches_ && good_[i] != 0;
      if (is_found)
        found_.hit_[i] = 1;
      else if (const auto here = find(i, before))
        found_.set(i, *here);
      before.reset();
      if (found_.is_hit(i)) before = found_.row(IntersectionRow::kS)[i];
    }
  }

 private:
  // Intersects one ray by itself.
  [[nodiscard]] std::optional<Intersection> find(std::size_t i,
                                                 std::optional<double> before) const {
    if (near_s_mm_ != nullptr)
      return surface_.intersect(rays_[i], static_cast<double>(near_s_mm_[i]));
    if (before)
      if (auto here = surface_.intersect(rays_[i], *before)) return here;
    return surface_.intersect(rays_[i]);
  }

  // Sets the starts between knots that are intersected one by one; next to a failed knot the start
  // is unknown.
  void begin(std::size_t first, std::size_t last) {
    std::size_t knot = first;
    auto here = find(knot, std::nullopt);
    start_mm_[knot] = here ? here->s_mm : kUnknown_mm;
    while (knot + 1 < last) {
      const std::size_t next = std::min(knot + kKnotsApart, last - 1);
      const auto there = find(next, here ? std::optional(here->s_mm) : std::nullopt);
      begin_between(knot, here, next, there);
      start_mm_[next] = there ? there->s_mm : kUnknown_mm;
      knot = next;
      here = there;
    }
  }

  void begin_between(std::size_t from, const std::optional<Intersection>& a, std::size_t to,
                     const std::optional<Intersection>& b) {
    if (!a || !b) {
      std::fill(start_mm_.begin() + static_cast<std::ptrdiff_t>(from) + 1,
                start_mm_.begin() + static_cast<std::ptrdiff_t>(to), kUnknown_mm);
      return;
    }
    const auto h = static_cast<double>(to - from);
    const double d_a = a->s_by(rays_[from], rays_[from + 1]);
    const double d_b = -b->s_by(rays_[to], rays_[to - 1]);
    for (std::size_t i = from + 1; i < to; ++i)
      start_mm_[i] = hermite(a->s_mm, d_a, b->s_mm, d_b, h, static_cast<double>(i - from) / h);
  }

  void step(std::size_t first, std::size_t last) {
    const auto out = [&](int number) { return found_.row(number) + first; };
    const FaceCurve& curve = *surface_.curve_;
    const bool is_across = surface_.line_ == Line::kAcross;
    intersect_stretch(
        static_cast<int>(last - first),
        {curve.nodes().data(), curve.s_mm(1), curve.length_mm(), surface_.offset_mm_,
         is_across ? 1.0 : 0.0, is_across ? 0.0 : -1.0},
        {origin_x_.data() + first, origin_y_.data() + first, direction_x_.data() + first,
         direction_y_.data() + first, start_mm_.data() + first, out(IntersectionRow::kS),
         out(IntersectionRow::kR), out(IntersectionRow::kZ), out(IntersectionRow::kPointS),
         out(IntersectionRow::kPointS + 1), out(IntersectionRow::kPointS + 2),
         out(IntersectionRow::kPointR), out(IntersectionRow::kPointR + 1),
         out(IntersectionRow::kPointR + 2), out(IntersectionRow::kNormal),
         out(IntersectionRow::kNormal + 1), out(IntersectionRow::kNormal + 2),
         good_.data() + first});
    for (std::size_t i = first; i < last; ++i)
      if (start_mm_[i] == kUnknown_mm) good_[i] = 0;
  }

  const RuledSurface& surface_;
  const std::vector<Ray>& rays_;
  const float* near_s_mm_;
  IntersectionRow& found_;
  bool in_stretches_ = false;
  std::vector<double> origin_x_, origin_y_, direction_x_, direction_y_, start_mm_, good_;
};

RuledSurface::IntersectionRow RuledSurface::intersect_row(const std::vector<Ray>& rays,
                                                          const std::vector<char>& requested,
                                                          const float* near_s_mm) const {
  IntersectionRow found(rays.size());
  RowSearch search(*this, rays, near_s_mm, found);
  for (std::size_t first = 0; first < rays.size();) {
    std::size_t last = first;
    while (last < rays.size() && requested[last] != 0) ++last;
    if (last > first) search.run(first, last);
    first = last + 1;
  }
  return found;
}

}  // namespace alltact
