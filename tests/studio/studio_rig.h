// A Studio window with a small simulated finger, for tests that use it as a person would.
#pragma once

#include "app/studio/main_window.h"
#include "tests/rigs/fake_camera.h"
#include "tests/support/program.h"
#include "widgets/pages/inspect_page.h"
#include "widgets/pages/live_page.h"
#include "widgets/pages/record_page.h"

#include <QAbstractButton>
#include <QTest>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace alltact::test {

/// True where the run may take as long as it likes (ALLTACT_SLOW), or renews pictures that are
/// kept.
[[nodiscard]] bool is_thorough();

/// Of the small finger's pictures: 768 x 432, in thorough runs 960 x 540.
[[nodiscard]] cv::Size small_size_px();

/// A scene of a finger that bends; with `is_touched` a ball is pressed in in every frame.
[[nodiscard]] std::string small_scene(bool is_touched = false,
                                      int width_px = small_size_px().width);

/// A folder of its own with the scenes `bending.yaml` and `touched.yaml`, a finger that is
/// `described` only, and one that is `calibrated`. Made once for all tests.
class MadeFingers {
 public:
  static const MadeFingers& get();
  [[nodiscard]] std::filesystem::path bending() const { return folder_ / "bending.yaml"; }
  [[nodiscard]] std::filesystem::path touched() const { return folder_ / "touched.yaml"; }
  /// Pictures of the touched finger, frame_00000.png to frame_00005.png.
  [[nodiscard]] std::filesystem::path touched_pictures() const { return folder_ / "touched"; }
  [[nodiscard]] std::filesystem::path camera() const { return folder_ / "camera.yaml"; }
  [[nodiscard]] std::filesystem::path described() const { return folder_ / "described"; }
  [[nodiscard]] std::filesystem::path calibrated() const { return folder_ / "calibrated"; }

 private:
  MadeFingers();
  TemporaryFolder folder_;
};

/// A window with the calibrated finger, touched.
[[nodiscard]] StudioOptions simulated();

/// Throws where making something for a test failed.
void must(const Status& status);

/// What a program that died leaves in its session's folder.
void leave_as_after_a_crash(const std::filesystem::path& session_folder);

/// As open_source; what a scene shows at the camera's pace is rendered once for all tests, and
/// comes again from its first frame on after its last one.
[[nodiscard]] Result<std::unique_ptr<Source>> open_remembered(
    const std::vector<std::filesystem::path>& inputs, const SourceOptions& options);

/// One of the frames that open_remembered would give of a scene made by small_scene.
[[nodiscard]] cv::Mat remembered_frame(const std::filesystem::path& scene, int number);

/// Opens the fake camera under the name "camera", everything else as ever.
[[nodiscard]] SourceOpener with_camera(FakeCamera& fake);

/// Turns the event loop until it is so; false after `patience_ms`, five times that with sanitizers.
bool wait_until(const std::function<bool()>& is_so, int patience_ms = 30000);

class Studio {
 public:
  explicit Studio(StudioOptions options = {});
  ~Studio();
  [[nodiscard]] MainWindow& window() { return *window_; }
  [[nodiscard]] LiveSession& session() { return window_->session(); }
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }
  /// The visible widget of this class with this accessible name, or text without '&'. Fails the
  /// test where there is none.
  template <class T>
  T* find(const QString& name) {
    for (T* widget : window_->findChildren<T*>())
      if (widget->isVisible() && (widget->accessibleName() == name || text_of(*widget) == name))
        return widget;
    ADD_FAILURE() << "no visible widget is called " << name.toStdString();
    return nullptr;
  }
  /// As soon as it can be clicked.
  void click(const QString& button);
  /// What the visible problem lists say, a line each.
  [[nodiscard]] std::string problems() const;
  bool wait_for_picture();
  void close();

 private:
  static QString text_of(const QWidget& widget);
  TemporaryFolder folder_;
  ProgramAppearance appearance_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace alltact::test
