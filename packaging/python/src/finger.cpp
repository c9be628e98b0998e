// The results of a frame, as Python holds them.
#include "calibration/export/export_texts.h"
#include "calibration/finger/measuring_presets.h"
#include "calibration/live/watched_finger.h"
#include "core/batch/batch.h"
#include "core/finger/finger_store.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/frame_result.h"
#include "core/sensing/result_json.h"
#include "core/sources/source.h"

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "packaging/python/src/arrays.h"
#include "packaging/python/src/module.h"
#include "packaging/python/src/sources.h"
#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace alltact::python {
namespace {

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

using ResultPtr = MeasuredResultPtr;

py::object parsed_line(MeasuredResult& result) {
  if (!result.parsed) result.parsed = py::module_::import("json").attr("loads")(result.line);
  return result.parsed;
}

/// The value under a key; `absent` where there is none.
py::object parsed_value(MeasuredResult& result, const char* key, py::object absent = py::none()) {
  return parsed_line(result).attr("get")(key, std::move(absent));
}

py::object depth_of(const ResultPtr& r) {
  return r->result && r->result->depth ? array_of(r->result->depth->depth_mm, r) : py::none();
}

py::object flags_of(const ResultPtr& r) {
  return r->result && r->result->depth ? array_of(r->result->depth->flags, r) : py::none();
}

py::object points_of(const ResultPtr& r) {
  if (!r->result || !r->result->depth) return py::none();
  if (r->points.empty()) r->points = contact_face_points_mm(*r->result, r->finger->finger.face);
  return array_of(r->points, r);
}

/// Returns whether both could be made.
bool make_sd_and_limits(MeasuredResult& r) {
  if (!r.result || !r.result->depth || !r.result->reference || !r.finger->mapping) return false;
  if (!r.sd.empty()) return true;
  const FrameResult& f = *r.result;
  DepthSdAndLimits made = depth_sd_and_limits(*f.depth, *f.reference, *f.shape, *r.finger->mapping);
  r.sd = std::move(made.sd_mm);
  r.limits = std::move(made.limits);
  return true;
}

py::object sd_of(const ResultPtr& r) {
  return make_sd_and_limits(*r) ? array_of(r->sd, r) : py::none();
}

py::object limits_of_result(const ResultPtr& r) {
  return make_sd_and_limits(*r) ? array_of(r->limits, r) : py::none();
}

/// [marker, (u, v)]
py::object markers_of(const MeasuredResult& r) {
  if (!r.result || !r.result->markers) return py::none();
  const Markers& markers = *r.result->markers;
  py::array_t<double> positions({markers.size(), std::size_t{2}});
  auto at = positions.mutable_unchecked<2>();
  for (py::ssize_t m = 0; m < at.shape(0); ++m) {
    at(m, 0) = markers[static_cast<std::size_t>(m)].u;
    at(m, 1) = markers[static_cast<std::size_t>(m)].v;
  }
  return positions;
}

py::object seen_of(const MeasuredResult& r) {
  if (!r.result || !r.result->markers) return py::none();
  const Markers& markers = *r.result->markers;
  py::array_t<bool> seen(static_cast<py::ssize_t>(markers.size()));
  auto at = seen.mutable_unchecked<1>();
  for (py::ssize_t m = 0; m < at.shape(0); ++m) at(m) = markers[static_cast<std::size_t>(m)].seen;
  return seen;
}

py::object grey_of(const ResultPtr& r) {
  if (r->result) return array_of(r->result->grey, r);
  return r->frame ? array_of(r->frame->grey, r) : py::none();
}

MeasuredResultPtr measured(FingerPtr finger, FrameResult result, std::size_t index,
                           ReferenceMethod method) {
  auto made = std::make_shared<MeasuredResult>();
  made->finger = std::move(finger);
  made->frame = result.frame;
  made->line = result_line(result, index, method);
  made->result = std::move(result);
  return made;
}

/// `frame`: may be null.
MeasuredResultPtr not_measured(FingerPtr finger, FramePtr frame, std::size_t index,
                               const Error& problem) {
  auto made = std::make_shared<MeasuredResult>();
  made->finger = std::move(finger);
  made->line =
      failure_line(frame ? frame->name : frame_name(problem, index), index, {as_sentence(problem)});
  made->frame = std::move(frame);
  return made;
}

}  // namespace

