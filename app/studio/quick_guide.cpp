#include "app/studio/quick_guide.h"

#include "app/studio/help_pages.h"
#include "core/program.h"
#include "widgets/report/pdf_date.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QCoreApplication>
#include <QHashFunctions>
#include <QImage>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QTextDocument>
#include <QUrl>

namespace alltact {
namespace {

// In the order of a finger's day.
const char* const kGuided[] = {"live", "record", "calibrate", "inspect", "accuracy"};
constexpr int kColumns = 2, kPages = 2;
constexpr double kLargest_pt = 12, kSmallest_pt = 6.5, kStep_pt = 0.25;
constexpr double kMm = 1 / 25.4 * 96;  // px: the document has 96 to the inch
constexpr double kMargin = 12 * kMm, kBetween = 7 * kMm, kHead = 14 * kMm, kFoot = 8 * kMm;
const QSizeF kPaper(210 * kMm, 297 * kMm);
const QSizeF kColumn((kPaper.width() - 2 * kMargin - kBetween) / kColumns,
                     kPaper.height() - 2 * kMargin - kHead - kFoot);

/// Paper has no links: they become plain words.
QString html_of(QString markdown) {
  static const QRegularExpression link(QStringLiteral("\\[([^\\]]*)\\]\\([^)]*\\)"));
  QTextDocument document;
  document.setMarkdown(markdown.replace(link, QStringLiteral("\\1")));
  const QString html = document.toHtml();
  const qsizetype begin = html.indexOf(QLatin1String("<p")),
                  end = html.indexOf(QLatin1String("</body>"));
  return begin < 0 || end < begin ? QString() : html.mid(begin, end - begin);
}

/// Without the lengths and fonts that toHtml() wrote.
QString plain_html(const QString& markdown) {
  QString html = html_of(markdown);
  html.remove(
      QLatin1String("<p style=\" margin-top:0px; margin-bottom:0px; margin-left:0px; "
                    "margin-right:0px; -qt-block-indent:0; text-indent:0px;\">"));
  return html.replace(QLatin1String("</p>"), QLatin1String(" "));
}

QString body_of_guide() {
  QString body;
  for (const char* page_name : kGuided) {
    const HelpLead lead = lead_of(help_text(QLatin1String(page_name)));
    body += QStringLiteral("<h2>%1</h2><p>%2</p>")
                .arg(lead.title.toHtmlEscaped(), plain_html(lead.lead));
    if (!lead.image.isEmpty())
      body += QStringLiteral("<p class=\"figure\"><img src=\"%1\" width=\"%2\"/></p>")
                  .arg(lead.image)
                  .arg(static_cast<int>(kColumn.width()));
    body += QLatin1String("<ol>");
    for (const QString& step : lead.steps)
      body += QLatin1String("<li>") + plain_html(step) + QLatin1String("</li>");
    body += QLatin1String("</ol>");
  }
  return body;
}

/// In letters of that size; returns the number of columns.
int layout_columns(QTextDocument& document, const QString& body, double size_pt) {
  document.setDefaultStyleSheet(
      QStringLiteral(
          "body { font-family: 'DejaVu Sans', sans-serif; font-size: %1pt; color: #16191d; }"
          "h2 { font-size: %2pt; margin-top: 8px; margin-bottom: 2px; color: #0b5fa5; }"
          "p { margin-top: 2px; margin-bottom: 4px; }"
          "p.figure { margin-top: 4px; margin-bottom: 4px; }"
          "ol { margin-left: -22px; margin-top: 2px; margin-bottom: 4px; }"
          "li { margin-bottom: 2px; }")
          .arg(size_pt)
          .arg(1.45 * size_pt));
  document.setHtml(QStringLiteral("<html><body>%1</body></html>").arg(body));
  document.setDocumentMargin(0);
  document.setPageSize(kColumn);
  return document.pageCount();
}

void add_images(QTextDocument& document) {
  for (const char* page_name : kGuided) {
    const QString name = lead_of(help_text(QLatin1String(page_name))).image;
    document.addResource(QTextDocument::ImageResource,
                         QUrl(name),
                         QImage(QStringLiteral(":/alltact/help/%1").arg(name)));
  }
}

QString title_of_guide() {
  return QCoreApplication::translate("alltact::QuickGuide", "AllTact Studio: quick guide");
}

void draw_page(QPainter& painter, QTextDocument& document, int page) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(22);
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(QColor("#16191d"));
  const QRectF head(kMargin, kMargin, kPaper.width() - 2 * kMargin, kHead);
  painter.drawText(head, Qt::AlignLeft | Qt::AlignTop, title_of_guide());
  font.setPixelSize(10);
  font.setBold(false);
  painter.setFont(font);
  painter.drawText(QRectF(head.left(), kPaper.height() - kMargin - kFoot, head.width(), kFoot),
                   Qt::AlignRight | Qt::AlignBottom,
                   QStringLiteral("%1   %2/%3")
                       .arg(QString::fromStdString(program_version()))
                       .arg(page + 1)
                       .arg(kPages));
  for (int i = 0; i < kColumns; ++i) {
    const int column = page * kColumns + i;
    if (column >= document.pageCount()) return;
    const QRectF part(0, column * kColumn.height(), kColumn.width(), kColumn.height());
    painter.save();
    painter.translate(kMargin + i * (kColumn.width() + kBetween), kMargin + kHead - part.top());
    document.drawContents(&painter, part);
    painter.restore();
  }
}

}  // namespace

Result<std::string> quick_guide_pdf(const std::string& date) {
  const QString body = body_of_guide();
  QTextDocument document;
  add_images(document);
  double size_pt = kLargest_pt;
  while (layout_columns(document, body, size_pt) > kColumns * kPages && size_pt > kSmallest_pt)
    size_pt -= kStep_pt;
  if (document.pageCount() > kColumns * kPages)
    return Error{en::say("the quick guide's texts do not fit on {} pages", kPages),
                 "",
                 en::say("shorten the numbered lists of the help pages")};
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  // Qt writes fonts in the order of a hash, which otherwise differs from run to run.
  QHashSeed::setDeterministicGlobalSeed();
  {
    QPdfWriter writer(&buffer);
    writer.setTitle(title_of_guide());
    writer.setCreator(QStringLiteral("AllTact Studio"));
    writer.setResolution(300);
    writer.setPageLayout(
        QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
    QPainter painter(&writer);
    painter.scale(300.0 / 96, 300.0 / 96);
    for (int page = 0; page < kPages; ++page) {
      if (page > 0) writer.newPage();
      draw_page(painter, document, page);
    }
  }
  QHashSeed::resetRandomGlobalSeed();
  set_pdf_time(bytes, date);
  return bytes.toStdString();
}

}  // namespace alltact
