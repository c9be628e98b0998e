#include "widgets/plots/press_error_plot.h"

#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>

namespace alltact {
namespace {

constexpr int kLongestName = 22;

double worst_of(const PressError& error) {
  return std::max(error.residual_mm, error.held_out_mm.value_or(0.0));
}

QString short_name(const std::string& name) {
  const QString text = QString::fromStdString(name);
  if (text.size() <= kLongestName) return text;
  return text.left(kLongestName / 2) + QChar(0x2026) + text.right(kLongestName / 2 - 1);
}

}  // namespace

void PressErrorPlot::set_data(std::vector<PressError> errors) {
  errors_ = std::move(errors);
  std::stable_sort(errors_.begin(), errors_.end(), [](const PressError& a, const PressError& b) {
    return worst_of(a) > worst_of(b);
  });
  setAccessibleName(tr("Error of every press, worst first"));
  if (!errors_.empty())
    setAccessibleDescription(
        tr("The worst of %n press(es) is %1 with %2 mm.", "", static_cast<int>(errors_.size()))
            .arg(QString::fromStdString(errors_.front().press))
            .arg(worst_of(errors_.front()), 0, 'f', 3));
  rebuild();
}

QString PressErrorPlot::empty_text() const {
  return tr("No presses yet");
}

int PressErrorPlot::comfortable_height() const {
  const int shown = std::min(kShown, static_cast<int>(errors_.size()));
  return 130 + 30 * std::max(2, shown);
}

bool PressErrorPlot::draw() {
  if (errors_.empty()) return false;
  const int shown = std::min(kShown, static_cast<int>(errors_.size()));
  auto* own = new QCPBars(chart().yAxis, chart().xAxis);
  auto* held_out = new QCPBars(chart().yAxis, chart().xAxis);
  auto* group = new QCPBarsGroup(&chart());
  group->setSpacingType(QCPBarsGroup::stAbsolute);
  group->setSpacing(1);
  // The group stacks upwards: what is read first comes last.
  for (QCPBars* bars : {held_out, own}) {
    bars->setBarsGroup(group);
    bars->setWidth(0.36);
  }
  own->setName(tr("residual: the mapping knows this press"));
  own->setPen(Qt::NoPen);
  own->setBrush(series_colour(0, palette()));
  held_out->setName(tr("left out: the mapping was made without it"));
  held_out->setPen(QPen(series_colour(1, palette()), 1));
  held_out->setBrush(QBrush(series_colour(1, palette()), Qt::Dense4Pattern));

  QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
  bool any_held_out = false;
  for (int i = 0; i < shown; ++i) {
    const PressError& error = errors_[static_cast<std::size_t>(i)];
    const double row = shown - 1 - i;
    names->addTick(row, short_name(error.press));
    own->addData(row, error.residual_mm);
    if (error.held_out_mm) held_out->addData(row, *error.held_out_mm);
    any_held_out = any_held_out || error.held_out_mm.has_value();
  }
  if (!any_held_out) held_out->removeFromLegend();
  chart().yAxis->setTicker(names);
  chart().yAxis->setTickLength(0);
  chart().yAxis->grid()->setVisible(false);
  chart().yAxis->setRange(-0.6, shown - 0.4);
  chart().xAxis->setRange(0, 1.05 * std::max(worst_of(errors_.front()), 1e-6));
  const int cut = static_cast<int>(errors_.size()) - shown;
  chart().xAxis->setLabel(cut > 0 ? tr("Mean depth error inside the contact (mm); %n better "
                                       "press(es) not shown",
                                       "",
                                       cut)
                                  : tr("Mean depth error inside the contact (mm)"));
  show_legend();
  return true;
}

}  // namespace alltact
