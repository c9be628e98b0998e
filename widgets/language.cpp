#include "widgets/language.h"

#include "core/numerics/readable_numbers.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <cmath>

namespace alltact {
namespace {

constexpr const char* kContext = "alltact::en";  // where lupdate puts the messages

/// Numbers with the decimal mark of the window's language.
Message with_local_numbers(const Message& message) {
  std::string words = message.words();
  if (message.kind() == Message::Kind::kNumber)
    words = QString::fromStdString(words)
                .replace(QLatin1Char('.'), QLocale().decimalPoint())
                .toStdString();
  std::vector<Message> parts;
  for (const Message& part : message.parts()) parts.push_back(with_local_numbers(part));
  return Message::compose(message.kind(), std::move(words), message.context(), message.count(),
                          std::move(parts));
}

std::string in_language(const Message& message) {
  const bool is_counted = message.kind() == Message::Kind::kCounted;
  const char* const words = message.words().c_str();
  const char* const of = message.context().empty() ? nullptr : message.context().c_str();
  const int count = is_counted ? static_cast<int>(message.count()) : -1;
  const std::string translated =
      QCoreApplication::translate(kContext, words, of, count).toStdString();
  // Qt returns the source text, which is the plural form, where there is no translation.
  return is_counted && count == 1 && translated == words ? message.context() : translated;
}

thread_local int in_english = 0;  // number of EnglishScope that exist

}  // namespace

QString in_window_language(const Message& message) {
  return QString::fromStdString(with_local_numbers(message).in(in_language));
}

QString window_sentence(const Message& message) {
  constexpr QChar kFullStop{0x3002};
  QString line = in_window_language(message);
  while (line.endsWith(QLatin1Char('.')) || line.endsWith(kFullStop)) line.chop(1);
  if (line.isEmpty()) return {};
  line[0] = line[0].toUpper();
  constexpr QChar kAsks{0xff1f}, kCalls{0xff01};
  for (const QChar close : {QChar(u'?'), QChar(u'!'), kAsks, kCalls})
    if (line.endsWith(close)) return line;
  return in_window_language(en::say("{}.", Message::typed(line.toStdString())));
}

QString window_phrase(const Message& message) {
  QString words = in_window_language(message);
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words;
}

QString as_sentence(const QString& words) {
  return in_window_language(en::say("{}.", Message::typed(words.toStdString())));
}

QString WindowTranslator::translate(const char* context, const char* source, const char* of,
                                    int count) const {
  return in_english > 0 ? QString() : QTranslator::translate(context, source, of, count);
}

EnglishScope::EnglishScope() {
  ++in_english;
  QLocale::setDefault(QLocale::c());
}

EnglishScope::~EnglishScope() {
  --in_english;
  QLocale::setDefault(before_);
}

namespace {

struct LocalText {
  Q_DECLARE_TR_FUNCTIONS(alltact::LocalText)
};

}  // namespace

QString listed(const QStringList& things) {
  return things.join(LocalText::tr(", ", "between things of one kind"));
}

QString joined(const QStringList& parts) {
  QStringList parts_shown = parts;
  parts_shown.removeAll(QString());
  return parts_shown.join(LocalText::tr(", ", "between parts of a sentence"));
}

QString joined_clauses(const QStringList& clauses) {
  return clauses.join(LocalText::tr("; ", "between clauses"));
}

QString labelled(const QString& label, const QString& what) {
  return label + LocalText::tr(": ", "after what names the next") + what;
}

QString day_text(const QDate& day) {
  const QLocale locale;
  if (locale.language() == QLocale::English || locale.language() == QLocale::C)
    return locale.toString(day, QStringLiteral("d MMM yyyy"));
  static const QRegularExpression weekday(QStringLiteral("[,\\s]*dddd[,\\s]*"));
  return locale.toString(day, locale.dateFormat(QLocale::LongFormat).remove(weekday));
}

QString moment_text(const QDateTime& moment) {
  return joined({day_text(moment.date()), moment.toString(QStringLiteral("HH:mm"))});
}

QString plain_number(double value, int digits) {
  const double unit = std::pow(10, digits);
  return QLocale().toString(std::round(value * unit) / unit + 0.0, 'f', digits);
}

QString sd_number(double sd, int digits) {
  switch (sd_kind(sd, digits)) {
    case SdKind::kNumber:
      return plain_number(sd, digits);
    case SdKind::kUnder:
      return LocalText::tr("under %1", "of a standard deviation")
          .arg(plain_number(std::pow(10, -digits), digits));
    case SdKind::kUnknown:
      break;
  }
  return LocalText::tr("unknown", "of a standard deviation");
}

QString number_and_sd(double value, const std::optional<double>& sd, int digits) {
  const QString text = plain_number(value, digits);
  return sd ? QStringLiteral("%1 ± %2").arg(text, sd_number(*sd, digits)) : text;
}

QString limit_and_sd(double value, const std::optional<double>& sd, int digits) {
  return (value < 0 ? LocalText::tr("at most %1") : LocalText::tr("at least %1"))
      .arg(number_and_sd(value, sd, digits));
}

}  // namespace alltact
