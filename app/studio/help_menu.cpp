#include "app/studio/help_menu.h"

#include "core/program.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QLocale>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace alltact {

HelpMenu::HelpMenu(std::function<std::string()> place, QWidget* window)
    : TranslatedMenu(window), place_(std::move(place)) {
  set_title([] { return tr("&Help"); });
  add(
      {QKeySequence::HelpContents},
      [] { return tr("&Help on this place"); },
      [this] { show_help(); });
  add(
      {}, [] { return tr("&About AllTact Studio"); }, [this] { show_about(); });
}

void HelpMenu::show_help() {
  const QString page = QString::fromStdString(place_());
  const QString language = QLocale().name().startsWith(QStringLiteral("de")) ? QStringLiteral("_de")
                           : QLocale().name().startsWith(QStringLiteral("zh"))
                               ? QStringLiteral("_zh_CN")
                               : QString();
  QFile file(QStringLiteral(":/alltact/help/%1%2.md").arg(page, language));
  if (!file.exists()) file.setFileName(QStringLiteral(":/alltact/help/%1.md").arg(page));
  if (!file.open(QIODevice::ReadOnly)) return;
  show_page(tr("Help"), QString::fromUtf8(file.readAll()), {880, 720});
}

void HelpMenu::show_about() {
  show_page(
      tr("About AllTact Studio"),
      tr("## AllTact Studio %1\n\nTurns a clear silicone finger with a camera inside into a "
         "measuring instrument.\n\nIts own source is under the BSD-3-Clause licence; with the "
         "libraries it uses, the program as a whole is under the GPL, version 3.")
          .arg(QString::fromStdString(program_version())),
      {640, 320});
}

void HelpMenu::show_page(const QString& title, const QString& markdown, const QSize& size) {
  auto* dialog = new QDialog(parentWidget());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  auto* layout = new QVBoxLayout(dialog);
  auto* text = new QTextBrowser;
  text->setOpenExternalLinks(true);
  text->setSearchPaths({QStringLiteral(":/alltact/help")});  // of the pages' pictures
  text->setMarkdown(markdown);
  text->setAccessibleName(title);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  layout->addWidget(text);
  layout->addWidget(buttons);
  dialog->resize(size);
  dialog->show();
}

}  // namespace alltact
