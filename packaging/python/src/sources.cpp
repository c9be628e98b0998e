#include "packaging/python/src/sources.h"

#include "core/image/image_file.h"
#include "core/open/open_source.h"
#include "core/sources/file_source.h"

#include "packaging/python/src/arrays.h"
#include "packaging/python/src/module.h"
#include <pybind11/stl.h>

namespace alltact::python {
namespace {

namespace fs = std::filesystem;

OpenSourcePtr open(const std::vector<fs::path>& inputs, Pace pace, std::uint64_t seed) {
  auto opened = std::make_shared<OpenSource>();
  SourceOptions options;
  options.pace = pace;
  options.seed = seed;
  options.job = &opened->job;
  const py::gil_scoped_release others_may_run;
  opened->source = value_of(open_source(inputs, options));
  return opened;
}

FramePtr next_of(OpenSource& source) {
  const py::gil_scoped_release others_may_run;
  const std::lock_guard lock(source.reading);
  return value_of(source.get().next());
}

/// Any frame of a recording by its number.
struct Recording {
  RecordedFrames frames;
  std::mutex reading;
};

FramePtr frame_of(Recording& recording, py::ssize_t number) {
  const auto count = static_cast<py::ssize_t>(recording.frames.count());
  if (number < 0) number += count;
  if (number < 0 || number >= count) throw py::index_error("there is no such frame");
  const py::gil_scoped_release others_may_run;
  const std::lock_guard lock(recording.reading);
  return value_of(recording.frames.frame(static_cast<std::size_t>(number)));
}

py::object times_of(const Recording& recording) {
  const auto times = recording.frames.times_ns();
  if (!times) return py::none();
  return py::array_t<std::int64_t>(static_cast<py::ssize_t>(times->size()), times->data());
}

void bind_frame(py::module_& module) {
  Documented<Frame>(module, "Frame")
      .made_by(
          [](const py::object& grey, std::optional<std::int64_t> time_ns, const std::string& name,
             std::uint64_t sequence) {
            auto frame = frame_over(grey);
            frame->time_ns = time_ns;
            frame->name = name;
            frame->sequence = sequence;
            return frame;
          },
          py::arg("grey"), py::kw_only(), py::arg("time_ns") = py::none(),
          py::arg("name") = "frame", py::arg("sequence") = 0)
      .property("grey", [](const std::shared_ptr<Frame>& f) { return array_of(f->grey, f); })
      .property("name", [](const Frame& f) { return f.name; })
      .property("origin", [](const Frame& f) { return f.origin; })
      .property("sequence", [](const Frame& f) { return f.sequence; })
      .property("time_ns", [](const Frame& f) { return f.time_ns; })
      .property("controls", [](const Frame& f) {
        return f.controls ? std::optional(*f.controls) : std::nullopt;
      });
}

void bind_recording(py::module_& module) {
  Documented<Recording>(module, "Recording")
      .made_by(
          [](const fs::path& input) {
            const py::gil_scoped_release others_may_run;
            return std::shared_ptr<Recording>(
                new Recording{value_of(RecordedFrames::open(input, Job())), {}});
          },
          py::arg("path"))
      .method("__len__", [](const Recording& r) { return r.frames.count(); })
      .method(
          "__getitem__",
          [](Recording& r, py::ssize_t number) {
            return std::const_pointer_cast<Frame>(frame_of(r, number));
          },
          py::arg("number"))
      .property("times_ns", &times_of)
      .property("frames_per_s", [](const Recording& r) { return r.frames.frames_per_s(); })
      .property("is_continuous", [](const Recording& r) { return r.frames.is_continuous(); });
}

void bind_depth_files(py::module_& module) {
  function(
      module, "depth_tiff",
      [](const py::object& depth) { return py::bytes(depth_tiff(depth_over(depth))); },
      py::arg("depth"));
  function(
      module, "to_depth16",
      [](const py::object& depth) { return array_of(depth_steps(depth_over(depth))); },
      py::arg("depth"));
  function(
      module, "read_depth",
      [](const fs::path& folder, const std::string& frame) {
        return array_of(value_of(read_frame_depth(folder, frame)));
      },
      py::arg("folder"), py::arg("frame"));
}

}  // namespace

Source& OpenSource::get() {
  if (!source)
    throw Failure(
        {en::say("something else reads this source already"), "", en::say("opening it once more")});
  return *source;
}

std::vector<fs::path> paths_of(const py::object& given) {
  if (py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__"))
    return {given.cast<fs::path>()};
  return given.cast<std::vector<fs::path>>();
}

OpenSourcePtr source_of(const py::object& given, Pace pace) {
  if (py::isinstance<OpenSource>(given)) return given.cast<OpenSourcePtr>();
  return open(paths_of(given), pace, 1);
}

void bind_sources(py::module_& module) {
  bind_frame(module);
  Documented<OpenSource>(module, "Source")
      .property("is_live", [](OpenSource& s) { return s.get().is_live(); })
      .property("is_continuous", [](OpenSource& s) { return s.get().is_continuous(); })
      .property("frames_per_s", [](OpenSource& s) { return s.get().frames_per_s(); })
      .property("count", [](OpenSource& s) { return s.get().count(); })
      .iterates_over_itself()
      .method("__next__", [](OpenSource& s) {
        const FramePtr frame = next_of(s);
        if (!frame) throw py::stop_iteration();
        return std::const_pointer_cast<Frame>(frame);  // Python cannot write any of it
      });
  function(
      module, "open_source",
      [](const py::object& inputs, bool live, std::uint64_t seed) {
        return open(paths_of(inputs), live ? Pace::kRecorded : Pace::kOnDemand, seed);
      },
      py::arg("inputs"), py::kw_only(), py::arg("live") = false, py::arg("seed") = 1);
  bind_recording(module);
  bind_depth_files(module);
}

}  // namespace alltact::python
