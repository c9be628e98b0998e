#include "packaging/python/src/results.h"

#include "core/sensing/depth/depth_limits.h"
#include "core/sensing/result_json.h"

#include "packaging/python/src/arrays.h"
#include "packaging/python/src/documented.h"
#include "packaging/python/src/failure.h"

namespace alltact::python {
namespace {

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

}  // namespace

MeasuredResultPtr measured(FingerPtr finger,
                           FrameResult result,
                           std::size_t index,
                           ReferenceMethod method) {
  auto made = std::make_shared<MeasuredResult>();
  made->finger = std::move(finger);
  made->frame = result.frame;
  made->line = result_line(result, index, method);
  made->result = std::move(result);
  return made;
}

MeasuredResultPtr not_measured(FingerPtr finger,
                               FramePtr frame,
                               std::size_t index,
                               const Error& problem) {
  auto made = std::make_shared<MeasuredResult>();
  made->finger = std::move(finger);
  made->line =
      failure_line(frame ? frame->name : frame_name(problem, index), index, {as_sentence(problem)});
  made->frame = std::move(frame);
  return made;
}

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

}  // namespace alltact::python
