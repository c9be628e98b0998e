// What is wrong with a frame as a whole, as sentences for a person.
#pragma once

#include "core/frame.h"
#include "core/message.h"
#include "core/sensing/depth/light_gain.h"
#include "core/sensing/depth/pixel_flags.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Of a picture in which nothing was found yet: black (its brightest thousandth below 16 grey
/// levels), saturated (kClippedFrom of grey_range.h and above) over more than a third, or blank
/// (but for a thousandth on either side all of it within 3 neighbouring grey levels, where noise
/// alone spans more). Looks at every eighth pixel of every eighth row. grey: CV_8UC1.
[[nodiscard]] std::optional<Message> picture_fault(const cv::Mat& grey);

/// True when `now` is `before` looked at again rather than the camera's next: it shares its memory,
/// or both say where they come from and agree in origin, name, number and time of capture (a
/// recording's frame that was read a second time).
[[nodiscard]] bool is_same_frame(const Frame& before, const Frame& now);

/// True when both pictures are the same to the last grey level, which no two exposures are.
[[nodiscard]] bool is_same_picture(const cv::Mat& a, const cv::Mat& b);

/// What a measured face tells: its end hidden, however little of it; saturated or unknown to its
/// reference over more than a fiftieth of it; far brighter or darker than when that was recorded
/// (by half, or a third), or so much of it brighter than its reference (a tenth) that it is another
/// finger's. Contacts only darken.
[[nodiscard]] std::vector<Message> face_faults(const FlagShares& shares, const LightGain& light);

}  // namespace alltact
