#include "widgets/panels/brightness_box.h"

#include "calibration/checks/rig_check.h"
#include "core/image/grey_range.h"
#include "widgets/copy_figure.h"
#include "widgets/language.h"
#include "widgets/theme.h"

#include <QLocale>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace alltact {

LevelsPlot::LevelsPlot(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  set_accessible_role(*this, QAccessible::Chart);
  new CopyFigure(*this, [this] { return grab().toImage(); });
}

void LevelsPlot::set_data(const std::optional<FaceLevels>& levels) {
  levels_ = levels;
  update();
}

void LevelsPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  if (levels_) {
    const auto& counts = levels_->counts;
    const int most = *std::max_element(counts.begin(), counts.end());
    const double bar_width = static_cast<double>(width()) / static_cast<double>(counts.size());
    for (std::size_t i = 0; i < counts.size() && most > 0; ++i) {
      if (counts[i] == 0) continue;
      const int level = static_cast<int>(i) * FaceLevels::kLevelsPerBin;
      const bool is_bright = level + FaceLevels::kLevelsPerBin > kClippedFrom;
      const bool is_dark = level < kTooDarkBelow;
      const QColor colour = is_bright || is_dark ? meaning_colour(Meaning::kBad, palette())
                                                 : role_colour(ColourRole::kMeasured, palette());
      // The root shows a few clipped pixels next to many others.
      const double bar_height =
          std::max(1.0, std::sqrt(static_cast<double>(counts[i]) / most) * (height() - 2));
      painter.fillRect(QRectF(bar_width * static_cast<double>(i), height() - bar_height,
                              std::max(1.0, bar_width), bar_height),
                       colour);
    }
  }
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

BrightnessBox::BrightnessBox(QWidget* parent)
    : Translated(parent),
      plot_(new LevelsPlot),
      text_(new QLabel),
      base_{.now_px = {}, .best = {}, .text = new QLabel},
      tip_{.now_px = {}, .best = {}, .text = new QLabel} {
  auto* column = without_margins(new QVBoxLayout(this));
  for (QLabel* label : {text_, base_.text, tip_.text}) {
    label->setFont(text_font(font(), TextSize::kSmall));
    label->setMinimumWidth(1);
  }
  add_widgets(*column, {plot_, text_, base_.text, tip_.text});
  clock_.start();
  say([this] {
    plot_->setAccessibleName(tr("Pixels by grey level"));
    plot_->setToolTip(
        tr("Pixels by grey level, dark at the left. Bars in another colour at the ends are too "
           "dark or too bright to measure."));
    for (QLabel* label : {base_.text, tip_.text})
      label->setToolTip(
          tr("Width of the edges of the face in the image: the smaller, the sharper. A sharp image "
             "has about 2 to 4 px. Turn the lens until both ends are sharp. Best: the least of the "
             "last 30 seconds."));
    show_text();
  });
}

void BrightnessBox::show_image(const FrameResult* result) {
  levels_.reset();
  const bool has_image = result != nullptr && !result->grey.empty();
  if (has_image) levels_ = face_levels(result->grey, result->edges ? &*result->edges : nullptr);
  const double now_s = 1e-3 * static_cast<double>(clock_.elapsed());
  base_.add(has_image ? edge_sharpness_px(*result, false) : std::nullopt, now_s);
  tip_.add(has_image ? edge_sharpness_px(*result, true) : std::nullopt, now_s);
  plot_->set_data(levels_);
  show_text();
}

void BrightnessBox::Sharpness::add(const std::optional<double>& width_px, double time_s) {
  now_px = width_px;
  while (!best.empty() && best.front().first < time_s - kBest_s) best.pop_front();
  if (!width_px) return;
  while (!best.empty() && best.back().second >= *width_px) best.pop_back();
  best.emplace_back(time_s, *width_px);
}

void BrightnessBox::show_text() {
  text_->setText(levels_text());
  set_accessible_value(*plot_, text_->text());
  const auto px = [](double width) { return QLocale().toString(width, 'f', 1); };
  const auto width = [&](const Sharpness& at) {
    return at.now_px ? tr("%1 px (best: %2 px)").arg(px(*at.now_px), px(at.best.front().second))
                     : tr("no edges in view");
  };
  base_.text->setText(tr("Focus at the base: %1").arg(width(base_)));
  tip_.text->setText(tr("Focus at the tip: %1").arg(width(tip_)));
}

QString BrightnessBox::levels_text() const {
  if (!levels_) return tr("No image yet.");
  const QLocale locale;
  const auto percent = [&](double part) {
    const double value = 100 * part;
    return value > 0 && value < 0.1 ? tr("< %1 %").arg(locale.toString(0.1, 'f', 1))
                                    : tr("%1 %").arg(locale.toString(value, 'f', 1));
  };
  return (levels_->is_of_face ? tr("Face: %1 too bright, %2 too dark")
                              : tr("Image: %1 too bright, %2 too dark"))
      .arg(percent(levels_->too_bright), percent(levels_->too_dark));
}

}  // namespace alltact
