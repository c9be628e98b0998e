#include "calibration/report/contact_error.h"

#include "calibration/verdict/verdict.h"
#include "core/numerics/median.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/depth/local_depth.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kInContactMm = 0.1;

/// Means over a contact's samples; NaN where there is none.
struct MeanSd {
  double all_mm = 0, without_mapping_mm = 0;
};
MeanSd mean_sd(const ComparedPress& compared,
               const PressResiduals& contact,
               const Mapping& mapping) {
  const auto& [press, reference] = compared;
  Difference difference = press->difference;
  cv::Mat1b mask = cv::Mat1b::zeros(difference.x.size());
  for (const ResidualSample& sample : contact.samples)
    if (sample.ball_depth_mm > kInContactMm)
      mask(static_cast<int>(sample.pixel.y()), static_cast<int>(sample.pixel.x())) = 1;
  // Depth is computed around this contact only, to save time.
  constexpr int kAround = 40;  // px: further than a layer's thickness displaces a point
  const cv::Rect box = cv::boundingRect(mask);
  const cv::Rect near =
      cv::Rect(box.tl() - cv::Point(kAround, kAround), box.br() + cv::Point(kAround, kAround)) &
      cv::Rect({0, 0}, mask.size());
  cv::Mat x(difference.x.size(), CV_32FC1, cv::Scalar(NAN));
  press->difference.x(near).copyTo(x(near));
  difference.x = x;
  DepthMap depth = depth_map(difference, mapping, press->shape);
  depth.live_sd = difference.grey_sd / std::hypot(1.0, reference->noise_gain);
  // With the errors of recorded poses: how far the finger deflects differs from contact to contact.
  Reference known = *reference;
  known.error_factor = std::min(known.error_factor, 1.0);
  known.outer_error_factor = std::min(known.outer_error_factor, 1.0);
  DepthErrorModel error(depth, known, press->shape, mapping);
  MeanSd sum;
  int count = 0;
  for (int v = 0; v < mask.rows; ++v) {
    if (cv::countNonZero(mask.row(v)) == 0) continue;
    error.row(v, [&](int u, const DepthErrorTerms& causes) {
      if (mask(v, u) == 0) return;
      sum.all_mm += causes.total();
      DepthErrorTerms others = causes;
      others.mapping = 0;
      sum.without_mapping_mm += others.total();
      ++count;
    });
  }
  return {sum.all_mm / count, sum.without_mapping_mm / count};
}

}  // namespace

ContactError contact_error(const std::vector<ComparedPress>& presses,
                           const std::vector<PressResiduals>& contacts,
                           const MappingParameters& parameters) {
  const auto mapping = Mapping::create(parameters);
  if (!mapping) return {};
  std::vector<double> all_mm, others_mm;
  for (const PressResiduals& contact : contacts) {
    const auto compared =
        std::find_if(presses.begin(), presses.end(), [&](const ComparedPress& one) {
          return one.press->name == contact.press;
        });
    if (compared == presses.end()) continue;
    const MeanSd sd = mean_sd(*compared, contact, *mapping);
    if (!std::isfinite(sd.all_mm)) continue;
    all_mm.push_back(kMeanOfSd * sd.all_mm);
    others_mm.push_back(sd.without_mapping_mm);
  }
  return {upper_median(all_mm), upper_median(others_mm)};
}

}  // namespace alltact
