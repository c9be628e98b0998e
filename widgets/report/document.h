// A report as text with images, for one HTML file or for PDF, with the same content.
#pragma once

#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"

#include <QByteArray>
#include <QImage>
#include <QString>
#include <string>
#include <vector>

class QPagedPaintDevice;

namespace alltact {

/// Built from top to bottom. All text is plain; HTML's special characters are escaped here.
class Document {
 public:
  explicit Document(const QString& title);

  /// The next heading begins a page of paper.
  void new_page() { on_new_page_ = true; }
  void heading(const QString& text);
  /// From now on a section that does not fit into the rest of a page begins a new one.
  void keep_sections_together() { sections_stay_together_ = true; }
  void paragraph(const QString& text);
  /// A paragraph in a box that catches the eye; `colour` of its border.
  void box(const QString& first_line, const QString& text, const QColor& colour);
  void command(const QString& text);
  void list(const QStringList& items);
  /// An image of `width` px at 96 to the inch, whatever its own pixels, with its caption.
  void figure(const QImage& image, int width, const QString& caption);

  struct Cell {
    QString text;
    QImage image = {};  ///< instead of text where it is not null
    int width = 0;      ///< of the image
  };
  using Row = std::vector<Cell>;
  /// Empty `head`: none. Columns with `numbers` are right-aligned. `widths_percent` of the columns:
  /// the table is as wide as the page; empty: as wide as its text.
  void table(const QStringList& head, const std::vector<Row>& rows,
             const std::vector<bool>& numbers, const std::vector<int>& widths_percent = {});

  /// A table with an image in every row, cut into one for each page of paper, which breaks such
  /// rows badly.
  void image_table(const QStringList& head, const std::vector<Row>& rows,
                   const std::vector<bool>& numbers);

  /// One self-contained file. The same document gives the same bytes.
  [[nodiscard]] std::string html() const;
  /// On paper or a file; its margins are the document's own.
  void print(QPagedPaintDevice& paper) const;
  /// A4. `date` (UTC, 2026-01-31T12:00:00Z) becomes the file's creation time, so that the same
  /// document gives the same bytes. Error: the printing failed.
  [[nodiscard]] Result<std::string> pdf(const std::string& date) const;

 private:
  QString image_html(const QImage& image, int width);
  [[nodiscard]] QString full_html(const QString& style) const;

  bool on_new_page_ = false, sections_stay_together_ = false;
  QString title_, body_;
  std::vector<QImage> images_;  // by their number in body_
};

// Text and number formats of reports.

inline QString as_text(const std::string& text) { return QString::fromStdString(text); }

/// Reports are English.
inline QString text(const char* words) { return QString::fromUtf8(words); }
inline QString as_text(const Message& message) { return as_text(message.english()); }

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
inline QString when(QString date) { return date.replace('T', ' ').replace('Z', " UTC"); }

inline QString mm(double value, int digits = 3) { return QString::number(value, 'f', digits); }

inline QString percent(double part) {
  return (part < 0 ? QString() : QString("+")) + QString::number(100 * part, 'f', 1);
}

// The creation time in a PDF.

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
