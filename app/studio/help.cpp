#include "app/studio/help.h"

#include "core/base/atomic_file.h"
#include "core/base/program.h"
#include "core/base/utc_time.h"
#include "widgets/report/document.h"
#include "widgets/shell/page.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHashFunctions>
#include <QImage>
#include <QLocale>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QTextDocument>
#include <QUrl>
#include <QVBoxLayout>

namespace alltact {
namespace {

QString language_ending() {
  const QString name = QLocale().name();
  if (name.startsWith(QLatin1String("de"))) return QStringLiteral("_de");
  if (name.startsWith(QLatin1String("zh"))) return QStringLiteral("_zh_CN");
  return {};
}

/// Joins the lines of one paragraph: between Chinese letters without a blank.
void join(QString& text, const QString& line) {
  const auto is_wide = [](QChar letter) { return letter.unicode() >= 0x2e80; };
  if (!text.isEmpty() && !(is_wide(text.back()) && is_wide(line.front()))) text += QLatin1Char(' ');
  text += line;
}

}  // namespace

QString help_file(const QString& name) {
  const QString file = QStringLiteral(":/alltact/help/%1%2.md").arg(name, language_ending());
  return QFile::exists(file) ? file : QStringLiteral(":/alltact/help/%1.md").arg(name);
}

QString help_text(const QString& name) {
  QFile file(help_file(name));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

HelpLead lead_of(const QString& markdown) {
  static const QRegularExpression image(QStringLiteral("^!\\[.*\\]\\(([^)]+)\\)$"));
  static const QRegularExpression step(QStringLiteral("^[0-9]+\\. +(.*)$"));
  HelpLead lead;
  bool is_step = false;
  for (const QString& raw : markdown.split(QLatin1Char('\n'))) {
    const QString line = raw.trimmed();
    if (line.startsWith(QLatin1String("# "))) {
      lead.title = line.mid(2);
    } else if (line.isEmpty()) {
      is_step = false;
      if (!lead.steps.isEmpty()) break;
    } else if (const auto found = image.match(line); found.hasMatch()) {
      lead.image = found.captured(1);
    } else if (const auto begun = step.match(line); begun.hasMatch()) {
      lead.steps << begun.captured(1);
      is_step = true;
    } else if (is_step) {
      join(lead.steps.last(), line);
    } else if (line.startsWith(QLatin1Char('#'))) {
      break;  // the lead ends here
    } else if (lead.image.isEmpty()) {
      join(lead.lead, line);
    }
  }
  return lead;
}

QString without_marks(QString markdown) {
  static const QRegularExpression link(QStringLiteral("\\[([^\\]]*)\\]\\([^)]*\\)"));
  return markdown.replace(link, QStringLiteral("\\1"))
      .remove(QLatin1Char('*'))
      .remove(QLatin1Char('`'));
}

namespace {

constexpr int kListWidth = 150;
const QStringList kFurther{QStringLiteral("keys"), QStringLiteral("glossary"),
                           QStringLiteral("effects")};

}  // namespace

HelpWindow::HelpWindow(const std::vector<Page*>& pages, QWidget* parent)
    : Translated(parent),
      pages_(pages),
      list_(new QListWidget),
      text_(new QTextBrowser),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  list_->setFixedWidth(kListWidth);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const auto add = [this](const QString& name) {
    auto* entry = new QListWidgetItem(list_);
    entry->setData(Qt::UserRole, name);
  };
  for (const Page* page : pages_) add(QString::fromStdString(page->name()));
  for (const QString& name : kFurther) add(name);
  text_->setOpenExternalLinks(true);
  text_->setSearchPaths({QStringLiteral(":/alltact/help")});  // of the pages' images
  auto* row = new QHBoxLayout;
  row->addWidget(list_);
  row->addWidget(text_, 1);
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  column->addWidget(buttons_);
  connect(list_, &QListWidget::currentRowChanged, this, &HelpWindow::load);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(980, 720);
  say([this] { name_pages(); });
}

void HelpWindow::name_pages() {
  setWindowTitle(tr("Help"));
  list_->setAccessibleName(tr("Pages"));
  text_->setAccessibleName(tr("Help"));
  int row = 0;
  for (const Page* page : pages_) list_->item(row++)->setText(page->title());
  for (const QString& words : {tr("Keys"), tr("Glossary"), tr("Effects of scenes")})
    list_->item(row++)->setText(words);
  buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  buttons_->button(QDialogButtonBox::Close)->setToolTip(tr("Closes this window (Esc)"));
  load();
}

void HelpWindow::show_page(const QString& name) {
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(Qt::UserRole).toString() == name) list_->setCurrentRow(row);
  show();
  raise();
  activateWindow();
  text_->setFocus();
}

