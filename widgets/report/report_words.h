// Text and number formats of reports.
#pragma once

#include "core/message.h"

#include <QString>
#include <string>

namespace alltact {

inline QString as_text(const std::string& text) {
  return QString::fromStdString(text);
}

/// Reports are English.
inline QString text(const char* words) {
  return QString::fromUtf8(words);
}
inline QString as_text(const Message& message) {
  return as_text(message.english());
}

/// A message as a sentence: a capital first and a full stop last.
inline QString sentence(const Message& message) {
  QString line = as_text(message);
  if (!line.isEmpty()) line[0] = line[0].toUpper();
  if (!line.isEmpty() && !line.endsWith('.')) line += '.';
  return line;
}

/// The same without a full stop, as a title.
inline QString phrase(const Message& message) {
  QString words = as_text(message);
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words;
}

/// 2026-01-31 12:00:00 UTC
inline QString when(QString date) {
  return date.replace('T', ' ').replace('Z', " UTC");
}

inline QString mm(double value, int digits = 3) {
  return QString::number(value, 'f', digits);
}

inline QString percent(double part) {
  return (part < 0 ? QString() : QString("+")) + QString::number(100 * part, 'f', 1);
}

}  // namespace alltact
