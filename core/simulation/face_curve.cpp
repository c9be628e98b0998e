#include "core/simulation/face_curve.h"

#include "core/numerics/dispatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr double kMinCrossing = 0.02;

// Three-point Gauss on [0, 1]; kGaussAt[0] is 1/2 - sqrt(0.15).
constexpr std::array<double, 3> kGaussAt{0.5 - 0.387298334620741689, 0.5,
                                         0.5 + 0.387298334620741689};
constexpr std::array<double, 3> kGaussWeight{5.0 / 18, 8.0 / 18, 5.0 / 18};

using NodeNumbers = std::array<double, FaceCurve::kCells + 1>;

// The mean cosine and sine of each cell between n + 1 nodes of small angle change, and the maximum
// change there.
ALLTACT_WIDE void integrate_cells(int n, const double* __restrict theta,
                                  const double* __restrict theta_s, const double* __restrict cos,
                                  const double* __restrict sin, double h, double* __restrict x,
                                  double* __restrict z, double* __restrict turn) {
  for (int i = 0; i < n; ++i) {
    turn[i] = std::abs(theta[i + 1] - theta[i]) +
              h * (4.0 / 27) * (std::abs(theta_s[i]) + std::abs(theta_s[i + 1]));
    const auto toward = [&](double t) {
      const double there = hermite(theta[i], theta_s[i], theta[i + 1], theta_s[i + 1], h, t);
      return turned(cos[i], sin[i], there - theta[i]);
    };
    const TurnedDirection d0 = toward(kGaussAt[0]), d1 = toward(kGaussAt[1]),
                          d2 = toward(kGaussAt[2]);
    x[i] = kGaussWeight[0] * d0.cos + kGaussWeight[1] * d1.cos + kGaussWeight[2] * d2.cos;
    z[i] = kGaussWeight[0] * d0.sin + kGaussWeight[1] * d1.sin + kGaussWeight[2] * d2.sin;
  }
}

}  // namespace

FaceCurve::FaceCurve(const Eigen::Vector3d& base_mm, double incline_rad, double length_mm)
    : length_mm_(length_mm), cell_mm_(length_mm / kCells) {
  base_.theta = incline_rad;
  base_.shift_mm = base_mm.y();
  base_.x_mm = base_mm.x();
  base_.z_mm = base_mm.z();
  base_.x_s = std::cos(incline_rad);
  base_.z_s = std::sin(incline_rad);
}

void FaceCurve::make_nodes() {
  if (!nodes_.empty()) return;
  nodes_.reserve(kCells + 1);
  for (int i = 0; i <= kCells; ++i) nodes_.push_back(along_line(s_mm(i)));
}

FaceCurve::Node FaceCurve::along_line(double s_mm) const {
  Node p = base_;
  p.x_mm += s_mm * p.x_s;
  p.z_mm += s_mm * p.z_s;
  return p;
}

FaceCurve::Node& FaceCurve::node(int i) {
  make_nodes();
  is_bent_ = true;
  return nodes_[static_cast<std::size_t>(i)];
}

void FaceCurve::sway(double sway_mm) {
  make_nodes();
  for (int i = 0; i <= kCells; ++i) {
    Node& here = nodes_[static_cast<std::size_t>(i)];
    const double t = s_mm(i) / length_mm_;
    here.shift_mm += sway_mm * t * t;
    here.shift_s += 2 * sway_mm * t / length_mm_;
  }
}

void FaceCurve::bend(double q1_mm, double q2_mm) {
  for (int i = 0; i <= kCells; ++i) {
    const double t = s_mm(i) / length_mm_;
    Node& here = node(i);
    here.theta += (q1_mm * 2 * t + q2_mm * (3 * t * t - 2 * t)) / length_mm_;
    here.theta_s += (q1_mm * 2 + q2_mm * (6 * t - 2)) / (length_mm_ * length_mm_);
  }
}

