#include "calibration/joint/body_pose.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace alltact {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Gap gap_at(const MeshDistance& shape, const Isometry3d& camera_from_body, const Vector3d& point) {
  const auto nearest = shape(camera_from_body.inverse(Eigen::Isometry) * point);
  return {nearest.distance, camera_from_body.linear() * nearest.outwards};
}

namespace {

constexpr std::size_t kTried = 60;  // points are enough to try a pose

Gap gap_at(const BodyPatch& patch, const Isometry3d& camera_from_body, const Vector3d& point) {
  const Vector3d off = camera_from_body.inverse(Eigen::Isometry) * point - patch.point;
  const double height = patch.outwards.dot(off);
  const Vector3d aside = off - height * patch.outwards, turned = patch.bend * aside;
  return {height + 0.5 * aside.dot(turned),
          camera_from_body.linear() * (patch.outwards + turned).normalized()};
}

/// A small motion: rotation about `centre`, then translation.
Isometry3d moved(const Isometry3d& pose, const Vector3d& turn, const Vector3d& shift,
                 const Vector3d& centre) {
  Isometry3d result = pose;
  const double angle = turn.norm();
  if (angle > 0) {
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    result.linear() = rotation * pose.linear();
    result.translation() = rotation * (pose.translation() - centre) + centre;
  }
  result.translation() += shift;
  return result;
}

/// Least squares whose rank shows which motions change nothing, such as turns of a rod.
Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver_of(const Eigen::MatrixXd& rows) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-4);
  solver.compute(rows);
  return solver;
}

}  // namespace

Gap BodySurface::gap(std::size_t i, const Isometry3d& camera_from_body,
                     const Vector3d& point) const {
  return shape_ != nullptr ? alltact::gap_at(*shape_, camera_from_body, point)
                           : gap_at((*patches_)[i], camera_from_body, point);
}

BodyGaps gaps_at(const std::vector<SkinPoint>& skin, const BodySurface& surface,
                 const Isometry3d& pose, double factor) {
  BodyGaps at;
  const auto count = static_cast<Eigen::Index>(skin.size());
  at.by_pose.resize(count, 6);
  at.by_factor.resize(count);
  at.mm.resize(count);
  for (const SkinPoint& point : skin) at.centre += point.at(factor) / static_cast<double>(count);
  double squares = 0;
  for (const SkinPoint& point : skin) squares += (point.at(factor) - at.centre).squaredNorm();
  at.reach_mm = std::max(1e-3, std::sqrt(squares / static_cast<double>(count)));
  for (Eigen::Index i = 0; i < count; ++i) {
    const SkinPoint& point = skin[static_cast<std::size_t>(i)];
    const Vector3d here = point.at(factor);
    const Gap gap = surface.gap(static_cast<std::size_t>(i), pose, here);
    at.mm[i] = gap.mm;
    at.by_pose.row(i) << (gap.outwards.cross(here - at.centre) / at.reach_mm).transpose(),
        -gap.outwards.transpose();
    at.by_factor[i] = -point.depth_mm * gap.outwards.dot(point.line.along);
    at.outwards.push_back(gap.outwards);
  }
  return at;
}

Eigen::VectorXd root_weights(const Eigen::VectorXd& gaps_mm) {
  std::vector<double> sizes(gaps_mm.data(), gaps_mm.data() + gaps_mm.size());
  for (double& size : sizes) size = std::abs(size);
  const double limit = std::max(1e-4, 2 * 1.4826 * upper_median(sizes));
  return gaps_mm.unaryExpr(
      [&](double gap) { return std::sqrt(limit / std::max(limit, std::abs(gap))); });
}

Eigen::VectorXd of_factor_alone(const BodyGaps& gaps, const Eigen::VectorXd& roots) {
  const Eigen::MatrixXd rows = roots.asDiagonal() * gaps.by_pose;
  const Eigen::VectorXd column = roots.cwiseProduct(gaps.by_factor);
  return column - rows * solver_of(rows).solve(column);
}

void refine_pose(const std::vector<SkinPoint>& skin, const BodySurface& surface, bool frees_factor,
                 BodyPose& posed) {
  const BodyGaps at = gaps_at(skin, surface, posed.camera_from_body, posed.factor);
  const Eigen::VectorXd roots = root_weights(at.mm);
  const Eigen::MatrixXd rows = roots.asDiagonal() * at.by_pose;
  Eigen::VectorXd left = roots.cwiseProduct(at.mm);
  double change = 0;
  if (frees_factor) {
    const Eigen::VectorXd alone = of_factor_alone(at, roots);
    const double strength = alone.squaredNorm();
    if (strength > kNoStrength) change = std::clamp(-alone.dot(left) / strength, -0.3, 0.3);
    left += change * roots.cwiseProduct(at.by_factor);
  }
  const Eigen::Matrix<double, 6, 1> motion = -solver_of(rows).solve(left);
  const Vector3d turn = motion.head<3>() / at.reach_mm, shift = motion.tail<3>();
  // A step as long as the contact is no small motion.
  const double size = std::max(turn.norm() * at.reach_mm, shift.norm());
  const double shorten = std::min(1.0, 0.5 * at.reach_mm / std::max(size, 1e-12));
  posed.camera_from_body =
      moved(posed.camera_from_body, shorten * turn, shorten * shift, at.centre);
  posed.factor = std::clamp(posed.factor + shorten * change, 0.2, 5.0);
}

