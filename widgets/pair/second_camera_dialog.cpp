#include "widgets/pair/second_camera_dialog.h"

#include "widgets/tip_of_text.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QVBoxLayout>

namespace alltact {
namespace {

QString path_text(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

}  // namespace

SecondCameraDialog::SecondCameraDialog(const std::optional<SecondCamera>& now,
                                       const QStringList& cameras,
                                       QWidget* parent)
    : FittedDialog(parent),
      now_(now),
      intro_(new QLabel),
      finger_label_(new QLabel),
      source_label_(new QLabel),
      gripper_label_(new QLabel),
      missing_(new QLabel),
      finger_(new QLineEdit),
      gripper_(new QLineEdit),
      source_(new QComboBox),
      choose_finger_(new QPushButton),
      choose_source_(new QPushButton),
      choose_gripper_(new QPushButton),
      show_(new QPushButton),
      cancel_(new QPushButton) {
  auto* column = new QVBoxLayout(this);
  intro_->setWordWrap(true);
  column->addWidget(intro_);
  auto* grid = new QGridLayout;
  int row = 0;
  for (const auto& [label, line, button] :
       std::initializer_list<std::tuple<QLabel*, QWidget*, QPushButton*>>{
           {finger_label_, finger_, choose_finger_},
           {source_label_, source_, choose_source_},
           {gripper_label_, gripper_, choose_gripper_}}) {
    label->setBuddy(line);
    line->setMinimumWidth(300);
    grid->addWidget(label, row, 0);
    grid->addWidget(line, row, 1);
    grid->addWidget(button, row++, 2);
  }
  grid->setColumnStretch(1, 1);
  column->addLayout(grid);
  column->addStretch();
  column->addWidget(missing_);
  auto* buttons = new QDialogButtonBox;
  buttons->addButton(show_, QDialogButtonBox::AcceptRole);
  buttons->addButton(cancel_, QDialogButtonBox::RejectRole);
  show_->setDefault(true);
  column->addWidget(buttons);
  source_->setEditable(true);
  source_->addItems(cameras);
  source_->setCurrentText(now && !now->source.empty() ? path_text(now->source.front()) : QString());
  for (QLineEdit* line : {finger_, gripper_}) show_text_as_tip(*line);
  if (now) {
    finger_->setText(path_text(now->finger));
    gripper_->setText(path_text(now->gripper));
  }
  connect(finger_, &QLineEdit::textChanged, this, &SecondCameraDialog::show_missing);
  connect(source_, &QComboBox::editTextChanged, this, &SecondCameraDialog::show_missing);
  connect(choose_finger_, &QPushButton::clicked, this, [this] {
    choose(finger_, true, tr("The second finger's folder"), {});
  });
  connect(choose_source_, &QPushButton::clicked, this, [this] {
    choose(source_,
           false,
           tr("What shows the second finger"),
           tr("Videos and scenes (*.mkv *.avi *.mp4 *.yaml *.yml)"));
  });
  connect(choose_gripper_, &QPushButton::clicked, this, [this] {
    choose(gripper_, false, tr("The gripper's file"), tr("Grippers (*.yaml)"));
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    Q_EMIT chosen(entered());
    accept();
  });
  say([this] { name_parts(); });
}

void SecondCameraDialog::name_parts() {
  setWindowTitle(tr("Second finger"));
  intro_->setText(
      tr("Another finger of the same gripper with its own camera. Both pictures are shown as of "
         "one moment; with a gripper.yaml the gap between the faces and the width of what is held "
         "are told, too."));
  finger_label_->setText(tr("&Finger's folder"));
  source_label_->setText(tr("&Camera"));
  gripper_label_->setText(tr("&Gripper"));
  finger_->setAccessibleName(tr("Finger's folder"));
  source_->setAccessibleName(tr("Camera, video or scene"));
  gripper_->setAccessibleName(tr("Gripper's file"));
  gripper_->setPlaceholderText(tr("gripper.yaml; may be left empty"));
  choose_finger_->setText(tr("Choose…"));
  choose_source_->setText(tr("File…"));
  choose_gripper_->setText(tr("Choose…"));
  choose_finger_->setAccessibleName(tr("Choose the finger's folder"));
  choose_source_->setAccessibleName(tr("Choose a video or a scene"));
  choose_gripper_->setAccessibleName(tr("Choose the gripper's file"));
  show_->setText(tr("&Show it"));
  cancel_->setText(tr("Cancel"));
  show_missing();
}

void SecondCameraDialog::choose(QWidget* line,
                                bool is_folder,
                                const QString& title,
                                const QString& filter) {
  auto* dialog = new QFileDialog(this, title, {}, filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(is_folder ? QFileDialog::Directory : QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, line, [line](const QString& file) {
    if (auto* box = qobject_cast<QComboBox*>(line))
      box->setEditText(file);
    else
      qobject_cast<QLineEdit*>(line)->setText(file);
  });
  dialog->show();
}

SecondCamera SecondCameraDialog::entered() const {
  SecondCamera second;
  second.finger = finger_->text().trimmed().toStdString();
  second.source = {source_->currentText().trimmed().toStdString()};
  second.gripper = gripper_->text().trimmed().toStdString();
  if (now_ && now_->gripper == second.gripper) second.motor_turns = now_->motor_turns;
  return second;
}

void SecondCameraDialog::show_missing() {
  const bool has_finger = !finger_->text().trimmed().isEmpty();
  const bool has_source = !source_->currentText().trimmed().isEmpty();
  show_->setEnabled(has_finger && has_source);
  missing_->setText(!has_finger   ? tr("Choose the finger's folder.")
                    : !has_source ? tr("Choose the camera that watches it.")
                                  : QString());
}

}  // namespace alltact
