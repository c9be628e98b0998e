// What a frame told, as Python holds it.
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

/// One frame's. What is dear is made when it is asked for, and kept.
struct MeasuredResult {
  FingerPtr finger;
  std::optional<FrameResult> result;  ///< absent: it could not be read or measured
  FramePtr frame;                     ///< null: it could not be read
  std::string line;                   ///< of results.jsonl
  cv::Mat points, sd, limits;
  py::object told;  ///< the line, parsed; null until it is asked for
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
