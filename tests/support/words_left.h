// Finds what the libraries said and nobody translated.
#pragma once

#include "tests/support/ts_file.h"

#include <QRegularExpression>
#include <QStringList>

namespace alltact::test {

/// Stretches of the libraries' English sentences, `least` letters long at least, in a text of
/// another language. What German says alike, as commands, is no sentence.
inline QStringList words_left(const QString& text, qsizetype least = 12) {
  static const QStringList kStretches = [] {
    static const QRegularExpression hole(QStringLiteral("\\{[^{}]*\\}"));
    QStringList stretches;
    for (const TsMessage& message : messages_of(ts_file("de")))
      if (message.context == QLatin1String(kSaidContext))
        for (const QString& form : {message.source, message.comment})
          for (const QString& part : form.split(hole))
            if (const QString words = part.trimmed();
                words.contains(QLatin1Char(' ')) &&
                !message.translations.join(QLatin1Char(' ')).contains(words))
              stretches << words;
    stretches.removeDuplicates();
    return stretches;
  }();
  QStringList left;
  for (const QString& words : kStretches)
    if (words.size() >= least && text.contains(words)) left << words;
  return left;
}

}  // namespace alltact::test
