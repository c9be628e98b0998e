#include "widgets/plots/force_plot.h"

#include "core/numerics/round_step.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr double kNoForce = std::numeric_limits<double>::quiet_NaN();  // breaks a line
constexpr double kLeastSpan_N = 1.0;
constexpr double kBetweenPoints_s = 0.05;  // nearer points share a pixel and cost drawing time

}  // namespace

void ForcePlot::set_data(const TouchHistory& history, const std::optional<ForceZero>& zero) {
  history_ = history;
  zero_ = zero;
  rebuild();
}

void ForcePlot::set_empty_text(const QString& text) {
  if (text == empty_text_) return;
  empty_text_ = text;
  rebuild();
}

/// Covers the readings in range with their intervals. Readings out of range count only where there
/// are no others, since they can have any value.
void ForcePlot::set_span() {
  for (const bool is_in_range : {true, false}) {
    double low = 0, top = 0;
    bool is_any = false;
    for (const auto& reading : history_.forces()) {
      if (!reading.force || reading.force->in_range != is_in_range) continue;
      const Force force = zeroed(*reading.force, zero_);
      is_any = true;
      for (Eigen::Index axis = 0; axis < force.axes; ++axis) {
        const double half = is_in_range ? force.half_95_N[axis] : 0.0;
        low = std::min(low, force.force_N[axis] - half);
        top = std::max(top, force.force_N[axis] + half);
      }
    }
    const double step = round_step(std::max(top - low, kLeastSpan_N)) / 4;
    low_N_ = step * std::floor(low / step);
    top_N_ = step * std::ceil(std::max(top, low_N_ + step) / step);
    if (is_any) return;
  }
}

void ForcePlot::draw_contacts() {
  for (const auto& contact : history_.contacts())
    draw_span(contact.from_s, contact.to_s, 26, Qt::SolidPattern);
  for (const auto& slip : history_.slips()) draw_span(slip.from_s, slip.to_s, 90, Qt::BDiagPattern);
}

void ForcePlot::draw_span(double from_s, double to_s, int alpha, Qt::BrushStyle style) {
  const double now = *history_.now_s();
  auto* span = new QCPItemRect(&chart());
  span->setLayer("background");
  span->topLeft->setCoords(std::max(from_s - now, -TouchHistory::kLength_s), top_N_);
  span->bottomRight->setCoords(to_s - now, low_N_);
  span->setPen(Qt::NoPen);
  QColor colour = palette().color(QPalette::Text);
  colour.setAlpha(alpha);
  span->setBrush(QBrush(colour, style));
}

QString ForcePlot::axis_name(int axis) const {
  return axis == 0 ? QStringLiteral("Fx") : axis == 1 ? QStringLiteral("Fy") : QStringLiteral("Fz");
}

void ForcePlot::draw_axis(int axis) {
  constexpr std::array kStyles{Qt::SolidLine, Qt::DashLine, Qt::DashDotLine};
  const QColor colour = series_colour(axis, palette());
  QColor band = colour;
  band.setAlpha(50);
  std::array<QVector<double>, 5> columns;  // time, force, both ends, out of range
  auto& [times, forces, uppers, lowers, others] = columns;
  std::optional<double> last_s;
  bool had_force = false;
  for (const auto& reading : history_.forces()) {
    const bool is_like_last = had_force == reading.force.has_value();
    if (last_s && is_like_last && reading.time_s - *last_s < kBetweenPoints_s) continue;
    last_s = reading.time_s;
    had_force = reading.force.has_value();
    times << reading.time_s - *history_.now_s();
    const bool has_force = reading.force && axis < reading.force->axes;
    const Force force = has_force ? zeroed(*reading.force, zero_) : Force();
    const double value = force.force_N[axis], half = force.half_95_N[axis];
    const bool is_valid = has_force && force.in_range;
    forces << (is_valid ? value : kNoForce);
    uppers << (is_valid ? value + half : kNoForce);
    lowers << (is_valid ? value - half : kNoForce);
    others << (has_force && !is_valid ? value : kNoForce);
  }
  auto* upper = chart().addGraph();
  auto* lower = chart().addGraph();
  upper->setData(times, uppers, true);
  lower->setData(times, lowers, true);
  upper->setPen(Qt::NoPen);
  lower->setPen(Qt::NoPen);
  upper->setBrush(band);
  upper->setChannelFillGraph(lower);
  auto* unsure = chart().addGraph();
  unsure->setData(times, others, true);
  unsure->setPen(QPen(colour, 1, Qt::DotLine));
  auto* line = chart().addGraph();
  line->setData(times, forces, true);
  line->setPen(QPen(colour, 2, kStyles[static_cast<std::size_t>(axis)]));
  line->setName(axis_name(axis));
  for (auto* hidden : {upper, lower, unsure}) hidden->removeFromLegend();
}

bool ForcePlot::draw() {
  if (!history_.has_forces()) return false;
  set_span();
  chart().xAxis->setRange(-TouchHistory::kLength_s, 0);
  chart().yAxis->setRange(low_N_, top_N_);
  draw_contacts();
  int axes = 0;
  for (const auto& reading : history_.forces())
    if (reading.force) axes = std::max(axes, reading.force->axes);
  for (int axis = 0; axis < axes; ++axis) draw_axis(axis);
  chart().xAxis->setLabel(tr("Time (s)"));
  chart().yAxis->setLabel(tr("Force (N)"));
  show_legend();
  return true;
}

}  // namespace alltact