namespace {

double rms_of(const std::vector<SkinPoint>& skin, const MeshDistance& shape,
              const BodyPose& posed) {
  double squares = 0;
  for (const SkinPoint& point : skin) {
    const double gap = gap_at(shape, posed.camera_from_body, point.at(posed.factor)).mm;
    squares += gap * gap;
  }
  return std::sqrt(squares / static_cast<double>(skin.size()));
}

std::vector<SkinPoint> every(const std::vector<SkinPoint>& skin, std::size_t limit) {
  std::vector<SkinPoint> some;
  const std::size_t step = skin.size() / limit + 1;
  for (std::size_t i = 0; i < skin.size(); i += step) some.push_back(skin[i]);
  return some;
}

// Where a search for the pose starts.

/// Directions to the faces, edges and corners of a cube: meshes are mostly made along their axes.
std::vector<Vector3d> directions() {
  std::vector<Vector3d> all;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) all.push_back(Vector3d(x, y, z).normalized());
  return all;
}

/// Middles of the parts of a mesh that lie furthest in a direction, each at most `extent_mm` wide.
std::vector<Vector3d> tops_of(const TriangleMesh& mesh, const Vector3d& direction,
                              double extent_mm) {
  constexpr std::size_t kMost = 6;
  double top = -std::numeric_limits<double>::infinity();
  for (const Vector3d& point : mesh.points) top = std::max(top, direction.dot(point));
  struct Part {
    Vector3d sum;
    double count;
  };
  std::vector<Part> parts;
  for (const Vector3d& point : mesh.points) {
    if (direction.dot(point) < top - 0.02 * extent_mm) continue;
    const auto near = std::find_if(parts.begin(), parts.end(), [&](const Part& part) {
      return (part.sum / part.count - point).norm() < 0.5 * extent_mm;
    });
    if (near != parts.end())
      near->sum += point, near->count += 1;
    else if (parts.size() < kMost)
      parts.push_back({point, 1});
  }
  std::vector<Vector3d> middles;
  Vector3d middle = Vector3d::Zero();
  for (const Part& part : parts) {
    middles.emplace_back(part.sum / part.count);
    middle += middles.back() / static_cast<double>(parts.size());
  }
  if (middles.size() > 1) middles.push_back(middle);
  return middles;
}

std::vector<Isometry3d> starts(const std::vector<SkinPoint>& skin, const Vector3d& normal,
                               const TriangleMesh& mesh) {
  constexpr int kTurns = 12;
  const auto deepest = std::max_element(
      skin.begin(), skin.end(),
      [](const SkinPoint& a, const SkinPoint& b) { return a.depth_mm < b.depth_mm; });
  // The middle of what is nearly as deep.
  Vector3d middle = Vector3d::Zero();
  double count = 0, extent_mm = 0;
  for (const SkinPoint& point : skin)
    if (point.depth_mm > 0.9 * deepest->depth_mm) middle += point.at(1), count += 1;
  middle /= count;
  for (const SkinPoint& point : skin)
    extent_mm = std::max(extent_mm, 2 * (point.at(1) - middle).norm());
  std::vector<Isometry3d> poses;
  for (const Vector3d& direction : directions()) {
    const Eigen::Quaterniond facing = Eigen::Quaterniond::FromTwoVectors(direction, -normal);
    for (const Vector3d& top : tops_of(mesh, direction, extent_mm))
      for (int i = 0; i < kTurns; ++i) {
        Isometry3d pose = Isometry3d::Identity();
        pose.linear() =
            (Eigen::AngleAxisd(2 * M_PI * i / kTurns, normal) * facing).toRotationMatrix();
        pose.translation() = middle - pose.linear() * top;
        poses.push_back(pose);
      }
  }
  return poses;
}

}  // namespace

Result<BodyPose> find_pose(const std::vector<SkinPoint>& skin, const Vector3d& normal,
                           const MeshDistance& shape, bool frees_factor, const Job& job) {
  constexpr std::size_t kBest = 12;
  const std::vector<SkinPoint> few = every(skin, kTried);
  const BodySurface surface(shape);
  std::vector<BodyPose> tried;
  for (const Isometry3d& start : starts(skin, normal, shape.mesh())) {
    if (job.stop_requested()) return Error{en::say("stopped before the body was found"), "", ""};
    BodyPose posed{start, 1, 0};
    for (int i = 0; i < 3; ++i) refine_pose(few, surface, false, posed);
    posed.rms_mm = rms_of(few, shape, posed);
    tried.push_back(posed);
  }
  const auto is_better = [](const BodyPose& a, const BodyPose& b) { return a.rms_mm < b.rms_mm; };
  std::stable_sort(tried.begin(), tried.end(), is_better);
  tried.resize(std::min(tried.size(), kBest));
  for (BodyPose& posed : tried) {
    for (int i = 0; i < 25; ++i) refine_pose(few, surface, frees_factor && i > 8, posed);
    posed.rms_mm = rms_of(few, shape, posed);
  }
  return *std::min_element(tried.begin(), tried.end(), is_better);
}

}  // namespace alltact
