// The second live finger, the time difference of both views, and joint readings.
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
  void open_requested();
  void close_requested();
  void motor_requested(double turns);

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

/// The finger's name or, while it is being read, its folder's name.
[[nodiscard]] QString finger_name(const FingerStatus& finger);

}  // namespace alltact
