#include "calibration/presses/press_samples.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

/// Noise of block means: white noise has second differences of variance 6 sd^2, a smooth relief
/// nearly none.
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
  return 1.4826 * upper_median(differences) / std::sqrt(6.0);
}

/// Means of complete blocks; NaN where any pixel is (a NaN in a sum stays one).
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

/// Derivative of the untouched point by the pixel; zero where the face ends.
Eigen::Vector3d by_pixel(const FaceShape& shape,
                         const Face& face,
                         const Eigen::Vector2d& pixel,
                         const Eigen::Vector2d& step) {
  const Eigen::Vector2d from = pixel - step, to = pixel + step;
  const auto before = shape.at(from.x(), from.y()), after = shape.at(to.x(), to.y());
  if (!before || !after) return Eigen::Vector3d::Zero();
  return 0.5 * (untouched_point_mm(*after, face.layer_mm, MappingAlong::kNormal) -
                untouched_point_mm(*before, face.layer_mm, MappingAlong::kNormal));
}

PressSamples sample_in(const Press& press, const Face& face, const cv::Rect& box, int block_px) {
  PressSamples result;
  result.ball_radius_mm = press.ball_radius_mm;
  result.given_depth = press.given_depth;
  result.block_px = block_px;
  result.blur_px2 = press.difference.blur_px2 + block_px * block_px / 12.0;
  const cv::Mat means = block_means(press.difference.x(box), block_px);
  result.x_sd = noise_of(means);
  for (int row = 0; row < means.rows; ++row) {
    for (int column = 0; column < means.cols; ++column) {
      const double x = static_cast<double>(means.at<float>(row, column));
      if (!std::isfinite(x)) continue;
      const Eigen::Vector2d pixel(box.x + (column + 0.5) * block_px - 0.5,
                                  box.y + (row + 0.5) * block_px - 0.5);
      const auto local = press.shape.at(pixel.x(), pixel.y());
      if (!local) continue;
      Sample sample;
      sample.pixel = pixel;
      sample.untouched_z = untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ);
      sample.untouched_n = untouched_point_mm(*local, face.layer_mm, MappingAlong::kNormal);
      sample.normal = local->normal;
      sample.cos_incline = local->cos_incline;
      sample.x = x;
      sample.position_mm = press.shape.position_mm(pixel.x(), pixel.y());
      result.samples.push_back(sample);
    }
  }
  return result;
}

void retain_near(const Eigen::Vector3d& middle, double radius_mm, PressSamples* press) {
  std::erase_if(press->samples, [&](const Sample& s) {
    return !((s.untouched_n - middle).squaredNorm() <= radius_mm * radius_mm);
  });
}

}  // namespace

PressedArea pressed_area(const std::vector<const PressSamples*>& presses) {
  constexpr double kMinMm = 1.0;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const PressSamples* press : presses)
    for (const Sample& sample : press->samples) {
      low = low.cwiseMin(sample.position_mm);
      high = high.cwiseMax(sample.position_mm);
    }
  if (!low.allFinite()) return {};
  return {0.5 * (low + high), (0.5 * (high - low)).cwiseMax(kMinMm)};
}

void set_unit_positions(const PressedArea& part, PressSamples* press) {
  for (Sample& sample : press->samples)
    sample.unit_position = (sample.position_mm - part.middle_mm).cwiseQuotient(part.half_mm);
}

PressSamples sample_press(const Press& press, const Face& face, int block_px) {
  return sample_in(press, face, {{0, 0}, press.difference.x.size()}, block_px);
}

const Sample* nearest_sample(const PressSamples& press, const Eigen::Vector3d& point_mm) {
  const auto nearest = std::min_element(
      press.samples.begin(), press.samples.end(), [&](const Sample& a, const Sample& b) {
        return (a.untouched_n - point_mm).squaredNorm() < (b.untouched_n - point_mm).squaredNorm();
      });
  return nearest == press.samples.end() ? nullptr : &*nearest;
}

PressSamples sample_around(const Press& press,
                           const Face& face,
                           const Eigen::Vector3d& middle,
                           double radius_mm,
                           int limit) {
  // The approximate extent from a coarse sample, then blocks as fine as the limit allows.
  constexpr int kRough = 8;
  constexpr int kFinest = 2;
  PressSamples rough = sample_press(press, face, kRough);
  retain_near(middle, radius_mm + 0.01 * middle.norm(), &rough);
  if (rough.samples.empty()) return rough;
  Eigen::Vector2d low = rough.samples.front().pixel;
  Eigen::Vector2d high = low;
  for (const Sample& sample : rough.samples) {
    low = low.cwiseMin(sample.pixel);
    high = high.cwiseMax(sample.pixel);
  }
  const cv::Point first(static_cast<int>(low.x()) - 2 * kRough,
                        static_cast<int>(low.y()) - 2 * kRough);
  const cv::Point last(static_cast<int>(high.x()) + 2 * kRough,
                       static_cast<int>(high.y()) + 2 * kRough);
  const cv::Rect box = cv::Rect(first, last) & cv::Rect({0, 0}, press.difference.x.size());
  const double pixels = static_cast<double>(rough.samples.size()) * kRough * kRough;
  const int block = std::max(kFinest, static_cast<int>(std::ceil(std::sqrt(pixels / limit))));
  PressSamples near = sample_in(press, face, box, block);
  retain_near(middle, radius_mm, &near);
  for (Sample& sample : near.samples) {
    sample.by_u = by_pixel(press.shape, face, sample.pixel, {1, 0});
    sample.by_v = by_pixel(press.shape, face, sample.pixel, {0, 1});
  }
  return near;
}

}  // namespace alltact
