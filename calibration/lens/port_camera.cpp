#include "calibration/lens/port_camera.h"

#include "calibration/lens/view_cost.h"
#include "calibration/solver_settings.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kSteepest = 5;  // tangent in air; 79 degrees, beyond it hardly any light comes

/// Points of the medium on the exact paths of light, and the pixels that see them.
BoardView points_seen(const Camera& air, const FlatPort& port, double near_mm, double far_mm) {
  constexpr int kColumns = 24, kRows = 18, kDistances = 5;
  BoardView points;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const Eigen::Vector2d pixel((air.size().width - 1) * column / (kColumns - 1.0),
                                  (air.size().height - 1) * row / (kRows - 1.0));
      const auto ray = air.unproject(pixel);
      if (!ray || ray->direction.head<2>().norm() > kSteepest) continue;
      const auto bent = ray_through(port, ray->direction);
      if (!bent) continue;
      for (int i = 0; i < kDistances; ++i) {
        const double z_mm = near_mm + (far_mm - near_mm) * i / (kDistances - 1);
        points.board_mm.push_back(bent->point_at(z_mm));
        points.pixels.push_back(pixel);
      }
    }
  return points;
}

/// nullopt where no lens with so many coefficients does it without folding over.
std::optional<PortCamera> fitted(const CameraParameters& air,
                                 const FlatPort& port,
                                 const BoardView& points,
                                 double far_mm,
                                 int coefficients) {
  PortCamera result;
  result.camera = air;
  if (air.model == CameraModel::kPinhole) result.camera.model = CameraModel::kBrown;
  Eigen::VectorXd numbers = lens_numbers(result.camera);
  numbers.tail(numbers.size() - 4).setZero();
  ViewCost::Units units;
  units.px = air.width_px;
  units.mm = far_mm;
  numbers.head<2>() *= port.medium_index;
  numbers.head<4>() /= units.px;
  Eigen::Matrix<double, 6, 1> pose = Eigen::Matrix<double, 6, 1>::Zero();
  pose[5] = (port.medium_index * apparent_distance_mm(port, far_mm) - far_mm) / units.mm;
  BoardShape flat;
  const std::vector<double> ones(points.pixels.size(), 1.0);
  ceres::Problem problem;
  problem.AddResidualBlock(new ViewCost(result.camera.model, points, ones, units),
                           nullptr,
                           numbers.data(),
                           pose.data(),
                           flat.numbers.data());
  problem.SetParameterBlockConstant(flat.numbers.data());
  problem.SetManifold(pose.data(), new ceres::SubsetManifold(6, {0, 1, 2, 3, 4}));
  std::vector<int> fixed;
  for (int i = 4 + coefficients; i < numbers.size(); ++i) fixed.push_back(i);
  if (!fixed.empty())
    problem.SetManifold(numbers.data(),
                        new ceres::SubsetManifold(static_cast<int>(numbers.size()), fixed));
  const ceres::Solver::Options solver = solver_settings();
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  if (!summary.IsSolutionUsable()) return std::nullopt;
  numbers.head<4>() *= units.px;
  set_lens_numbers(result.camera, numbers);
  result.shift_mm = pose[5] * units.mm;
  const auto camera = Camera::create(result.camera);
  if (!camera) return std::nullopt;
  for (std::size_t i = 0; i < points.pixels.size(); ++i) {
    const auto pixel = camera->project(points.board_mm[i] + Eigen::Vector3d(0, 0, result.shift_mm));
    if (!pixel) return std::nullopt;
    const double error = (*pixel - points.pixels[i]).norm();
    result.worst_px = std::max(result.worst_px, error);
    result.rms_px += error * error / static_cast<double>(points.pixels.size());
  }
  result.rms_px = std::sqrt(result.rms_px);
  return result;
}

}  // namespace

Result<PortCamera> camera_behind_port(const CameraParameters& air,
                                      const FlatPort& port,
                                      double near_mm,
                                      double far_mm) {
  if (const Status status = check_port(port); !status) return status.error();
  const auto camera = Camera::create(air);
  if (!camera) return camera.error();
  if (!camera->is_perspective() || !(near_mm > port.gap_mm + port.plate_mm && far_mm > near_mm))
    return Error{fmt::format("the finger must lie behind the window, which ends {:g} mm from the "
                             "lens",
                             port.gap_mm + port.plate_mm),
                 "--distance-mm",
                 "the distance from the lens to the finger's middle"};
  const BoardView points = points_seen(*camera, port, near_mm, far_mm);
  // A polynomial that follows a very wide view to its last degree may turn back in the corners.
  const int most = air.model == CameraModel::kFisheye ? 4 : 5;
  for (int coefficients = most; coefficients > 0; --coefficients)
    if (const auto found = fitted(air, port, points, far_mm, coefficients)) return *found;
  return Error{"no camera model stands for this lens behind this window",
               "",
               "a calibration with the board seen through the window, in the medium itself"};
}

}  // namespace alltact