void FaceCurve::twist(double tip_rad) {
  make_nodes();
  is_twisted_ = true;
  for (int i = 0; i <= kCells; ++i) {
    Node& here = nodes_[static_cast<std::size_t>(i)];
    here.twist += tip_rad * s_mm(i) / length_mm_;
    here.twist_s += tip_rad / length_mm_;
  }
}

Eigen::Vector3d FaceCurve::across(const Node& p) {
  const double c = std::cos(p.twist), s = std::sin(p.twist);
  return {-s * p.z_s, c, s * p.x_s};
}

Eigen::Vector3d FaceCurve::normal(const Node& p) {
  const double c = std::cos(p.twist), s = std::sin(p.twist);
  return {-c * p.z_s, -s, c * p.x_s};
}

void FaceCurve::integrate() {
  if (!is_bent_) return;
  NodeNumbers theta, theta_s, cos, sin;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    const double c = std::cos(node.theta), s = std::sin(node.theta);
    cos[i] = node.x_s = c;
    sin[i] = node.z_s = s;
    theta[i] = node.theta;
    theta_s[i] = node.theta_s;
  }
  std::array<double, kCells> x, z, turn;
  integrate_cells(kCells, theta.data(), theta_s.data(), cos.data(), sin.data(), cell_mm_, x.data(),
                  z.data(), turn.data());
  has_small_turns_ = *std::max_element(turn.begin(), turn.end()) <= kSeriesTurn;
  for (std::size_t i = 0; i < kCells; ++i) {
    const Node& a = nodes_[i];
    Node& b = nodes_[i + 1];
    if (turn[i] > kSeriesTurn) {
      x[i] = z[i] = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double angle = hermite(a.theta, a.theta_s, b.theta, b.theta_s, cell_mm_, kGaussAt[k]);
        x[i] += kGaussWeight[k] * std::cos(angle);
        z[i] += kGaussWeight[k] * std::sin(angle);
      }
    }
    b.x_mm = a.x_mm + cell_mm_ * x[i];
    b.z_mm = a.z_mm + cell_mm_ * z[i];
  }
  find_unique_directions();
}

// From node to node a line's distance x - origin - direction z grows by dx - direction dz.
void FaceCurve::find_unique_directions() {
  constexpr double kMinGrowth = 1e-6;  // mm; far above rounding
  unique_low_ = std::numeric_limits<double>::lowest();
  unique_high_ = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
    const double dx = nodes_[i + 1].x_mm - nodes_[i].x_mm - kMinGrowth;
    const double dz = nodes_[i + 1].z_mm - nodes_[i].z_mm;
    if (dz > 0) unique_high_ = std::min(unique_high_, dx / dz);
    if (dz < 0) unique_low_ = std::max(unique_low_, dx / dz);
    if (dz == 0 && dx <= 0) unique_high_ = std::numeric_limits<double>::lowest();
  }
}

FaceCurve::Node FaceCurve::at(double s_mm) const {
  if (nodes_.empty()) return along_line(s_mm);
  if (s_mm < 0 || s_mm > length_mm_) {
    Node end = s_mm < 0 ? nodes_.front() : nodes_.back();
    const double beyond = s_mm < 0 ? s_mm : s_mm - length_mm_;
    end.x_mm += beyond * end.x_s;
    end.z_mm += beyond * end.z_s;
    end.shift_mm += beyond * end.shift_s;
    end.twist += beyond * end.twist_s;
    end.theta_s = 0;
    return end;
  }
  const auto i = static_cast<std::size_t>(std::min(static_cast<int>(s_mm / cell_mm_), kCells - 1));
  const Node &a = nodes_[i], &b = nodes_[i + 1];
  const double h = cell_mm_, t = s_mm / h - static_cast<double>(i);
  Node p = along_line(s_mm);
  p.shift_mm = hermite(a.shift_mm, a.shift_s, b.shift_mm, b.shift_s, h, t);
  p.shift_s = a.shift_s + (b.shift_s - a.shift_s) * t;
  p.twist = hermite(a.twist, a.twist_s, b.twist, b.twist_s, h, t);
  p.twist_s = a.twist_s + (b.twist_s - a.twist_s) * t;
  if (!is_bent_) return p;
  p.theta = hermite(a.theta, a.theta_s, b.theta, b.theta_s, h, t);
  p.theta_s = a.theta_s + (b.theta_s - a.theta_s) * t;
  p.x_mm = hermite(a.x_mm, a.x_s, b.x_mm, b.x_s, h, t);
  p.z_mm = hermite(a.z_mm, a.z_s, b.z_mm, b.z_s, h, t);
  if (!has_small_turns_) {
    p.x_s = std::cos(p.theta);
    p.z_s = std::sin(p.theta);
    return p;
  }
  const TurnedDirection d = turned(a.x_s, a.z_s, p.theta - a.theta);
  p.x_s = d.cos;
  p.z_s = d.sin;
  return p;
}

