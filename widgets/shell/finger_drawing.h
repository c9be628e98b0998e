// Drawings of what the program is about, in the window's colours: the finger seen from its side,
// and the layer where a ball presses. Without words, so that they need no language; with numbers,
// which the glossary explains.
#pragma once

#include <QPainter>
#include <QWidget>

namespace alltact {

enum class DrawnThing { kFinger = 1, kPress };

class FingerDrawing : public QWidget {
  Q_OBJECT
 public:
  explicit FingerDrawing(DrawnThing what, QWidget* parent = nullptr);
  void show_numbers(bool are_wanted);
  [[nodiscard]] QSize sizeHint() const override { return {640, 320}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {120, 60}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  DrawnThing what_;
  bool has_numbers_ = false;
};

}  // namespace alltact
