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
    : length_mm_(length_mm), cell_mm_(length_mm / kCells), nodes_(kCells + 1) {
  for (Node& node : nodes_) {
    node.theta = incline_rad;
    node.shift_mm = base_mm.y();
  }
  nodes_.front().x_mm = base_mm.x();
  nodes_.front().z_mm = base_mm.z();
}

void FaceCurve::integrate() {
  static const double kOff = std::sqrt(0.15);
  const std::array<double, 3> place{0.5 - kOff, 0.5, 0.5 + kOff};
  constexpr std::array<double, 3> kWeight{5.0 / 18, 8.0 / 18, 5.0 / 18};
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
  if (s_mm < 0 || s_mm > length_mm_) {
    Node end = s_mm < 0 ? nodes_.front() : nodes_.back();
    const double beyond = s_mm < 0 ? s_mm : s_mm - length_mm_;
    end.x_mm += beyond * std::cos(end.theta);
    end.z_mm += beyond * std::sin(end.theta);
    end.shift_mm += beyond * end.shift_s;
    end.theta_s = 0;
    return end;
  }
  const auto i = static_cast<std::size_t>(std::min(static_cast<int>(s_mm / cell_mm_), kCells - 1));
  const Node &a = nodes_[i], &b = nodes_[i + 1];
  const double h = cell_mm_, t = s_mm / h - static_cast<double>(i);
  Node p;
  p.theta = hermite(a.theta, a.theta_s, b.theta, b.theta_s, h, t);
  p.theta_s = a.theta_s + (b.theta_s - a.theta_s) * t;
  p.shift_mm = hermite(a.shift_mm, a.shift_s, b.shift_mm, b.shift_s, h, t);
  p.shift_s = a.shift_s + (b.shift_s - a.shift_s) * t;
  p.x_mm = hermite(a.x_mm, std::cos(a.theta), b.x_mm, std::cos(b.theta), h, t);
  p.z_mm = hermite(a.z_mm, std::sin(a.theta), b.z_mm, std::sin(b.theta), h, t);
  return p;
}

double FaceCurve::meet(double origin_x_mm, double direction_x) const {
  const auto gap = [&](const Node& n) { return n.x_mm - origin_x_mm - direction_x * n.z_mm; };
  const auto slope = [&](const Node& n) {
    return std::cos(n.theta) - direction_x * std::sin(n.theta);
  };
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double s = 0;
  if (gap(nodes_.front()) >= 0 || gap(nodes_.back()) <= 0) {
    const bool before = gap(nodes_.front()) >= 0;
    const Node& end = before ? nodes_.front() : nodes_.back();
    if (slope(end) <= kLeastCrossing) return kNone;
    s = (before ? 0 : length_mm_) - gap(end) / slope(end);
  } else {
    const auto above = std::partition_point(
        nodes_.begin(), nodes_.end(), [&](const Node& n) { return gap(n) < 0; });
    s = cell_mm_ * static_cast<double>(above - nodes_.begin() - 1) + 0.5 * cell_mm_;
    for (int i = 0; i < 4; ++i) {
      const Node here = at(s);
      if (slope(here) <= kLeastCrossing) return kNone;
      s -= gap(here) / slope(here);
    }
  }
  return at(s).z_mm > 0 ? s : kNone;
}

}  // namespace alltact
