#include "calibration/joint/spread_shapes.h"

#include "calibration/joint/mapping_curve.h"

#include <algorithm>
#include <string>
#include <utility>

namespace alltact {
namespace {

/// The domain of a curve that reads these presses: their greatest difference.
double largest_difference(const std::vector<Press>& presses, const Face& face) {
  double x_max = 0;
  for (const Press& press : presses)
    for (const Sample& sample : sample_for_body(press, face).samples)
      x_max = std::max(x_max, sample.x);
  return x_max;
}

}  // namespace

SpreadShapes::SpreadShapes(const std::vector<Press>& presses, const Face& face, const Job& job)
    : face_(face), job_(job) {
  for (const Press& press : presses)
    if (!press.is_ball()) presses_.push_back(press);
}

void SpreadShapes::find(const std::vector<Press>& local, const MappingCurve& curve) {
  shapes_ = find_steps(local, face_, &left_out_);
  // The curve of spread light varies with nothing that positions in an area give.
  for (KnownShape& body :
       find_bodies(local, face_, {}, curve, MappingAlong::kNormal, job_, &left_out_))
    shapes_.push_back(std::move(body));
  is_found_ = true;
}

std::vector<ScaleSeen> SpreadShapes::read(const MappingParameters& mapping) {
  if (presses_.empty()) return {};
  std::vector<Press> local;
  for (const Press& press : presses_) local.push_back(without_light_spread(press, mapping));
  MappingParameters over_domain = mapping;
  over_domain.x_max = largest_difference(local, face_);
  const MappingCurve curve = curve_of(over_domain);
  if (!is_found_) find(local, curve);
  std::vector<ScaleSeen> seen;
  for (KnownShape& shape : shapes_) {
    const std::string& name = press_of(shape);
    const auto press = std::find_if(local.begin(), local.end(),
                                    [&](const Press& one) { return one.name == name; });
    update_brightness(press->difference.x, &samples_of(shape));
    const ScaleReading reading =
        read_scale(shape, curve, curve.values().data(), MappingAlong::kNormal);
    seen.push_back({reading.scale, reading.sd});
  }
  return seen;
}

}  // namespace alltact
