#include "core/sensing/depth_sd.h"

#include "core/sensing/grey_steps.h"

#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr int kTable = 512;

/// What the mapping says of a depth that it gives: the difference, and its slope there.
class Curve {
 public:
  explicit Curve(const Mapping& mapping) : step_mm_(mapping.depth_mm(mapping.x_max()) / kTable) {
    for (int i = 0; i <= kTable; ++i) {
      const double x = mapping.difference_at(i * step_mm_);
      x_.push_back(x);
      slope_mm_.push_back(mapping.slope_mm(x));
    }
  }
  struct At {
    double x, slope_mm;
  };
  /// Beyond the domain the curve goes on straight.
  [[nodiscard]] At at(double depth_mm) const {
    const double end_mm = step_mm_ * kTable;
    if (depth_mm >= end_mm)
      return {x_.back() + (depth_mm - end_mm) / slope_mm_.back(), slope_mm_.back()};
    const double place = std::max(0.0, depth_mm) / step_mm_;
    const auto i = static_cast<std::size_t>(place);
    const double part = place - static_cast<double>(i);
    const auto between = [&](const std::vector<double>& values) {
      return values[i] + part * (values[i + 1] - values[i]);
    };
    return {between(x_), between(slope_mm_)};
  }

 private:
  double step_mm_;
  std::vector<double> x_, slope_mm_;
};

}  // namespace

cv::Mat depth_sd_mm(const DepthMap& depth,
                    const Reference& reference,
                    const FaceShape& shape,
                    const Mapping& mapping) {
  const cv::Mat& mm = depth.depth_mm;
  CV_Assert(mm.type() == CV_32FC1 && mm.size() == reference.picture.size());
  const MappingParameters& parameters = mapping.parameters();
  const std::vector<float> along_z =
      parameters.along == MappingAlong::kZ
          ? std::vector<float>(static_cast<std::size_t>(mm.cols), 1.0F)
          : shape.along_z_per_normal();
  const Curve curve(mapping);
  ReferencePicture::Reader reader(reference.picture);
  cv::Mat sd(mm.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  for (int v = 0; v < mm.rows; ++v) {
    const float* row = mm.ptr<float>(v);
    const FaceRun whole{v, 0, mm.cols, 0};
    const std::int16_t* grey = reader.row(v, {&whole, 1});
    for (int u = 0; u < mm.cols; ++u) {
      if (!std::isfinite(row[u]) || grey[u] == kNoGrey || grey[u] <= 0) continue;
      const Eigen::Vector2d place = shape.place_mm(u, v);
      const double longer = static_cast<double>(along_z[static_cast<std::size_t>(u)]);
      const double factor = parameters.variation.at(place);
      const auto [x, slope_mm] = curve.at(static_cast<double>(row[u]) / (longer * factor));
      const double level = static_cast<double>(grey[u]) / kGreySteps;
      const double noise = factor * slope_mm * depth.live_sd / level *
                           std::hypot(1.0, (1.0 - x) * reference.noise_gain);
      sd.at<float>(v, u) =
          static_cast<float>(longer * std::hypot(noise, mapping.depth_sd_mm(x, place)));
    }
  }
  return sd;
}

}  // namespace alltact
