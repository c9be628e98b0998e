// A finger that tells forces.
#pragma once

#include "calibration/force/collect_force.h"
#include "calibration/force/train_force.h"
#include "core/finger/finger_store.h"
#include "tests/studio/studio_rig.h"

#include <filesystem>
#include <limits>

namespace alltact::test {

/// The calibrated finger with a force model. What was "pressed" is made up: proportional to the
/// mean way of the markers from where they rest, as a soft finger's would be.
class ForceFinger {
 public:
  static const ForceFinger& get() {
    static const ForceFinger finger;
    return finger;
  }
  static constexpr double kNewtonsPerPx = 0.25;

  [[nodiscard]] std::filesystem::path folder() const { return folder_ / "strong"; }
  [[nodiscard]] Eigen::Vector2d force_N(const Markers& markers) const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t m = 0; m < markers.size(); ++m)
      sum += Eigen::Vector2d(markers[m].u, markers[m].v) - rest_px_.at(m);
    return kNewtonsPerPx / static_cast<double>(markers.size()) * sum;
  }

 private:
  ForceFinger() {
    std::filesystem::copy(MadeFingers::get().calibrated(), folder(),
                          std::filesystem::copy_options::recursive);
    const FingerPtr finger = open_finger(folder()).value();
    rest_px_ = finger->finger.contact->rest_markers;
    const auto frames = marker_frames({MadeFingers::get().bending()}, *finger, Job()).value();
    ForceGauge gauge;
    gauge.has_block = true;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      GaugeReading reading;
      reading.frame = frames[i].name;
      reading.force_N.head<2>() = force_N(frames[i].markers);
      reading.block = std::to_string(i / 10);
      gauge.readings.push_back(std::move(reading));
    }
    ForceTraining quick;
    quick.comparison_only = true;
    quick.kind = ForceKind::kRidge;
    quick.network.steps = 20;
    quick.network.members = 1;
    const auto table = collect_force(frames, gauge);
    must(table ? Status() : Status(table.error()));
    const auto trained = train_finger_force(folder(), table->table, quick, Job());
    must(trained ? Status() : Status(trained.error()));
  }
  TemporaryFolder folder_;
  std::vector<Eigen::Vector2d> rest_px_;
};

}  // namespace alltact::test
