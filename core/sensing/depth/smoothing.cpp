#include "core/sensing/depth/smoothing.h"

#include <cmath>

#include <Eigen/Dense>

namespace alltact {

double Smoothing::noise_factor() const {
  double squares = weights.front() * weights.front();
  for (std::size_t k = 1; k < weights.size(); ++k) squares += 2.0 * weights[k] * weights[k];
  return squares;  // the root for either axis, and there are two
}

Smoothing smoothing_of(double smoothing_px) {
  constexpr double kWider = 2.7;  // than a Gaussian that leaves the same noise
  constexpr double kReach = 2.2;  // standard deviations
  if (!(smoothing_px > 0.0)) return {};
  const double sd = kWider * smoothing_px;
  const int reach = std::max(2, static_cast<int>(std::ceil(kReach * sd)));
  // Moments of the Gaussian on integer pixels, for a sum of 1 and the target variance.
  double moments[3] = {0, 0, 0};
  const auto gauss = [sd](int k) { return std::exp(-0.5 * k * k / (sd * sd)); };
  for (int k = -reach; k <= reach; ++k) {
    const double square = static_cast<double>(k) * k;
    moments[0] += gauss(k);
    moments[1] += gauss(k) * square;
    moments[2] += gauss(k) * square * square;
  }
  Eigen::Matrix2d system;
  system << moments[0], moments[1], moments[1], moments[2];
  const Eigen::Vector2d part = system.inverse() * Eigen::Vector2d(1.0, -kOpticsPx2);
  Smoothing smoothing{{}, -kOpticsPx2};
  for (int k = 0; k <= reach; ++k)
    smoothing.weights.push_back(gauss(k) * (part[0] + part[1] * k * k));
  return smoothing;
}

Smoothing gaussian_smoothing(double smoothing_px) {
  if (!(smoothing_px > 0.0)) return {};
  const int reach = static_cast<int>(std::ceil(2.0 * smoothing_px));
  Smoothing smoothing{{}, 0.0};
  double sum = 0;
  for (int k = 0; k <= reach; ++k) {
    const double weight = std::exp(-0.5 * k * k / (smoothing_px * smoothing_px));
    smoothing.weights.push_back(weight);
    sum += (k == 0 ? 1.0 : 2.0) * weight;
    smoothing.variance_px2 += 2.0 * weight * k * k;
  }
  smoothing.variance_px2 /= sum;
  for (double& weight : smoothing.weights) weight /= sum;
  return smoothing;
}

}  // namespace alltact
