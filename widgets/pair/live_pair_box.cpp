#include "widgets/pair/live_pair_box.h"

#include "widgets/joined_words.h"
#include "widgets/language.h"
#include "widgets/touch/contact_words.h"

#include <QGridLayout>
#include <QSignalBlocker>
#include <cmath>

namespace alltact {

QString finger_name(const FingerStatus& finger) {
  return QString::fromStdString(finger.finger ? finger.finger->name
                                              : finger.folder.filename().string());
}

LivePairBox::LivePairBox(const LivePair& pair, const LiveSession& first, QWidget* parent)
    : Translated(parent),
      pair_(pair),
      first_(first),
      open_(new QPushButton),
      close_(new QPushButton),
      names_(new QLabel),
      moment_(new QLabel),
      reading_(new QLabel),
      motor_label_(new QLabel),
      motor_(new NumberField) {
  auto* grid = new QGridLayout(this);
  grid->addWidget(names_, 0, 0, 1, 2);
  grid->addWidget(reading_, 1, 0, 1, 2);
  grid->addWidget(motor_label_, 2, 0);
  grid->addWidget(motor_, 2, 1);
  grid->addWidget(moment_, 3, 0, 1, 2);
  grid->addWidget(open_, 4, 0);
  grid->addWidget(close_, 4, 1);
  for (QLabel* label : {names_, moment_, reading_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::RichText);
  }
  reading_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  motor_label_->setBuddy(motor_);
  motor_->set_shown_decimals(3);
  motor_->setSingleStep(0.1);
  connect(open_, &QPushButton::clicked, this, &LivePairBox::open_requested);
  connect(close_, &QPushButton::clicked, this, &LivePairBox::close_requested);
  connect(motor_, &NumberField::valueChanged, this, &LivePairBox::motor_requested);
  say([this] { name_parts(); });
}

void LivePairBox::name_parts() {
  setTitle(tr("Second finger"));
  open_->setText(tr("&Second finger…"));
  close_->setText(tr("Close it"));
  motor_label_->setText(tr("Mo&tor at"));
  motor_->setSuffix(tr(" turns"));
  motor_->setAccessibleName(tr("Motor position in turns"));
  motor_->setToolTip(tr("Where the gripper's motor stands: the figures hold for this position."));
  reading_->setAccessibleName(tr("Gap and width"));
  moment_->setAccessibleName(tr("Whether both pictures are of one moment"));
  show_pair();
}

void LivePairBox::show_pair() {
  const bool is_open = pair_.opened().has_value() && pair_.second() != nullptr;
  for (QWidget* widget : std::initializer_list<QWidget*>{close_, names_, moment_, reading_})
    widget->setVisible(is_open);
  const auto turns = pair_.motor_turns();
  motor_label_->setVisible(turns.has_value());
  motor_->setVisible(turns.has_value());
  if (!is_open) return;
  if (turns) {
    const QSignalBlocker blocker(motor_);
    const GripperMotor& motor = pair_.gripper()->gripper.motor;
    motor_->setRange(motor.first_turns, motor.last_turns);
    motor_->setValue(*turns);
  }
  names_->setText(names_text());
  moment_->setText(moment_text());
  reading_->setText(reading_text());
}

QString LivePairBox::names_text() const {
  const auto& pair = pair_.pair();
  QStringList lines;
  for (const std::size_t i : {0U, 1U}) {
    const LiveSession& session = i == 0 ? first_ : *pair_.second();
    QString line =
        labelled(QString::number(i + 1), finger_name(session.status().finger).toHtmlEscaped());
    const QString felt = pair ? brief_contact_words(pair->views[i]->result) : QString();
    if (!felt.isEmpty()) line += QStringLiteral("<br>&nbsp;&nbsp;&nbsp;") + felt;
    lines << line;
  }
  return lines.join(QStringLiteral("<br>"));
}

QString LivePairBox::moment_text() const {
  if (const auto problem = pair_.problem())
    return window_sentence(problem->message()).toHtmlEscaped();
  const auto& pair = pair_.pair();
  if (!pair) return tr("Waiting for the second picture.");
  if (!pair->later_ms) return tr("Without times of capture: the newest of both.");
  const QString later = plain_number(*pair->later_ms, 1);
  if (pair->is_in_time) return tr("In time: 2 was taken %1 ms after 1.").arg(later);
  return QStringLiteral("<b>%1 %2</b>")
      .arg(QString(QChar(0x25b2)),
           tr("Not in time: 2 was taken %1 ms after 1, more than half a frame.").arg(later));
}

QString LivePairBox::reading_text() const {
  if (pair_.opened()->gripper.empty())
    return tr(
        "With a gripper.yaml, the gap between the faces and the width of what is held are "
        "told here.");
  if (!pair_.gripper() || pair_.problem()) return {};
  const auto& reading = pair_.reading();
  if (!reading) return tr("Measuring…");
  QString rows;
  const auto add = [&](const QString& name, double mm, const std::optional<double>& sd) {
    rows += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td><b>%2</b></td></tr>")
                .arg(name, tr("%1 mm").arg(number_and_sd(mm, sd, 2)));
  };
  if (reading->gap) add(tr("Gap"), reading->gap->mm, reading->gap->sd_mm);
  if (reading->width) add(tr("Held width"), reading->width->mm, reading->width->sd_mm);
  QString text = QStringLiteral("<table>%1</table>").arg(rows);
  if (!reading->gap) text += tr("No gap is told: both faces need depth.");
  if (!reading->width) text += QStringLiteral(" ") + tr("Nothing is held by both.");
  return text;
}

}  // namespace alltact
