#include "widgets/shell/start_panel.h"

#include "widgets/controls/camera_label.h"
#include "widgets/language.h"

namespace alltact {

StartPanel::StartPanel(QWidget* parent)
    : Translated(parent),
      title_(new QLabel),
      intro_(new QLabel),
      cards_(new FingerCards),
      try_(new QPushButton),
      last_(new QPushButton),
      simulated_(new QPushButton),
      video_(new QPushButton),
      folder_(new QPushButton),
      finger_(new QPushButton),
      new_finger_(new QPushButton),
      sources_(new QGroupBox),
      fingers_(new QGroupBox),
      cameras_(new QVBoxLayout) {
  auto* outer = new QVBoxLayout(this);
  auto* column = new QVBoxLayout;
  auto* middle = new QHBoxLayout;
  outer->addStretch(1);
  outer->addLayout(middle);
  outer->addStretch(2);
  middle->addStretch();
  middle->addLayout(column);
  middle->addStretch();
  column->setSpacing(12);
  QFont large = title_->font();
  large.setPointSizeF(1.6 * large.pointSizeF());
  title_->setFont(large);
  intro_->setWordWrap(true);
  intro_->setMinimumWidth(460);
  column->addWidget(title_);
  column->addWidget(intro_);
  column->addWidget(last_);
  column->addWidget(cards_);
  auto* sources = new QVBoxLayout(sources_);
  sources->addLayout(cameras_);
  for (QPushButton* button : {simulated_, video_, folder_}) sources->addWidget(button);
  auto* fingers = new QVBoxLayout(fingers_);
  for (QPushButton* button : {finger_, new_finger_}) fingers->addWidget(button);
  auto* ways = new QHBoxLayout;
  ways->addWidget(sources_, 1);
  ways->addWidget(fingers_, 1);
  column->addLayout(ways);
  try_->setMinimumHeight(36);
  fingers->addWidget(try_);
  fingers->addStretch();
  sources->addStretch();
  connect(cards_, &FingerCards::finger_chosen, this, &StartPanel::finger_chosen);
  connect(try_, &QPushButton::clicked, this, &StartPanel::try_wanted);
  connect(last_, &QPushButton::clicked, this, &StartPanel::last_wanted);
  connect(simulated_, &QPushButton::clicked, this, &StartPanel::simulated_wanted);
  connect(video_, &QPushButton::clicked, this, &StartPanel::video_wanted);
  connect(folder_, &QPushButton::clicked, this, &StartPanel::folder_wanted);
  connect(finger_, &QPushButton::clicked, this, &StartPanel::finger_wanted);
  connect(new_finger_, &QPushButton::clicked, this, &StartPanel::new_finger_wanted);
  say([this] {
    title_->setText(tr("What shall be shown?"));
    intro_->setText(tr("Choose where pictures come from. A finger can be opened before or after."));
    try_->setText(tr("&Try with a simulated finger"));
    try_->setToolTip(
        tr("A whole day in five minutes: record, press, calibrate and check a finger that is "
           "computed"));
    simulated_->setText(tr("&Simulated finger"));
    video_->setText(tr("&Video file…"));
    folder_->setText(tr("Folder of &pictures…"));
    finger_->setText(tr("&Open a finger…"));
    new_finger_->setText(tr("&New finger…"));
    sources_->setTitle(tr("Source"));
    fingers_->setTitle(tr("Finger"));
    set_last(last_text_);
    show_cameras();
  });
}

void StartPanel::set_last(const QString& what) {
  last_text_ = what;
  last_->setVisible(!what.isEmpty());
  last_->setText(tr("&Go on with %1").arg(what));
}

void StartPanel::set_cameras(const std::vector<FoundCamera>& cameras) {
  found_ = cameras;
  show_cameras();
}

void StartPanel::show_cameras() {
  while (QLayoutItem* item = cameras_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  if (found_.empty()) cameras_->addWidget(new QLabel(tr("No camera is plugged in.")));
  for (const FoundCamera& camera : found_) {
    const QString name = QString::fromStdString(camera.identity.lasting());
    auto* button = new QPushButton(tr("Camera %1").arg(camera_label(camera, found_)));
    button->setToolTip(name);
    connect(button, &QPushButton::clicked, this, [this, name] { Q_EMIT camera_wanted(name); });
    cameras_->addWidget(button);
    if (!camera.problem) continue;
    button->setEnabled(false);
    auto* why = new QLabel(window_sentence(camera.problem->message()));
    why->setWordWrap(true);
    cameras_->addWidget(why);
  }
}

}  // namespace alltact
