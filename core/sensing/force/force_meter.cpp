#include "core/sensing/force/force_meter.h"

#include <cmath>

namespace alltact {
namespace {

constexpr double kLongestGap = 5.0;  // creep times after which earlier frames are ignored

}  // namespace

ForceInput force_input(const ForceModel& model, const Markers& markers,
                       const std::optional<Eigen::Vector2d>& position_mm) {
  ForceInput input;
  const auto count = static_cast<Eigen::Index>(markers.size());
  input.displacement_px = Eigen::VectorXd::Zero(2 * count);
  input.seen = Eigen::VectorXd::Zero(count);
  for (Eigen::Index m = 0; m < count && m < static_cast<Eigen::Index>(model.rest_px.size()); ++m) {
    const Marker& marker = markers[static_cast<std::size_t>(m)];
    input.seen[m] = marker.seen ? 1 : 0;
    if (marker.seen)
      input.displacement_px.segment<2>(2 * m) =
          Eigen::Vector2d(marker.u, marker.v) - model.rest_px[static_cast<std::size_t>(m)];
  }
  input.position_mm = position_mm;
  return input;
}

Eigen::VectorXd CreepMean::operator()(const Eigen::VectorXd& displacement_px, double time_s) {
  const double step_s = time_s - last_s_;
  const bool is_new =
      mean_.size() != displacement_px.size() || !(step_s >= 0) || step_s > kLongestGap * creep_s_;
  last_s_ = time_s;
  if (is_new) {
    mean_ = displacement_px;
  } else {
    mean_ += -std::expm1(-step_s / creep_s_) * (displacement_px - mean_);
  }
  return displacement_px - mean_;
}

std::optional<Force> ForceMeter::operator()(const Markers& markers,
                                            const std::optional<Eigen::Vector2d>& position_mm,
                                            std::optional<double> time_s) {
  ForceInput input = force_input(*model_, markers, position_mm);
  if (input.seen.size() != model_->marker_count || input.seen.sum() < 0.5 ||
      !input.displacement_px.allFinite())
    return std::nullopt;
  if (model_->creep_s > 0 && time_s && std::isfinite(*time_s)) {
    model_->range.fill(input);
    input.crept_px = creep_(input.displacement_px, *time_s);
  }
  return (*model_)(std::move(input));
}

}  // namespace alltact
