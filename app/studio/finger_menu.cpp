#include "app/studio/finger_menu.h"

#include "widgets/shell/elided_label.h"
#include "widgets/shell/export_dialog.h"
#include "widgets/shell/finger_list_dialog.h"
#include "widgets/shell/new_finger_dialog.h"

#include <QFileDialog>

namespace alltact {
namespace {

constexpr int kPathRoom = 420;  // px

Status make_described(const NewFinger& requested) {
  const auto made = make_finger(requested);
  return made ? Status() : Status(made.error());
}

}  // namespace

FingerMenu::FingerMenu(Workspace& work, QWidget* window)
    : TranslatedMenu(window), work_(work), recent_(new QMenu(this)) {
  setToolTipsVisible(true);
  recent_->setToolTipsVisible(true);
  connect(&work_, &Workspace::finger_changed, this, &FingerMenu::fill);
  say([this] {
    recent_->setTitle(tr("&Recent fingers"));
    fill();
  });
}

void FingerMenu::add_to(TranslatedMenu& file) {
  file.add(
      {QKeySequence::Open}, [] { return tr("&Open finger…"); }, [this] { choose(); });
  file.add(
      {QKeySequence::New}, [] { return tr("&New finger…"); }, [this] { make(); });
  file.addMenu(recent_);
  file.add(
      {Qt::CTRL | Qt::Key_L}, [] { return tr("&All fingers…"); }, [this] { list_all(); });
  QAction* exports = file.add(
      {Qt::CTRL | Qt::Key_E}, [] { return tr("E&xport finger…"); }, [this] { export_finger(); });
  const auto follow = [this, exports] { exports->setEnabled(!work_.state().finger.empty()); };
  connect(&work_, &Workspace::finger_changed, exports, follow);
  follow();
  file.add(
      {}, [] { return tr("&Close finger"); }, [this] { work_.open_finger({}); });
}

void FingerMenu::fill() {
  clear();
  recent_->clear();
  const auto folders = offered();
  for (const std::filesystem::path& folder : folders)
    for (QMenu* menu : {recent_, static_cast<QMenu*>(this)}) {
      const QString path = QString::fromStdString(folder.string());
      QAction* entry = menu->addAction(elided_path(path, fontMetrics(), kPathRoom));
      entry->setToolTip(path);
      connect(entry, &QAction::triggered, this, [this, folder] { work_.open_finger(folder); });
    }
  recent_->setEnabled(!folders.empty());
  if (!folders.empty()) addSeparator();
  connect(addAction(tr("&Open finger…")), &QAction::triggered, this, &FingerMenu::choose);
  connect(addAction(tr("&All fingers…")), &QAction::triggered, this, &FingerMenu::list_all);
  connect(addAction(tr("&New finger…")), &QAction::triggered, this, [this] { make(); });
  connect(
      addAction(tr("&Close finger")), &QAction::triggered, this, [this] { work_.open_finger({}); });
}

std::vector<std::filesystem::path> FingerMenu::offered() const {
  const auto& recent = work_.state().recent_fingers;
  if (!found_) return recent;
  std::vector<std::filesystem::path> offered;
  for (const auto& folder : recent)
    if (std::find(found_->begin(), found_->end(), folder) != found_->end())
      offered.push_back(folder);
  return offered;
}

void FingerMenu::offer(const std::vector<std::filesystem::path>& found) {
  if (found_ == found) return;
  found_ = found;
  fill();
}

void FingerMenu::list_all() {
  auto* dialog = new FingerListDialog(work_.state().recent_fingers, parentWidget());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &FingerListDialog::finger_chosen, this, [this](const QString& folder) {
    work_.open_finger(folder.toStdString());
  });
  dialog->show();
}

void FingerMenu::choose() {
  auto* dialog = new QFileDialog(parentWidget(), tr("Open a finger's folder"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    work_.open_finger(folder.toStdString());
  });
  dialog->show();
}

void FingerMenu::make(const NewFinger& known) {
  auto* dialog = new NewFingerDialog(make_described, parentWidget());
  dialog->set_description(known);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &NewFingerDialog::made, this, [this](const QString& folder) {
    work_.open_finger(folder.toStdString());
  });
  dialog->show();
}

void FingerMenu::export_finger() {
  auto* dialog = new ExportDialog(work_.state().finger, parentWidget());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

}  // namespace alltact
