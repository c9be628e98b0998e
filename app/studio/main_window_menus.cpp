// What the window's menus and dialogs do. No dialog stops what runs.
#include "app/studio/main_window.h"
#include "core/finger/new_finger.h"
#include "core/program.h"
#include "core/sources/open/open_source.h"
#include "widgets/shell/export_dialog.h"
#include "widgets/shell/new_finger_dialog.h"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QPushButton>
#include <QSettings>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace alltact {
namespace {

Status make(const NewFinger& wanted) {
  const auto made = make_finger(wanted);
  return made ? Status() : Status(made.error());
}

/// A page of text in a window of its own.
void show_page(QWidget* parent, const QString& title, const QString& markdown, const QSize& size) {
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  auto* layout = new QVBoxLayout(dialog);
  auto* text = new QTextBrowser;
  text->setOpenExternalLinks(true);
  text->setSearchPaths({QStringLiteral(":/alltact/help")});  // of the pages' pictures
  text->setMarkdown(markdown);
  text->setAccessibleName(title);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->button(QDialogButtonBox::Close)->setText(MainWindow::tr("&Close"));
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  layout->addWidget(text);
  layout->addWidget(buttons);
  dialog->resize(size);
  dialog->show();
}

}  // namespace

void MainWindow::fill_source_menu() {
  source_menu_->clear();
  for (const FoundCamera& camera : finder_.cameras()) {
    const QString name = QString::fromStdString(camera.identity.lasting());
    QAction* action =
        source_menu_->addAction(tr("Camera %1").arg(QString::fromStdString(camera.identity.name)));
    action->setToolTip(name);
    action->setEnabled(!camera.problem);
    connect(action, &QAction::triggered, this, [this, name] { open_source({name.toStdString()}); });
  }
  if (finder_.cameras().empty())
    source_menu_->addAction(tr("No camera is plugged in"))->setEnabled(false);
  source_menu_->addSeparator();
  const auto add_entry = [this](const QString& text, auto slot) {
    connect(source_menu_->addAction(text), &QAction::triggered, this, slot);
  };
  add_entry(tr("&Simulated finger"), &MainWindow::open_simulated);
  add_entry(tr("&Video file…"), &MainWindow::choose_video);
  add_entry(tr("Folder of &pictures…"), &MainWindow::choose_folder);
  add_entry(tr("Scene &file…"), &MainWindow::choose_scene);
  source_menu_->addSeparator();
  add_entry(tr("&Close the source"), [this] { open_source({}); });
}

void MainWindow::fill_recent_menu() {
  QMenu& button_menu = *finger_button_->menu();
  recent_menu_->clear();
  button_menu.clear();
  for (const auto& folder : state_.recent_fingers) {
    const QString text = QString::fromStdString(folder.string());
    for (QMenu* menu : {recent_menu_, &button_menu})
      connect(menu->addAction(text), &QAction::triggered, this, [this, folder = folder] {
        open_finger(std::filesystem::path(folder));
      });
  }
  recent_menu_->setEnabled(!state_.recent_fingers.empty());
  if (!state_.recent_fingers.empty()) button_menu.addSeparator();
  connect(button_menu.addAction(tr("&Open finger…")), &QAction::triggered, this, [this] {
    choose_finger();
  });
  connect(button_menu.addAction(tr("&New finger…")), &QAction::triggered, this, [this] {
    new_finger();
  });
  connect(button_menu.addAction(tr("&Close finger")), &QAction::triggered, this, [this] {
    open_finger({});
  });
}

void MainWindow::choose_finger() {
  auto* dialog = new QFileDialog(this, tr("Open a finger's folder"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    open_finger(folder.toStdString());
  });
  dialog->show();
}

void MainWindow::new_finger(const NewFinger& known) {
  auto* dialog = new NewFingerDialog(make, this);
  dialog->set_description(known);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &NewFingerDialog::made, this, [this](const QString& folder) {
    open_finger(folder.toStdString());
  });
  dialog->show();
}

void MainWindow::export_open_finger() {
  auto* dialog = new ExportDialog(state_.finger, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

void MainWindow::choose_video() {
  auto* dialog =
      new QFileDialog(this, tr("Open a video"), QString(), tr("Videos (*.mkv *.avi *.mp4)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    open_source({file.toStdString()});
  });
  dialog->show();
}

void MainWindow::choose_folder() {
  auto* dialog = new QFileDialog(this, tr("Open a folder of pictures"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    open_source({folder.toStdString()});
  });
  dialog->show();
}

void MainWindow::choose_scene() {
  auto* dialog = new QFileDialog(this, tr("Open a scene"), QString(), tr("Scenes (*.yaml *.yml)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    open_source({file.toStdString()});
  });
  dialog->show();
}

void MainWindow::open_simulated() {
  const auto scene = find_resource("scenes/studio_finger.yaml");
  if (scene)
    open_source({*scene});
  else
    problems_->set_problems({Problem::of(scene.error())});
}

void MainWindow::show_settings() {
  auto* dialog = new SettingsDialog(dresser_.appearance(), &pedal_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &SettingsDialog::appearance_chosen, this, [this](const Appearance& chosen) {
    const auto change = [this](const Appearance& appearance) {
      dresser_.wear(appearance);
      QSettings settings;
      settings.setValue(QStringLiteral("appearance/theme"), static_cast<int>(appearance.theme));
      settings.setValue(QStringLiteral("appearance/language"), appearance.language);
    };
    change(chosen);
  });
  dialog->show();
}

void MainWindow::show_help() {
  const QString page = QString::fromStdString(state_.place);
  const QString language = QLocale().name().startsWith(QStringLiteral("de")) ? QStringLiteral("_de")
                           : QLocale().name().startsWith(QStringLiteral("zh"))
                               ? QStringLiteral("_zh_CN")
                               : QString();
  QFile file(QStringLiteral(":/alltact/help/%1%2.md").arg(page, language));
  if (!file.exists()) file.setFileName(QStringLiteral(":/alltact/help/%1.md").arg(page));
  if (!file.open(QIODevice::ReadOnly)) return;
  show_page(this, tr("Help"), QString::fromUtf8(file.readAll()), {880, 720});
}

void MainWindow::show_about() {
  show_page(
      this,
      tr("About AllTact Studio"),
      tr("## AllTact Studio %1\n\nTurns a clear silicone finger with a camera inside into a "
         "measuring instrument.\n\nIts own source is under the BSD-3-Clause licence; with the "
         "libraries it uses, the program as a whole is under the GPL, version 3.")
          .arg(QString::fromStdString(program_version())),
      {640, 320});
}

}  // namespace alltact
