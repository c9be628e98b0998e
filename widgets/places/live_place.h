// The place Live: the picture at full rate, what is drawn over it, the camera's controls; ways to
// begin where there is no source yet.
#pragma once

#include "widgets/controls/control_panel.h"
#include "widgets/controls/lamp_panel.h"
#include "widgets/controls/number_field.h"
#include "widgets/pair/live_pair_box.h"
#include "widgets/panels/force_box.h"
#include "widgets/panels/picture_panel.h"
#include "widgets/places/place.h"
#include "widgets/shell/start_panel.h"
#include "widgets/undo_step.h"

#include <QCheckBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QStackedLayout>
#include <QUndoStack>
#include <array>

namespace alltact {

class LivePlace : public Place {
  Q_OBJECT
 public:
  /// Changes go through `undo`.
  LivePlace(LiveSession& session, QUndoStack& undo, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Live"); }
  [[nodiscard]] QString menu_text() const override { return tr("&Live"); }

  /// Shown in place of the picture, which comes by itself with the first view.
  [[nodiscard]] StartPanel& start() { return *start_; }
  void show_start(bool is_wanted);
  /// That can be chosen from.
  void set_cameras(const std::vector<FoundCamera>& cameras);

  /// A second finger with its camera beside the live one; can be undone. None: no second one.
  void open_second(const std::optional<SecondCamera>& second);
  [[nodiscard]] const LivePair& pair() const { return pair_; }

  /// What changed() tells of.
  [[nodiscard]] const ViewOptions& options() const { return options_; }
  /// Not undoable: what a kept session begins with.
  void set_options(const ViewOptions& options);

 Q_SIGNALS:
  void control_set(const alltact::ControlValue& control);
  void lock_set(bool is_locked);

 private:
  struct Choice {
    QCheckBox* box;
    bool ViewOptions::*member;
  };
  [[nodiscard]] QWidget* make_picture();
  [[nodiscard]] QWidget* make_side();
  void make_contact();
  void connect_force();
  void connect_choices();
  void name_parts();
  void change_options(const ViewOptions& options, const StepWords& what, int merge_id);
  void change_control(std::uint32_t id, std::int64_t before, std::int64_t value);
  void change_lock(bool is_locked);
  void connect_lamp();
  void change_lamp(const std::optional<DimmerSetting>& wanted);
  [[nodiscard]] ShownForce shown_force() const;
  void connect_pair();
  void choose_second();
  void change_second(const std::optional<SecondCamera>& second,
                     const StepWords& what,
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
  QStringList cameras_;  // names that open them
  ViewOptions options_;
  QStackedLayout* pages_;
  bool is_start_wanted_ = false;  // until a source is opened
  StartPanel* start_;
  PicturePanel* panel_;
  PicturePanel* second_panel_ = nullptr;  // there from the first second finger on
  QHBoxLayout* pictures_;
  Lamp lamp_;
  QGroupBox *over_, *camera_, *lamp_group_, *contact_group_, *times_group_;
  std::array<Choice, 5> choices_;
  QLabel* top_label_;
  NumberField* top_;
  QLabel *contact_, *times_;
  ControlPanel* controls_;
  ForceBox* force_;
  LivePairBox* pair_box_;
};

}  // namespace alltact
