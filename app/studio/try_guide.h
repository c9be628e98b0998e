// A day with a simulated finger, for whoever has none at hand: says what comes next and leads
// there.
#pragma once

#include "app/studio/workspace.h"
#include "widgets/places/calibrate_place.h"
#include "widgets/shell/one_line.h"

#include <QFrame>
#include <QPushButton>

namespace alltact {

class TryGuide : public Translated<QFrame> {
  Q_OBJECT
 public:
  /// work_folder: where the finger that is tried gets a folder of its own.
  TryGuide(LiveSession& session,
           Workspace& work,
           CalibratePlace& calibrate,
           std::filesystem::path work_folder);

  /// The simulated finger is being opened: begin with it.
  void begin();
  [[nodiscard]] bool is_on() const { return is_on_; }
  /// Where one is now, by its name.
  void set_place(const std::string& place);

  enum class Step { kFinger = 1, kRecord, kPresses, kCalibrate, kCheck, kDone };
  [[nodiscard]] Step step() const { return step_; }

 Q_SIGNALS:
  /// is_on() has changed.
  void turned();
  /// By its name.
  void place_wanted(const std::string& name);
  void failed(const alltact::Error& why);

 private:
  void end();
  void follow();
  [[nodiscard]] Step next_step() const;
  [[nodiscard]] std::string place_of_step() const;
  void make_finger_once();
  void lead();
  [[nodiscard]] QString what_next() const;

  LiveSession& session_;
  Workspace& work_;
  CalibratePlace& calibrate_;
  std::filesystem::path work_folder_;
  std::string place_;
  OneLine* text_;
  QPushButton *lead_, *end_;
  Step step_ = Step::kFinger;
  bool is_on_ = false, has_finger_ = false;
  BackgroundWork making_;
};

}  // namespace alltact