void bind_results(py::module_& module) {
  Documented<MeasuredResult>(module, "Result")
      .property("frame",
                [](const MeasuredResult& r) { return std::const_pointer_cast<Frame>(r.frame); })
      .property("line", [](const MeasuredResult& r) { return r.line; })
      .property("told", &parsed_line)
      .property("grey", &grey_of)
      .property("depth", &depth_of)
      .property("flags", &flags_of)
      .property("points", &points_of)
      .property("depth_sd", &sd_of)
      .property("limits", &limits_of_result)
      .property("markers", &markers_of)
      .property("markers_seen", &seen_of)
      .property("contact", [](MeasuredResult& r) { return parsed_value(r, "finger_contact"); })
      .property("push", [](MeasuredResult& r) { return parsed_value(r, "contact"); })
      .property("regions", [](MeasuredResult& r) { return parsed_value(r, "regions", py::list()); })
      .property("force", [](MeasuredResult& r) { return parsed_value(r, "force"); })
      .property("problems",
                [](MeasuredResult& r) { return parsed_value(r, "problems", py::list()); })
      .property("times_ms",
                [](MeasuredResult& r) { return parsed_value(r, "times_ms", py::dict()); })
      .property("finger_revision", [](const MeasuredResult& r) { return r.finger->revision; });
}

// A finger that measures: single images, recordings as the command line does, live sources.

namespace {

namespace fs = std::filesystem;

/// The settings that a finger is measured with, as its folder has them now.
struct RequestedSettings {
  fs::path folder;
  std::string preset;
  std::vector<std::pair<std::string, std::string>> given;

  [[nodiscard]] Result<PipelineSettings> now() const {
    PipelineSettings settings;
    if (preset.empty()) {
      auto presets = presets_of_finger(folder);
      if (!presets) return presets.error();
      settings = presets->now;
    } else {
      auto named = preset_settings(folder, preset);
      if (!named) return named.error();
      settings = *named;
    }
    for (const auto& [name, value] : given) {
      const auto taken = take_setting(pipeline_settings(), name, value, settings);
      if (!taken) return taken.error();
      if (!*taken) return no_setting(name, names_of(pipeline_settings()));
    }
    return settings;
  }
  [[nodiscard]] Result<Pipeline> pipeline(const FingerSnapshot& finger, const Job& job) const {
    const auto settings = now();
    if (!settings) return settings.error();
    return finger.finger.reference ? Pipeline::create(finger, *settings, job)
                                   : Pipeline::without_reference(finger, *settings);
  }
};

/// A finger as it was when it was loaded.
struct OpenFinger {
  RequestedSettings requested;
  FingerPtr finger;
  std::mutex measuring;  // over:
  std::optional<Pipeline> pipeline;
  std::size_t index = 0;
};
using OpenFingerPtr = std::shared_ptr<OpenFinger>;

std::string words_of(const py::handle& value) { return py::str(value).cast<std::string>(); }

OpenFingerPtr load(const fs::path& folder, const std::string& preset, const py::kwargs& settings) {
  auto open = std::make_shared<OpenFinger>();
  open->requested = {folder, preset, {}};
  for (const auto& [name, value] : settings)
    open->requested.given.emplace_back(words_of(name), words_of(value));
  const py::gil_scoped_release others_may_run;
  open->finger = value_of(alltact::open_finger(folder));
  open->pipeline = value_of(open->requested.pipeline(*open->finger, Job()));
  return open;
}

/// A frame of its own or one made over an array.
FramePtr frame_to_measure(OpenFinger& open, const py::object& image,
                          std::optional<std::int64_t> time_ns, const std::string& name) {
  if (py::isinstance<Frame>(image)) return image.cast<std::shared_ptr<Frame>>();
  auto frame = frame_over(image);
  // Averaged frames must not change; the array is the caller's.
  if (open.pipeline->settings().average_frames > 1) frame->grey = frame->grey.clone();
  frame->time_ns = time_ns;
  frame->sequence = open.index;
  frame->name = name.empty() ? fmt::format("frame_{:05}", open.index) : name;
  return frame;
}

MeasuredResultPtr measure(OpenFinger& open, const py::object& image,
                          std::optional<std::int64_t> time_ns, const std::string& name) {
  FramePtr frame = frame_to_measure(open, image, time_ns, name);
  const py::gil_scoped_release others_may_run;
  const std::lock_guard lock(open.measuring);
  auto result = value_of((*open.pipeline)(frame));
  return measured(open.finger, std::move(result), open.index++,
                  open.pipeline->settings().reference);
}

/// Every frame of a source, as `alltact reconstruct` measures it.
class EveryFrame {
 public:
  EveryFrame(const OpenFinger& open, OpenSourcePtr source)
      : finger_(open.finger),
        source_(std::move(source)),
        frames_(value_of(open.requested.pipeline(*open.finger, Job())),
                source_->get().is_continuous()) {}

