// What the ball's position means for one press: the error of the mapping under it, as an image
// overlay and as points around the curve. Updated while an outline is dragged.
#pragma once

#include "calibration/finger/forecast_calibration.h"
#include "widgets/image/overlays.h"
#include "widgets/plots/mapping_plot.h"
#include "widgets/translated.h"

#include <QLabel>
#include <QWidget>
#include <optional>

namespace alltact {

/// Mapping minus ball over the contact as colours: red where the mapping is too deep.
[[nodiscard]] std::vector<Overlay> residual_overlays(const PressFit& fit);

class PressFitPane : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit PressFitPane(QWidget* parent = nullptr);

  /// fit: at the current ball position; before: at the calibrated position, if the ball was moved
  /// by hand. Null fit: the pane is hidden. `forecast`: expected accuracy with all presses.
  void show_fit(const PressFit* fit,
                const PressFit* before,
                const Calibration* calibration,
                const QString& forecast);

  /// Text of the plot, for the layout next to the image; shown and hidden with the pane.
  [[nodiscard]] QLabel* words() const { return words_; }

  [[nodiscard]] QSize sizeHint() const override { return {640, 190}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 150}; }

 private:
  MappingPlot* plot_;
  QLabel* words_;
};

}  // namespace alltact
