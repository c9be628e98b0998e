// Shows each widget alone, with made-up content: alltact_gallery NAME, or without a name which
// there are.
#include "core/sources/v4l2/camera_controls.h"
#include "widgets/controls/control_panel.h"
#include "widgets/picture/overlays.h"
#include "widgets/recording/coverage_view.h"
#include "widgets/shell/new_finger_dialog.h"
#include "widgets/shell/problem_list.h"
#include "widgets/shell/settings_dialog.h"
#include "widgets/shell/start_panel.h"
#include "widgets/shell/studio_style.h"

#include <QApplication>
#include <cmath>
#include <iostream>
#include <map>

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
  return std::make_unique<NewFingerDialog>([](const FingerDescription&) -> Status {
    return Error{"the gallery makes no fingers", "", "the Studio itself"};
  });
}

Shown settings_dialog() {
  return std::make_unique<SettingsDialog>(Appearance{});
}

const std::map<std::string, Shown (*)()> kWidgets{{"control_panel", control_panel},
                                                  {"coverage_view", coverage_view},
                                                  {"image_view", image_view},
                                                  {"new_finger_dialog", new_finger_dialog},
                                                  {"problem_list", problem_list},
                                                  {"settings_dialog", settings_dialog},
                                                  {"start_panel", start_panel}};

}  // namespace
}  // namespace alltact

int main(int argc, char** argv) {
  using namespace alltact;
  const auto wanted = argc == 2 ? kWidgets.find(argv[1]) : kWidgets.end();
  if (wanted == kWidgets.end()) {
    std::cerr << "usage: alltact_gallery NAME [with NAME one of";
    for (const auto& [name, make] : kWidgets) std::cerr << ' ' << name;
    std::cerr << "]\n";
    return 2;
  }
  int only_name = 1;
  QApplication application(only_name, argv);
  QApplication::setStyle(new StudioStyle);
  const Shown widget = wanted->second();
  widget->show();
  return QApplication::exec();
}
