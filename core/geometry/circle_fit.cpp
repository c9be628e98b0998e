#include "core/geometry/circle_fit.h"

#include "core/numerics/linear_algebra.h"

#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kStraight = 1e6;  // radius over extent beyond which a circle counts as a line

struct Frame {
  Eigen::Vector2d mean;
  double extent;  // root mean square distance from the mean
};

std::optional<Frame> frame_of(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3) return std::nullopt;
  Frame frame{Eigen::Vector2d::Zero(), 0.0};
  for (const auto& p : points) frame.mean += p;
  frame.mean /= static_cast<double>(points.size());
  for (const auto& p : points) frame.extent += (p - frame.mean).squaredNorm();
  frame.extent = std::sqrt(frame.extent / static_cast<double>(points.size()));
  if (!std::isfinite(frame.extent) || !(frame.extent > 0.0)) return std::nullopt;
  return frame;
}

double rms_distance(const std::vector<Eigen::Vector2d>& points, const Circle& circle) {
  double sum = 0;
  for (const auto& p : points) {
    const double distance = (p - circle.centre).norm() - circle.radius;
    sum += distance * distance;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/// A circle given by its point at `offset * normal`, normal = (cos angle, sin angle), and its
/// curvature; its centre lies at (offset + 1 / curvature) * normal.
struct Arc {
  double curvature, angle, offset;

  /// Signed distance of p, positive outside, with its derivatives by the three parameters.
  double distance(const Eigen::Vector2d& p, Eigen::Vector3d* gradient) const {
    const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d w = p - offset * normal;
    const double along = w.dot(normal);
    const double across = -w.x() * normal.y() + w.y() * normal.x();
    const double q = curvature * w.squaredNorm() - 2.0 * along;
    const double s = std::sqrt(std::max(0.0, 1.0 + curvature * q));
    if (gradient != nullptr) {
      const double by_q = 0.5 / std::max(s, 1e-12);
      (*gradient)[0] = by_q * w.squaredNorm() - by_q * q * q / ((1.0 + s) * (1.0 + s));
      (*gradient)[1] = -2.0 * by_q * across * (1.0 + curvature * offset);
      (*gradient)[2] = 2.0 * by_q * (1.0 - curvature * along);
    }
    return q / (1.0 + s);
  }
};

double cost_of(const std::vector<Eigen::Vector2d>& points, const Arc& arc) {
  double sum = 0;
  for (const auto& p : points) sum += std::pow(arc.distance(p, nullptr), 2);
  return sum;
}

Arc refine(const std::vector<Eigen::Vector2d>& points, Arc arc) {
  double cost = cost_of(points, arc);
  double damping = 1e-4;
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd design(n + 3, 3);
  Eigen::VectorXd target = Eigen::VectorXd::Zero(n + 3);
  for (int iteration = 0; iteration < 100 && damping < 1e12; ++iteration) {
    for (Eigen::Index i = 0; i < n; ++i) {
      Eigen::Vector3d gradient;
      target[i] = arc.distance(points[static_cast<std::size_t>(i)], &gradient);
      design.row(i) = gradient.transpose();
    }
    // On a short arc curvature and offset are nearly collinear; the normal equations would square
    // that condition.
    design.bottomRows<3>() =
        (std::sqrt(damping) * design.topRows(n).colwise().norm()).asDiagonal().toDenseMatrix();
    const Eigen::Vector3d step = least_squares(design, target);
    if (!step.allFinite()) break;
    const Arc next{arc.curvature - step[0], arc.angle - step[1], arc.offset - step[2]};
    const double next_cost = cost_of(points, next);
    if (!(next_cost <= cost)) {
      damping *= 10.0;
      continue;
    }
    arc = next;
    cost = next_cost;
    damping *= 0.1;
    if (step.norm() < 1e-15) break;
  }
  return arc;
}

}  // namespace

std::optional<Circle> fit_circle_taubin(const std::vector<Eigen::Vector2d>& points) {
  const auto frame = frame_of(points);
  if (!frame) return std::nullopt;
  const auto n = static_cast<Eigen::Index>(points.size());
  // In units of the extent the mean of x^2 + y^2 is 1.
  Eigen::MatrixXd design(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d p = (points[static_cast<std::size_t>(i)] - frame->mean) / frame->extent;
    design.row(i) << 0.5 * (p.squaredNorm() - 1.0), p.x(), p.y();
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::ColPivHouseholderQRPreconditioner> svd(
      design, Eigen::ComputeThinV);
  if (!(svd.singularValues()[1] > 1e-9 * svd.singularValues()[0])) return std::nullopt;
  const Eigen::Vector3d v = svd.matrixV().col(2);
  const double a = 0.5 * v[0];
  if (!(std::abs(a) * kStraight > 0.5 * v.tail<2>().norm()) || a == 0.0) return std::nullopt;
  Circle circle;
  const Eigen::Vector2d centre = -v.tail<2>() / (2.0 * a);
  circle.centre = frame->mean + frame->extent * centre;
  circle.radius = frame->extent * std::sqrt(centre.squaredNorm() + 1.0);
  circle.rms = rms_distance(points, circle);
  return circle;
}

std::optional<Circle> fit_circle(const std::vector<Eigen::Vector2d>& points) {
  const auto frame = frame_of(points);
  const auto start = fit_circle_taubin(points);
  if (!frame || !start) return std::nullopt;
  // The origin moves to the arc's middle, where the three parameters are independent.
  Eigen::Vector2d outward = frame->mean - start->centre;
  outward = outward.norm() > 1e-9 * start->radius ? Eigen::Vector2d(outward.normalized())
                                                  : Eigen::Vector2d(1.0, 0.0);
  const Eigen::Vector2d origin = start->centre + start->radius * outward;
  std::vector<Eigen::Vector2d> scaled;
  scaled.reserve(points.size());
  for (const auto& p : points) scaled.emplace_back((p - origin) / frame->extent);
  const Arc first{frame->extent / start->radius, std::atan2(-outward.y(), -outward.x()), 0.0};
  const Arc best = refine(scaled, first);
  if (!std::isfinite(best.curvature) || !(std::abs(best.curvature) * kStraight > 1.0))
    return std::nullopt;

  Circle circle;
  const Eigen::Vector2d normal(std::cos(best.angle), std::sin(best.angle));
  circle.centre = origin + frame->extent * (best.offset + 1.0 / best.curvature) * normal;
  circle.radius = frame->extent / std::abs(best.curvature);
  circle.rms = rms_distance(points, circle);
  return circle;
}

}  // namespace alltact
