#include "widgets/plots/convergence_plot.h"

#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace alltact {
namespace {

/// Labels 10⁻⁶ and 1 where the library writes 1E-06.
class PowersOfTen final : public QCPAxisTickerLog {
 protected:
  QString getTickLabel(double tick, const QLocale&, QChar, int) override {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    const int power = static_cast<int>(std::lround(std::log10(tick)));
    if (power == 0) return QStringLiteral("1");
    QString label = QStringLiteral("10");
    if (power < 0) label += QStringLiteral("⁻");
    for (const QChar digit : QString::number(std::abs(power))) label += digits[digit.digitValue()];
    return label;
  }
};

}  // namespace

ConvergencePlot::ConvergencePlot(QWidget* parent) : Plot(parent) {
  setAccessibleName(tr("How the solution settles"));
}

void ConvergencePlot::set_rounds(const std::vector<Round>& rounds) {
  if (rounds.size() == rounds_.size() && !rounds.empty()) return;  // rounds are only appended
  rounds_ = rounds;
  if (!rounds_.empty())
    setAccessibleDescription(
        tr("After %n round(s) %1 mm are left.", "", static_cast<int>(rounds_.size()))
            .arg(QLocale().toString(rounds_.back().residual_mm, 'f', 4)));
  rebuild();
}

QString ConvergencePlot::empty_text() const {
  return tr("The solution has not begun to settle yet");
}

void ConvergencePlot::draw_residual() {
  auto* line = chart().addGraph();
  double most = 0;
  for (std::size_t i = 0; i < rounds_.size(); ++i) {
    line->addData(static_cast<double>(i + 1), rounds_[i].residual_mm);
    most = std::max(most, rounds_[i].residual_mm);
  }
  line->setName(tr("Left over"));
  line->setPen(QPen(series_colour(0, palette()), 2));
  line->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, series_colour(0, palette()), 6));
  chart().yAxis->setRange(0, most > 0 ? 1.25 * most : 1);
  chart().yAxis->setLabel(tr("Left over (mm)"));
}

void ConvergencePlot::draw_change() {
  constexpr double kNone = 1e-12;  // smaller changes are drawn as this
  QCPAxis& axis = *chart().yAxis2;
  auto* line = chart().addGraph(chart().xAxis, &axis);
  double least = 1, most = kNone;
  for (std::size_t i = 0; i < rounds_.size(); ++i) {
    const double change = std::max(rounds_[i].change_mm, kNone);
    line->addData(static_cast<double>(i + 1), change);
    least = std::min(least, change);
    most = std::max(most, change);
  }
  line->setName(tr("Still moves"));
  line->setPen(QPen(series_colour(1, palette()), 2, Qt::DashLine));
  line->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssSquare, series_colour(1, palette()), 6));
  axis.setTicks(true);
  axis.setTickLabels(true);
  axis.setScaleType(QCPAxis::stLogarithmic);
  axis.setTicker(QSharedPointer<PowersOfTen>::create());
  axis.setRange(std::pow(10, std::floor(std::log10(least))),
                std::pow(10, std::ceil(std::log10(most) + 0.5)));
  axis.setLabel(tr("Unknowns still move by (mm)"));
}

bool ConvergencePlot::draw() {
  if (rounds_.empty()) return false;
  draw_residual();
  draw_change();
  chart().xAxis->setRange(0.5, static_cast<double>(std::max<std::size_t>(rounds_.size(), 8)) + 0.5);
  auto integer_ticks = QSharedPointer<QCPAxisTickerFixed>::create();
  integer_ticks->setTickStep(1);
  integer_ticks->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
  chart().xAxis->setTicker(integer_ticks);
  chart().xAxis->setLabel(tr("Round"));
  show_legend();
  return true;
}

}  // namespace alltact
