// Pictures as NumPy sees them and back, in the same memory.
#pragma once

#include "core/frame.h"

#include <memory>

#include <opencv2/core.hpp>
#include <pybind11/numpy.h>

namespace alltact::python {

namespace py = pybind11;

/// A read-only array [v, u] or [v, u, channel] over the picture's memory, which lives as long as
/// the array. `owner` too, where the memory is another's; None for an empty picture.
[[nodiscard]] py::object array_of(const cv::Mat& picture,
                                  std::shared_ptr<const void> owner = nullptr);

/// The array's memory as a frame, which holds the array. Throws Failure for anything but uint8
/// [v, u] with pixels side by side.
[[nodiscard]] std::shared_ptr<Frame> frame_over(const py::object& picture);

/// A depth map's memory; nothing holds it. Throws Failure for anything but float32 [v, u] with
/// pixels side by side.
[[nodiscard]] cv::Mat depth_over(const py::object& depth);

}  // namespace alltact::python
