// Beside the live pictures: the second finger, whether both are of one moment, and what both tell
// together.
#pragma once

#include "widgets/controls/number_field.h"
#include "widgets/pair/live_pair.h"
#include "widgets/translated.h"

#include <QGroupBox>
#include <QLabel>
#include <QPushButton>

namespace alltact {

class LivePairBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  /// Both outlive it.
  LivePairBox(const LivePair& pair, const LiveSession& first, QWidget* parent = nullptr);
  void show_pair();

 Q_SIGNALS:
  void open_wanted();
  void close_wanted();
  void motor_wanted(double turns);

 private:
  void name_parts();
  [[nodiscard]] QString names_text() const;
  [[nodiscard]] QString moment_text() const;
  [[nodiscard]] QString reading_text() const;

  const LivePair& pair_;
  const LiveSession& first_;
  QPushButton *open_, *close_;
  QLabel *names_, *moment_, *reading_, *motor_label_;
  NumberField* motor_;
};

/// As it is called on the screen: the finger's name, or its folder's while that is read.
[[nodiscard]] QString finger_name(const FingerStatus& finger);

}  // namespace alltact
