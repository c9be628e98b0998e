#include "calibration/contact_error.h"

#include "core/sensing/depth_sd.h"
#include "core/sensing/local_depth.h"

#include <cmath>

namespace alltact {
namespace {

constexpr double kInContactMm = 0.1;
constexpr int kEvery = 3;  // px in both directions: more say nothing new

}  // namespace

double contact_error_mm(const std::vector<TakenPress>& presses,
                        const MappingParameters& parameters) {
  const auto mapping = Mapping::create(parameters);
  if (!mapping) return 0.0;
  double sum = 0;
  int count = 0;
  for (const TakenPress& taken : presses) {
    if (!taken.left_out.empty() || !taken.press || !taken.reference) continue;
    const Difference& difference = taken.press->difference;
    DepthMap depth = depth_map(difference, *mapping, taken.press->shape);
    depth.live_sd = difference.grey_sd / std::hypot(1.0, taken.reference->noise_gain);
    DepthError error(depth, *taken.reference, taken.press->shape, *mapping);
    for (int v = 0; v < depth.depth_mm.rows; v += kEvery)
      error.row(v, [&](int u, const DepthCauses& causes) {
        if (u % kEvery != 0 || !(depth.depth_mm.at<float>(v, u) > kInContactMm)) return;
        sum += causes.total();
        ++count;
      });
  }
  constexpr double kMeanOfSd = 0.7978845608028654;  // sqrt(2 / pi)
  return count > 0 && std::isfinite(sum) ? kMeanOfSd * sum / count : 0.0;
}

}  // namespace alltact
