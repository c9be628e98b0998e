// The page Live: the live image at full rate with overlays, and the camera's controls. Without a
// source it shows a start panel.
#pragma once

#include "core/devices/camera_list.h"
#include "widgets/controls/control_panel.h"
#include "widgets/controls/number_field.h"
#include "widgets/live/live_pair.h"
#include "widgets/panels/brightness_box.h"
#include "widgets/panels/force_box.h"
#include "widgets/panels/image_panel.h"
#include "widgets/shell/finger_card.h"
#include "widgets/shell/finger_drawing.h"
#include "widgets/shell/page.h"
#include "widgets/undo_step.h"
#include "widgets/widget_base.h"

#include <QCheckBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedLayout>
#include <QUndoStack>
#include <QVBoxLayout>
#include <array>
#include <vector>

namespace alltact {

// Shown while no source is open: the options to start with, in the order of their likelihood.

class StartPanel : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit StartPanel(QWidget* parent = nullptr);
  void set_cameras(const std::vector<FoundCamera>& cameras);
  /// Name of the last session's source; empty for none.
  void set_last(const QString& what);
  /// The recent fingers.
  [[nodiscard]] FingerCards& cards() { return *cards_; }

 Q_SIGNALS:
  void last_requested();
  void camera_requested(const QString& name);
  void simulation_requested();
  /// The tutorial with a simulated finger, for users without a finger at hand.
  void tutorial_requested();
  /// All fingers that were ever made here, in one list.
  void all_fingers_requested();
  void video_requested();
  void folder_requested();
  void finger_requested();
  void new_finger_requested();

 private:
  [[nodiscard]] QVBoxLayout* make_left();
  [[nodiscard]] QVBoxLayout* make_right();
  void name_parts();
  void show_cameras();
  /// The most likely option is the largest button.
  void mark_primary();

  std::vector<FoundCamera> found_;
  QString last_text_;
  QLabel *title_, *intro_;
  FingerCards* cards_;
  FingerDrawing* drawing_;
  QPushButton *try_, *last_, *simulated_, *video_, *folder_, *finger_, *new_finger_, *all_;
  QGroupBox *sources_, *fingers_;
  QVBoxLayout* cameras_;
};

class LivePage : public Page {
  Q_OBJECT
 public:
  /// `undo`: receives every change.
  LivePage(LiveSession& session, QUndoStack& undo, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Live"); }
  [[nodiscard]] QString menu_text() const override { return tr("&Live"); }

  /// Shown instead of the live image, which appears with the first view.
  [[nodiscard]] StartPanel& start() { return *start_; }
  void show_start(bool is_requested);
  /// Cameras offered for selection.
  void set_cameras(const std::vector<FoundCamera>& cameras);

  /// A second finger with its camera; can be undone. None: closes it.
  void open_second(const std::optional<SecondCamera>& second);
  [[nodiscard]] const LivePair& pair() const { return pair_; }

  /// State reported by changed().
  [[nodiscard]] const ViewOptions& options() const { return options_; }
  /// Without an undo step, for a restored session.
  void set_options(const ViewOptions& options);

 Q_SIGNALS:
  void control_set(const alltact::ControlValue& control);
  void lock_set(bool is_locked);

 private:
  struct Choice {
    QCheckBox* box;
    bool ViewOptions::*member;
  };
  [[nodiscard]] QWidget* make_view_page();
  [[nodiscard]] SidePanel make_side();
  void connect_force();
  void connect_choices();
  void name_parts();
  void change_options(const ViewOptions& options, const StepWords& what, int merge_id);
  void change_control(std::uint32_t id, std::int64_t before, std::int64_t value);
  void change_lock(bool is_locked);
  void connect_lamp();
  void change_lamp(const std::optional<DimmerSetting>& requested);
  [[nodiscard]] ShownForce shown_force() const;
  void connect_pair();
  void choose_second();
  void change_second(const std::optional<SecondCamera>& second, const StepWords& what,
                     int merge_id);
  void set_second(const std::optional<SecondCamera>& second);
  void set_layers(LiveSession& session) const;
  void show_pair();
  void show_pair_state();
  void show_status();
  void show_times();

  LiveSession& session_;
  QUndoStack& undo_;
  LivePair pair_;
  QStringList cameras_;  // identifiers that open them
  ViewOptions options_;
  QStackedLayout* pages_;
  bool is_start_requested_ = false;  // until a source is opened
  StartPanel* start_;
  ImagePanel* panel_;
  ImagePanel* second_panel_ = nullptr;  // created with the first second finger
  QHBoxLayout* panels_;
  Lamp lamp_;
  QGroupBox *overlay_group_, *camera_, *lamp_group_, *times_group_;
  std::array<Choice, 6> choices_;
  QLabel* top_label_;
  NumberField* top_;
  ContactBox* contact_;
  QLabel* times_;
  BrightnessBox* brightness_;
  ControlPanel* controls_;
  ForceBox* force_;
  LivePairBox* pair_box_;
};

}  // namespace alltact
