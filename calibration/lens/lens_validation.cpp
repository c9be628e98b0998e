#include "calibration/lens/calibrate_lens.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr std::size_t kFewestOfHalf = 3;  // views: a lens needs three homographies
constexpr std::size_t kFewestForShape = 6;
constexpr double kShapeSigmas = 6;  // significance of a board's shape

/// The views for which `selects(index)` holds, with the start for them.
template <class Selector>
std::pair<std::vector<BoardView>, LensFit> part_of(const std::vector<BoardView>& views,
                                                   const LensFit& fit, const Selector& selects) {
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

Eigen::Vector4d pinhole_numbers(const CameraParameters& lens) {
  return {lens.fx_px, lens.fy_px, lens.cx_px, lens.cy_px};
}

}  // namespace

std::optional<HeldOut> cross_validate(const std::vector<BoardView>& views, const LensFit& fit,
                                      int coefficients, const Job& job) {
  if (views.size() < 4) return std::nullopt;
  const std::size_t folds = std::min<std::size_t>(5, views.size());
  double sum = 0, freedom = 0;
  std::vector<Eigen::Vector4d> numbers;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    const auto [others, start] =
        part_of(views, fit, [&](std::size_t i) { return i % folds != fold; });
    const auto without = fit_lens(others, start, coefficients, job);
    if (!without) return std::nullopt;
    numbers.push_back(pinhole_numbers(without->lens));
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
  const auto n = static_cast<double>(folds);
  Eigen::Vector4d mean = Eigen::Vector4d::Zero(), spread = Eigen::Vector4d::Zero();
  for (const Eigen::Vector4d& one : numbers) mean += one / n;
  for (const Eigen::Vector4d& one : numbers) spread += (one - mean).cwiseAbs2();
  return HeldOut{std::sqrt(sum / freedom), (spread * (n - 1) / n).cwiseSqrt()};
}

std::optional<LensDifference> difference_of(const CameraParameters& a, const CameraParameters& b,
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
    const auto seen =
        project_by(b.model, {numbers.data(), static_cast<std::size_t>(numbers.size())},
                   pose(cloud.board_mm[i]));
    if (!seen) return std::nullopt;
    differences.push_back((seen->pixel - cloud.pixels[i]).norm());
  }
  LensDifference result;
  result.worst_px = *std::max_element(differences.begin(), differences.end());
  result.median_px = upper_median(differences);
  return result;
}

std::optional<HalvesComparison> compare_halves(const std::vector<BoardView>& views,
                                               const LensFit& fit, int coefficients,
                                               double distance_mm, const Job& job) {
  // Of four blocks of views, three splits into halves are independent of each other. The first is
  // every second view.
  constexpr std::array<std::array<bool, 4>, 3> kSplits{
      {{false, true, false, true}, {false, false, true, true}, {false, true, true, false}}};
  HalvesComparison comparison;
  Eigen::Vector4d squares = Eigen::Vector4d::Zero();
  double splits = 0;
  for (const auto& split : kSplits) {
    std::vector<LensFit> halves;
    for (const bool second : {false, true}) {
      const auto [some, start] =
          part_of(views, fit, [&](std::size_t i) { return split[i % 4] == second; });
      if (some.size() < kFewestOfHalf) break;
      const auto fitted = fit_lens(some, start, coefficients, job);
      if (!fitted) break;
      halves.push_back(*fitted);
    }
    if (halves.size() < 2) {
      if (splits == 0) return std::nullopt;
      continue;
    }
    const Eigen::Vector4d first = pinhole_numbers(halves[0].lens),
                          second = pinhole_numbers(halves[1].lens);
    const Eigen::Vector4d variance =
        halves[0].covariance.diagonal().head<4>() + halves[1].covariance.diagonal().head<4>();
    const Eigen::Vector4d sigmas =
        (first - second)
            .cwiseAbs()
            .cwiseQuotient(variance.cwiseSqrt().cwiseMax(std::numeric_limits<double>::min()));
    squares += sigmas.cwiseAbs2();
    if (splits++ > 0) continue;
    const auto difference = difference_of(halves[0].lens, halves[1].lens, distance_mm);
    if (!difference) return std::nullopt;
    comparison.difference = *difference;
    comparison.numbers = {first, second};
    comparison.sigmas = sigmas;
  }
  comparison.scatter = (squares / splits).cwiseSqrt();
  return comparison;
}

Eigen::Vector4d lens_sd_px(const LensFit& fit, const std::optional<HeldOut>& held_out,
                           const std::optional<HalvesComparison>& halves,
                           const std::optional<BoardShape>& shape) {
  Eigen::Vector4d sd = fit.covariance.diagonal().head<4>().cwiseSqrt();
  if (halves) sd = sd.cwiseProduct(halves->sigmas.cwiseMax(halves->scatter).cwiseMax(1.0)).eval();
  if (held_out) sd = sd.cwiseMax(held_out->sd_px).eval();
  if (shape && shape->has_defect()) {
    const Eigen::Vector4d moved = pinhole_numbers(shape->lens) - pinhole_numbers(fit.lens);
    sd = (sd.cwiseAbs2() + moved.cwiseAbs2()).cwiseSqrt().eval();
  }
  return sd;
}

std::optional<BoardShape> board_shape(const std::vector<BoardView>& views, const LensFit& fit,
                                      int coefficients, double disagreement, const Job& job) {
  if (views.size() < kFewestForShape) return std::nullopt;
  const auto shaped = fit_lens(views, fit, coefficients, job, true);
  if (!shaped) return std::nullopt;
  Eigen::Vector3d low = views.front().board_mm.front(), high = low;
  for (const BoardView& view : views)
    for (const Eigen::Vector3d& point_mm : view.board_mm) {
      low = low.cwiseMin(point_mm);
      high = high.cwiseMax(point_mm);
    }
  BoardShape shape;
  shape.lens = shaped->lens;
  shape.stretch = shaped->shape[0];
  shape.stretch_sd = disagreement * shaped->shape_sd[0];
  int most = 1;
  for (const int i : {2, 3})
    if (std::abs(shaped->shape[i]) > std::abs(shaped->shape[most])) most = i;
  const double half_mm = 0.5 * (high - low).norm();
  shape.bend_mm = half_mm * std::abs(shaped->shape[most]);
  constexpr double kMinStretch = 0.001, kMinBend = 0.002;  // limits that few prints reach
  const auto is_significant = [&](int i, double min_value) {
    const double value = std::abs(shaped->shape[i]);
    return value > kShapeSigmas * shaped->shape_sd[i] && value > min_value;
  };
  shape.is_stretched = is_significant(0, kMinStretch);
  shape.is_bent =
      is_significant(1, kMinBend) || is_significant(2, kMinBend) || is_significant(3, kMinBend);
  return shape;
}

}  // namespace alltact
