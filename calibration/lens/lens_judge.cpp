#include "calibration/lens/lens_judge.h"

#include "core/numerics/median.h"

namespace alltact {
namespace {

/// The views for which `selects(index)` holds, with the start for them.
template <class Selector>
std::pair<std::vector<BoardView>, LensFit> part_of(const std::vector<BoardView>& views,
                                                   const LensFit& fit,
                                                   const Selector& selects) {
  std::pair<std::vector<BoardView>, LensFit> part;
  part.second.lens = fit.lens;
  part.second.shape = fit.shape;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!selects(i)) continue;
    part.first.push_back(views[i]);
    part.second.poses.push_back(fit.poses[i]);
  }
  return part;
}

}  // namespace

std::optional<HeldOut> cross_validate(const std::vector<BoardView>& views,
                                      const LensFit& fit,
                                      const LensFitOptions& options,
                                      const Job& job) {
  if (views.size() < 4) return std::nullopt;
  const std::size_t folds = std::min<std::size_t>(5, views.size());
  double sum = 0, freedom = 0;
  std::vector<Eigen::Vector2d> focals;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    const auto [others, start] =
        part_of(views, fit, [&](std::size_t i) { return i % folds != fold; });
    const auto without = fit_lens(others, start, options, job);
    if (!without) return std::nullopt;
    focals.emplace_back(without->lens.fx_px, without->lens.fy_px);
    for (std::size_t i = fold; i < views.size(); i += folds) {
      BoardPose pose = fit.poses[i];
      const double error = fit_pose(views[i], without->lens, fit.weights[i], pose);
      if (!std::isfinite(error)) continue;
      const double used =
          2 * static_cast<double>(std::count(fit.weights[i].begin(), fit.weights[i].end(), 1.0)) -
          6;
      sum += error * error * used;
      freedom += used;
    }
  }
  if (!(freedom > 0)) return std::nullopt;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero(), spread = Eigen::Vector2d::Zero();
  const auto n = static_cast<double>(folds);
  for (const Eigen::Vector2d& focal : focals) mean += focal / n;
  for (const Eigen::Vector2d& focal : focals) spread += (focal - mean).cwiseAbs2();
  spread = (spread * (n - 1) / n).cwiseSqrt();
  return HeldOut{static_cast<int>(folds), std::sqrt(sum / freedom), spread.x(), spread.y()};
}

std::optional<LensDifference> difference_of(const CameraParameters& a,
                                            const CameraParameters& b,
                                            double distance_mm) {
  const auto camera = Camera::create(a);
  if (!camera || !Camera::create(b)) return std::nullopt;
  constexpr int kColumns = 16, kRows = 12;
  BoardView cloud;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const Eigen::Vector2d pixel((a.width_px - 1) * column / (kColumns - 1.0),
                                  (a.height_px - 1) * row / (kRows - 1.0));
      const auto ray = camera->unproject(pixel);
      if (!ray || ray->direction.head<2>().norm() > 5) continue;  // beyond 79 degrees
      for (const double part : {2.0 / 3, 4.0 / 3}) {
        cloud.board_mm.push_back(ray->point_at(part * distance_mm));
        cloud.pixels.push_back(pixel);
      }
    }
  if (cloud.pixels.size() < 20) return std::nullopt;
  BoardPose pose;
  const std::vector<double> ones(cloud.pixels.size(), 1.0);
  if (!std::isfinite(fit_pose(cloud, b, ones, pose))) return std::nullopt;
  std::vector<double> differences;
  const Eigen::VectorXd numbers = lens_numbers(b);
  for (std::size_t i = 0; i < cloud.pixels.size(); ++i) {
    const auto seen = project_by(b.model,
                                 {numbers.data(), static_cast<std::size_t>(numbers.size())},
                                 pose(cloud.board_mm[i]));
    if (!seen) return std::nullopt;
    differences.push_back((seen->pixel - cloud.pixels[i]).norm());
  }
  LensDifference result;
  result.worst_px = *std::max_element(differences.begin(), differences.end());
  result.median_px = upper_median(differences);
  return result;
}

std::optional<LensDifference> difference_of_halves(const std::vector<BoardView>& views,
                                                   const LensFit& fit,
                                                   const LensFitOptions& options,
                                                   double distance_mm,
                                                   const Job& job) {
  if (views.size() < 6) return std::nullopt;
  std::vector<CameraParameters> lenses;
  for (const std::size_t half : {0, 1}) {
    const auto [some, start] = part_of(views, fit, [&](std::size_t i) { return i % 2 == half; });
    const auto fitted = fit_lens(some, start, options, job);
    if (!fitted) return std::nullopt;
    lenses.push_back(fitted->lens);
  }
  return difference_of(lenses[0], lenses[1], distance_mm);
}

}  // namespace alltact
