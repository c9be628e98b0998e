// What the libraries say, in the window's language.
#pragma once

#include "core/message.h"

#include <QLocale>
#include <QString>
#include <QTranslator>

namespace alltact {

/// GUI thread only.
[[nodiscard]] QString in_window_language(const Message& message);

/// The same, as one to begin a line with: a capital first and a full stop last.
[[nodiscard]] QString window_sentence(const Message& message);

/// Without a full stop, as a title or in a label: a capital first.
[[nodiscard]] QString window_phrase(const Message& message);

/// Words that are in the window's language already, with its full stop.
[[nodiscard]] QString as_sentence(const QString& words);

/// Translates unless somebody is InEnglish.
class WindowTranslator : public QTranslator {
 public:
  QString translate(const char* context,
                    const char* source,
                    const char* of,
                    int count) const override;
};

/// While it lives texts and numbers are those of a program without translations, whatever the
/// window speaks: for what is written for others. GUI thread only, and not across its event loop.
class InEnglish {
 public:
  InEnglish();
  ~InEnglish();
  InEnglish(const InEnglish&) = delete;
  InEnglish& operator=(const InEnglish&) = delete;

 private:
  QLocale before_;
};

}  // namespace alltact
