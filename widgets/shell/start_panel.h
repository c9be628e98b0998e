// Shown while no source is open: the options to start with, in the order of their likelihood.
#pragma once

#include "core/sources/v4l2/camera_list.h"
#include "widgets/shell/finger_cards.h"
#include "widgets/shell/finger_drawing.h"
#include "widgets/translated.h"

#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <vector>

namespace alltact {

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

}  // namespace alltact
