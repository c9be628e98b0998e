#include "app/studio/help_pages.h"

#include <QFile>
#include <QLocale>
#include <QRegularExpression>

namespace alltact {
namespace {

QString language_ending() {
  const QString name = QLocale().name();
  if (name.startsWith(QLatin1String("de"))) return QStringLiteral("_de");
  if (name.startsWith(QLatin1String("zh"))) return QStringLiteral("_zh_CN");
  return {};
}

/// Joins the lines of one paragraph: between Chinese letters without a blank.
void join(QString& text, const QString& line) {
  const auto is_wide = [](QChar letter) { return letter.unicode() >= 0x2e80; };
  if (!text.isEmpty() && !(is_wide(text.back()) && is_wide(line.front()))) text += QLatin1Char(' ');
  text += line;
}

}  // namespace

QString help_file(const QString& name) {
  const QString file = QStringLiteral(":/alltact/help/%1%2.md").arg(name, language_ending());
  return QFile::exists(file) ? file : QStringLiteral(":/alltact/help/%1.md").arg(name);
}

QString help_text(const QString& name) {
  QFile file(help_file(name));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

HelpLead lead_of(const QString& markdown) {
  static const QRegularExpression image(QStringLiteral("^!\\[.*\\]\\(([^)]+)\\)$"));
  static const QRegularExpression step(QStringLiteral("^[0-9]+\\. +(.*)$"));
  HelpLead lead;
  bool is_step = false;
  for (const QString& raw : markdown.split(QLatin1Char('\n'))) {
    const QString line = raw.trimmed();
    if (line.startsWith(QLatin1String("# "))) {
      lead.title = line.mid(2);
    } else if (line.isEmpty()) {
      is_step = false;
      if (!lead.steps.isEmpty()) break;
    } else if (const auto found = image.match(line); found.hasMatch()) {
      lead.image = found.captured(1);
    } else if (const auto begun = step.match(line); begun.hasMatch()) {
      lead.steps << begun.captured(1);
      is_step = true;
    } else if (is_step) {
      join(lead.steps.last(), line);
    } else if (line.startsWith(QLatin1Char('#'))) {
      break;  // the lead ends here
    } else if (lead.image.isEmpty()) {
      join(lead.lead, line);
    }
  }
  return lead;
}

QString without_marks(QString markdown) {
  static const QRegularExpression link(QStringLiteral("\\[([^\\]]*)\\]\\([^)]*\\)"));
  return markdown.replace(link, QStringLiteral("\\1"))
      .remove(QLatin1Char('*'))
      .remove(QLatin1Char('`'));
}

}  // namespace alltact
