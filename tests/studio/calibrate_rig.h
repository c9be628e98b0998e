// What tests of the place Calibrate need: a finger that may be changed, presses of a simulated
// ball, and a person who counts what they do.
#pragma once

#include "tests/studio/studio_rig.h"
#include "widgets/places/calibrate_place.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>

#include <fmt/format.h>
#include <opencv2/core.hpp>

namespace alltact::test {

/// A scene of the small finger with a ball at six places and depths, half a second each.
[[nodiscard]] std::string pressing_scene();

/// A window on a finger of its own, with a reference and without a mapping, and a ball that
/// presses.
class CalibrateStudio {
 public:
  /// `presses`: pictures that lie in the finger's folder from the beginning.
  explicit CalibrateStudio(int presses = 0);
  [[nodiscard]] Studio& studio() { return *studio_; }
  [[nodiscard]] CalibratePlace& place();
  [[nodiscard]] PressDesk& desk() { return place().desk(); }
  [[nodiscard]] CalibrationRun& run() { return place().run(); }
  [[nodiscard]] std::filesystem::path finger() const { return folder_ / "finger"; }
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

  /// The window, at the place. With the program of the command line it writes reports.
  void open(const std::filesystem::path& command_line = {});
  void close() { studio_.reset(); }
  void go_to_step(const QString& title);  ///< or its number, in any language
  void type_radius(const QString& text);
  bool wait_until_looked_at(int count);
  bool wait_for_report();
  /// Until the ball presses in by at least 0.3 mm and elsewhere than the last time.
  bool wait_for_press();

 private:
  TemporaryFolder folder_;
  std::unique_ptr<Studio> studio_;
  std::optional<double> last_along_mm_;
};

}  // namespace alltact::test
