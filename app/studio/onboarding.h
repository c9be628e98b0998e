// A tutorial with a simulated finger, for users without a finger at hand: shows the next step and
// leads there.
#pragma once

#include "app/studio/workspace.h"
#include "widgets/pages/calibrate_page.h"
#include "widgets/widget_base.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>

namespace alltact {

class Tutorial : public Translated<QFrame> {
  Q_OBJECT
 public:
  /// work_folder: where the tutorial's finger gets a folder of its own.
  Tutorial(LiveSession& session, Workspace& work, CalibratePage& calibrate,
           std::filesystem::path work_folder);

  /// Begins when the simulated finger is being opened.
  void begin();
  [[nodiscard]] bool is_on() const { return is_on_; }
  /// The shown page, by its name, and the one that it leads to itself.
  void set_page(const std::string& page, const std::string& leads_to);

  /// The person's steps count from 1; the finger is made without them.
  enum class Step { kFinger, kRecord, kPresses, kCalibrate, kCheck, kDone };
  [[nodiscard]] Step step() const { return step_; }

 Q_SIGNALS:
  /// is_on() has changed.
  void turned();
  /// By its name.
  void page_requested(const std::string& name);
  void failed(const alltact::Error& why);

 private:
  void end();
  void follow();
  [[nodiscard]] Step next_step() const;
  [[nodiscard]] std::string page_of_step() const;
  void make_finger_once();
  void lead();
  [[nodiscard]] QString what_next() const;

  LiveSession& session_;
  Workspace& work_;
  CalibratePage& calibrate_;
  std::filesystem::path work_folder_;
  std::string page_, leads_to_;
  ElidedLabel* text_;
  QPushButton *lead_, *end_;
  Step step_ = Step::kFinger;
  bool is_on_ = false, has_finger_ = false;
  BackgroundWork making_;
};

// The purpose of a page, shown at the first visit; once dismissed it stays away. Its text is the
// beginning of the page's help.

class PageHint : public Translated<QFrame> {
  Q_OBJECT
 public:
  /// Hidden while `guide` is on.
  explicit PageHint(const Tutorial& guide, QWidget* parent = nullptr);
  /// By its name.
  void show_for(const std::string& page);
  /// Hidden while notices need its room.
  void make_room(bool is_needed);
  /// The settings key of a page whose hint was dismissed.
  [[nodiscard]] static QString key(const std::string& page);

 Q_SIGNALS:
  void help_requested();

 private:
  void follow();

  const Tutorial& guide_;
  std::string page_;
  bool is_room_needed_ = false;
  ElidedLabel* text_;
  QPushButton *more_, *seen_;
};

}  // namespace alltact
