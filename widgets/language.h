// Messages of the libraries in the window's language.
#pragma once

#include "core/message.h"

#include <QLocale>
#include <QString>
#include <QTranslator>

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
  QString translate(const char* context,
                    const char* source,
                    const char* of,
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

}  // namespace alltact
