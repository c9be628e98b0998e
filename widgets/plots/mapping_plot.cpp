#include "widgets/plots/mapping_plot.h"

#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>

namespace alltact {

void MappingPlot::set_data(MappingPlotData data) {
  data_ = std::move(data);
  setAccessibleName(tr("Mapping from brightness to depth"));
  rebuild();
}

QString MappingPlot::empty_text() const {
  return tr("No mapping yet: calibrate with ball presses");
}

/// Plus and minus two standard deviations, below points and curve.
void MappingPlot::draw_band() {
  auto* low = chart().addGraph();
  auto* high = chart().addGraph();
  for (const auto& point : data_.curve) {
    low->addData(point.x, point.depth_mm - 2 * point.sd_mm);
    high->addData(point.x, point.depth_mm + 2 * point.sd_mm);
  }
  QColor colour = series_colour(1, palette());
  low->setPen(Qt::NoPen);
  high->setPen(Qt::NoPen);
  colour.setAlpha(90);
  high->setBrush(colour);
  high->setChannelFillGraph(low);
  high->setName(tr("± 2 standard deviations"));
  low->removeFromLegend();
}

void MappingPlot::draw_points(bool certain, const QString& name) {
  auto* cloud = chart().addGraph();
  QColor colour =
      certain ? series_colour(0, palette()) : palette().color(QPalette::Disabled, QPalette::Text);
  colour.setAlpha(certain ? 170 : 120);
  cloud->setLineStyle(QCPGraph::lsNone);
  cloud->setScatterStyle(QCPScatterStyle(
      certain ? QCPScatterStyle::ssDisc : QCPScatterStyle::ssCross, colour, certain ? 3.0 : 4.0));
  for (const auto& point : data_.points)
    if (point.is_certain == certain) cloud->addData(point.x, point.depth_mm);
  cloud->setName(name);
  if (cloud->dataCount() == 0) chart().removeGraph(cloud);
}

void MappingPlot::draw_chosen() {
  auto* cloud = chart().addGraph();
  cloud->setLineStyle(QCPGraph::lsNone);
  cloud->setScatterStyle(
      QCPScatterStyle(QCPScatterStyle::ssPlus, palette().color(QPalette::Text), 5.0));
  for (const auto& point : data_.points)
    if (point.is_chosen) cloud->addData(point.x, point.depth_mm);
  cloud->setName(data_.chosen);
  if (cloud->dataCount() == 0) chart().removeGraph(cloud);
}

bool MappingPlot::draw() {
  if (data_.curve.empty()) return false;
  draw_band();
  draw_points(false, tr("nearer the rim"));
  draw_points(true, tr("inner part of a contact"));
  draw_chosen();
  auto* curve = chart().addGraph();
  for (const auto& point : data_.curve) curve->addData(point.x, point.depth_mm);
  curve->setPen(QPen(series_colour(1, palette()), 2));
  curve->setName(tr("mapping"));

  double deepest = 0, darkest = data_.x_max;
  for (const auto& point : data_.curve) deepest = std::max(deepest, point.depth_mm);
  for (const auto& point : data_.points) {
    deepest = std::max(deepest, point.depth_mm);
    darkest = std::max(darkest, point.x);
  }
  chart().xAxis->setLabel(data_.is_small
                              ? tr("Brightness difference x (no unit)")
                              : tr("Brightness difference x (share of the untouched brightness)"));
  chart().yAxis->setLabel(data_.is_small               ? tr("Depth (mm)")
                          : data_.depth_axis.isEmpty() ? tr("Press depth (mm)")
                                                       : data_.depth_axis);
  chart().xAxis->setRange(std::min(0.0, -0.02 * darkest), 1.06 * darkest);
  chart().yAxis->setRange(-0.04 * deepest, 1.12 * deepest);
  if (data_.x_max > 0) {
    auto* end = new QCPItemLine(&chart());
    end->start->setCoords(data_.x_max, chart().yAxis->range().lower);
    end->end->setCoords(data_.x_max, chart().yAxis->range().upper);
    end->setPen(QPen(palette().color(QPalette::Text), 1, Qt::DashLine));
    if (!data_.is_small)
      add_note(data_.x_max, 0, tr("end of the calibrated range"), Qt::AlignRight | Qt::AlignBottom);
  }
  if (!data_.is_small) show_legend();
  return true;
}

}  // namespace alltact
