// A finger that keeps a study, always the same one: times of the day would make other pictures.
#pragma once

#include "calibration/study/study_file.h"
#include "core/base/program.h"
#include "tests/studio/studio_rig.h"

namespace alltact::test {

/// What one setting changes of time (part of the base's) and error (factor).
struct MadeUpTrade {
  const char* name;
  const char* value;
  double more_time, error_factor;
};
inline constexpr MadeUpTrade kMadeUpTrades[] = {{"edge-method", "integer", -0.05, 1.6},
                                                {"edge-columns", "32", -0.12, 1.35},
                                                {"edge-columns", "16", -0.06, 1.05},
                                                {"edge-columns", "4", 0.08, 0.97},
                                                {"edge-columns", "2", 0.2, 0.95},
                                                {"profile-degree", "3", -0.03, 1.5},
                                                {"profile-degree", "5", -0.015, 1.1},
                                                {"profile-degree", "9", 0.03, 1.02},
                                                {"marker-method", "paper", -0.1, 1.2},
                                                {"marker-method", "network", 60, 0.99},
                                                {"reference-method", "single", -0.35, 3.5},
                                                {"reference-method", "nearest", -0.28, 1.6},
                                                {"light-change", "ignored", -0.08, 1.15},
                                                {"rays", "parallel", -0.05, 1.3},
                                                {"smoothing-px", "0", -0.2, 2.0},
                                                {"smoothing-px", "2", 0.12, 0.8},
                                                {"smoothing-px", "4", 0.3, 0.9}};

[[nodiscard]] inline AccuracyStudy made_up_study(const PipelineSettings& base,
                                                 const Finger& finger) {
  AccuracyStudy study;
  for (const PipelineSettings& choice : study_choices(base, StudyExtent::kQuick, finger)) {
    StudyRow row;
    row.settings = choice;
    row.frames = 9;
    row.time_ms = row.time_p95_ms = 3.2;
    double median_mm = 0.012;
    for (const auto& setting : pipeline_settings())
      for (const MadeUpTrade& trade : kMadeUpTrades)
        if (setting.get(choice) != setting.get(base) && setting.name == trade.name &&
            setting.get(choice) == trade.value) {
          row.time_ratio += trade.more_time;
          median_mm *= trade.error_factor;
        }
    row.depth = ErrorSpread{median_mm, 3.2 * median_mm};
    row.position_mm = 0.08;
    study.rows.push_back(row);
  }
  return study;
}

class MeasuredFinger {
 public:
  static const MeasuredFinger& get() {
    static const MeasuredFinger finger;
    return finger;
  }
  [[nodiscard]] std::filesystem::path folder() const { return folder_ / "calibrated"; }

 private:
  MeasuredFinger() {
    std::filesystem::copy(MadeFingers::get().calibrated(), folder(),
                          std::filesystem::copy_options::recursive);
    const FingerPtr finger = open_finger(folder()).value();
    must(store_study(finger, made_up_study({}, finger->finger), program_version()));
  }
  TemporaryFolder folder_;
};

}  // namespace alltact::test
