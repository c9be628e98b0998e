#include "calibration/report/contact_error.h"

#include "calibration/joint/verdict.h"
#include "core/numerics/median.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/depth/local_depth.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kInContactMm = 0.1;

/// Mean standard deviation at the middles of a contact's samples; NaN where there is none.
double mean_sd_mm(const ComparedPress& compared,
                  const PressResiduals& contact,
                  const Mapping& mapping) {
  const auto& [press, reference] = compared;
  Difference difference = press->difference;
  cv::Mat1b wanted = cv::Mat1b::zeros(difference.x.size());
  for (const ResidualSample& sample : contact.samples)
    if (sample.ball_depth_mm > kInContactMm)
      wanted(static_cast<int>(sample.pixel.y()), static_cast<int>(sample.pixel.x())) = 1;
  // Depth costs most where something presses, and only this contact is asked for.
  constexpr int kAround = 40;  // px: further than a layer's thickness moves a place
  const cv::Rect box = cv::boundingRect(wanted);
  const cv::Rect near =
      cv::Rect(box.tl() - cv::Point(kAround, kAround), box.br() + cv::Point(kAround, kAround)) &
      cv::Rect({0, 0}, wanted.size());
  cv::Mat x(difference.x.size(), CV_32FC1, cv::Scalar(NAN));
  press->difference.x(near).copyTo(x(near));
  difference.x = x;
  DepthMap depth = depth_map(difference, mapping, press->shape);
  depth.live_sd = difference.grey_sd / std::hypot(1.0, reference->noise_gain);
  // Of poses that the recording shows: how far the finger gives way is each contact's own affair.
  Reference known = *reference;
  known.error_factor = std::min(known.error_factor, 1.0);
  known.outer_error_factor = std::min(known.outer_error_factor, 1.0);
  DepthError error(depth, known, press->shape, mapping);
  double sum = 0;
  int count = 0;
  for (int v = 0; v < wanted.rows; ++v) {
    if (cv::countNonZero(wanted.row(v)) == 0) continue;
    error.row(v, [&](int u, const DepthCauses& causes) {
      if (wanted(v, u) == 0) return;
      sum += causes.total();
      ++count;
    });
  }
  return sum / count;
}

}  // namespace

double contact_error_mm(const std::vector<ComparedPress>& presses,
                        const std::vector<PressResiduals>& contacts,
                        const MappingParameters& parameters) {
  const auto mapping = Mapping::create(parameters);
  if (!mapping) return 0.0;
  std::vector<double> errors_mm;
  for (const PressResiduals& contact : contacts) {
    const auto compared =
        std::find_if(presses.begin(), presses.end(), [&](const ComparedPress& one) {
          return one.press->name == contact.press;
        });
    if (compared == presses.end()) continue;
    const double sd_mm = mean_sd_mm(*compared, contact, *mapping);
    if (std::isfinite(sd_mm)) errors_mm.push_back(kMeanOfSd * sd_mm);
  }
  return upper_median(errors_mm);
}

}  // namespace alltact
