#include "calibration/twin/twin_noise.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kMaskPower = 36;        // sum of the squares of the second differences' weights
constexpr double kQuantised = 1.0 / 12;  // variance of rounding to integer grey levels
constexpr int kLevels = 12;              // groups by brightness
constexpr double kCut = 3.5;             // sd; larger second differences are structure, not noise
constexpr double kCutVariance = 0.9939;  // of a normal distribution truncated there

/// One second difference: its square as a variance, and the grey level.
struct Wiggle {
  double level, variance;
};

void collect(const cv::Mat& values,
             const cv::Mat& used,
             const cv::Mat& levels,
             double share,
             std::vector<Wiggle>& wiggles) {
  cv::Mat_<float> second;
  const cv::Mat mask = (cv::Mat_<float>(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
  cv::filter2D(values, second, CV_32F, mask);
  cv::Mat inner;
  cv::erode(used, inner, cv::Mat(), cv::Point(-1, -1), 1, cv::BORDER_CONSTANT, 0);
  for (int v = 1; v + 1 < second.rows; ++v)
    for (int u = 1; u + 1 < second.cols; ++u) {
      const float level = levels.at<float>(v, u);
      if (inner.at<std::uint8_t>(v, u) == 0 || level < 3 || level > 250) continue;
      const double wiggle = second(v, u);
      wiggles.push_back({level, share * wiggle * wiggle / kMaskPower});
    }
}

/// Removes dots, edges and scratches.
void cut(std::vector<Wiggle>& wiggles) {
  for (int round = 0; round < 4 && !wiggles.empty(); ++round) {
    double mean = 0;
    for (const Wiggle& one : wiggles) mean += one.variance / static_cast<double>(wiggles.size());
    std::erase_if(wiggles, [&](const Wiggle& one) { return one.variance > kCut * kCut * mean; });
  }
}

struct NoiseLaw {
  double constant = 0, per_level = 0, constant_sd = 0, per_level_sd = 0;
  double variance = 0, level = 0;  // at the mean brightness
  double count = 0;
};

/// variance = constant + per_level * level, from groups of equal number. A group's variance has a
/// relative sd of sqrt(2 / n), times the correlation of neighbouring second differences.
NoiseLaw law_of(std::vector<Wiggle> wiggles, double rounding) {
  cut(wiggles);
  NoiseLaw law;
  law.count = static_cast<double>(wiggles.size());
  if (wiggles.size() < 400) return law;
  std::sort(wiggles.begin(), wiggles.end(), [](const Wiggle& a, const Wiggle& b) {
    return a.level < b.level;
  });
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (int group = 0; group < kLevels; ++group) {
    const std::size_t first = wiggles.size() * group / kLevels;
    const std::size_t end = wiggles.size() * (group + 1) / kLevels;
    double level = 0, variance = 0;
    for (std::size_t i = first; i < end; ++i) {
      level += wiggles[i].level;
      variance += wiggles[i].variance / kCutVariance;
    }
    const auto n = static_cast<double>(end - first);
    level /= n, variance /= n;
    law.level += level / kLevels;
    law.variance += variance / kLevels;
    // 36^2 over the sum of the mask's squared autocorrelation: fewer independent values by 4900 /
    // 1296.
    const double sd = std::max(1e-3, variance) * std::sqrt(2 * 4900.0 / 1296 / n);
    const Eigen::Vector2d row(1, level);
    normal += row * row.transpose() / (sd * sd);
    right += row * (variance - rounding) / (sd * sd);
  }
  law.variance -= rounding;
  const Eigen::Matrix2d covariance = normal.inverse();
  const Eigen::Vector2d x = covariance * right;
  law.constant = x[0], law.per_level = x[1];
  law.constant_sd = std::sqrt(covariance(0, 0)), law.per_level_sd = std::sqrt(covariance(1, 1));
  return law;
}

cv::Mat as_float(const cv::Mat& grey) {
  cv::Mat result;
  grey.convertTo(result, CV_32F);
  return result;
}

cv::Mat smooth_levels(const cv::Mat& values) {
  cv::Mat result;
  cv::boxFilter(values, result, CV_32F, cv::Size(7, 7));
  return result;
}

void put_law(const NoiseLaw& law, TwinNoise& noise) {
  const double flat_sd = law.variance * std::sqrt(2 * 4900.0 / 1296 / std::max(1.0, law.count));
  noise.sd = std::sqrt(std::max(0.0, law.variance));
  if (law.per_level > 2.5 * law.per_level_sd && law.constant > -2 * law.constant_sd) {
    noise.shot_gain = law.per_level;
    noise.shot_gain_sd = law.per_level_sd;
    noise.read_sd = std::sqrt(std::max(0.0, law.constant));
    if (noise.read_sd > 0) noise.read_sd_sd = law.constant_sd / (2 * noise.read_sd);
    return;
  }
  noise.read_sd = noise.sd;
  if (noise.sd > 0) noise.read_sd_sd = flat_sd / (2 * noise.sd);
}

}  // namespace

TwinNoise measure_noise(const std::vector<NoisyImage>& alike,
                        const std::vector<NoisyImage>& singles,
                        const Message& what_is_alike) {
  TwinNoise noise;
  std::vector<Wiggle> single;
  for (const NoisyImage& one : singles) {
    const cv::Mat values = as_float(one.grey);
    collect(values, one.used, smooth_levels(values), 1, single);
  }
  const NoiseLaw spatial = law_of(single, kQuantised);
  if (alike.size() < 2) {
    put_law(spatial, noise);
    noise.from = en::say(
        "noise is told from single pictures: a fixed pattern of the camera cannot be told from "
        "noise "
        "in time");
    return noise;
  }
  std::vector<Wiggle> pairs;
  for (std::size_t i = 0; i + 1 < alike.size(); ++i) {
    const cv::Mat a = as_float(alike[i].grey), b = as_float(alike[i + 1].grey);
    cv::Mat used;
    cv::bitwise_and(alike[i].used, alike[i + 1].used, used);
    collect(a - b, used, smooth_levels(a), 0.5, pairs);
  }
  const NoiseLaw in_time = law_of(pairs, kQuantised);
  put_law(in_time, noise);
  noise.from = what_is_alike;
  const double fixed = spatial.variance - in_time.variance;
  const double fixed_sd = std::sqrt(2 * 4900.0 / 1296 / std::max(1.0, in_time.count)) *
                          std::hypot(spatial.variance, in_time.variance);
  if (fixed > 2 * fixed_sd && in_time.level > 0) {
    noise.prnu = std::sqrt(fixed) / in_time.level;
    noise.prnu_sd = fixed_sd / (2 * std::sqrt(fixed)) / in_time.level;
  }
  return noise;
}

}  // namespace alltact
