#include "widgets/report/document.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QColor>
#include <QEventLoop>
#include <QHashFunctions>
#include <QPageLayout>
#include <QPdfWriter>
#include <QStringList>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextLayout>
#include <QTextTable>
#include <QUrl>
#include <cmath>
#include <memory>

namespace alltact {
namespace {

constexpr const char* kPaperStyle =
    "body { font-family: 'DejaVu Sans', sans-serif; font-size: 9pt; color: #16191d; }"
    "h1 { font-size: 17pt; } h2 { font-size: 12pt; margin-top: 14px; }"
    "p.figure { margin-top: 12px; margin-bottom: 2px; }"
    "p.caption { font-size: 8pt; color: #4c5158; margin-top: 2px; } pre { font-family: 'DejaVu "
    "Sans Mono'; }"
    "th { text-align: left; background-color: #eef0f2; }";
constexpr const char* kScreenStyle =
    "body { font-family: 'DejaVu Sans', Verdana, sans-serif; font-size: 15px; line-height: 1.45;"
    " color: #16191d; background: #ffffff; max-width: 46em; margin: 2em auto; padding: 0 1em; }"
    "h1 { font-size: 1.7em; } h2 { font-size: 1.2em; margin-top: 2em; }"
    "p.caption { font-size: 0.87em; color: #4c5158; margin-top: 0.2em; }"
    "pre { background: #eef0f2; padding: 0.7em; overflow-x: auto; }"
    "th { text-align: left; background: #eef0f2; } td, th { padding: 0.3em 0.6em; }"
    "table { border-collapse: collapse; } img { max-width: 100%; height: auto; }";

QString escaped(const QString& text) {
  return text.toHtmlEscaped().replace(QLatin1Char('\n'), QLatin1String("<br/>"));
}

QByteArray png_of(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes;
}

/// The layout of QTextDocument::print() on A4, to find where its pages end.
class PaperLayout {
 public:
  PaperLayout(QTextDocument& document, QPagedPaintDevice& paper) : document_(document) {
    constexpr double kMargin_px = 2 / 2.54 * 96;  // print()'s own, at 96 to the inch
    document.documentLayout()->setPaintDevice(&paper);
    QTextFrameFormat format = document.rootFrame()->frameFormat();
    format.setMargin(std::floor(kMargin_px));
    document.rootFrame()->setFrameFormat(format);
    document.setPageSize(QSizeF(paper.width(), paper.height()));
  }

  /// Of two blocks outside of tables, from the first line of one to the last of the other.
  [[nodiscard]] bool is_on_one_page(const QTextBlock& first, const QTextBlock& last) const {
    document_.documentLayout()->documentSize();  // completes the layout, which lines alone do not
    const QTextLayout &begin = *first.layout(), &end = *last.layout();
    if (begin.lineCount() == 0 || end.lineCount() == 0) return true;
    const QTextLine line = end.lineAt(end.lineCount() - 1);
    const double top = begin.position().y() + begin.lineAt(0).y();
    const double bottom = end.position().y() + line.y() + line.height();
    const double page = document_.pageSize().height();
    return std::floor(top / page) == std::floor(bottom / page);
  }

  /// The layout follows at once.
  static void begin_page_with(const QTextBlock& block) {
    QTextCursor cursor(block);
    QTextBlockFormat format;
    format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
    cursor.mergeBlockFormat(format);
  }

