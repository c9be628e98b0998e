#include "calibration/lens/outlier_views.h"

#include "core/numerics/median.h"

namespace alltact {
namespace {

constexpr double kOutlierScatter = 2.5;  // times the median view's
constexpr double kMinScatterPx = 0.05;   // below, no view is an outlier
constexpr double kBlurred = 1.6;         // times the median view's edge width
constexpr double kShapeSigmas = 6;       // significance of a board's shape

/// Robust scatter of one coordinate of all corners of a view, outliers included.
double scatter_px(const std::vector<double>& errors_px) {
  std::vector<double> errors = errors_px;
  return upper_median(errors) / 1.1774;
}

Message outlier_reason(const BoardView& view,
                       const LensFit& fit,
                       std::size_t index,
                       double scatter,
                       double median_scatter,
                       double median_edge_px) {
  const Message found = en::say(
      "its corners lie {:.2f} px from where the lens sees them, those of the others {:.2f} px",
      scatter,
      median_scatter);
  if (view.edge_px > kBlurred * median_edge_px)
    return en::say(
        "blurred, by motion or focus: its edges are {:.1f} px wide, those of the "
        "others {:.1f} px",
        view.edge_px,
        median_edge_px);
  const std::vector<double> ones(view.pixels.size(), 1.0);
  BoardPose flat_pose = fit.poses[index], bent_pose = flat_pose;
  BoardShape shape;
  const double flat = fit_pose(view, fit.lens, ones, flat_pose);
  const double bent = fit_pose(view, fit.lens, ones, bent_pose, &shape);
  if (bent < 0.5 * flat)
    return en::clauses({found, en::say("the board is bent in it, glue it to something stiff")});
  const auto wrong = std::count(fit.weights[index].begin(), fit.weights[index].end(), 0.0);
  if (scatter < kOutlierScatter * median_scatter)
    return en::say(
        "{} of its {} corners lie elsewhere: covered, mirrored in something, or "
        "blurred",
        wrong,
        view.pixels.size());
  return en::clauses({found, en::say("moved during the exposure, or not this board")});
}

}  // namespace

std::vector<OutlierView> outlier_views(const std::vector<BoardView>& views, const LensFit& fit) {
  std::vector<double> scatters, edges;
  for (std::size_t i = 0; i < views.size(); ++i) {
    scatters.push_back(scatter_px(fit.errors_px[i]));
    edges.push_back(views[i].edge_px);
  }
  std::vector<double> sorted = scatters;
  const double median_scatter = upper_median(sorted);
  const double median_edge_px = upper_median(edges);
  std::vector<OutlierView> outliers;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto wrong = std::count(fit.weights[i].begin(), fit.weights[i].end(), 0.0);
    const bool scattered =
        scatters[i] > kOutlierScatter * median_scatter && scatters[i] > kMinScatterPx;
    if (!scattered && 4 * static_cast<std::size_t>(wrong) <= views[i].pixels.size()) continue;
    outliers.push_back(
        {i, outlier_reason(views[i], fit, i, scatters[i], median_scatter, median_edge_px)});
  }
  return outliers;
}

Message board_problem(const std::vector<BoardView>& views,
                      const LensFit& fit,
                      const LensFitOptions& options,
                      const Job& job) {
  constexpr std::size_t kFewestViewsForShape = 6;
  if (views.size() < kFewestViewsForShape) return {};
  LensFitOptions with_shape = options;
  with_shape.free_shape = true;
  const auto shaped = fit_lens(views, fit, with_shape, job);
  if (!shaped) return {};
  Eigen::Vector3d low = views.front().board_mm.front(), high = low;
  for (const BoardView& view : views)
    for (const Eigen::Vector3d& point_mm : view.board_mm) {
      low = low.cwiseMin(point_mm);
      high = high.cwiseMax(point_mm);
    }
  const double half_mm = 0.5 * (high - low).norm();
  const auto& shape = shaped->shape.numbers;
  const auto is_significant = [&](int i, double min_value) {
    const double value = std::abs(shape[static_cast<std::size_t>(i)]);
    return value > kShapeSigmas * shaped->shape_sd[i] && value > min_value;
  };
  Message problem;
  constexpr double kMinStretch = 0.001, kMinBend = 0.002;  // limits that few prints reach
  if (is_significant(0, kMinStretch))
    problem = en::say("its squares are {:.2f} % {} than they are high",
                      100 * std::abs(shape[0]),
                      shape[0] > 0 ? en::say("wider") : en::say("narrower"));
  if (is_significant(1, kMinBend) || is_significant(2, kMinBend) || is_significant(3, kMinBend)) {
    const double bend = std::max({std::abs(shape[1]), std::abs(shape[2]), std::abs(shape[3])});
    const Message bent =
        en::say("it is bent by about {:.2g} mm from its middle to its corners", bend * half_mm);
    problem = problem.empty() ? bent : en::say("{}, and {}", problem, bent);
  }
  if (problem.empty()) return {};
  return en::say(
      "the board is not the flat, even one it is taken for: {}; with that allowed for fx would be "
      "{:.2f} instead of {:.2f} px; use a board on glass or metal",
      problem,
      shaped->lens.fx_px,
      fit.lens.fx_px);
}

}  // namespace alltact