// at(s_mm).z_mm alone.
double FaceCurve::z_at(double s_mm) const {
  if (!is_bent_ || s_mm < 0 || s_mm > length_mm_) return at(s_mm).z_mm;
  const auto i = static_cast<std::size_t>(std::min(static_cast<int>(s_mm / cell_mm_), kCells - 1));
  const Node &a = nodes_[i], &b = nodes_[i + 1];
  const double t = s_mm / cell_mm_ - static_cast<double>(i);
  return hermite(a.z_mm, a.z_s, b.z_mm, b.z_s, cell_mm_, t);
}

double FaceCurve::intersect(double origin_x_mm, double direction_x) const {
  const auto gap = [&](const Node& n) { return n.x_mm - origin_x_mm - direction_x * n.z_mm; };
  const auto slope = [&](const Node& n) { return n.x_s - direction_x * n.z_s; };
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto if_visible = [&](double s) { return z_at(s) > 0 ? s : kNone; };
  if (!is_bent_)
    return slope(base_) <= kMinCrossing ? kNone : if_visible(-gap(base_) / slope(base_));
  if (gap(nodes_.front()) >= 0 || gap(nodes_.back()) <= 0) {
    const bool before = gap(nodes_.front()) >= 0;
    const Node& end = before ? nodes_.front() : nodes_.back();
    if (slope(end) <= kMinCrossing) return kNone;
    return if_visible((before ? 0 : length_mm_) - gap(end) / slope(end));
  }
  const auto above =
      std::partition_point(nodes_.begin(), nodes_.end(), [&](const Node& n) { return gap(n) < 0; });
  const Node &a = *(above - 1), &b = *above;
  if (std::min(slope(a), slope(b)) <= kMinCrossing) return kNone;
  // Within a cell the gap is also a cubic Hermite curve, and nearly straight.
  const double h = cell_mm_, f0 = gap(a), f1 = gap(b), d0 = h * slope(a), d1 = h * slope(b);
  double t = f0 / (f0 - f1);
  for (int i = 0; i < 3; ++i) {
    const double f =
        f0 + t * (d0 + t * (3 * (f1 - f0) - 2 * d0 - d1 + t * (2 * (f0 - f1) + d0 + d1)));
    const double f_t =
        d0 + t * (2 * (3 * (f1 - f0) - 2 * d0 - d1) + 3 * t * (2 * (f0 - f1) + d0 + d1));
    t -= f / f_t;
  }
  return if_visible(cell_mm_ * (static_cast<double>(above - nodes_.begin() - 1) + t));
}

// The cell in which each line crosses the curve; -1 where intersect() has to decide. Neighbouring
// lines cross in the same cell or the next ones, so each search starts at the previous result.
std::vector<int> FaceCurve::cells_hit(const std::vector<double>& origin_x_mm,
                                      const std::vector<double>& direction_x) const {
  std::vector<int> cells(direction_x.size(), -1);
  if (!is_bent_ || !has_small_turns_) return cells;
  const Node* node = nodes_.data();
  int cell = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double origin = origin_x_mm[i], direction = direction_x[i];
    const auto gap = [&](const Node& n) { return n.x_mm - origin - direction * n.z_mm; };
    const auto slope = [&](const Node& n) { return n.x_s - direction * n.z_s; };
    if (!(direction > unique_low_ && direction < unique_high_)) continue;
    if (gap(node[0]) >= 0 || gap(node[kCells]) <= 0) continue;
    while (gap(node[cell]) >= 0) --cell;
    while (gap(node[cell + 1]) < 0) ++cell;
    if (std::min(slope(node[cell]), slope(node[cell + 1])) > kMinCrossing) cells[i] = cell;
  }
  return cells;
}

