#include "widgets/shell/start_panel.h"

#include "widgets/controls/camera_label.h"
#include "widgets/language.h"
#include "widgets/shell/primary_button.h"
#include "widgets/theme.h"

namespace alltact {

StartPanel::StartPanel(QWidget* parent)
    : Translated(parent),
      title_(new QLabel),
      intro_(new QLabel),
      cards_(new FingerCards),
      drawing_(new FingerDrawing(DrawnThing::kFinger)),
      try_(new QPushButton),
      last_(new QPushButton),
      simulated_(new QPushButton),
      video_(new QPushButton),
      folder_(new QPushButton),
      finger_(new QPushButton),
      new_finger_(new QPushButton),
      all_(new QPushButton),
      sources_(new QGroupBox),
      fingers_(new QGroupBox),
      cameras_(new QVBoxLayout) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kSpacing, kSpacing, kSpacing, kSpacing);
  row->setSpacing(3 * kSpacing);
  row->addLayout(make_left(), 1);
  row->addLayout(make_right());
  connect(cards_, &FingerCards::filled, this, &StartPanel::mark_primary);
  connect(try_, &QPushButton::clicked, this, &StartPanel::tutorial_requested);
  connect(last_, &QPushButton::clicked, this, &StartPanel::last_requested);
  connect(simulated_, &QPushButton::clicked, this, &StartPanel::simulation_requested);
  connect(video_, &QPushButton::clicked, this, &StartPanel::video_requested);
  connect(folder_, &QPushButton::clicked, this, &StartPanel::folder_requested);
  connect(finger_, &QPushButton::clicked, this, &StartPanel::finger_requested);
  connect(new_finger_, &QPushButton::clicked, this, &StartPanel::new_finger_requested);
  connect(all_, &QPushButton::clicked, this, &StartPanel::all_fingers_requested);
  say([this] { name_parts(); });
}

QVBoxLayout* StartPanel::make_left() {
  auto* column = new QVBoxLayout;
  column->setSpacing(kSpacing + kSpacing / 2);
  title_->setFont(text_font(font(), TextSize::kTitle));
  intro_->setWordWrap(true);
  for (QWidget* widget : {static_cast<QWidget*>(title_),
                          static_cast<QWidget*>(intro_),
                          static_cast<QWidget*>(last_),
                          static_cast<QWidget*>(cards_)})
    column->addWidget(widget);
  column->addWidget(drawing_, 1);
  return column;
}

QVBoxLayout* StartPanel::make_right() {
  constexpr int kWidth = 220;
  auto* sources = new QVBoxLayout(sources_);
  sources->addLayout(cameras_);
  for (QPushButton* button : {simulated_, video_, folder_}) sources->addWidget(button);
  auto* fingers = new QVBoxLayout(fingers_);
  for (QPushButton* button : {finger_, all_, new_finger_}) fingers->addWidget(button);
  auto* column = new QVBoxLayout;
  column->setSpacing(2 * kSpacing);
  for (QWidget* widget : {static_cast<QWidget*>(try_),
                          static_cast<QWidget*>(sources_),
                          static_cast<QWidget*>(fingers_)}) {
    widget->setMinimumWidth(kWidth);
    column->addWidget(widget);
  }
  column->addStretch();
  return column;
}

void StartPanel::name_parts() {
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
  all_->setText(tr("&All fingers…"));
  all_->setToolTip(tr("What each is worth, and what is due, in one list"));
  new_finger_->setText(tr("&New finger…"));
  sources_->setTitle(tr("Source"));
  fingers_->setTitle(tr("Finger"));
  drawing_->setAccessibleName(
      tr("A finger from its side: camera and lamps at its base, and a ball that presses"));
  set_last(last_text_);
  show_cameras();
}

void StartPanel::mark_primary() {
  const bool has_worked = !last_text_.isEmpty();
  set_primary(*last_, has_worked);
  set_primary(*try_, !has_worked && cards_->cards().empty());
  all_->setEnabled(!cards_->cards().empty());
}

void StartPanel::set_last(const QString& what) {
  last_text_ = what;
  last_->setVisible(!what.isEmpty());
  last_->setText(tr("&Go on with %1").arg(what));
  mark_primary();
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
    const QString name = QString::fromStdString(camera.identity.stable_name());
    auto* button = new QPushButton(tr("Camera %1").arg(camera_label(camera, found_)));
    button->setToolTip(name);
    connect(button, &QPushButton::clicked, this, [this, name] { Q_EMIT camera_requested(name); });
    cameras_->addWidget(button);
    if (!camera.problem) continue;
    button->setEnabled(false);
    auto* why = new QLabel(window_sentence(camera.problem->message()));
    why->setWordWrap(true);
    cameras_->addWidget(why);
  }
}

}  // namespace alltact
