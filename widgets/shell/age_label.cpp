#include "widgets/shell/age_label.h"

#include "widgets/theme.h"

#include <QApplication>
#include <QLocale>

namespace alltact {

AgeLabel::AgeLabel(QWidget* parent) : Translated<QLabel>(parent) {
  say([this] {
    setAccessibleName(tr("Age of the picture"));
    show_now();
  });
}

void AgeLabel::show_age(std::optional<double> age_ms) {
  age_ms_ = age_ms;
  show_now();
}

void AgeLabel::show_now() {
  const QLocale locale;
  constexpr double kSecond_ms = 1000;
  const bool was_late = std::exchange(is_late_, age_ms_ && *age_ms_ > kLate_ms);
  QString text = tr("pictures without times");
  if (age_ms_ && *age_ms_ >= kSecond_ms)
    text = tr("picture %1 s old").arg(locale.toString(*age_ms_ / kSecond_ms, 'f', 1));
  else if (age_ms_)
    text = tr("picture %1 ms old").arg(locale.toString(*age_ms_, 'f', 0));
  // The sign does not rely on the colour.
  setText(is_late_ ? QString(QChar(0x25b2)) + QLatin1Char(' ') + text : text);
  setToolTip(is_late_ ? tr("What moves is seen late. Close other programs, or choose a faster "
                           "setting in Accuracy.")
                      : QString());
  if (is_late_ != was_late) colour();
}

void AgeLabel::colour() {
  QPalette own;
  if (is_late_)
    own.setColor(QPalette::WindowText, meaning_colour(Meaning::kBad, QApplication::palette(this)));
  setPalette(own);
}

void AgeLabel::changeEvent(QEvent* event) {
  Translated<QLabel>::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && is_late_) colour();
}

}  // namespace alltact
