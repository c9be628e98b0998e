#include "widgets/inspect/pair_box.h"

#include "widgets/joined_words.h"

#include <QGridLayout>
#include <QLocale>
#include <cmath>

namespace alltact {

PairBox::PairBox(const FingerPair& pair, QWidget* parent)
    : Translated(parent),
      pair_(pair),
      open_(new QPushButton),
      close_(new QPushButton),
      pose_first_(new QPushButton),
      pose_second_(new QPushButton),
      names_(new QLabel),
      joined_(new QLabel),
      gap_(new QLabel) {
  auto* grid = new QGridLayout(this);
  grid->addWidget(names_, 0, 0, 2, 1);
  grid->addWidget(close_, 0, 1);
  grid->addWidget(pose_first_, 2, 0);
  grid->addWidget(pose_second_, 2, 1);
  grid->addWidget(gap_, 3, 0, 1, 2);
  grid->addWidget(joined_, 4, 0, 1, 2);
  for (QLabel* label : {names_, joined_, gap_}) label->setWordWrap(true);
  gap_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  connect(open_, &QPushButton::clicked, this, &PairBox::open_requested);
  connect(close_, &QPushButton::clicked, this, &PairBox::close_requested);
  connect(pose_first_, &QPushButton::clicked, this, [this] { Q_EMIT pose_requested(false); });
  connect(pose_second_, &QPushButton::clicked, this, [this] { Q_EMIT pose_requested(true); });
  say([this] {
    setTitle(tr("Second finger"));
    open_->setText(tr("Second fin&ger…"));
    close_->setText(tr("Close it"));
    pose_first_->setText(tr("Place of 1…"));
    pose_second_->setText(tr("Place of 2…"));
    pose_first_->setAccessibleName(tr("Place of the first finger in the gripper"));
    pose_second_->setAccessibleName(tr("Place of the second finger in the gripper"));
    for (QPushButton* button : {pose_first_, pose_second_})
      button->setToolTip(tr("Where this finger's camera sits in the gripper."));
    gap_->setAccessibleName(tr("Distance between the faces"));
    joined_->setAccessibleName(tr("How the two recordings are joined"));
  });
}

void PairBox::show_pair(bool is_recording) {
  const bool is_open = pair_.is_open();
  open_->setEnabled(is_recording);
  open_->setToolTip(is_recording ? QString()
                                 : tr("Open a recording first; a second one can be joined to it."));
  setVisible(is_open);
  if (!is_open) return;
  pose_first_->setEnabled(!pair_.folder(false).empty());
  names_->setText(labelled(QStringLiteral("1"), pair_.name(false).toHtmlEscaped()) +
                  QStringLiteral("<br>") +
                  labelled(QStringLiteral("2"), pair_.name(true).toHtmlEscaped()));
  joined_->setText(joined_text());
  gap_->setText(gap_text());
}

QString PairBox::joined_text() const {
  const MatchedFrame& partner = pair_.partner();
  if (!pair_.frames()) return {};
  const QString later = QLocale().toString(std::round(10 * partner.later_ms) / 10 + 0.0, 'f', 1);
  switch (partner.by) {
    case MatchedBy::kTime:
      return tr("Joined by time stamps; 2 was taken %1 ms after 1.").arg(later);
    case MatchedBy::kBeginning:
      return tr("Recorded at different times: their beginnings count as one moment; 2 was taken "
                "%1 ms after 1.")
          .arg(later);
    case MatchedBy::kNumber:
      break;
  }
  return tr("Without time stamps: joined by the number of the frame.");
}

QString PairBox::gap_text() const {
  if (!pair_.has_both_poses() || !pair_.frames()) return {};
  const auto gap = pair_.gap();
  if (!gap) return tr("Measuring the distance…");
  const double apart_mm = gap->distance();
  if (apart_mm < 0.005) return tr("<b>The faces touch or cross.</b>");
  const Eigen::Vector3d middle = 0.5 * (gap->first + gap->second);
  const auto number = [](double value, int digits) {
    const double unit = std::pow(10, digits);
    return QLocale().toString(std::round(value * unit) / unit + 0.0, 'f', digits);
  };
  return tr("<b>%1 mm</b> between the faces where they are nearest, around X %2, Y %3, Z %4 mm")
      .arg(
          number(apart_mm, 2), number(middle.x(), 1), number(middle.y(), 1), number(middle.z(), 1));
}

}  // namespace alltact
