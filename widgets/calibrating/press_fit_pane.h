// What the ball's place means for one press: how far the mapping is off under it, as a picture, and
// its points beside the curve, at once while an outline is dragged.
#pragma once

#include "calibration/finger/forecast_calibration.h"
#include "widgets/picture/overlays.h"
#include "widgets/plots/mapping_plot.h"
#include "widgets/translated.h"

#include <QLabel>
#include <QWidget>
#include <optional>

namespace alltact {

/// Mapping minus ball over the contact, in colours: red where the mapping reads too deep.
[[nodiscard]] std::vector<Overlay> residual_overlays(const PressFit& fit);

class PressFitPane : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit PressFitPane(QWidget* parent = nullptr);

  /// fit: with the ball where it is now; before: where the calibration puts it, if a hand moved it.
  /// Null: nothing to compare with, and the pane is hidden. `forecast`: a sentence about the whole.
  void show_fit(const PressFit* fit,
                const PressFit* before,
                const Calibration* calibration,
                const QString& forecast);

  /// What the plot says, to be laid out beside the picture; shown with it.
  [[nodiscard]] QLabel* words() const { return words_; }

  [[nodiscard]] QSize sizeHint() const override { return {640, 190}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 150}; }

 private:
  MappingPlot* plot_;
  QLabel* words_;
};

}  // namespace alltact
