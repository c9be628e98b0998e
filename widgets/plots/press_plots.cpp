#include "widgets/plots/press_plots.h"

#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"
#include "widgets/widget_base.h"

#include <QKeyEvent>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kLongestName = 22;

/// Presses are sorted and labelled by the press's error; where it is missing (one press only) by
/// the residual.
double shown_mm(const PressError& error) { return error.held_out_mm.value_or(error.residual_mm); }

double longest_bar_mm(const std::vector<PressError>& errors) {
  double longest = 1e-6;
  for (const PressError& error : errors)
    longest = std::max({longest, error.residual_mm, error.held_out_mm.value_or(0.0)});
  return longest;
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
    return shown_mm(a) > shown_mm(b);
  });
  if (!chosen_row()) chosen_.clear();
  announce();
  rebuild();
}

void PressErrorPlot::enable_choice() {
  can_choose_ = true;
  setFocusPolicy(Qt::StrongFocus);
  connect(&chart(), &QCustomPlot::mousePress, this, [this](QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) press(event->position());
  });
  connect(&chart(), &QCustomPlot::mouseDoubleClick, this, [this] {
    if (!chosen_.empty()) Q_EMIT press_opened(chosen_);
  });
  connect(&chart(), &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) {
    chart().setCursor(row_at(event->position()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
  });
  chart().setMouseTracking(true);
}

void PressErrorPlot::choose(const std::string& press) {
  const std::string before = std::exchange(chosen_, press);
  if (!chosen_row()) chosen_.clear();
  if (chosen_ == before) return;
  announce();
  rebuild();
}

void PressErrorPlot::choose_by_hand(const std::string& press) {
  const std::string before = chosen_;
  choose(press);
  if (chosen_ != before) Q_EMIT press_chosen(chosen_);
}

void PressErrorPlot::announce() {
  if (errors_.empty()) return;
  const auto words = [](const QString& sentence, const PressError& error) {
    return sentence.arg(QString::fromStdString(error.press),
                        QLocale().toString(shown_mm(error), 'f', 3));
  };
  setAccessibleDescription(
      words(tr("The worst of %n press(es) is %1 with %2 mm.", "", static_cast<int>(errors_.size())),
            errors_.front()));
  if (!can_choose_) return;
  const auto row = chosen_row();
  set_accessible_value(*this, row ? words(tr("%1: %2 mm"), errors_[static_cast<std::size_t>(*row)])
                                  : tr("No press is chosen"));
}

int PressErrorPlot::shown() const { return std::min(kShown, static_cast<int>(errors_.size())); }

std::optional<int> PressErrorPlot::chosen_row() const {
  for (int i = 0; i < shown(); ++i)
    if (errors_[static_cast<std::size_t>(i)].press == chosen_) return i;
  return std::nullopt;
}

/// A row includes its name and its bars.
std::optional<int> PressErrorPlot::row_at(const QPointF& pixel) const {
  const QRect axes = chart().axisRect()->rect();
  if (errors_.empty() || pixel.y() < axes.top() || pixel.y() > axes.bottom()) return std::nullopt;
  const double from_below = chart().yAxis->pixelToCoord(pixel.y());
  const int row = shown() - 1 - static_cast<int>(std::lround(from_below));
  return row >= 0 && row < shown() ? std::optional(row) : std::nullopt;
}

void PressErrorPlot::press(const QPointF& pixel) {
  setFocus(Qt::MouseFocusReason);
  const auto row = row_at(pixel);
  choose_by_hand(row ? errors_[static_cast<std::size_t>(*row)].press : std::string());
}

void PressErrorPlot::keyPressEvent(QKeyEvent* event) {
  if (!can_choose_ || errors_.empty()) return Plot::keyPressEvent(event);
  const auto row = chosen_row();
  const auto go = [this](int to) {
    choose_by_hand(errors_[static_cast<std::size_t>(std::clamp(to, 0, shown() - 1))].press);
  };
  switch (event->key()) {
    case Qt::Key_Up:
      return go(row ? *row - 1 : shown() - 1);
    case Qt::Key_Down:
      return go(row ? *row + 1 : 0);
    case Qt::Key_Home:
      return go(0);
    case Qt::Key_End:
      return go(shown() - 1);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (row) Q_EMIT press_opened(chosen_);
      return;
    case Qt::Key_Escape:
      if (!row) break;
      return choose_by_hand({});
    default:
      break;
  }
  Plot::keyPressEvent(event);
}