  /// Null after the last one.
  MeasuredResultPtr next() {
    const std::lock_guard lock(source_->reading);
    const auto frame = source_->get().next();
    if (frame && !*frame) return nullptr;
    const std::size_t index = index_++;
    if (!frame) {
      frames_.skip();
      return not_measured(finger_, nullptr, index, frame.error());
    }
    auto result = frames_(*frame);
    if (!result) return not_measured(finger_, *frame, index, result.error());
    return measured(finger_, std::move(*result), index, frames_.pipeline().settings().reference);
  }

 private:
  FingerPtr finger_;
  OpenSourcePtr source_;
  SequentialBatch frames_;
  std::size_t index_ = 0;
};

/// The newest frame of a source again and again, measured with the finger's current files.
class NewestFrame {
 public:
  NewestFrame(const OpenFinger& open, const OpenSourcePtr& source)
      : source_(source),
        finger_(value_of(WatchedFinger::open(
            open.requested.folder,
            [requested = open.requested](const FingerSnapshot& finger, const Job& job) {
              return requested.pipeline(finger, job);
            },
            Job()))) {
    static_cast<void>(source->get());  // or throws
    newest_.emplace(std::move(source->source));
  }
  ~NewestFrame() { close(); }

  MeasuredResultPtr next() {
    const std::lock_guard lock(reading_);
    if (!newest_) return nullptr;
    static_cast<void>(finger_->take_update());
    const auto now = std::make_shared<const FingerSnapshot>(finger_->finger());
    const auto frame = newest_->next();
    if (frame && !*frame) return nullptr;
    const std::size_t index = index_++;
    if (!frame) return not_measured(now, nullptr, index, frame.error());
    auto result = finger_->pipeline()(*frame);
    if (!result) return not_measured(now, *frame, index, result.error());
    return measured(now, std::move(*result), index, finger_->pipeline().settings().reference);
  }
  [[nodiscard]] std::uint64_t skipped() const { return newest_ ? newest_->skipped() : skipped_; }
  void close() {
    source_->job.request_stop();
    const std::lock_guard lock(reading_);
    skipped_ = skipped();
    newest_.reset();
  }

