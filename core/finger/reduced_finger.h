// A finger as it is in pictures of fewer pixels.
#pragma once

#include "core/finger/finger_store.h"

namespace alltact {

/// With everything that stands in pixels (camera, markers at rest, places of poses) at the places
/// of pictures that are reduced (reduced_picture.h) by `by` pixels a side. The same finger where
/// `by` is 1, or it is reduced already, or its pictures would be smaller than any camera's (16 px).
[[nodiscard]] FingerSnapshot reduced_finger(const FingerSnapshot& finger, int by);

/// A raw picture turned as the finger's camera has it, and reduced as the finger is. Error: its
/// size is not that of the finger's camera, see oriented_for().
[[nodiscard]] Result<cv::Mat> picture_for(const FingerSnapshot& finger,
                                          const cv::Mat& raw,
                                          const Message& what,
                                          const Where& where,
                                          const Message& advice);

}  // namespace alltact
