#include "tests/studio/studio_rig.h"

#include "app/studio/onboarding.h"
#include "calibration/reference/reference_recording.h"
#include "core/base/atomic_file.h"
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
#include "core/open/open_source.h"
#include "core/simulation/plan.h"
#include "tests/support/sanitized.h"

#include <QSettings>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact::test {
void must(const Status& status) {
  if (!status) throw std::runtime_error(status.error().sentence());
}

bool is_thorough() {
  return qEnvironmentVariableIsSet("ALLTACT_SLOW") ||
         qEnvironmentVariableIsSet("ALLTACT_RENEW_HELP");
}

cv::Size small_size_px() { return is_thorough() ? cv::Size(960, 540) : cv::Size(768, 432); }

std::string small_scene(bool is_touched, int width_px) {
  const double scale = width_px / 960.0;
  const int height_px = width_px * 9 / 16;
  const std::string ball =
      "  - {use: ball, radius_mm: 4.0, s_mm: 46.0, y_mm: 0.0, depth_mm: 0.8}\n"
      "  - {use: rolloff, kind: hertz, length_mm: 0.8}\n";
  return fmt::format(
      "name: small finger\n"
      "why: a test looks at it\n"
      "frames: 60\n"
      "finger:\n"
      "  camera: {{model: pinhole, size: [{1}, {2}], fx: {3}, fy: {3}, cx: {4}, cy: {5}}}\n"
      "  face: {{kind: fin_ray, width_mm: 24.0, layer_mm: 1.5}}\n"
      "  markers: {{per_row: 6, polarity: bright}}\n"
      "untouched: {{x_mm: -25.0, z_mm: 28.0, incline_deg: 34.0, length_mm: 116.0}}\n"
      "motion: {{kind: wander, frames_per_move: 10}}\n"
      "effects:\n"
      "  - {{use: bend, q1_mm: {{from: -{0}, to: {0}}}, q2_mm: {{from: -{0}, to: {0}}}}}\n"
      "  - {{use: sway, sway_mm: {{from: -{0}, to: {0}}}}}\n"
      "{6}"
      "  - {{use: markers, radius_mm: 1.5, setback_mm: 4.0, first: 0.1, last: 0.92, albedo: 0.9}}\n"
      "  - {{use: layer, scatter_per_mm: 0.6, along: normal}}\n"
      "  - {{use: sides, albedo: 0.12, depth_mm: 14.0}}\n"
      "  - use: leds\n"
      "    lamps:\n"
      "      - {{at_mm: [0.0, -3.0, 0.0], power: 270000.0}}\n"
      "      - {{at_mm: [0.0, 3.0, 0.0], power: 270000.0}}\n"
      "      - {{at_mm: [4.0, 0.0, -20.0], power: 3300000.0, aim_mm: [71.0, 0.0, 93.0], lobe: 8}}\n"
      "  - {{use: read, sd: 1.0}}\n"
      "  - {{use: quantisation}}\n",
      is_touched ? 0.3 : 3.0,  // a touched finger stays near the pose at rest
      width_px, height_px, 523.9 * scale, 0.5 * (width_px - 1), 0.5 * (height_px - 1),
      is_touched ? ball : "");
}

const MadeFingers& MadeFingers::get() {
  static const MadeFingers fingers;
  return fingers;
}

MadeFingers::MadeFingers() {
  must(write_file_atomically(bending(), small_scene()));
  must(write_file_atomically(touched(), small_scene(true)));
  const Finger simulated = Plan::compile(Scene::load(bending()).value(), 1).value().finger();
  must(save_camera(camera(), simulated.camera));
  must(make_folder(touched_pictures()));
  const auto source = open_source({touched()}).value();
  for (int i = 0; i < 6; ++i) {
    const FramePtr frame = source->next().value();
    must(write_image(touched_pictures() / (frame->name + ".png"), frame->grey));
  }
  for (const auto& folder : {described(), calibrated()}) {
    NewFinger wanted;
    wanted.finger = folder;
    wanted.camera = camera();
    wanted.width_mm = 24;
    wanted.layer_mm = 1.5;
    wanted.per_row = 6;
    auto finger = make_finger(wanted);
    must(finger ? Status() : Status(finger.error()));
    if (folder != calibrated()) continue;
    const auto report = set_reference(folder, {bending()}, Job());
    must(report ? Status() : Status(report.error()));
    // What the demonstration's calibration gives of the same silicone.
    MappingParameters mapping;
    mapping.kind = MappingKind::kMoebius;
    mapping.a_mm = 3.425;
    mapping.b = 1.012;
    mapping.x_max = 0.507;
    const auto mapped = FingerStore::of(folder)->update([&](Finger& now) {
      now.mapping = mapping;
      // It keeps no presses that the source paper's method could calibrate with.
      now.mapping_record = MappingRecord{"paper", {}, 0, 0, 0, 0, ""};
      return Status();
    });
    must(mapped ? Status() : Status(mapped.error()));
  }
}

