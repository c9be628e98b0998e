#include "widgets/number_text.h"

#include "core/numerics/sd_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

namespace alltact {
namespace {

struct NumberText {
  Q_DECLARE_TR_FUNCTIONS(alltact::NumberText)
 public:
  static QString sd(double sd, int digits) {
    switch (sd_kind(sd, digits)) {
      case SdKind::kNumber:
        return plain_number(sd, digits);
      case SdKind::kUnder:
        return tr("under %1", "of a standard deviation")
            .arg(plain_number(std::pow(10, -digits), digits));
      case SdKind::kUnknown:
        break;
    }
    return tr("unknown", "of a standard deviation");
  }
  static QString at_least() { return tr("at least %1"); }
  static QString at_most() { return tr("at most %1"); }
};

}  // namespace

QString plain_number(double value, int digits) {
  const double unit = std::pow(10, digits);
  return QLocale().toString(std::round(value * unit) / unit + 0.0, 'f', digits);
}

QString number_and_sd(double value, const std::optional<double>& sd, int digits) {
  const QString text = plain_number(value, digits);
  return sd ? QStringLiteral("%1 ± %2").arg(text, NumberText::sd(*sd, digits)) : text;
}

QString sd_number(double sd, int digits) {
  return NumberText::sd(sd, digits);
}

QString limit_and_sd(double value, const std::optional<double>& sd, int digits) {
  return (value < 0 ? NumberText::at_most() : NumberText::at_least())
      .arg(number_and_sd(value, sd, digits));
}

}  // namespace alltact
