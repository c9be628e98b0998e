// Guidance in the live image while presses are collected: the next position and depth, the present
// depth, and a ring that fills while the contact is still.
#pragma once

#include "calibration/presses/guided_presses.h"
#include "core/sensing/stationary_contact.h"
#include "widgets/calibrating/calibration_run.h"
#include "widgets/image/image_view.h"

#include <optional>
#include <vector>

namespace alltact {

/// Guidance for one live frame.
struct PressGuidance {
  std::optional<PressTarget> target;         ///< none: there are enough presses
  std::optional<Eigen::Vector2d> target_px;  ///< where the target appears in the image
  std::vector<Eigen::Vector2d> outline_px;   ///< rim of the contact to be made
  std::optional<DarkPatch> contact;
  std::optional<double> depth_mm;  ///< approximate depth of the present contact, along the normal
  double layer_mm = 0;
  double lateral_offset_mm = 0;  ///< from the target to the contact, along the face
  double hold_fraction = 0;      ///< fraction of the burst of frames captured so far, [0, 1]
};

/// Next press: advised by the calibration or its forecast, else by the plan for a first
/// calibration. nullopt: enough presses. `shape`: the face in the present frame.
[[nodiscard]] std::optional<PressTarget> target_press(const PressCollection& collection,
                                                      const PressForecast& forecast,
                                                      const FaceShape& shape);

/// The last argument: see PressGuidance.
[[nodiscard]] PressGuidance guidance_of(const FrameResult& result,
                                        const PressCollection& collection,
                                        const PressForecast& forecast, double hold_fraction);

/// One sentence for the image and for screen readers: "Press here, 0.8 mm deep, now 0.5 mm:
/// deeper."
[[nodiscard]] QString guide_words(const PressGuidance& frame);

/// Why a requested press is not taken yet, or was not; empty: none is requested.
[[nodiscard]] QString waiting_words(PressTaker::State state);

[[nodiscard]] std::vector<Overlay> guide_overlays(const PressGuidance& frame);

}  // namespace alltact
