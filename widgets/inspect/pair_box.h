// Beside what is shown: the second finger, how its frames are joined, and how far it is away.
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
  /// is_recording: a recording is shown, which a second one can be joined to.
  void show_pair(bool is_recording);
  /// Stands wherever there is room for it: the box is hidden while there is no second finger.
  [[nodiscard]] QPushButton* open_button() const { return open_; }

 Q_SIGNALS:
  void open_wanted();
  void close_wanted();
  void place_wanted(bool is_second);

 private:
  [[nodiscard]] QString joined_text() const;
  [[nodiscard]] QString gap_text() const;

  const FingerPair& pair_;
  QPushButton *open_, *close_, *place_first_, *place_second_;
  QLabel *names_, *joined_, *gap_;
};

}  // namespace alltact
