// What a place is for, said when somebody comes there for the first time; sent away it stays away.
// The words are those with which the place's help begins.
#pragma once

#include "app/studio/try_guide.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>

namespace alltact {

class PlaceHint : public Translated<QFrame> {
  Q_OBJECT
 public:
  /// Silent while `guide` speaks.
  explicit PlaceHint(const TryGuide& guide, QWidget* parent = nullptr);
  /// By its name.
  void show_for(const std::string& place);
  /// What is kept of a place whose hint was sent away.
  [[nodiscard]] static QString key(const std::string& place);

 Q_SIGNALS:
  void help_wanted();

 private:
  void follow();

  const TryGuide& guide_;
  std::string place_;
  QLabel* text_;
  QPushButton *more_, *seen_;
};

}  // namespace alltact
