// The results of a frame, as Python holds them.
#pragma once

#include "core/finger/finger_store.h"
#include "core/sensing/pipeline.h"

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <pybind11/pybind11.h>

namespace alltact::python {

namespace py = pybind11;

/// The results of one frame. Expensive parts are made at first use and cached.
struct MeasuredResult {
  FingerPtr finger;
  std::optional<FrameResult> result;  ///< nullopt: it could not be read or measured
  FramePtr frame;                     ///< null: it could not be read
  std::string line;                   ///< of results.jsonl
  cv::Mat points, sd, limits;
  py::object parsed;  ///< the line, parsed; null until first use
};
using MeasuredResultPtr = std::shared_ptr<MeasuredResult>;

[[nodiscard]] MeasuredResultPtr measured(FingerPtr finger,
                                         FrameResult result,
                                         std::size_t index,
                                         ReferenceMethod method);
/// `frame`: may be null.
[[nodiscard]] MeasuredResultPtr not_measured(FingerPtr finger,
                                             FramePtr frame,
                                             std::size_t index,
                                             const Error& problem);

}  // namespace alltact::python
