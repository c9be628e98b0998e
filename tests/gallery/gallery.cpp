#include "tests/gallery/gallery.h"

#include "core/devices/camera_controls.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/controls/control_panel.h"
#include "widgets/image/outline_editor.h"
#include "widgets/image/overlays.h"
#include "widgets/inspect/finger_pair.h"
#include "widgets/pages/live_page.h"
#include "widgets/pages/record_page.h"
#include "widgets/panels/recording_checks.h"
#include "widgets/plots/calibration_plots.h"
#include "widgets/plots/press_plots.h"
#include "widgets/shell/export_dialog.h"
#include "widgets/shell/new_finger_dialog.h"
#include "widgets/shell/problem_list.h"
#include "widgets/shell/settings_dialog.h"

#include <QVBoxLayout>
#include <cmath>

#include <linux/videodev2.h>

namespace alltact {
namespace {

using Shown = std::unique_ptr<QWidget>;

Shown image_view() {
  auto view = std::make_unique<ImageView>();
  cv::Mat grey(270, 480, CV_8UC1);
  for (int v = 0; v < grey.rows; ++v)
    for (int u = 0; u < grey.cols; ++u)
      grey.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>((u + v) / 3);
  Markers markers;
  for (int i = 0; i < 12; ++i)
    markers.push_back({60.0 + 70 * (i % 6), i < 6 ? 50.0 : 220.0, i % 4 != 3, 0.1});
  view->show_image(grey,
                   {markers_overlay(markers), colour_bar_overlay(depth_scale(1.0), "Depth, mm")});
  return view;
}

/// A dark disc, and a ball whose outline is to be drawn onto it.
Shown outline_editor() {
  CameraParameters lens;
  lens.width_px = 960;
  lens.height_px = 540;
  lens.fx_px = lens.fy_px = 523.9;
  lens.cx_px = 479.5;
  lens.cy_px = 269.5;
  const auto camera = Camera::create(lens);
  auto editor = std::make_unique<OutlineEditor>();
  cv::Mat grey(540, 960, CV_8UC1, cv::Scalar(150));
  for (int v = 0; v < grey.rows; ++v)
    for (int u = 0; u < grey.cols; ++u)
      if (std::hypot(u - 610, v - 240) < 41) grey.at<std::uint8_t>(v, u) = 70;
  editor->show_image(grey, {});
  if (camera) editor->set_ball(ShownBall{*camera, 4, {12, -4, 52}, true});
  return editor;
}

Shown control_panel() {
  auto panel = std::make_unique<ControlPanel>();
  CameraControl exposure;
  exposure.id = V4L2_CID_EXPOSURE_ABSOLUTE;
  exposure.name = "Exposure Time, Absolute";
  exposure.type = ControlType::kInteger;
  exposure.low = 3;
  exposure.high = 2047;
  exposure.value = 250;
  CameraControl gain = exposure;
  gain.id = V4L2_CID_GAIN;
  gain.name = "Gain";
  gain.low = 0;
  gain.high = 100;
  gain.value = 12;
  panel->set_controls({gain, exposure}, false);
  return panel;
}

Shown problem_list() {
  auto list = std::make_unique<ProblemList>();
  list->set_problems({{Meaning::kBad, "The camera was unplugged.", "Plug it in again.", {}, {}},
                      {Meaning::kDoubtful, "The source has ended.", {}, "Play it again", [] {}},
                      {Meaning::kGood, "The reference is installed.", {}, {}, {}}});
  return list;
}

Shown coverage_view() {
  auto view = std::make_unique<CoverageView>();
  BendCoverage coverage;
  coverage.begin();
  for (int i = 0; i < 400; ++i) {
    const double turn = 0.05 * i, reach = 0.015 * i;
    coverage.add(TipPose{{0, 0.4 * reach * std::sin(turn), 60 + reach * std::cos(turn)},
                         {0, 0, 1},
                         0.3 * reach * M_PI / 180});
  }
  view->show_coverage(coverage.state());
  return view;
}

Shown start_panel() {
  auto panel = std::make_unique<StartPanel>();
  FoundCamera camera;
  camera.identity.name = "Finger camera";
  camera.identity.by_id = "usb-Maker_Camera_0001-video-index0";
  FoundCamera busy = camera;
  busy.problem = Error{en::say("another program uses it"), std::string("/dev/video2"),
                       en::say("closing that program")};
  panel->set_cameras({camera, busy});
  panel->set_last("finger left-07");
  return panel;
}

Shown new_finger_dialog() { return std::make_unique<NewFingerDialog>(); }

Shown export_dialog() { return std::make_unique<ExportDialog>("/fingers/left-07"); }

Shown mapping_plot() {
  auto plot = std::make_unique<MappingPlot>();
  MappingPlotData data;
  data.x_max = 0.5;
  for (int i = 0; i <= 50; ++i) {
    const double x = 0.01 * i, depth_mm = 2.4 * x / (1 + 0.6 * x);
    data.curve.push_back({x, depth_mm, 0.02 * depth_mm});
    data.points.push_back({x, depth_mm + 0.03 * std::sin(11.0 * i), i > 8});
  }
  plot->set_data(std::move(data));
  return plot;
}

Shown press_error_plot() {
  auto plot = std::make_unique<PressErrorPlot>();
  plot->set_data({{"press_1", 0.012, 0.019}, {"press_2", 0.008, 0.011}, {"press_3", 0.021, 0.034}});
  return plot;
}

Shown step_list() {
  auto list = std::make_unique<StepList>();
  list->show_steps({{"Lens", StepState::kDone, true, {}},
                    {"Presses", StepState::kOutdated, true, {}},
                    {"Mapping", StepState::kToDo, true, {}},
                    {"Verdict", StepState::kToDo, false, "There is no mapping yet."}},
                   2);
  return list;
}

Shown convergence_plot() {
  auto plot = std::make_unique<ConvergencePlot>();
  std::vector<Round> rounds;
  for (int i = 0; i < 9; ++i)
    rounds.push_back({i + 1, 0.021 + 0.03 * std::exp(-0.9 * i), 0.2 * std::pow(0.11, i)});
  plot->set_rounds(rounds);
  return plot;
}

Shown gripper_dialog() {
  return std::make_unique<GripperDialog>(
      "left-07", RigidTransform{rotation_from_rpy_deg({0, 90, -12.5}), {-42.5, 0, 18}});
}

Shown second_finger_dialog() {
  return std::make_unique<SecondFingerDialog>(
      SecondFinger{"/fingers/right-03", "/recordings/grasp_right.mkv"});
}

Shown settings_dialog() { return std::make_unique<SettingsDialog>(Appearance{}, nullptr); }

/// The place with nothing to record from.
class EmptyRecording : public QWidget {
 public:
  EmptyRecording() : place_(session_, undo_) {
    // In no folder that there is: the space left on a disk is another one everywhere.
    place_.set_file(QStringLiteral("/no/such/folder/bending.mkv"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(&place_);
  }

 private:
  LiveSession session_;
  QUndoStack undo_;
  RecordPage place_;
};

Shown empty_recording() { return std::make_unique<EmptyRecording>(); }

}  // namespace

const std::map<std::string, std::unique_ptr<QWidget> (*)()>& gallery() {
  static const std::map<std::string, Shown (*)()> widgets{
      {"control_panel", control_panel},
      {"convergence_plot", convergence_plot},
      {"coverage_view", coverage_view},
      {"empty_recording", empty_recording},
      {"export_dialog", export_dialog},
      {"gripper_dialog", gripper_dialog},
      {"image_view", image_view},
      {"mapping_plot", mapping_plot},
      {"new_finger_dialog", new_finger_dialog},
      {"outline_editor", outline_editor},
      {"press_error_plot", press_error_plot},
      {"problem_list", problem_list},
      {"second_finger_dialog", second_finger_dialog},
      {"settings_dialog", settings_dialog},
      {"start_panel", start_panel},
      {"step_list", step_list}};
  return widgets;
}

}  // namespace alltact
