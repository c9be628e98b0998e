#include "calibration/press_samples.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Noise of block means: white noise has second differences of variance 6 sd^2, and a smooth
/// relief has next to none.
double noise_of(const cv::Mat& means) {
  std::vector<double> differences;
  for (int row = 0; row < means.rows; ++row) {
    const float* x = means.ptr<float>(row);
    for (int u = 1; u + 1 < means.cols; ++u) {
      const double second = x[u - 1] - 2.0 * x[u] + x[u + 1];
      if (std::isfinite(second)) differences.push_back(std::abs(second));
    }
  }
  if (differences.size() < 20) return 0.0;
  return 1.4826 * median(differences) / std::sqrt(6.0);
}

/// Means of whole blocks; NaN where any pixel is (a NaN in a sum stays one).
cv::Mat block_means(const cv::Mat& x, int block) {
  cv::Mat means(x.rows / block, x.cols / block, CV_32FC1);
  for (int row = 0; row < means.rows; ++row) {
    for (int column = 0; column < means.cols; ++column) {
      double sum = 0;
      for (int v = row * block; v < (row + 1) * block; ++v) {
        const float* line = x.ptr<float>(v) + column * block;
        for (int u = 0; u < block; ++u) sum += static_cast<double>(line[u]);
      }
      means.at<float>(row, column) = static_cast<float>(sum / (block * block));
    }
  }
  return means;
}

}  // namespace

PressSamples sample_press(const Press& press, const Face& face, int block_px) {
  PressSamples result;
  result.block_px = block_px;
  const cv::Mat means = block_means(press.difference.x, block_px);
  result.x_sd = noise_of(means);
  double area_mm2 = 0;
  for (int row = 0; row < means.rows; ++row) {
    for (int column = 0; column < means.cols; ++column) {
      const double x = static_cast<double>(means.at<float>(row, column));
      if (!std::isfinite(x)) continue;
      const Eigen::Vector2d pixel((column + 0.5) * block_px - 0.5, (row + 0.5) * block_px - 0.5);
      const auto local = press.shape.at(pixel.x(), pixel.y());
      if (!local) continue;
      Sample sample;
      sample.pixel = pixel;
      sample.face_mm = {press.shape.length_at(pixel.x()), local->view_point_mm.y()};
      sample.untouched_z = untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ);
      sample.untouched_n = untouched_point_mm(*local, face.layer_mm, MappingAlong::kNormal);
      sample.normal = local->normal;
      sample.cos_incline = local->cos_incline;
      sample.x = x;
      area_mm2 += local->area_mm2;
      result.samples.push_back(sample);
    }
  }
  if (!result.samples.empty())
    result.block_mm = block_px * std::sqrt(area_mm2 / static_cast<double>(result.samples.size()));
  return result;
}

PressSamples sample_around(const Press& press,
                           const Face& face,
                           const Eigen::Vector3d& middle,
                           double radius_mm,
                           int limit) {
  const auto keep_near = [&](int block_px) {
    PressSamples near = sample_press(press, face, block_px);
    std::erase_if(near.samples, [&](const Sample& s) {
      return !((s.untouched_n - middle).squaredNorm() <= radius_mm * radius_mm);
    });
    return near;
  };
  PressSamples near = keep_near(4);
  const double excess = static_cast<double>(near.samples.size()) / limit;
  if (excess <= 1.0) return near;
  return keep_near(static_cast<int>(std::ceil(4.0 * std::sqrt(excess))));
}

}  // namespace alltact
