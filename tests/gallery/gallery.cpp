#include "tests/gallery/gallery.h"

#include "core/sources/v4l2/camera_controls.h"
#include "widgets/controls/control_panel.h"
#include "widgets/picture/outline_editor.h"
#include "widgets/picture/overlays.h"
#include "widgets/places/record_place.h"
#include "widgets/recording/coverage_view.h"
#include "widgets/shell/new_finger_dialog.h"
#include "widgets/shell/problem_list.h"
#include "widgets/shell/settings_dialog.h"
#include "widgets/shell/start_panel.h"

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
  view->show_picture(grey, {markers_overlay(markers), colour_bar_overlay(1.0, "Depth, mm")});
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
  editor->show_picture(grey, {});
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
    coverage.add(Motion{reach * std::cos(turn), 0.4 * reach * std::sin(turn), 0.3 * reach});
  }
  view->show_coverage(coverage.picture());
  return view;
}

Shown start_panel() {
  auto panel = std::make_unique<StartPanel>();
  FoundCamera camera;
  camera.identity.name = "Finger camera";
  camera.identity.by_id = "usb-Maker_Camera_0001-video-index0";
  FoundCamera busy = camera;
  busy.problem = Error{"another program uses it", "/dev/video2", "closing that program"};
  panel->set_cameras({camera, busy});
  panel->set_last("finger left-07");
  return panel;
}

Shown new_finger_dialog() {
  return std::make_unique<NewFingerDialog>([](const NewFinger&) -> Status {
    return Error{"the gallery makes no fingers", "", "the Studio itself"};
  });
}

Shown settings_dialog() {
  return std::make_unique<SettingsDialog>(Appearance{});
}

/// The place with nothing to record from.
class EmptyRecording : public QWidget {
 public:
  EmptyRecording() : place_(session_, no_installer) {
    // In no folder that there is: the space left on a disk is another one everywhere.
    place_.set_file(QStringLiteral("/no/such/folder/bending.mkv"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(&place_);
  }

 private:
  static Result<ReferenceReport> no_installer(const std::filesystem::path& /*folder*/,
                                              const std::filesystem::path& /*video*/,
                                              const Job& /*job*/) {
    return Error{"the gallery has no fingers", "", "the Studio itself"};
  }
  LiveSession session_;
  RecordPlace place_;
};

Shown empty_recording() {
  return std::make_unique<EmptyRecording>();
}

}  // namespace

const std::map<std::string, std::unique_ptr<QWidget> (*)()>& gallery() {
  static const std::map<std::string, Shown (*)()> widgets{{"control_panel", control_panel},
                                                          {"coverage_view", coverage_view},
                                                          {"empty_recording", empty_recording},
                                                          {"image_view", image_view},
                                                          {"new_finger_dialog", new_finger_dialog},
                                                          {"outline_editor", outline_editor},
                                                          {"problem_list", problem_list},
                                                          {"settings_dialog", settings_dialog},
                                                          {"start_panel", start_panel}};
  return widgets;
}

}  // namespace alltact
