#include "core/sensing/face/darkened_edge.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Dense>

namespace alltact {
namespace {

using Rows = Eigen::Matrix<double, AcrossEdge::kCount, 1>;

/// Where the step is, how far it is blurred, and how fast the face recovers behind it.
struct EdgeForm {
  double at_px = 0;
  double log_sd = 0, log_length = 0;  // of px
};

double normal_integral(double x) { return 0.5 * std::erfc(-x * M_SQRT1_2); }

/// The recovery 1 - exp(-r / length) from r = 0, blurred.
double blurred_recovery(double r, double sd, double length) {
  const double exponent = 0.5 * sd * sd / (length * length) - r / length;
  return normal_integral(r / sd) -
         std::exp(std::min(exponent, 50.0)) * normal_integral(r / sd - sd / length);
}

/// A form with the levels that fit best, and what they leave.
struct FormFit {
  Eigen::Vector3d levels = Eigen::Vector3d::Zero();  // outside, step, recovery
  Rows residual = Rows::Zero();
};
FormFit fit_levels(const EdgeForm& form, const Rows& brightness) {
  Eigen::Matrix<double, AcrossEdge::kCount, 3> parts;
  const double sd = std::exp(form.log_sd), length = std::exp(form.log_length);
  for (int i = 0; i < AcrossEdge::kCount; ++i) {
    const double r = AcrossEdge::kFirst + i - form.at_px;
    parts.row(i) << 1.0, normal_integral(r / sd), blurred_recovery(r, sd, length);
  }
  FormFit fit;
  const Eigen::Matrix3d normal = parts.transpose() * parts;
  fit.levels = normal.ldlt().solve(parts.transpose() * brightness);
  fit.residual = parts * fit.levels - brightness;
  return fit;
}

/// Levenberg-Marquardt over the three numbers of the form; the levels follow (variable projection).
EdgeForm solve_form(EdgeForm form, const Rows& brightness) {
  constexpr int kRounds = 25;
  constexpr double kStep = 1e-4, kDone = 1e-4;
  const auto moved = [](EdgeForm from, const Eigen::Vector3d& by) {
    from.at_px += by[0];
    from.log_sd = std::clamp(from.log_sd + by[1], std::log(0.3), std::log(4.0));
    from.log_length = std::clamp(from.log_length + by[2], std::log(1.0), std::log(60.0));
    return from;
  };
  double damping = 1e-3;
  Rows here = fit_levels(form, brightness).residual;
  for (int round = 0; round < kRounds && damping < 1e6; ++round) {
    Eigen::Matrix<double, AcrossEdge::kCount, 3> by;
    for (int c = 0; c < 3; ++c)
      by.col(c) =
          (fit_levels(moved(form, kStep * Eigen::Vector3d::Unit(c)), brightness).residual - here) /
          kStep;
    Eigen::Matrix3d normal = by.transpose() * by;
    normal.diagonal() *= 1.0 + damping;
    normal.diagonal().array() += 1e-9;
    Eigen::Vector3d step = normal.ldlt().solve(-(by.transpose() * here));
    step = step.cwiseMax(-0.7).cwiseMin(0.7);
    const EdgeForm next = moved(form, step);
    const Rows there = fit_levels(next, brightness).residual;
    if (!(there.squaredNorm() < here.squaredNorm())) {
      damping *= 10.0;
      continue;
    }
    form = next;
    here = there;
    damping *= 0.2;
    if (step.cwiseAbs().maxCoeff() < kDone) break;
  }
  return form;
}

/// Cheap: whether brightness still changes behind the step.
bool may_darken(const Rows& brightness) {
  constexpr double kLeast = 0.05;
  const auto mean = [&](int from_px, int to_px) {
    return brightness.segment(from_px - AcrossEdge::kFirst, to_px - from_px + 1).mean();
  };
  const double outside = mean(-6, -4), near = mean(4, 6), far = mean(12, 14);
  return (far - near) * (far - outside) > kLeast * (far - outside) * (far - outside);
}

}  // namespace

std::optional<double> fit_darkened_edge(const AcrossEdge& profile) {
  constexpr double kMostPx = 2.0;
  constexpr double kLeastStep = 0.15;      // of the contrast
  constexpr double kLeastDarkening = 0.1;  // below, the crossing itself has no bias
  constexpr double kMostLeft = 0.02;       // rms of the residual over the contrast
  const Rows brightness = Eigen::Map<const Rows>(profile.brightness.data());
  if (!brightness.allFinite() || !may_darken(brightness)) return std::nullopt;
  const EdgeForm form = solve_form({0.0, std::log(0.9), std::log(4.0)}, brightness);
  const FormFit fit = fit_levels(form, brightness);
  const double contrast = fit.levels[1] + fit.levels[2];
  const double seen = brightness[AcrossEdge::kCount - 1] - fit.levels[0];
  if (!(std::abs(seen) > 1.0) || !(contrast * seen > 0)) return std::nullopt;
  const double step = fit.levels[1] / seen;
  const double left = std::sqrt(fit.residual.squaredNorm() / AcrossEdge::kCount) / std::abs(seen);
  if (!(step > kLeastStep && step < 1.0 - kLeastDarkening) || !(left < kMostLeft) ||
      !(std::abs(form.at_px) < kMostPx))
    return std::nullopt;
  return -form.at_px;
}

namespace {

constexpr int kWindows = 8;
constexpr int kHalfColumns = 3;  // averaged on each side of a sample's middle, along the edge

/// Slope of the edge at a sample, by its valid neighbours.
double slope_at(const std::vector<double>& u, const Edge& edge, std::size_t i) {
  constexpr std::size_t kReach = 4;
  std::size_t before = i, after = i;
  for (std::size_t k = 1; k <= kReach; ++k) {
    if (i >= k && edge.valid[i - k]) before = i - k;
    if (i + k < u.size() && edge.valid[i + k]) after = i + k;
  }
  return after > before ? (edge.v[after] - edge.v[before]) / (u[after] - u[before]) : 0.0;
}

/// Brightness across one sample of the edge; nullopt where it leaves the image.
std::optional<std::array<float, AcrossEdge::kCount>> across(const cv::Mat& grey, double u, double v,
                                                            double slope, int inwards) {
  std::array<float, AcrossEdge::kCount> sums{};
  const int middle = static_cast<int>(std::lround(u));
  if (middle < kHalfColumns || middle + kHalfColumns >= grey.cols) return std::nullopt;
  for (int column = middle - kHalfColumns; column <= middle + kHalfColumns; ++column) {
    const double crossing = v + slope * (column - u);
    for (int i = 0; i < AcrossEdge::kCount; ++i) {
      const double row = crossing + inwards * (AcrossEdge::kFirst + i);
      const double floor = std::floor(row);
      if (!(floor >= 0) || !(floor + 1 < grey.rows)) return std::nullopt;
      const int k = static_cast<int>(floor);
      const auto a = static_cast<float>(grey.at<std::uint8_t>(k, column)),
                 b = static_cast<float>(grey.at<std::uint8_t>(k + 1, column));
      sums[static_cast<std::size_t>(i)] += a + static_cast<float>(row - floor) * (b - a);
    }
  }
  for (float& sum : sums) sum /= 2 * kHalfColumns + 1;
  return sums;
}

/// A stretch of the edge: its middle column, and how far crossings lie inside.
struct Window {
  double u = 0, inside_px = 0;
};

std::vector<Window> windows_of(const cv::Mat& grey, const std::vector<double>& u, int inwards,
                               const Edge& edge) {
  constexpr std::size_t kLeastSamples = 5;
  std::vector<std::size_t> valid;
  for (std::size_t i = 0; i < u.size(); ++i)
    if (edge.valid[i]) valid.push_back(i);
  std::vector<Window> windows;
  for (std::size_t w = 0; w < kWindows; ++w) {
    const std::size_t first = valid.size() * w / kWindows, last = valid.size() * (w + 1) / kWindows;
    std::array<std::vector<float>, AcrossEdge::kCount> rows;
    double sum_u = 0;
    for (std::size_t n = first; n < last; ++n) {
      const std::size_t i = valid[n];
      const auto profile = across(grey, u[i], edge.v[i], slope_at(u, edge, i), inwards);
      if (!profile) continue;
      sum_u += u[i];
      for (std::size_t k = 0; k < rows.size(); ++k) rows[k].push_back((*profile)[k]);
    }
    if (rows[0].size() < kLeastSamples) continue;
    AcrossEdge middle;
    const double middle_u = sum_u / static_cast<double>(rows[0].size());
    for (std::size_t k = 0; k < rows.size(); ++k)
      middle.brightness[k] = static_cast<double>(upper_median(rows[k]));
    if (const auto inside_px = fit_darkened_edge(middle)) windows.push_back({middle_u, *inside_px});
  }
  return windows;
}

/// Each window with the median of it and its neighbours.
std::vector<Window> without_outliers(const std::vector<Window>& windows) {
  std::vector<Window> smooth = windows;
  for (std::size_t i = 1; i + 1 < windows.size(); ++i) {
    const double a = windows[i - 1].inside_px, b = windows[i].inside_px,
                 c = windows[i + 1].inside_px;
    smooth[i].inside_px = std::max(std::min(a, b), std::min(std::max(a, b), c));
  }
  return smooth;
}

double inside_at(const std::vector<Window>& windows, double u) {
  const auto after = std::lower_bound(windows.begin(), windows.end(), u,
                                      [](const Window& w, double at) { return w.u < at; });
  if (after == windows.begin()) return after->inside_px;
  if (after == windows.end()) return windows.back().inside_px;
  const Window& before = *(after - 1);
  const double part = (u - before.u) / (after->u - before.u);
  return before.inside_px + part * (after->inside_px - before.inside_px);
}

}  // namespace

void move_to_darkened_edge(const cv::Mat& grey, const std::vector<double>& u, bool is_upper,
                           Edge* edge) {
  constexpr double kUnsure = 0.15;  // of the shift: what the form leaves
  const int inwards = is_upper ? 1 : -1;
  const std::vector<Window> windows = windows_of(grey, u, inwards, *edge);
  if (2 * windows.size() < kWindows) return;
  const std::vector<Window> smooth = without_outliers(windows);
  for (std::size_t i = 0; i < u.size(); ++i) {
    if (!edge->valid[i]) continue;
    const double inside_px = inside_at(smooth, u[i]);
    edge->v[i] -= inwards * inside_px;
    edge->sd[i] = std::hypot(edge->sd[i], kUnsure * inside_px);
  }
}

}  // namespace alltact
