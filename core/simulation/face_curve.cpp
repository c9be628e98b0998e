#include "core/simulation/face_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace alltact {

namespace {

constexpr double kLeastCrossing = 0.02;

// Cubic Hermite interpolation on a cell of width h, t in [0, 1].
double hermite(double f0, double d0, double f1, double d1, double h, double t) {
  const double u = 1 - t;
  return u * u * (f0 * (1 + 2 * t) + h * d0 * t) + t * t * (f1 * (3 - 2 * t) - h * d1 * u);
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
    node(i).theta += (q1_mm * 2 * t + q2_mm * (3 * t * t - 2 * t)) / length_mm_;
    node(i).theta_s += (q1_mm * 2 + q2_mm * (6 * t - 2)) / (length_mm_ * length_mm_);
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
  static const double kOff = std::sqrt(0.15);
  const std::array<double, 3> place{0.5 - kOff, 0.5, 0.5 + kOff};
  constexpr std::array<double, 3> kWeight{5.0 / 18, 8.0 / 18, 5.0 / 18};
  for (Node& node : nodes_) {
    node.x_s = std::cos(node.theta);
    node.z_s = std::sin(node.theta);
  }
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
    const Node& a = nodes_[i];
    Node& b = nodes_[i + 1];
    double x = 0, z = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double theta = hermite(a.theta, a.theta_s, b.theta, b.theta_s, cell_mm_, place[k]);
      x += kWeight[k] * std::cos(theta);
      z += kWeight[k] * std::sin(theta);
    }
    b.x_mm = a.x_mm + cell_mm_ * x;
    b.z_mm = a.z_mm + cell_mm_ * z;
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
  p.x_s = std::cos(p.theta);
  p.z_s = std::sin(p.theta);
  return p;
}

double FaceCurve::meet(double origin_x_mm, double direction_x) const {
  const auto gap = [&](const Node& n) { return n.x_mm - origin_x_mm - direction_x * n.z_mm; };
  const auto slope = [&](const Node& n) { return n.x_s - direction_x * n.z_s; };
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto seen = [&](double s) { return at(s).z_mm > 0 ? s : kNone; };
  if (!is_bent_) return slope(base_) <= kLeastCrossing ? kNone : seen(-gap(base_) / slope(base_));
  if (gap(nodes_.front()) >= 0 || gap(nodes_.back()) <= 0) {
    const bool before = gap(nodes_.front()) >= 0;
    const Node& end = before ? nodes_.front() : nodes_.back();
    if (slope(end) <= kLeastCrossing) return kNone;
    return seen((before ? 0 : length_mm_) - gap(end) / slope(end));
  }
  const auto above =
      std::partition_point(nodes_.begin(), nodes_.end(), [&](const Node& n) { return gap(n) < 0; });
  const Node &a = *(above - 1), &b = *above;
  if (std::min(slope(a), slope(b)) <= kLeastCrossing) return kNone;
  // Within a cell the gap is a cubic Hermite curve too, and nearly straight.
  const double h = cell_mm_, f0 = gap(a), f1 = gap(b), d0 = h * slope(a), d1 = h * slope(b);
  double t = f0 / (f0 - f1);
  for (int i = 0; i < 3; ++i) {
    const double f =
        f0 + t * (d0 + t * (3 * (f1 - f0) - 2 * d0 - d1 + t * (2 * (f0 - f1) + d0 + d1)));
    const double f_t =
        d0 + t * (2 * (3 * (f1 - f0) - 2 * d0 - d1) + 3 * t * (2 * (f0 - f1) + d0 + d1));
    t -= f / f_t;
  }
  return seen(cell_mm_ * (static_cast<double>(above - nodes_.begin() - 1) + t));
}

}  // namespace alltact
