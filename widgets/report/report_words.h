// How reports write things down.
#pragma once

#include <QString>
#include <string>

namespace alltact {

inline QString as_text(const std::string& text) {
  return QString::fromStdString(text);
}

/// A sentence of ours, as one to begin a line with.
inline QString sentence(const std::string& text) {
  QString line = as_text(text);
  if (!line.isEmpty()) line[0] = line[0].toUpper();
  if (!line.isEmpty() && !line.endsWith('.')) line += '.';
  return line;
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
