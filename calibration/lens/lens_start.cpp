#include "calibration/lens/lens_start.h"

#include "core/numerics/median.h"

#include <limits>

#include <opencv2/calib3d.hpp>

namespace alltact {
namespace {

constexpr double kWorst = std::numeric_limits<double>::infinity();
constexpr std::size_t kMaxViews = 16;  // that the table is tested on

/// Focal lengths in image widths: fields of view from 170 degrees to 6.
constexpr std::array kFocals{
    0.2, 0.25, 0.3, 0.36, 0.44, 0.53, 0.64, 0.77, 0.93, 1.1, 1.4, 1.7, 2.2, 3.0, 4.5, 7.0, 10.0};
constexpr std::array kBends{0.0, -0.12, -0.25, 0.15};

CameraParameters candidate(CameraModel model, cv::Size size, double focal, double bend) {
  CameraParameters lens;
  lens.model = model;
  lens.width_px = size.width, lens.height_px = size.height;
  lens.fx_px = lens.fy_px = focal * size.width;
  lens.cx_px = 0.5 * (size.width - 1), lens.cy_px = 0.5 * (size.height - 1);
  if (model == CameraModel::kBrown && bend != 0) {
    // kBends is the bend at the image's edge; k1 is that over the radius squared.
    const double edge = 0.5 / focal;
    lens.distortion = {bend / (edge * edge)};
  }
  return lens;
}

/// Median over views of the error of each view's best pose.
double median_error_px(const std::vector<const BoardView*>& views, const Camera& camera) {
  std::vector<double> errors;
  for (const BoardView* view : views) {
    const auto poses = poses_of(*view, camera);
    errors.push_back(poses.empty() ? kWorst : pose_error_px(*view, camera, poses.front()));
  }
  return upper_median(errors);
}

}  // namespace

std::vector<BoardPose> poses_of(const BoardView& view, const Camera& camera) {
  std::vector<cv::Point3d> board;
  std::vector<cv::Point2d> straight;
  for (std::size_t i = 0; i < view.pixels.size(); ++i) {
    const auto ray = camera.unproject(view.pixels[i]);
    if (!ray || ray->direction.head<2>().norm() > 12) continue;  // 85 degrees: unusable here
    board.emplace_back(view.board_mm[i].x(), view.board_mm[i].y(), 0.0);
    straight.emplace_back(ray->direction.x(), ray->direction.y());
  }
  if (board.size() < 6 || 2 * board.size() < view.pixels.size()) return {};
  std::vector<cv::Mat> turns, shifts;
  try {
    cv::solvePnPGeneric(board,
                        straight,
                        cv::Mat::eye(3, 3, CV_64F),
                        cv::noArray(),
                        turns,
                        shifts,
                        false,
                        cv::SOLVEPNP_IPPE);
  } catch (const cv::Exception&) {
    return {};  // the corners lie in a line
  }
  std::vector<std::pair<double, BoardPose>> found;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    BoardPose pose;
    for (int k = 0; k < 3; ++k) {
      pose.turn[k] = turns[i].at<double>(k);
      pose.shift_mm[k] = shifts[i].at<double>(k);
    }
    const double error = pose_error_px(view, camera, pose);
    if (std::isfinite(error)) found.emplace_back(error, pose);
  }
  std::sort(
      found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<BoardPose> poses;
  for (const auto& [error, pose] : found) poses.push_back(pose);
  return poses;
}

double pose_error_px(const BoardView& view, const Camera& camera, const BoardPose& pose) {
  double sum = 0;
  const Eigen::VectorXd numbers = lens_numbers(camera.parameters());
  const Eigen::Matrix3d rotation = pose.rotation();
  const CameraModel model = camera.parameters().model == CameraModel::kFisheye
                                ? CameraModel::kFisheye
                                : CameraModel::kBrown;
  for (std::size_t i = 0; i < view.pixels.size(); ++i) {
    const auto seen = project_by(model,
                                 {numbers.data(), static_cast<std::size_t>(numbers.size())},
                                 rotation * view.board_mm[i] + pose.shift_mm);
    if (!seen) return kWorst;
    sum += (seen->pixel - view.pixels[i]).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(view.pixels.size()));
}

Result<CameraParameters> first_lens(const std::vector<BoardView>& views,
                                    CameraModel model,
                                    cv::Size size) {
  std::vector<const BoardView*> some;
  const std::size_t step = (views.size() + kMaxViews - 1) / kMaxViews;
  for (std::size_t i = 0; i < views.size(); i += step) some.push_back(&views[i]);
  double best = kWorst;
  CameraParameters lens;
  for (const double focal : kFocals)
    for (const double bend : kBends) {
      if (model == CameraModel::kFisheye && bend != 0) continue;
      const auto camera = Camera::create(candidate(model, size, focal, bend));
      if (!camera) continue;  // folds over
      const double error = median_error_px(some, *camera);
      if (error >= best) continue;
      best = error;
      lens = camera->parameters();
    }
  if (!std::isfinite(best))
    return Error{
        en::say("no lens explains the corners that were found"),
        "",
        en::say("a flat board of the size given with --board; --model fisheye for a lens wider "
                "than 120 degrees")};
  return lens;
}

}  // namespace alltact