 private:
  QTextDocument& document_;
};

bool is_in_table(const QTextBlock& block) { return QTextCursor(block).currentTable() != nullptr; }

bool is_section_heading(const QTextBlock& block) { return block.blockFormat().headingLevel() == 2; }

QTextBlock last_of_section(const QTextBlock& heading) {
  QTextBlock last = heading;
  for (QTextBlock block = heading.next(); block.isValid() && !is_section_heading(block);
       block = block.next())
    if (!is_in_table(block)) last = block;
  return last;
}

/// Numbers of the blocks that begin a page: figures that would be separated from their captions
/// and, where requested, sections that would be split.
std::vector<int> blocks_on_new_pages(const QTextDocument& document, QPagedPaintDevice& paper,
                                     bool sections_stay_together) {
  const std::unique_ptr<QTextDocument> copy(document.clone());
  const PaperLayout layout(*copy, paper);
  std::vector<int> found;
  for (QTextBlock block = copy->begin(); block.isValid(); block = block.next()) {
    if (is_in_table(block)) continue;
    QTextBlock last = block;
    if (is_section_heading(block) && sections_stay_together)
      last = last_of_section(block);
    else if (block.text() == QString(QChar::ObjectReplacementCharacter) && block.next().isValid())
      last = block.next();
    if (layout.is_on_one_page(block, last)) continue;
    PaperLayout::begin_page_with(block);
    found.push_back(block.blockNumber());
  }
  return found;
}

}  // namespace

Document::Document(const QString& title) : title_(title) {
  body_ = "<h1>" + escaped(title) + "</h1>\n";
}

void Document::heading(const QString& text) {
  body_ += on_new_page_ ? "<h2 style=\"page-break-before: always;\">" : "<h2>";
  on_new_page_ = false;
  body_ += escaped(text) + "</h2>\n";
}

void Document::paragraph(const QString& text) { body_ += "<p>" + escaped(text) + "</p>\n"; }

void Document::box(const QString& first_line, const QString& text, const QColor& colour) {
  body_ += QString(
               "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"8\"><tr>"
               "<td width=\"6\" bgcolor=\"%1\"></td><td bgcolor=\"#eef0f2\">"
               "<b style=\"font-size: large;\">%2</b><br/>%3</td></tr></table>\n")
               .arg(colour.name(), escaped(first_line), escaped(text));
}

void Document::command(const QString& text) {
  body_ += "<pre>" + text.toHtmlEscaped() + "</pre>\n";
}

void Document::list(const QStringList& items) {
  body_ += "<ul>";
  for (const QString& item : items) body_ += "<li>" + escaped(item) + "</li>";
  body_ += "</ul>\n";
}

QString Document::image_html(const QImage& image, int width) {
  images_.push_back(image);
  return QString("<img src=\"picture:%1\" width=\"%2\" height=\"%3\" alt=\"\"/>")
      .arg(images_.size() - 1)
      .arg(width)
      .arg(width * image.height() / std::max(1, image.width()));
}

void Document::figure(const QImage& image, int width, const QString& caption) {
  body_ += "<p class=\"figure\">" + image_html(image, width) + "</p><p class=\"caption\">" +
           escaped(caption) + "</p>\n";
}

void Document::table(const QStringList& head, const std::vector<Row>& rows,
                     const std::vector<bool>& numbers, const std::vector<int>& widths_percent) {
  const auto align = [&](std::size_t column) {
    QString of;
    if (column < numbers.size() && numbers[column]) of += " align=\"right\"";
    if (column < widths_percent.size()) of += QString(" width=\"%1%\"").arg(widths_percent[column]);
    return of;
  };
  body_ += "<table cellspacing=\"0\" cellpadding=\"4\"";
  body_ += widths_percent.empty() ? ">" : " width=\"100%\">";
  if (!head.isEmpty()) {
    body_ += "<tr>";
    for (qsizetype i = 0; i < head.size(); ++i)
      body_ += "<th" + align(static_cast<std::size_t>(i)) + ">" + escaped(head[i]) + "</th>";
    body_ += "</tr>";
  }
  for (const Row& row : rows) {
    body_ += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      body_ +=
          "<td valign=\"middle\"" + align(i) + ">" +
          (row[i].image.isNull() ? escaped(row[i].text) : image_html(row[i].image, row[i].width)) +
          "</td>";
    body_ += "</tr>\n";
  }
  body_ += "</table>\n";
}

void Document::image_table(const QStringList& head, const std::vector<Row>& rows,
                           const std::vector<bool>& numbers) {
  constexpr std::size_t kRowsOfPage = 7;
  for (std::size_t first = 0; first < rows.size(); first += kRowsOfPage) {
    if (first > 0) {
      new_page();
      heading("Continued");
    }
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(first);
    const auto count = std::min(kRowsOfPage, rows.size() - first);
    table(head, {begin, begin + static_cast<std::ptrdiff_t>(count)}, numbers);
  }
}

QString Document::full_html(const QString& style) const {
  return "<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"/><title>" + escaped(title_) +
         "</title><style>" + style + "</style></head>\n<body>\n" + body_ + "</body></html>\n";
}

std::string Document::html() const {
  QString text = full_html(kScreenStyle);
  // From the last to the first: the number 1 is also the beginning of 12.
  for (std::size_t i = images_.size(); i-- > 0;)
    text.replace(
        QString("\"picture:%1\"").arg(i),
        "\"data:image/png;base64," + QString::fromLatin1(png_of(images_[i]).toBase64()) + '"');
  return text.toStdString();
}

void Document::print(QPagedPaintDevice& paper) const {
  QTextDocument document;
  document.setDefaultStyleSheet(kPaperStyle);
  for (std::size_t i = 0; i < images_.size(); ++i)
    document.addResource(QTextDocument::ImageResource, QUrl(QString("picture:%1").arg(i)),
                         images_[i]);
  document.setHtml(full_html(QString()));
  for (const int number : blocks_on_new_pages(document, paper, sections_stay_together_))
    PaperLayout::begin_page_with(document.findBlockByNumber(number));
  document.print(&paper);
}

Result<std::string> Document::pdf(const std::string& date) const {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  // QTextDocument processes long texts by timers, for which a thread needs a dispatcher.
  const QEventLoop dispatcher;
  // Qt writes fonts in the order of a hash, which otherwise differs from run to run.
  QHashSeed::setDeterministicGlobalSeed();
  {
    QPdfWriter writer(&buffer);
    writer.setTitle(title_);
    writer.setCreator("AllTact Studio");
    writer.setResolution(300);
    writer.setPageLayout(
        QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
    print(writer);
  }
  QHashSeed::resetRandomGlobalSeed();
  if (bytes.isEmpty()) return Error{en::say("the report could not be printed"), "", ""};
  set_pdf_time(bytes, date);
  return bytes.toStdString();
}

}  // namespace alltact