namespace {

// The steps of intersect() and at(), for lines whose cells are known.
ALLTACT_WIDE void intersect_in_cells(int n, const FaceCurve::Node* nodes,
                                     const int* __restrict cells, const double* __restrict origins,
                                     const double* __restrict directions, double h,
                                     double* __restrict s, double* __restrict x,
                                     double* __restrict z, double* __restrict x_s,
                                     double* __restrict z_s, double* __restrict shift) {
  for (int i = 0; i < n; ++i) {
    const int cell = std::max(cells[i], 0);
    const FaceCurve::Node &a = nodes[cell], &b = nodes[cell + 1];
    const double origin = origins[i], direction = directions[i];
    const double f0 = a.x_mm - origin - direction * a.z_mm,
                 f1 = b.x_mm - origin - direction * b.z_mm;
    const double d0 = h * (a.x_s - direction * a.z_s), d1 = h * (b.x_s - direction * b.z_s);
    const double c2 = 3 * (f1 - f0) - 2 * d0 - d1, c3 = 2 * (f0 - f1) + d0 + d1;
    double t = f0 / (f0 - f1);
    for (int k = 0; k < 3; ++k)
      t -= (f0 + t * (d0 + t * (c2 + t * c3))) / (d0 + t * (2 * c2 + 3 * t * c3));
    const double theta = hermite(a.theta, a.theta_s, b.theta, b.theta_s, h, t);
    const TurnedDirection d = turned(a.x_s, a.z_s, theta - a.theta);
    s[i] = h * (cell + t);
    x[i] = hermite(a.x_mm, a.x_s, b.x_mm, b.x_s, h, t);
    z[i] = hermite(a.z_mm, a.z_s, b.z_mm, b.z_s, h, t);
    x_s[i] = d.cos;
    z_s[i] = d.sin;
    shift[i] = hermite(a.shift_mm, a.shift_s, b.shift_mm, b.shift_s, h, t);
  }
}

}  // namespace

FaceCurve::Intersections FaceCurve::intersect_all(const std::vector<double>& origin_x_mm,
                                                  const std::vector<double>& direction_x) const {
  const std::size_t n = direction_x.size();
  const std::vector<int> cells = cells_hit(origin_x_mm, direction_x);
  Intersections m;
  for (auto* numbers : {&m.s_mm, &m.x_mm, &m.z_mm, &m.x_s, &m.z_s, &m.shift_mm}) numbers->resize(n);
  if (is_bent_)
    intersect_in_cells(static_cast<int>(n), nodes_.data(), cells.data(), origin_x_mm.data(),
                       direction_x.data(), cell_mm_, m.s_mm.data(), m.x_mm.data(), m.z_mm.data(),
                       m.x_s.data(), m.z_s.data(), m.shift_mm.data());
  for (std::size_t i = 0; i < n; ++i) {
    if (cells[i] >= 0 && m.z_mm[i] > 0) continue;
    const double s = intersect(origin_x_mm[i], direction_x[i]);
    // A line that misses the curve gets some point of it, so that its numbers are finite.
    const Node p = at(std::isfinite(s) ? s : length_mm_);
    m.s_mm[i] = s;
    m.x_mm[i] = p.x_mm, m.z_mm[i] = p.z_mm;
    m.x_s[i] = p.x_s, m.z_s[i] = p.z_s;
    m.shift_mm[i] = p.shift_mm;
  }
  return m;
}

}  // namespace alltact
