// The second finger, how both recordings are synchronised, and the distance between the faces.
#pragma once

#include "widgets/inspect/finger_pair.h"
#include "widgets/translated.h"

#include <QGroupBox>
#include <QLabel>
#include <QPushButton>

namespace alltact {

class PairBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  /// `pair` outlives it.
  explicit PairBox(const FingerPair& pair, QWidget* parent = nullptr);
  /// is_recording: a recording is open, so that a second one can be opened.
  void show_pair(bool is_recording);
  /// For the layout of another widget: the box is hidden while there is no second finger.
  [[nodiscard]] QPushButton* open_button() const { return open_; }

 Q_SIGNALS:
  void open_requested();
  void close_requested();
  void pose_requested(bool is_second);

 private:
  [[nodiscard]] QString joined_text() const;
  [[nodiscard]] QString gap_text() const;

  const FingerPair& pair_;
  QPushButton *open_, *close_, *pose_first_, *pose_second_;
  QLabel *names_, *joined_, *gap_;
};

}  // namespace alltact
