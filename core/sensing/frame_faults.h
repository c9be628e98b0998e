// Faults of a full frame, as sentences for a person.
#pragma once

#include "core/frame.h"
#include "core/message.h"
#include "core/sensing/depth/light_gain.h"
#include "core/sensing/depth/pixel_flags.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Checks an image before anything is found in it. Three faults are reported:
/// - black: its brightest thousandth lies below 16 grey levels;
/// - saturated: over a third of it lies at kClippedFrom of grey_range.h or above;
/// - blank: all of it lies within 3 neighbouring grey levels, except a thousandth on either side.
///   Noise alone spans more.
/// Reads every eighth pixel of every eighth row. grey: CV_8UC1.
[[nodiscard]] std::optional<Message> image_fault(const cv::Mat& grey);

/// True when `now` is `before` read again and not the camera's next frame. Either both share their
/// memory, or both state an origin and agree in origin, name, number and time of capture (a
/// recording's frame that was read twice).
[[nodiscard]] bool is_same_frame(const Frame& before, const Frame& now);

/// True when both images agree to the last grey level, which no two exposures do.
[[nodiscard]] bool is_same_image(const cv::Mat& a, const cv::Mat& b);

/// Faults of a measured face:
/// - its end is hidden, however little of it;
/// - more than a fiftieth of it is saturated, or unknown to its reference;
/// - it is far darker (by half) or brighter (by a third) than its reference recording;
/// - more than a tenth of it is brighter than its reference, so that it is another finger's face.
///   Contacts only darken.
[[nodiscard]] std::vector<Message> face_faults(const FlagFractions& shares, const LightGain& light);

}  // namespace alltact
