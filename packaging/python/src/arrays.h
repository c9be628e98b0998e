// Images as NumPy arrays and back, in the same memory.
#pragma once

#include "core/image/frame.h"

#include <memory>

#include <opencv2/core.hpp>
#include <pybind11/numpy.h>

namespace alltact::python {

namespace py = pybind11;

/// A read-only array [v, u] or [v, u, channel] over the image's memory, which lives as long as the
/// array. `owner`: owner of the memory where it is not the image's; None for an empty image.
[[nodiscard]] py::object array_of(const cv::Mat& image,
                                  std::shared_ptr<const void> owner = nullptr);

/// The array's memory as a frame, which holds the array. Throws Failure for anything but uint8 [v,
/// u] with contiguous rows.
[[nodiscard]] std::shared_ptr<Frame> frame_over(const py::object& image);

/// A depth map's memory, without holding it. Throws Failure for anything but float32 [v, u] with
/// contiguous rows.
[[nodiscard]] cv::Mat depth_over(const py::object& depth);

}  // namespace alltact::python
