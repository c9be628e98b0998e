#include "widgets/inspect/section_plot.h"

#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {

void SectionPlot::set_profiles(Profile profile, std::optional<Profile> other) {
  profile_ = std::move(profile);
  other_ = std::move(other);
  setAccessibleName(tr("Depth from A to B"));
  rebuild();
}

QString SectionPlot::csv() const {
  const auto number = [](double value) {
    return std::isfinite(value) ? QString::number(value, 'g', 8) : QString();
  };
  /// Depth of `other`, linearly interpolated between its own positions.
  const auto other_at = [&](double along_mm) {
    if (!other_) return std::numeric_limits<double>::quiet_NaN();
    const auto& all = other_->along_mm;
    const auto next = std::lower_bound(all.begin(), all.end(), along_mm);
    if (next == all.end()) return std::numeric_limits<double>::quiet_NaN();
    const auto i = static_cast<std::size_t>(next - all.begin());
    if (i == 0 || all[i] == along_mm) return other_->depth_mm[i];
    const double part = (along_mm - all[i - 1]) / (all[i] - all[i - 1]);
    return (1 - part) * other_->depth_mm[i - 1] + part * other_->depth_mm[i];
  };
  QString text = QStringLiteral("along_mm,depth_mm,sd_mm") +
                 (other_ ? QStringLiteral(",other_depth_mm\n") : QStringLiteral("\n"));
  for (std::size_t i = 0; i < profile_.along_mm.size(); ++i) {
    text += number(profile_.along_mm[i]) + QLatin1Char(',') + number(profile_.depth_mm[i]) +
            QLatin1Char(',') + number(profile_.sd_mm[i]);
    if (other_) text += QLatin1Char(',') + number(other_at(profile_.along_mm[i]));
    text += QLatin1Char('\n');
  }
  return text;
}

QString SectionPlot::empty_text() const {
  return tr("Choose two points, A and B");
}

bool SectionPlot::draw() {
  if (profile_.along_mm.size() < 2) return false;
  const auto vector_of = [](const std::vector<double>& values) {
    return QVector<double>(values.begin(), values.end());
  };
  double top = 0.1, low = 0;
  const auto widen = [&](const std::vector<double>& depths) {
    for (const double depth : depths) {
      if (!std::isfinite(depth)) continue;
      top = std::max(top, 1.15 * depth);
      low = std::min(low, 1.15 * depth);
    }
  };
  widen(profile_.depth_mm);
  // One standard deviation on each side.
  auto* upper = chart().addGraph();
  auto* lower = chart().addGraph();
  for (std::size_t i = 0; i < profile_.along_mm.size(); ++i) {
    upper->addData(profile_.along_mm[i], profile_.depth_mm[i] + profile_.sd_mm[i]);
    lower->addData(profile_.along_mm[i], profile_.depth_mm[i] - profile_.sd_mm[i]);
  }
  QColor band = series_colour(0, palette());
  band.setAlpha(60);
  upper->setPen(Qt::NoPen);
  lower->setPen(Qt::NoPen);
  upper->setBrush(band);
  upper->setChannelFillGraph(lower);
  auto* line = chart().addGraph();
  line->setData(vector_of(profile_.along_mm), vector_of(profile_.depth_mm), true);
  line->setPen(QPen(series_colour(0, palette()), 2));
  if (other_) {
    auto* second = chart().addGraph();
    second->setData(vector_of(other_->along_mm), vector_of(other_->depth_mm), true);
    second->setPen(QPen(series_colour(1, palette()), 2, Qt::DashLine));
    widen(other_->depth_mm);
    for (auto* hidden : {upper, lower}) hidden->removeFromLegend();
    line->setName(tr("shown"));
    second->setName(other_name_);
    show_legend();
  }
  chart().xAxis->setRange(0, profile_.along_mm.back());
  chart().yAxis->setRange(low, top);
  chart().xAxis->setLabel(tr("From A over the face (mm)"));
  chart().yAxis->setLabel(tr("Depth (mm)"));
  return true;
}

}  // namespace alltact
