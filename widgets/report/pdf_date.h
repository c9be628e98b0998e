// The creation time in a PDF.
#pragma once

#include <QByteArray>
#include <string>

namespace alltact {

/// Replaces the creation time by `date` (as utc_now() writes it), in as many characters; changes
/// nothing else.
inline void set_pdf_time(QByteArray& pdf, const std::string& date) {
  QByteArray digits;
  for (const char c : date)
    if (c >= '0' && c <= '9') digits.append(c);
  if (digits.size() != 14) return;
  const qsizetype mark = pdf.indexOf("/CreationDate (D:");
  if (mark < 0) return;
  const qsizetype first = mark + 17;
  const qsizetype end = pdf.indexOf(')', first);
  QByteArray time = digits + "+00'00'";
  if (end - first < time.size()) time = digits + 'Z';
  if (end - first < time.size()) return;
  pdf.replace(first, time.size(), time);
  for (qsizetype i = first + time.size(); i < end; ++i) pdf[i] = ' ';
}

}  // namespace alltact
