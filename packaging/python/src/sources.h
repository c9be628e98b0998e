// Frames and their sources, as Python holds them.
#pragma once

#include "core/base/job.h"
#include "core/image/frame.h"
#include "core/sources/source.h"

#include <memory>
#include <mutex>

#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

namespace alltact::python {

namespace py = pybind11;

/// A source and the job that ends its waits.
struct OpenSource {
  Job job;
  std::unique_ptr<Source> source;  // null once something else reads it
  std::mutex reading;

  ~OpenSource() { job.request_stop(); }
  /// Throws Failure where something else reads it.
  [[nodiscard]] Source& get();
};
using OpenSourcePtr = std::shared_ptr<OpenSource>;

/// Takes an open source, or opens a path or several. Throws Failure.
[[nodiscard]] OpenSourcePtr source_of(const py::object& given, Pace pace);

/// A path from Python (str or os.PathLike), or several.
[[nodiscard]] std::vector<std::filesystem::path> paths_of(const py::object& given);

}  // namespace alltact::python
