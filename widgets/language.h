// Messages of the libraries in the window's language.
#pragma once

#include "core/base/message.h"

#include <QDateTime>
#include <QLocale>
#include <QString>
#include <QStringList>
#include <QTranslator>
#include <optional>

namespace alltact {

/// GUI thread only.
[[nodiscard]] QString in_window_language(const Message& message);

/// The same as a sentence: a capital first and a full stop last.
[[nodiscard]] QString window_sentence(const Message& message);

/// The same as a title or label: a capital first, no full stop.
[[nodiscard]] QString window_phrase(const Message& message);

/// Adds the full stop of the window's language to words that are in it already.
[[nodiscard]] QString as_sentence(const QString& words);

/// Translates unless an EnglishScope exists.
class WindowTranslator : public QTranslator {
 public:
  QString translate(const char* context, const char* source, const char* of,
                    int count) const override;
};

/// While it lives, texts and numbers are English, whatever the window's language: for files that
/// others read. GUI thread only, and not across its event loop.
class EnglishScope {
 public:
  EnglishScope();
  ~EnglishScope();
  EnglishScope(const EnglishScope&) = delete;
  EnglishScope& operator=(const EnglishScope&) = delete;

 private:
  QLocale before_;
};

// Joins words and sentences with the punctuation of the window's language.

/// Items of one kind: "left, right, up".
QString listed(const QStringList& things);

/// Parts of a sentence without the empty ones: "3 contacts, deepest 0.41 mm in frame 7".
QString joined(const QStringList& parts);

/// Clauses without full stops: "depth 0.41 mm; x 3.1, y 0.2, z 24.6 mm".
QString joined_clauses(const QStringList& clauses);

/// A label and its value: "Camera: front".
QString labelled(const QString& label, const QString& what);

// Days and times as text in the window's language.

/// A day whose month is a word, so that nobody takes it for another: "30 Nov 2026".
[[nodiscard]] QString day_text(const QDate& day);
/// "30 Nov 2026, 14:05".
[[nodiscard]] QString moment_text(const QDateTime& moment);

// Measured numbers as text in the window's language.

/// Never "-0.0".
[[nodiscard]] QString plain_number(double value, int digits);

/// Plain text: "1.23 ± 0.04"; "1.23 ± under 0.01" where the digits would make the sd 0; "1.23 ±
/// unknown" where it is 0 or not finite; "1.23" without an sd.
[[nodiscard]] QString number_and_sd(double value, const std::optional<double>& sd, int digits);

/// The sd alone, in the same form.
[[nodiscard]] QString sd_number(double sd, int digits);

/// A number that was cut at a limit: "at least 1.50 ± 0.04"; "at most" for a negative one.
[[nodiscard]] QString limit_and_sd(double value, const std::optional<double>& sd, int digits);

}  // namespace alltact
