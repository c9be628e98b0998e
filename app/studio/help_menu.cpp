#include "app/studio/help_menu.h"

#include "app/studio/help_window.h"
#include "app/studio/quick_guide.h"
#include "core/io/atomic_file.h"
#include "core/program.h"
#include "core/utc_time.h"

#include <QDesktopServices>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QPushButton>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

namespace alltact {

HelpMenu::HelpMenu(std::function<std::string()> page, std::vector<Page*> pages, QWidget* window)
    : TranslatedMenu(window), page_(std::move(page)), pages_(std::move(pages)) {
  set_title([] { return tr("&Help"); });
  add(
      {QKeySequence::HelpContents},
      [] { return tr("&Help on this place"); },
      [this] { show_help(); });
  add(
      {}, [] { return tr("&Glossary"); }, [this] { show_page(QStringLiteral("glossary")); });
  add(
      {}, [] { return tr("&Quick guide to print…"); }, [this] { choose_guide_file(); });
  addSeparator();
  add(
      {}, [] { return tr("&About AllTact Studio"); }, [this] { show_about(); });
}

void HelpMenu::show_help() {
  show_page(QString::fromStdString(page_()));
}

void HelpMenu::show_page(const QString& name) {
  if (!help_window_) {
    help_window_ = new HelpWindow(pages_, parentWidget());
    help_window_->setAttribute(Qt::WA_DeleteOnClose);
  }
  help_window_->show_page(name);
}

void HelpMenu::choose_guide_file() {
  auto* dialog = new QFileDialog(parentWidget(),
                                 tr("Save the quick guide"),
                                 QDir::home().filePath(QStringLiteral("alltact-quick-guide.pdf")),
                                 tr("Pages to print (*.pdf)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("pdf"));
  connect(dialog, &QFileDialog::fileSelected, this, &HelpMenu::write_guide);
  dialog->show();
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
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  const QString title = tr("About AllTact Studio");
  dialog->setWindowTitle(title);
  auto* layout = new QVBoxLayout(dialog);
  auto* text = new QTextBrowser;
  text->setOpenExternalLinks(true);
  text->setMarkdown(
      tr("## AllTact Studio %1\n\nTurns a clear silicone finger with a camera inside into a "
         "measuring instrument.\n\nIts own source is under the BSD-3-Clause licence; with the "
         "libraries it uses, the program as a whole is under the GPL, version 3.")
          .arg(QString::fromStdString(program_version())));
  text->setAccessibleName(title);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  layout->addWidget(text);
  layout->addWidget(buttons);
  dialog->resize(640, 320);
  dialog->show();
}

}  // namespace alltact
