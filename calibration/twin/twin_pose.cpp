#include "calibration/twin/twin_pose.h"

#include "calibration/twin/twin_solver.h"
#include "core/simulation/face_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace alltact {
namespace {

constexpr int kColumns = 80;                // of an image
constexpr double kBendPrior_per_mm = 1e-4;  // weight of a bend of 1 mm against residuals in mm
constexpr int kPoseUnknowns = 3;

/// A column's ray, and its intersection with the middle line.
struct MiddleRay {
  double origin_x, direction_x, z_mm, y_mm;
};

std::vector<MiddleRay> middle_rays(const FaceShape& shape) {
  std::vector<int> valid;
  for (int u = 0; u < shape.width_px(); ++u)
    if (shape.columns()[static_cast<std::size_t>(u)].valid) valid.push_back(u);
  std::vector<MiddleRay> rays;
  const std::size_t step = std::max<std::size_t>(1, valid.size() / kColumns);
  for (std::size_t i = 0; i < valid.size(); i += step) {
    const auto middle = shape.middle_at(valid[i]);
    if (!middle) continue;
    const auto pixel = shape.camera().project(middle->point_mm);
    if (!pixel) continue;
    const auto ray = shape.camera().unproject(*pixel);
    if (!ray) continue;
    rays.push_back(
        {ray->origin_mm.x(), ray->direction.x(), middle->point_mm.z(), middle->point_mm.y()});
  }
  return rays;
}

FaceCurve curve_of(const TwinPoses& poses, const TwinPose& pose) {
  FaceCurve curve(poses.base_mm, poses.incline_rad, poses.length_mm);
  curve.bend(pose.q1_mm, pose.q2_mm);
  curve.sway(pose.sway_mm);
  curve.integrate();
  return curve;
}

class PoseStudy {
 public:
  PoseStudy(TwinPoses start, std::vector<std::vector<MiddleRay>> rays)
      : start_(std::move(start)), rays_(std::move(rays)) {}

  /// Unknowns: z and y of the base, incline (0.1 rad), and three a shape.
  [[nodiscard]] TwinUnknowns unknowns() const {
    const auto n = static_cast<Eigen::Index>(3 + kPoseUnknowns * rays_.size());
    TwinUnknowns u{Eigen::VectorXd::Zero(n),
                   Eigen::VectorXd::Constant(n, -60),
                   Eigen::VectorXd::Constant(n, 60)};
    u.start[0] = start_.base_mm.z(), u.low[0] = 1, u.high[0] = 1000;
    u.start[1] = start_.base_mm.y();
    u.start[2] = 10 * start_.incline_rad, u.low[2] = -13, u.high[2] = 13;
    return u;
  }
  [[nodiscard]] Eigen::Index residuals() const {
    std::size_t n = kPoseUnknowns * rays_.size();
    for (const auto& rays : rays_) n += 2 * rays.size();
    return static_cast<Eigen::Index>(n);
  }
  [[nodiscard]] TwinPoses at(const Eigen::VectorXd& x) const {
    TwinPoses poses = start_;
    poses.base_mm.z() = x[0];
    poses.base_mm.y() = x[1];
    poses.incline_rad = 0.1 * x[2];
    poses.poses.clear();
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(3 + kPoseUnknowns * i);
      poses.poses.push_back({x[k], x[k + 1], x[k + 2]});
    }
    return poses;
  }
  bool residuals_at(const Eigen::VectorXd& x, Eigen::VectorXd& residuals) const {
    const TwinPoses poses = at(x);
    Eigen::Index k = 0;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const FaceCurve curve = curve_of(poses, poses.poses[i]);
      for (const MiddleRay& ray : rays_[i]) {
        const double s = curve.intersect(ray.origin_x, ray.direction_x);
        if (!std::isfinite(s)) return false;
        const FaceCurve::Node node = curve.at(s);
        residuals[k++] = node.z_mm - ray.z_mm;
        residuals[k++] = node.shift_mm - ray.y_mm;
      }
      for (const double mm : {poses.poses[i].q1_mm, poses.poses[i].q2_mm, poses.poses[i].sway_mm})
        residuals[k++] = kBendPrior_per_mm * mm;
    }
    return true;
  }
  bool evaluate(const Eigen::VectorXd& x,
                Eigen::VectorXd& residuals_out,
                Eigen::MatrixXd* slopes) const {
    residuals_out.resize(residuals());
    if (!residuals_at(x, residuals_out)) return false;
    if (!slopes) return true;
    slopes->resize(residuals_out.size(), x.size());
    Eigen::VectorXd there(residuals_out.size());
    constexpr double kStep = 1e-5;  // curves are computed in double precision
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      Eigen::VectorXd moved = x;
      moved[k] += kStep;
      if (!residuals_at(moved, there)) return false;
      slopes->col(k) = (there - residuals_out) / kStep;
    }
    return true;
  }

 private:
  TwinPoses start_;
  std::vector<std::vector<MiddleRay>> rays_;
};

