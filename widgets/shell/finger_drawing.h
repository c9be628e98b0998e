// Drawings of the finger from its side, and of the layer under a ball, in the window's colours.
// The glossary explains their numbers.
#pragma once

#include <QPainter>
#include <QStringList>
#include <QWidget>

namespace alltact {

enum class DrawnThing { kFinger = 1, kPress };

class FingerDrawing : public QWidget {
  Q_OBJECT
 public:
  explicit FingerDrawing(DrawnThing what, QWidget* parent = nullptr);
  void show_numbers(bool are_shown);
  /// Of the parts in the order of their numbers, shown instead of those; an empty one is not shown.
  void show_names(const QStringList& names);
  [[nodiscard]] QSize sizeHint() const override { return {640, 320}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {120, 60}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  DrawnThing what_;
  bool has_numbers_ = false;
  QStringList names_;
};

}  // namespace alltact
