#include "widgets/calibrating/press_fit_pane.h"

#include "widgets/accessible.h"
#include "widgets/calibrating/press_model.h"
#include "widgets/calibrating/verdict_words.h"
#include "widgets/report/calibration_figures.h"

#include <QHBoxLayout>
#include <QPainter>
#include <cmath>

namespace alltact {
namespace {

constexpr int kOpaque = 170;  // of 255

Overlay squares_overlay(const PressFit& fit) {
  return [fit](QPainter& painter, const ImageTransform& transform) {
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double half = 0.5 * fit.side_px;
    for (const ResidualSample& sample : fit.residuals.samples) {
      if (!(sample.rim <= kInnerRim) || !std::isfinite(sample.residual_mm)) continue;
      const MapColour colour = cool_to_warm(sample.residual_mm / kGoodErrorMm);
      const QPointF at(sample.pixel.x(), sample.pixel.y());
      painter.fillRect(QRectF(transform.to_widget(at - QPointF(half, half)),
                              transform.to_widget(at + QPointF(half, half))),
                       QColor(colour.red, colour.green, colour.blue, kOpaque));
    }
  };
}

/// The press took part in the mapping, so this is not its error; see press_error_mm().
QString difference_text(const PressFit& fit) {
  return PressFitPane::tr("%1 mm").arg(local_mm(fit.error_mm, 3));
}

}  // namespace

std::vector<Overlay> residual_overlays(const PressFit& fit) {
  return {
      squares_overlay(fit),
      colour_bar_overlay(difference_scale(kGoodErrorMm), PressFitPane::tr("Mapping − ball, mm"))};
}

PressFitPane::PressFitPane(QWidget* parent)
    : Translated(parent), plot_(new MappingPlot), words_(new QLabel) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(plot_, 1);
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::RichText);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  say([this] { words_->setAccessibleName(tr("Mapping minus ball in this press")); });
  hide();
  words_->hide();
}

void PressFitPane::show_fit(const PressFit* fit,
                            const PressFit* before,
                            const Calibration* calibration,
                            const QString& forecast) {
  setVisible(fit != nullptr && calibration != nullptr);
  words_->setVisible(fit != nullptr && calibration != nullptr);
  if (fit == nullptr || calibration == nullptr) return;
  MappingPlotData data = mapping_figure(*calibration, {fit->residuals});
  data.is_small = true;
  plot_->set_data(std::move(data));
  QStringList lines{tr("<b>Mapping − ball here:</b> %1").arg(difference_text(*fit))};
  if (before != nullptr)
    lines << tr("as the calibration puts it: %1").arg(difference_text(*before));
  if (!forecast.isEmpty()) lines << forecast.toHtmlEscaped();
  words_->setText(lines.join(QStringLiteral("<br>")));
}

}  // namespace alltact
