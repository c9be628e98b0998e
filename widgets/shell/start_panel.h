// What stands where the picture will be: ways to begin, in the order in which they are wanted.
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
  /// What was worked on last; empty for nothing.
  void set_last(const QString& what);
  /// The recent fingers.
  [[nodiscard]] FingerCards& cards() { return *cards_; }

 Q_SIGNALS:
  void last_wanted();
  void camera_wanted(const QString& name);
  void simulated_wanted();
  /// Whoever has no finger at hand tries everything with one that is made up.
  void try_wanted();
  /// All that were ever made here, in one list.
  void all_fingers_wanted();
  void video_wanted();
  void folder_wanted();
  void finger_wanted();
  void new_finger_wanted();

 private:
  [[nodiscard]] QVBoxLayout* make_left();
  [[nodiscard]] QVBoxLayout* make_right();
  void name_parts();
  void show_cameras();
  /// What is most likely wanted is the largest button.
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