 private:
  OpenSourcePtr source_;  // its job
  std::unique_ptr<WatchedFinger> finger_;
  std::mutex reading_;
  std::optional<NewestSource> newest_;
  std::size_t index_ = 0;
  std::uint64_t skipped_ = 0;
};

/// Destroys it without the interpreter's lock, so that nobody waits for it.
template <class T>
std::shared_ptr<T> ended_apart(std::unique_ptr<T> frames) {
  return std::shared_ptr<T>(frames.release(), [](T* ending) {
    const py::gil_scoped_release others_may_run;
    delete ending;
  });
}

template <class T>
MeasuredResultPtr next_result(T& frames) {
  MeasuredResultPtr result;
  {
    const py::gil_scoped_release others_may_run;
    result = frames.next();
  }
  if (!result) throw py::stop_iteration();
  return result;
}

py::object parsed(const nlohmann::ordered_json& json) {
  return py::module_::import("json").attr("loads")(json.dump());
}

void bind_frames(py::module_& module) {
  Documented<EveryFrame>(module, "Reconstruction")
      .iterates_over_itself()
      .method("__next__", &next_result<EveryFrame>);
  Documented<NewestFrame>(module, "Stream")
      .iterates_over_itself()
      .method("__next__", &next_result<NewestFrame>)
      .property("skipped", &NewestFrame::skipped)
      .method("close", &NewestFrame::close, py::call_guard<py::gil_scoped_release>())
      .method("__enter__", [](const std::shared_ptr<NewestFrame>& f) { return f; })
      .method("__exit__", [](NewestFrame& f, const py::args&) {
        const py::gil_scoped_release others_may_run;
        f.close();
      });
}

void bind_facts(Documented<OpenFinger>& finger) {
  finger.property("folder", [](const OpenFinger& f) { return f.requested.folder; })
      .property("name", [](const OpenFinger& f) { return f.finger->finger.name; })
      .property("revision", [](const OpenFinger& f) { return f.finger->revision; })
      .property("is_calibrated", [](const OpenFinger& f) { return f.finger->mapping.has_value(); })
      .property("has_reference", [](const OpenFinger& f) { return f.pipeline->has_reference(); })
      .property("marker_count", [](const OpenFinger& f) { return f.finger->finger.marker_count(); })
      .property(
          "camera",
          [](const OpenFinger& f) { return parsed(camera_json(f.pipeline->finger().camera)); })
      .property("face",
                [](const OpenFinger& f) { return parsed(face_json(f.finger->finger.face)); })
      .property("provenance", [](const OpenFinger& f) { return f.finger->finger.provenance; })
      .property("settings",
                [](const OpenFinger& f) {
                  return settings_dict(pipeline_settings(), f.pipeline->settings());
                })
      .property("warnings", [](const OpenFinger& f) { return english(f.finger->warnings); });
}

void bind_measuring(Documented<OpenFinger>& finger) {
  finger
      .method("measure", &measure, py::arg("picture"), py::kw_only(),
              py::arg("time_ns") = py::none(), py::arg("name") = "")
      .method("forget",
              [](OpenFinger& f) {
                const py::gil_scoped_release others_may_run;
                const std::lock_guard lock(f.measuring);
                f.pipeline->forget();
              })
      .method(
          "reconstruct",
          [](const OpenFinger& f, const py::object& source) {
            const OpenSourcePtr opened = source_of(source, Pace::kOnDemand);
            const py::gil_scoped_release others_may_run;
            return std::make_shared<EveryFrame>(f, opened);
          },
          py::arg("source"))
      .method(
          "stream",
          [](const OpenFinger& f, const py::object& source) {
            const OpenSourcePtr opened = source_of(source, Pace::kRecorded);
            const py::gil_scoped_release others_may_run;
            return ended_apart(std::make_unique<NewestFrame>(f, opened));
          },
          py::arg("source"));
}

}  // namespace

void bind_finger(py::module_& module) {
  bind_frames(module);
  Documented<OpenFinger> finger(module, "Finger");
  bind_facts(finger);
  bind_measuring(finger);
  function(module, "load", &load, py::arg("folder"), py::arg("preset") = "");
}

}  // namespace alltact::python
