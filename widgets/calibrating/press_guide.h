// What the live picture shows while presses are taken: where to press next and how deep, how deep
// it is now, and a ring that fills while the contact is held still.
#pragma once

#include "calibration/presses/press_plan.h"
#include "calibration/presses/press_taker.h"
#include "core/live/stationary_contact.h"
#include "widgets/calibrating/press_forecast.h"
#include "widgets/picture/image_view.h"

#include <optional>
#include <vector>

namespace alltact {

/// What is known of one live frame.
struct GuidedFrame {
  std::optional<PressTarget> target;        ///< none: enough are made
  std::optional<Eigen::Vector2d> at_px;     ///< where the picture shows it
  std::vector<Eigen::Vector2d> outline_px;  ///< of the contact as it will be
  std::optional<DarkPatch> contact;
  std::optional<double> depth_mm;  ///< of the contact now, about, along the normal
  double layer_mm = 0;
  double off_mm = 0;  ///< of the contact from where the press is wanted, along the face
  double held = 0;    ///< part of a burst that is there, [0, 1]
};

/// Where to press next: as a calibration, made or forecast, advises, else by the plan of a first
/// one. nullopt: enough. `shape`: of the face as it is now.
[[nodiscard]] std::optional<PressTarget> wanted_press(const PressDesk& desk,
                                                      const PressForecast& forecast,
                                                      const FaceShape& shape);

/// `held`: see GuidedFrame.
[[nodiscard]] GuidedFrame guided_frame(const FrameResult& result,
                                       const PressDesk& desk,
                                       const PressForecast& forecast,
                                       double held);

/// "Press here, 0.8 mm deep, now 0.5 mm: deeper." One sentence, for the picture and for readers.
[[nodiscard]] QString guide_words(const GuidedFrame& frame);

/// Why a press that is wanted is not taken yet, or was not; empty: none is wanted.
[[nodiscard]] QString waiting_words(PressTaker::State state);

[[nodiscard]] std::vector<Overlay> guide_overlays(const GuidedFrame& frame);

}  // namespace alltact
