// Finds what the libraries said and nobody translated.
#pragma once

#include "widgets/words/catalogue.h"

#include <QRegularExpression>
#include <QStringList>

namespace alltact::test {

/// Stretches of the libraries' English sentences, `least` letters long at least, in a text of
/// another language.
inline QStringList words_left(const QString& text, qsizetype least = 12) {
  static const QStringList kStretches = [] {
    static const QRegularExpression hole(QStringLiteral("%[1-9]"));
    QStringList stretches;
    for (const char* pattern : library_patterns())
      for (const QString& part : QString::fromUtf8(pattern).split(hole))
        if (const QString words = part.trimmed(); words.contains(QLatin1Char(' ')))
          stretches << words;
    return stretches;
  }();
  QStringList left;
  for (const QString& words : kStretches)
    if (words.size() >= least && text.contains(words)) left << words;
  return left;
}

}  // namespace alltact::test
