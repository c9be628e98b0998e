#include "widgets/report/document.h"

#include "widgets/report/pdf_date.h"

#include <QBuffer>
#include <QColor>
#include <QHashFunctions>
#include <QPageLayout>
#include <QPdfWriter>
#include <QStringList>
#include <QTextDocument>
#include <QUrl>

namespace alltact {
namespace {

constexpr const char* kPaperStyle =
    "body { font-family: 'DejaVu Sans', sans-serif; font-size: 9pt; color: #16191d; }"
    "h1 { font-size: 17pt; } h2 { font-size: 12pt; margin-top: 14px; }"
    "p.caption { font-size: 8pt; color: #4c5158; } pre { font-family: 'DejaVu Sans Mono'; }"
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

QByteArray png_of(const QImage& picture) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  picture.save(&buffer, "PNG");
  return bytes;
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

void Document::paragraph(const QString& text) {
  body_ += "<p>" + escaped(text) + "</p>\n";
}

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

QString Document::image(const QImage& picture, int width) {
  pictures_.push_back(picture);
  return QString("<img src=\"picture:%1\" width=\"%2\" height=\"%3\" alt=\"\"/>")
      .arg(pictures_.size() - 1)
      .arg(width)
      .arg(width * picture.height() / std::max(1, picture.width()));
}

void Document::figure(const QImage& picture, int width, const QString& caption) {
  body_ +=
      "<p>" + image(picture, width) + "</p><p class=\"caption\">" + escaped(caption) + "</p>\n";
}

void Document::table(const QStringList& head,
                     const std::vector<Row>& rows,
                     const std::vector<bool>& numbers) {
  const auto align = [&](std::size_t column) {
    return column < numbers.size() && numbers[column] ? QString(" align=\"right\"") : QString();
  };
  body_ += "<table cellspacing=\"0\" cellpadding=\"4\">";
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
          (row[i].picture.isNull() ? escaped(row[i].text) : image(row[i].picture, row[i].width)) +
          "</td>";
    body_ += "</tr>\n";
  }
  body_ += "</table>\n";
}

void Document::pictured_table(const QStringList& head,
                              const std::vector<Row>& rows,
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

QString Document::whole(const QString& style) const {
  return "<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"/><title>" + escaped(title_) +
         "</title><style>" + style + "</style></head>\n<body>\n" + body_ + "</body></html>\n";
}

std::string Document::html() const {
  QString text = whole(kScreenStyle);
  // From the last to the first: "picture:1" is also how "picture:12" begins.
  for (std::size_t i = pictures_.size(); i-- > 0;)
    text.replace(
        QString("\"picture:%1\"").arg(i),
        "\"data:image/png;base64," + QString::fromLatin1(png_of(pictures_[i]).toBase64()) + '"');
  return text.toStdString();
}

Result<std::string> Document::pdf(const std::string& date) const {
  QTextDocument document;
  document.setDefaultStyleSheet(kPaperStyle);
  for (std::size_t i = 0; i < pictures_.size(); ++i)
    document.addResource(
        QTextDocument::ImageResource, QUrl(QString("picture:%1").arg(i)), pictures_[i]);
  document.setHtml(whole(QString()));
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  // Qt writes fonts in the order of a hash, which else differs from run to run.
  QHashSeed::setDeterministicGlobalSeed();
  {
    QPdfWriter writer(&buffer);
    writer.setTitle(title_);
    writer.setCreator("AllTact Studio");
    writer.setResolution(300);
    writer.setPageLayout(
        QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
    document.print(&writer);
  }
  QHashSeed::resetRandomGlobalSeed();
  if (bytes.isEmpty()) return Error{en::say("the report could not be printed"), "", ""};
  set_pdf_time(bytes, date);
  return bytes.toStdString();
}

}  // namespace alltact
