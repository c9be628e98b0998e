#include "app/studio/source_menu.h"

#include "core/program.h"

namespace alltact {

SourceMenu::SourceMenu(Workspace& work, const CameraFinder& finder, QWidget* window)
    : Translated(window), work_(work), finder_(finder) {
  connect(&finder_, &CameraFinder::cameras_changed, this, &SourceMenu::fill);
  say([this] {
    setTitle(tr("&Source"));
    fill();
  });
}

void SourceMenu::fill() {
  clear();
  for (const FoundCamera& camera : finder_.cameras()) {
    const std::string name = camera.identity.stable_name();
    QAction* entry = addAction(tr("Camera %1").arg(QString::fromStdString(camera.identity.name)));
    entry->setToolTip(QString::fromStdString(name));
    entry->setEnabled(!camera.problem);
    connect(entry, &QAction::triggered, this, [this, name] { work_.open_source({name}); });
  }
  if (finder_.cameras().empty()) addAction(tr("No camera is plugged in"))->setEnabled(false);
  addSeparator();
  const auto add = [this](const QString& text, auto slot) {
    connect(addAction(text), &QAction::triggered, this, slot);
  };
  add(tr("&Simulated finger"), &SourceMenu::open_simulated);
  add(tr("&Video file…"), &SourceMenu::choose_video);
  add(tr("Folder of &pictures…"), &SourceMenu::choose_folder);
  add(tr("Scene &file…"), &SourceMenu::choose_scene);
  addSeparator();
  add(tr("&Close the source"), [this] { work_.open_source({}); });
}

void SourceMenu::open_simulated() {
  open_shipped("scenes/studio_finger.yaml");
}

void SourceMenu::open_simulated_day() {
  open_shipped("scenes/studio_day.yaml");
}

void SourceMenu::open_shipped(const char* name) {
  const auto scene = find_resource(name);
  if (scene)
    work_.open_source({*scene});
  else
    Q_EMIT failed(scene.error());
}

void SourceMenu::choose_video() {
  choose(tr("Open a video"), QFileDialog::ExistingFile, tr("Videos (*.mkv *.avi *.mp4)"));
}

void SourceMenu::choose_folder() {
  choose(tr("Open a folder of pictures"), QFileDialog::Directory);
}

void SourceMenu::choose_scene() {
  choose(tr("Open a scene"), QFileDialog::ExistingFile, tr("Scenes (*.yaml *.yml)"));
}

void SourceMenu::choose(const QString& title, QFileDialog::FileMode mode, const QString& filter) {
  auto* dialog = new QFileDialog(parentWidget(), title, QString(), filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(mode);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& chosen) {
    work_.open_source({chosen.toStdString()});
  });
  dialog->show();
}

}  // namespace alltact