void HelpWindow::load() {
  const QListWidgetItem* item = list_->currentItem();
  if (item == nullptr) return;
  text_->setMarkdown(help_text(item->data(Qt::UserRole).toString()));
}

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
    document.addResource(QTextDocument::ImageResource, QUrl(name),
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
    return Error{en::say("the quick guide's texts do not fit on {} pages", kPages), "",
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

HelpMenu::HelpMenu(std::function<std::string()> page, std::vector<Page*> pages, QWidget* window)
    : TranslatedMenu(window), page_(std::move(page)), pages_(std::move(pages)) {
  set_title([] { return tr("&Help"); });
  add(
      {QKeySequence::HelpContents}, [] { return tr("&Help on this page"); },
      [this] { show_help(); });
  add(
      {}, [] { return tr("&Keys"); }, [this] { show_page(QStringLiteral("keys")); });
  add(
      {}, [] { return tr("&Glossary"); }, [this] { show_page(QStringLiteral("glossary")); });
  add(
      {}, [] { return tr("&Quick guide to print…"); }, [this] { choose_guide_file(); });
  addSeparator();
  add(
      {}, [] { return tr("&About AllTact Studio"); }, [this] { show_about(); });
}

void HelpMenu::show_help() { show_page(QString::fromStdString(page_())); }

void HelpMenu::show_page(const QString& name) {
  if (!help_window_) {
    help_window_ = new HelpWindow(pages_, parentWidget());
    help_window_->setAttribute(Qt::WA_DeleteOnClose);
  }
  help_window_->show_page(name);
}

void HelpMenu::choose_guide_file() {
  auto* dialog = new QFileDialog(parentWidget(), tr("Save the quick guide"),
                                 QDir::home().filePath(QStringLiteral("alltact-quick-guide.pdf")),
                                 tr("PDF files (*.pdf)"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("pdf"));
  connect(dialog, &QFileDialog::fileSelected, this, &HelpMenu::write_guide);
  show_dialog(*dialog);
}

void HelpMenu::write_guide(const QString& file) {
  const auto guide = quick_guide_pdf(utc_now());
  if (!guide) return void(Q_EMIT failed(guide.error()));
  if (const Status written = write_file_atomically(file.toStdString(), *guide); !written)
    return void(Q_EMIT failed(written.error()));
  QDesktopServices::openUrl(QUrl::fromLocalFile(file));
}

void HelpMenu::show_about() {
  auto* dialog = new QDialog(parentWidget());
  const QString title = tr("About AllTact Studio");
  dialog->setWindowTitle(title);
  auto* layout = new QVBoxLayout(dialog);
  auto* text = new QTextBrowser;
  text->setOpenExternalLinks(true);
  text->setMarkdown(
      tr("## AllTact Studio %1\n\nTurns a clear silicone finger with a camera inside into a "
         "measuring instrument.\n\nIts own source is under the BSD-3-Clause licence; with the "
         "libraries it uses, the entire program is under the GPL, version 3.")
          .arg(QString::fromStdString(program_version())));
  text->setAccessibleName(title);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Closes this window (Esc)"));
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  layout->addWidget(text);
  layout->addWidget(buttons);
  dialog->resize(640, 320);
  show_dialog(*dialog);
}

}  // namespace alltact
