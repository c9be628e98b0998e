// Scenes: images of a simulated finger, and the truth.
#include "calibration/export/export_texts.h"
#include "core/simulation/plan.h"

#include <filesystem>

#include "packaging/python/src/arrays.h"
#include "packaging/python/src/module.h"
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace alltact::python {
namespace {

namespace fs = std::filesystem;

struct OpenScene {
  Scene scene;
  Plan plan;
};

/// A scene has no last frame, so any number from 0 on is valid.
void refuse_negative(int number) {
  if (number < 0) throw py::index_error("there is no such frame");
}

py::dict truth_of(const OpenScene& open, int number) {
  refuse_negative(number);
  Truth truth;
  {
    const py::gil_scoped_release others_may_run;
    truth = open.plan.truth(number);
  }
  py::dict fields = py::module_::import("json").attr("loads")(truth.to_json());
  fields["depth_mm"] = array_of(truth.depth_mm);
  fields["view_z_mm"] = array_of(truth.view_z_mm);
  fields["untouched_z_mm"] = array_of(truth.untouched_z_mm);
  return fields;
}

py::object image_of(const OpenScene& open, int number, int threads) {
  refuse_negative(number);
  cv::Mat image;
  {
    const py::gil_scoped_release others_may_run;
    image = open.plan.render(number, threads);
  }
  return array_of(image);
}

}  // namespace

void bind_simulation(py::module_& module) {
  Documented<OpenScene>(module, "Scene")
      .made_by(
          [](const fs::path& path, std::uint64_t seed) {
            Scene scene = value_of(Scene::load(path));
            Plan plan = value_of(Plan::compile(scene, seed));
            return std::make_shared<OpenScene>(OpenScene{std::move(scene), std::move(plan)});
          },
          py::arg("path"), py::kw_only(), py::arg("seed") = 1)
      .property("name", [](const OpenScene& s) { return s.scene.name; })
      .property("why", [](const OpenScene& s) { return s.scene.why; })
      .property("effects", [](const OpenScene& s) { return s.plan.effects(); })
      .property("frames_per_s", [](const OpenScene& s) { return s.plan.frames_per_s(); })
      .property("camera",
                [](const OpenScene& s) {
                  return py::module_::import("json").attr("loads")(
                      camera_json(s.plan.finger().camera).dump());
                })
      .method("__len__", [](const OpenScene& s) { return s.plan.frame_count(); })
      .method("render", &image_of, py::arg("frame"), py::kw_only(), py::arg("threads") = 1)
      .method("truth", &truth_of, py::arg("frame"));
}

}  // namespace alltact::python
