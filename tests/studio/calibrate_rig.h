// What tests of the place Calibrate need: a finger that may be changed, presses of a simulated
// ball, and a person who counts what they do.
#pragma once

#include "tests/studio/studio_rig.h"
#include "widgets/pages/calibrate_page.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <opencv2/core.hpp>

namespace alltact::test {

/// A scene of the small finger with a ball at six places and depths, 30 frames a second; so many at
/// each: from the first to the last of 15 it is a little less than half a second.
[[nodiscard]] std::string pressing_scene(int frames_each = 15);

/// The same of a finger that holds still.
[[nodiscard]] std::string held_pressing_scene(int frames_each);

/// Such a finger that holds still, with the ball pressed in by 0.8 mm.
[[nodiscard]] std::string still_scene();

/// While it lives, a new finger's presses are taken as they are held still, as for somebody who has
/// never chosen otherwise. Before the window is made.
class PressesWhenStill {
 public:
  PressesWhenStill();
  ~PressesWhenStill();
  PressesWhenStill(const PressesWhenStill&) = delete;
  PressesWhenStill& operator=(const PressesWhenStill&) = delete;
};

/// Whether a label that is shown has these words.
[[nodiscard]] bool says(Studio& studio, const char* words);

/// Base, middle and tip, where a check needs presses: what the step Check then shows, and from
/// where to where along the face, in mm.
inline const std::tuple<const char*, double, double> kCheckedAt[] = {
    {"1 of 3 taken", 0, 30}, {"2 of 3 taken", 43, 53}, {"3 presses taken: enough", 76, 100}};

/// All bytes of a finger's folder.
[[nodiscard]] std::map<std::string, std::string> contents(const std::filesystem::path& folder);

/// A window on a finger of its own, with a reference and without a mapping, and a ball that
/// presses.
class CalibrateStudio {
 public:
  /// `presses`: pictures that lie in the finger's folder from the beginning.
  explicit CalibrateStudio(int presses = 0);
  [[nodiscard]] Studio& studio() { return *studio_; }
  [[nodiscard]] CalibratePage& place();
  [[nodiscard]] PressCollection& collection() { return place().collection(); }
  [[nodiscard]] CalibrationRun& run() { return place().run(); }
  [[nodiscard]] std::filesystem::path finger() const { return folder_ / "finger"; }
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

  /// Before open(): the ball holds still at each position, long enough for a slow machine.
  void hold_still() const;
  bool wait_for_depth();
  /// The window, at the place. With the program of the command line it writes reports.
  void open();
  void close() { studio_.reset(); }
  void go_to_step(const QString& title);  ///< or its number, in any language
  void type_radius(const QString& text);
  bool wait_until_looked_at(int count);
  bool wait_for_report();
  /// Adds the picture of a punch to the finger's folder, whose two levels are 0.5 mm apart.
  void add_punch(const std::string& name);
  /// From the step Presses, with the program of the command line: calibrates, then does the same
  /// with the command that the window copies. Fails unless both give the same bytes.
  std::string calibrate_and_compare_with_the_command();
  /// Until the ball presses in by at least 0.3 mm and elsewhere than the last time, at a place
  /// along the face.
  bool wait_for_press(double from_mm = 0, double to_mm = 1000);

 private:
  TemporaryFolder folder_;
  std::unique_ptr<Studio> studio_;
  std::optional<double> last_along_mm_;
};

}  // namespace alltact::test