/// A frame round the chosen row, behind its bars.
void PressErrorPlot::draw_chosen() {
  const auto row = chosen_row();
  if (!row) return;
  const double middle = shown() - 1 - *row;
  auto* frame = new QCPItemRect(&chart());
  frame->setLayer(QStringLiteral("background"));
  frame->topLeft->setTypeX(QCPItemPosition::ptAxisRectRatio);
  frame->bottomRight->setTypeX(QCPItemPosition::ptAxisRectRatio);
  frame->topLeft->setCoords(0, middle + 0.5);
  frame->bottomRight->setCoords(1, middle - 0.5);
  QColor inside = role_colour(ColourRole::kChosen, palette());
  frame->setPen(QPen(inside, 2));
  inside.setAlpha(50);
  frame->setBrush(inside);
}

QString PressErrorPlot::title() const { return tr("Error of every press, worst first"); }

QString PressErrorPlot::empty_text() const { return tr("No presses yet"); }

int PressErrorPlot::comfortable_height() const { return 160 + 30 * std::max(2, shown()); }

bool PressErrorPlot::draw() {
  if (errors_.empty()) return false;
  const int shown = this->shown();
  draw_chosen();
  auto* own = new QCPBars(chart().yAxis, chart().xAxis);
  auto* held_out = new QCPBars(chart().yAxis, chart().xAxis);
  auto* group = new QCPBarsGroup(&chart());
  group->setSpacingType(QCPBarsGroup::stAbsolute);
  group->setSpacing(1);
  // The group stacks upwards, so the first to read comes last.
  for (QCPBars* bars : {held_out, own}) {
    bars->setBarsGroup(group);
    bars->setWidth(0.36);
  }
  own->setName(tr("with this press in the mapping"));
  own->setPen(Qt::NoPen);
  own->setBrush(role_colour(ColourRole::kMeasured, palette()));
  held_out->setName(tr("without this press: its error"));
  held_out->setPen(QPen(role_colour(ColourRole::kExpected, palette()), 1));
  held_out->setBrush(QBrush(role_colour(ColourRole::kExpected, palette()), Qt::Dense4Pattern));

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
  chart().xAxis->setRange(0, 1.05 * longest_bar_mm(errors_));
  const int cut = static_cast<int>(errors_.size()) - shown;
  chart().xAxis->setLabel(cut > 0 ? tr("Mapping minus ball in the contact, mean (mm); %n "
                                       "better press(es) not shown",
                                       "", cut)
                                  : tr("Mapping minus ball in the contact, mean (mm)"));
  show_legend();
  return true;
}

void PressLightPlot::set_data(std::vector<PressLight> presses, double limit_percent) {
  presses_ = std::move(presses);
  limit_percent_ = limit_percent;
  rebuild();
}

QString PressLightPlot::title() const { return tr("Light of every press"); }

QString PressLightPlot::empty_text() const { return tr("No presses yet"); }

bool PressLightPlot::draw() {
  if (presses_.empty()) return false;
  auto* bars = new QCPBars(chart().xAxis, chart().yAxis);
  bars->setWidth(0.6);
  bars->setPen(Qt::NoPen);
  bars->setBrush(role_colour(ColourRole::kMeasured, palette()));
  double reach = 1.3 * limit_percent_;
  double number = 1;
  for (const PressLight& press : presses_) {
    bars->addData(number++, press.percent);
    reach = std::max(reach, 1.15 * std::abs(press.percent));
  }
  if (!(reach > 0)) reach = 1;
  const double last = static_cast<double>(presses_.size());
  chart().xAxis->setRange(0.3, last + 0.7);
  chart().yAxis->setRange(-reach, reach);
  QSharedPointer<QCPAxisTickerFixed> integer_ticks(new QCPAxisTickerFixed);
  integer_ticks->setTickStep(std::max(1.0, std::ceil(last / 12)));
  chart().xAxis->setTicker(integer_ticks);
  chart().xAxis->grid()->setVisible(false);
  chart().xAxis->setLabel(tr("Press, by number"));
  chart().yAxis->setLabel(tr("Light (%)"));
  for (const double limit : {-limit_percent_, 0.0, limit_percent_}) {
    auto* line = new QCPItemLine(&chart());
    line->start->setCoords(0, limit);
    line->end->setCoords(last + 1, limit);
    line->setPen(
        QPen(palette().color(QPalette::Text), 1, limit == 0 ? Qt::SolidLine : Qt::DashLine));
  }
  return true;
}

}  // namespace alltact
