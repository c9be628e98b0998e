#include "widgets/inspect/second_finger_dialog.h"

#include "widgets/tip_of_text.h"

#include <QFileDialog>
#include <QGridLayout>
#include <QVBoxLayout>

namespace alltact {

SecondFingerDialog::SecondFingerDialog(const std::optional<SecondFinger>& now, QWidget* parent)
    : FittedDialog(parent),
      intro_(new QLabel),
      finger_label_(new QLabel),
      recording_label_(new QLabel),
      missing_(new QLabel),
      finger_(new QLineEdit),
      recording_(new QLineEdit),
      choose_finger_(new QPushButton),
      choose_video_(new QPushButton),
      choose_folder_(new QPushButton),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  auto* column = new QVBoxLayout(this);
  intro_->setWordWrap(true);
  column->addWidget(intro_);
  auto* grid = new QGridLayout;
  grid->addWidget(finger_label_, 0, 0);
  grid->addWidget(finger_, 0, 1);
  grid->addWidget(choose_finger_, 0, 2, 1, 2);
  grid->addWidget(recording_label_, 1, 0);
  grid->addWidget(recording_, 1, 1);
  grid->addWidget(choose_video_, 1, 2);
  grid->addWidget(choose_folder_, 1, 3);
  finger_label_->setBuddy(finger_);
  recording_label_->setBuddy(recording_);
  for (QLineEdit* line : {finger_, recording_}) {
    line->setMinimumWidth(280);
    show_text_as_tip(*line);
  }
  column->addLayout(grid);
  column->addStretch();
  column->addWidget(missing_);
  column->addWidget(buttons_);
  if (now) {
    finger_->setText(QString::fromStdString(now->finger.string()));
    recording_->setText(QString::fromStdString(now->recording.string()));
  }
  for (QLineEdit* line : {finger_, recording_})
    connect(line, &QLineEdit::textChanged, this, &SecondFingerDialog::show_missing);
  connect(choose_finger_, &QPushButton::clicked, this, [this] {
    choose(finger_, true, tr("The second finger's folder"));
  });
  connect(choose_video_, &QPushButton::clicked, this, [this] {
    choose(recording_, false, tr("The second finger's video"));
  });
  connect(choose_folder_, &QPushButton::clicked, this, [this] {
    choose(recording_, true, tr("The second finger's folder of pictures"));
  });
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons_, &QDialogButtonBox::accepted, this, [this] {
    Q_EMIT chosen(
        {finger_->text().trimmed().toStdString(), recording_->text().trimmed().toStdString()});
    accept();
  });
  say([this] {
    setWindowTitle(tr("Second finger"));
    intro_->setText(
        tr("Another finger of the same gripper, with what it recorded at the same time. Both are "
           "shown in the gripper's frame; their frames are joined by the times of capture."));
    finger_label_->setText(tr("&Finger's folder"));
    recording_label_->setText(tr("&Recording"));
    finger_->setAccessibleName(tr("Finger's folder"));
    recording_->setAccessibleName(tr("Recording"));
    choose_finger_->setText(tr("Choose…"));
    choose_finger_->setAccessibleName(tr("Choose the finger's folder"));
    choose_video_->setText(tr("Video…"));
    choose_folder_->setText(tr("Pictures…"));
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("&Show it"));
    buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    show_missing();
  });
}

void SecondFingerDialog::choose(QLineEdit* line, bool is_folder, const QString& title) {
  auto* dialog = new QFileDialog(
      this, title, line->text(), is_folder ? QString() : tr("Videos (*.mkv *.avi *.mp4)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(is_folder ? QFileDialog::Directory : QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, line, &QLineEdit::setText);
  dialog->show();
}

void SecondFingerDialog::show_missing() {
  const bool has_finger = !finger_->text().trimmed().isEmpty();
  const bool has_recording = !recording_->text().trimmed().isEmpty();
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(has_finger && has_recording);
  missing_->setText(!has_finger      ? tr("Choose the finger's folder.")
                    : !has_recording ? tr("Choose what it recorded.")
                                     : QString());
}

}  // namespace alltact