SourceOpener with_camera(FakeCamera& fake) {
  return [&fake](const std::vector<std::filesystem::path>& inputs,
                 const SourceOptions& options) -> Result<std::unique_ptr<Source>> {
    if (inputs.front() != "camera") return open_remembered(inputs, options);
    CameraAccess place;
    place.calls = &fake;
    place.identity = "camera";
    place.find_node = [&fake]() -> Result<std::string> {
      if (!fake.is_plugged())
        return Error{en::say("there is no such camera"), std::string("camera"), ""};
      return std::string("/dev/video0");
    };
    auto camera = V4l2Camera::open(place, {});
    if (!camera) return camera.error();
    return std::unique_ptr<Source>(std::make_unique<CameraSource>(std::move(*camera)));
  };
}

void leave_as_after_a_crash(const std::filesystem::path& session_folder) {
  constexpr int kNobody = 4194303;  // no process has this number here
  must(write_file_atomically(session_folder / "running.lock",
                             fmt::format("{}\nalltact-studio\n{}\n{}\n{}\n", kNobody,
                                         QSysInfo::machineHostName().toStdString(),
                                         QSysInfo::machineUniqueId().toStdString(),
                                         QSysInfo::bootUniqueId().toStdString())));
}

bool wait_until(const std::function<bool()>& is_so, int patience_ms) {
  constexpr int kSlower = kIsSanitized ? 5 : 1;
  return QTest::qWaitFor(is_so, kSlower * patience_ms);
}

StudioOptions simulated() {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  options.source = {MadeFingers::get().touched()};
  return options;
}

Studio::Studio(StudioOptions options) {
  if (options.session_folder.empty()) options.session_folder = folder_ / "session";
  if (options.work_folder.empty()) options.work_folder = options.session_folder;
  using Open = decltype(&open_source);
  if (const Open* open = options.opener.target<Open>(); open && *open == &open_source)
    options.opener = &open_remembered;
  if (!options.lister) options.lister = [] { return std::vector<FoundCamera>{}; };
  appearance_.apply({Theme::kLight, QStringLiteral("en")});
  for (const char* place : {"live", "calibrate", "record", "inspect", "accuracy"})
    QSettings().setValue(PageHint::key(place), true);  // somebody who was here before
  if (!QSettings().contains(PressesPage::kAutomaticKey))
    QSettings().setValue(PressesPage::kAutomaticKey, false);  // and presses by hand
  window_ = std::make_unique<MainWindow>(options, appearance_);
  window_->resize(1280, 800);
  window_->show();
  QApplication::setActiveWindow(window_.get());  // a bare X server has nothing that would do it
  static_cast<void>(QTest::qWaitForWindowExposed(window_.get()));
}

Studio::~Studio() { window_.reset(); }

QString Studio::text_of(const QWidget& widget) {
  const QVariant text =
      widget.property("text").isValid() ? widget.property("text") : widget.property("title");
  return text.toString().remove(QLatin1Char('&'));
}

void Studio::click(const QString& button) {
  auto* found = find<QAbstractButton>(button);
  if (found == nullptr) return;
  EXPECT_TRUE(wait_until([&] { return found->isEnabled(); })) << button.toStdString();
  QTest::mouseClick(found, Qt::LeftButton);
}

std::string Studio::problems() const {
  std::string text;
  for (const ProblemList* list : window_->findChildren<ProblemList*>()) {
    if (!list->isVisible()) continue;
    for (const Problem& problem : list->problems())
      text += (problem.what + QLatin1Char(' ') + problem.advice + QLatin1Char('\n')).toStdString();
  }
  return text;
}

bool Studio::wait_for_picture() {
  return wait_until([this] { return session().view() != nullptr; });
}

void Studio::close() { window_->close(); }

}  // namespace alltact::test
