// Brightness and focus of the live image, next to the controls of the camera that change them.
#pragma once

#include "core/sensing/face/face_levels.h"
#include "core/sensing/frame_result.h"
#include "widgets/widget_base.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QWidget>
#include <deque>
#include <optional>
#include <utility>

namespace alltact {

/// Pixels by grey level; bars of too dark and of clipped levels have their own colours.
class LevelsPlot : public QWidget {
  Q_OBJECT
 public:
  explicit LevelsPlot(QWidget* parent = nullptr);
  void set_data(const std::optional<FaceLevels>& levels);
  [[nodiscard]] QSize sizeHint() const override { return {200, 56}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {64, 56}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<FaceLevels> levels_;
};

class BrightnessBox : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit BrightnessBox(QWidget* parent = nullptr);
  /// Null: no image.
  void show_image(const FrameResult* result);

  /// The sharpest edges of the last kBest_s: whoever turns the lens sees when it was passed.
  static constexpr double kBest_s = 30.0;

 private:
  /// Width of the edges at the base or at the tip (edge_sharpness_px).
  struct Sharpness {
    std::optional<double> now_px;
    std::deque<std::pair<double, double>> best;  // time, s, and px: ascending in both
    QLabel* text;
    void add(const std::optional<double>& width_px, double time_s);
  };
  void show_text();
  [[nodiscard]] QString levels_text() const;

  std::optional<FaceLevels> levels_;
  QElapsedTimer clock_;
  LevelsPlot* plot_;
  QLabel* text_;
  Sharpness base_, tip_;
};

}  // namespace alltact
