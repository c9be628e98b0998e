// Calibrating a finger with presses of a ball, and the presets that a study stored with it.
#include "calibration/finger/calibrate_finger.h"
#include "calibration/finger/measuring_presets.h"
#include "calibration/presses/press_note_kinds.h"
#include "core/base/program.h"

#include <map>

#include "packaging/python/src/arrays.h"
#include "packaging/python/src/module.h"
#include "packaging/python/src/sources.h"
#include <pybind11/functional.h>
#include <pybind11/stl.h>

namespace alltact::python {
namespace {

namespace fs = std::filesystem;

/// Long work that reports its progress to Python, and that Ctrl-C stops.
class WatchedJob {
 public:
  explicit WatchedJob(py::object progress)
      : progress_(std::move(progress)),
        job_([this](double fraction, const Message& what) { report_progress(fraction, what); }) {}
  [[nodiscard]] const Job& job() const { return job_; }
  /// An exception of Python's progress callback, raised once the work has stopped.
  void raise() {
    if (raised_) throw py::error_already_set(std::move(*raised_));
  }

 private:
  void report_progress(double fraction, const Message& what) {
    const py::gil_scoped_acquire python;
    if (raised_) return;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!progress_.is_none()) progress_(fraction, what.english());
    } catch (py::error_already_set& raised) {
      raised_ = std::make_unique<py::error_already_set>(std::move(raised));
      job_.request_stop();
    }
  }

  py::object progress_;
  Job job_;
  std::unique_ptr<py::error_already_set> raised_;
};

py::list presses_of(const FingerCalibration& done) {
  py::list presses;
  for (const BallFit& ball : done.calibration.balls) {
    py::dict press;
    press["name"] = ball.press;
    press["radius_mm"] = ball.radius_mm;
    press["centre_mm"] = std::vector<double>(ball.centre_mm.begin(), ball.centre_mm.end());
    press["centre_sd_mm"] = std::vector<double>(ball.centre_sd_mm.begin(), ball.centre_sd_mm.end());
    press["depth_mm"] = ball.depth_mm;
    press["residual_mm"] = ball.residual_mm;
    press["held_out_mm"] = ball.held_out_mm > 0 ? py::cast(ball.held_out_mm) : py::none();
    presses.append(std::move(press));
  }
  return presses;
}

/// Files, or frames in memory.
PressInput press_input(const py::object& given, bool bursts) {
  PressInput input;
  input.bursts = bursts;
  if (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given))
    for (const py::handle& one : given)
      if (py::isinstance<Frame>(one)) input.frames.push_back(one.cast<std::shared_ptr<Frame>>());
  if (input.frames.empty()) input.files = paths_of(given);
  return input;
}

void take_settings(const py::kwargs& settings, FingerCalibrationInput& input) {
  for (const auto& [key, value] : settings) {
    const auto name = py::str(key).cast<std::string>(), words = py::str(value).cast<std::string>();
    if (value_of(take_setting(calibration_settings(), name, words, input.calibration)) ||
        value_of(take_setting(pipeline_settings(), name, words, input.pipeline)))
      continue;
    std::vector<std::string> names = names_of(calibration_settings());
    const std::vector<std::string> more = names_of(pipeline_settings());
    names.insert(names.end(), more.begin(), more.end());
    throw Failure(no_setting(name, names));
  }
}

void add_annotations(const std::map<std::string, std::vector<std::string>>& say,
                     PressSet& press_set) {
  for (const auto& [flag, texts] : say) {
    const auto& kinds = press_note_kinds();
    const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                   [flag_name = flag_of(flag)](const PressNoteKind& known) {
                                     return flag_name == known.flag;
                                   });
    if (kind == kinds.end()) {
      std::vector<std::string> names;
      for (const PressNoteKind& known : kinds) names.emplace_back(known.flag);
      throw Failure({en::say("nothing of this kind can be said of a press: '{}', but {}", flag,
                             one_of(names, flag)),
                     "", ""});
    }
    for (const std::string& text : texts) check(set_press_note(*kind, text, press_set));
  }
}

using Say = std::map<std::string, std::vector<std::string>>;

std::shared_ptr<FingerCalibration> calibrate(const fs::path& folder, const py::object& presses,
                                             double ball_radius_mm,
                                             const std::optional<fs::path>& reference, bool bursts,
                                             const std::string& operator_name,
                                             const std::string& date, const Say& say,
                                             py::object progress, const py::kwargs& settings) {
  FingerCalibrationInput input;
  input.folder = folder;
  input.presses = press_input(presses, bursts);
  input.press_set.ball_radius_mm = ball_radius_mm;
  input.press_set.operator_name = operator_name;
  add_annotations(say, input.press_set);
  take_settings(settings, input);
  input.reference = reference;
  input.date = date;
  input.program_version = program_version();
  WatchedJob watched(std::move(progress));
  std::optional<Result<FingerCalibration>> done;
  {
    const py::gil_scoped_release others_may_run;
    done = calibrate_finger(input, watched.job());
  }
  watched.raise();
  return std::make_shared<FingerCalibration>(value_of(std::move(*done)));
}

py::dict presets_in(const fs::path& folder) {
  const MeasuringPresets stored = value_of(presets_of_finger(folder));
  py::dict presets;
  for (const MeasuringPreset& preset : stored.presets) {
    py::dict fields;
    fields["frame_ms"] = preset.frame_ms;
    fields["median_mm"] = preset.median_mm;
    fields["p95_mm"] = preset.p95_mm;
    fields["settings"] = settings_dict(pipeline_settings(), preset.settings);
    presets[preset.name.c_str()] = std::move(fields);
  }
  return presets;
}

}  // namespace

void bind_calibration(py::module_& module) {
  using Done = FingerCalibration;
  Documented<Done>(module, "Calibration")
      .property("verdict", [](const Done& c) { return c.verdict.sentence.english(); })
      .property("grade", [](const Done& c) { return std::string(to_string(c.verdict.grade)); })
      .property("expected_error_mm", [](const Done& c) { return c.verdict.error_mm; })
      .property("residual_mm", [](const Done& c) { return c.calibration.residual_mm; })
      .property("presses", &presses_of)
      .property("left_out", [](const Done& c) { return english(c.calibration.left_out); })
      .property("remarks", [](const Done& c) { return english(c.calibration.remarks); })
      .property("warnings", [](const Done& c) {
        std::vector<std::string> all = english(c.warnings), more = english(c.about_settings);
        all.insert(all.end(), more.begin(), more.end());
        return all;
      });
  function(module, "calibrate", &calibrate, py::arg("folder"), py::arg("presses"),
           py::arg("ball_radius_mm"), py::kw_only(), py::arg("reference") = py::none(),
           py::arg("bursts") = false, py::arg("operator") = "", py::arg("date") = "",
           py::arg("say") = Say(), py::arg("progress") = py::none());
  function(module, "presets", &presets_in, py::arg("folder"));
}

}  // namespace alltact::python
