// A finger that moves between three poses, and as it stands at any moment between.
#pragma once

#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {

inline const std::string kBend =
    "  - {use: bend, q1_mm: {from: -9, to: 9}, q2_mm: {from: -1, to: 1}}\n";
inline constexpr double kPoses[] = {-4, 2, 8};  // of frames 0, 1 and 2

inline std::string moving(const std::string& effects) {
  return "frames_per_s: 20\n"
         "motion: {kind: poses, poses: [{q1_mm: -4}, {q1_mm: 2}, {q1_mm: 8}]}\n" +
         scene_text(kBend + kFaceAndLamps + effects);
}
/// The finger as it stands at a moment, in frames.
inline cv::Mat_<float> still_at(double moment) {
  moment = std::max(moment, 0.0);
  const auto i = std::min(static_cast<std::size_t>(moment), std::size_t{1});
  const double q1 = kPoses[i] + (moment - static_cast<double>(i)) * (kPoses[i + 1] - kPoses[i]);
  return rendered(fmt::format("motion: {{kind: hold, pose: {{q1_mm: {:.15g}}}}}\n", q1) +
                  scene_text(kBend + kFaceAndLamps));
}

}  // namespace alltact
