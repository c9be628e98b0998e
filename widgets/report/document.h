// A report as text with pictures, to be read as one HTML file or printed as PDF: the same content.
#pragma once

#include "core/job.h"
#include "core/result.h"

#include <QImage>
#include <QString>
#include <string>
#include <vector>

class QPagedPaintDevice;

namespace alltact {

/// Built from top to bottom. All text is plain; what HTML would take for marks is escaped here.
class Document {
 public:
  explicit Document(const QString& title);

  /// The next heading begins a page of paper.
  void new_page() { on_new_page_ = true; }
  void heading(const QString& text);
  /// From now on what stands between two headings begins a page of paper where it does not fit into
  /// what is left of one.
  void keep_sections_whole() { keeps_sections_whole_ = true; }
  void paragraph(const QString& text);
  /// A paragraph in a box that catches the eye; `colour` of its border.
  void box(const QString& first_line, const QString& text, const QColor& colour);
  void command(const QString& text);
  void list(const QStringList& items);
  /// A picture of `width` px at 96 to the inch, whatever its own pixels, with its caption.
  void figure(const QImage& picture, int width, const QString& caption);

  struct Cell {
    QString text;
    QImage picture;  ///< instead of text where it is not null
    int width = 0;   ///< of the picture
  };
  using Row = std::vector<Cell>;
  /// Empty `head`: none. Numbers are right-aligned where `numbers` says so of a column.
  /// `widths_percent` of the columns: the table is as wide as the page; empty: as its text.
  void table(const QStringList& head,
             const std::vector<Row>& rows,
             const std::vector<bool>& numbers,
             const std::vector<int>& widths_percent = {});

  /// A table with a picture in every row, cut into one for each page of paper, which breaks such
  /// rows in ugly ways.
  void pictured_table(const QStringList& head,
                      const std::vector<Row>& rows,
                      const std::vector<bool>& numbers);

  /// One file without anything beside it. The same document gives the same bytes.
  [[nodiscard]] std::string html() const;
  /// On paper, or what stands for it; its margins are the document's own.
  void print(QPagedPaintDevice& paper) const;
  /// A4. `date` (UTC, 2026-01-31T12:00:00Z) stands in the file as its time, so that the same
  /// document gives the same bytes. Error: the printing failed.
  [[nodiscard]] Result<std::string> pdf(const std::string& date) const;

 private:
  QString image(const QImage& picture, int width);
  [[nodiscard]] QString whole(const QString& style) const;

  bool on_new_page_ = false, keeps_sections_whole_ = false;
  QString title_, body_;
  std::vector<QImage> pictures_;  // "picture:N" in body_
};

}  // namespace alltact