/// A straight face through the visible points of the first shape.
TwinPoses straight_start(const std::vector<const FaceShape*>& shapes,
                         const std::vector<MiddleRay>& rays) {
  TwinPoses start;
  const MiddleRay& first = rays.front();
  const MiddleRay& last = rays.back();
  const double x = first.origin_x + first.z_mm * first.direction_x;
  const double x_last = last.origin_x + last.z_mm * last.direction_x;
  start.base_mm = {x, first.y_mm, first.z_mm};
  start.incline_rad = std::atan2(last.z_mm - first.z_mm, x_last - x);
  for (const FaceShape* shape : shapes)
    for (int u = shape->width_px() - 1; u >= 0; --u)
      if (shape->columns()[static_cast<std::size_t>(u)].valid) {
        start.length_mm = std::max(start.length_mm, shape->length_at(u));
        break;
      }
  return start;
}

}  // namespace

Result<TwinPoses> fit_poses(const std::vector<const FaceShape*>& shapes, const Job& job) {
  std::vector<std::vector<MiddleRay>> rays;
  for (const FaceShape* shape : shapes) {
    rays.push_back(middle_rays(*shape));
    if (rays.back().size() < 12)
      return Error{en::say("too little of the finger's length is seen"),
                   "",
                   en::say("pictures in which the whole face is seen")};
    if (!shape->base_at_low_u())
      return Error{
          en::say("the finger's base is on the right of the picture, and no scene has it there"),
          "",
          en::say("camera.orientation: flip_u in finger.yaml")};
  }
  const PoseStudy study(straight_start(shapes, rays.front()), rays);
  auto solution = solve_twin(
      [&](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* slopes) {
        return study.evaluate(x, r, slopes);
      },
      study.unknowns(),
      study.residuals(),
      {100, 1e-10},
      job);
  if (!solution) return solution.error();
  TwinPoses poses = study.at(solution->x);
  double sum = 0;
  Eigen::Index k = 0, count = 0;
  for (const auto& one : rays) {
    for (std::size_t i = 0; i < one.size(); ++i, k += 2, ++count)
      sum += solution->residuals[k] * solution->residuals[k];
    k += kPoseUnknowns;
  }
  poses.rms_mm = std::sqrt(sum / static_cast<double>(count));
  return poses;
}

Eigen::Vector2d position_under(const TwinScene& scene,
                               const TwinPose& pose,
                               const Eigen::Vector3d& ball_mm) {
  if (scene.face.kind == FaceKind::kFlat) return ball_mm.head<2>();
  const TwinPoses poses{scene.base_mm, scene.incline_rad, scene.length_mm, {}, 0};
  const FaceCurve curve = curve_of(poses, pose);
  double nearest = std::numeric_limits<double>::infinity(), at = 0;
  const auto distance = [&](double s) {
    const FaceCurve::Node node = curve.at(s);
    return std::hypot(node.x_mm - ball_mm.x(), node.z_mm - ball_mm.z());
  };
  for (double s = 0; s <= scene.length_mm; s += 0.05)
    if (const double d = distance(s); d < nearest) nearest = d, at = s;
  return {at, ball_mm.y() - curve.at(at).shift_mm};
}

}  // namespace alltact
