#include "widgets/recording/rig_check_box.h"

#include "widgets/controls/control_names.h"
#include "widgets/joined_words.h"
#include "widgets/language.h"
#include "widgets/shell/icons.h"

#include <QHBoxLayout>

namespace alltact {
namespace {

constexpr int kRigSymbol = 16;

QString item_name(RigItem item) {
  switch (item) {
    case RigItem::kFocusBase:
      return RigCheckBox::tr("Focus at the base");
    case RigItem::kFocusTip:
      return RigCheckBox::tr("Focus at the tip");
    case RigItem::kBrightness:
      return RigCheckBox::tr("Brightness");
    case RigItem::kLamp:
      return RigCheckBox::tr("Lamp");
    case RigItem::kDots:
      break;
  }
  return RigCheckBox::tr("Dots");
}

}  // namespace

RigCheckBox::RigCheckBox(QWidget* parent)
    : Translated(parent),
      fold_(new QToolButton),
      rows_(new QWidget),
      column_(new QVBoxLayout(rows_)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  fold_->setCheckable(true);
  fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  column->addWidget(fold_);
  column_->setContentsMargins(4, 0, 0, 0);
  column->addWidget(rows_);
  connect(fold_, &QToolButton::toggled, this, &RigCheckBox::show_fold);
  say([this] {
    rows_->setAccessibleName(tr("Before the first recording"));
    show_findings(findings_, controls_);
  });
}

void RigCheckBox::set_needed(bool is_needed) {
  if (is_needed == is_needed_) return;
  is_needed_ = is_needed;
  fold_->setChecked(is_needed);
}

RigCheckBox::Line RigCheckBox::line_of(const RigFinding& finding) {
  Line line;
  line.is_known = finding.state != RigState::kWaiting;
  line.meaning = finding.state == RigState::kFine  ? Meaning::kGood
                 : finding.state == RigState::kBad ? Meaning::kBad
                                                   : Meaning::kDoubtful;
  line.text = tr("%1: %2.").arg(item_name(finding.item), in_window_language(finding.sentence));
  if (!finding.advice.empty()) line.text += QLatin1Char(' ') + window_sentence(finding.advice);
  return line;
}

void RigCheckBox::show_findings(const std::vector<RigFinding>& findings,
                                const std::vector<CameraControl>& controls) {
  findings_ = findings;
  controls_ = controls;
  std::vector<Line> lines;
  for (const RigFinding& finding : findings) lines.push_back(line_of(finding));
  if (!controls.empty()) {
    QStringList names;
    for (const CameraControl& control : automatic_modes_on(controls))
      names << control_name(control);
    lines.push_back(
        {names.isEmpty() ? Meaning::kGood : Meaning::kBad,
         true,
         names.isEmpty()
             ? tr("Camera: nothing sets itself.")
             : tr("Camera: %1 is on and changes the brightness that is measured. Lock brightness "
                  "in Live, or switch it off there.")
                   .arg(listed(names))});
  }
  const bool is_other_count = lines.size() != shown_.size();
  if (lines == lines_ && !is_other_count) return show_fold();
  lines_ = std::move(lines);
  show_lines(is_other_count);
  show_fold();
}

void RigCheckBox::show_lines(bool anew) {
  if (anew) {
    while (QLayoutItem* item = column_->takeAt(0)) {
      delete item->widget();
      delete item;
    }
    shown_.clear();
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      auto* line_widget = new QWidget;
      auto* row = new QHBoxLayout(line_widget);
      row->setContentsMargins(0, 0, 0, 0);
      Row made{new QLabel, new QLabel};
      made.symbol->setFixedWidth(kRigSymbol);
      made.text->setWordWrap(true);
      row->addWidget(made.symbol, 0, Qt::AlignTop);
      row->addWidget(made.text, 1);
      column_->addWidget(line_widget);
      shown_.push_back(made);
    }
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Line& line = lines_[i];
    const QString name = line.meaning == Meaning::kGood       ? QStringLiteral("good")
                         : line.meaning == Meaning::kDoubtful ? QStringLiteral("doubtful")
                                                              : QStringLiteral("bad");
    shown_[i].symbol->setPixmap(
        line.is_known
            ? symbol(name, meaning_colour(line.meaning, palette()), kRigSymbol, devicePixelRatioF())
            : QPixmap());
    shown_[i].text->setText(line.text);
  }
}

void RigCheckBox::show_fold() {
  const auto count = std::count_if(lines_.begin(), lines_.end(), [](const Line& line) {
    return line.is_known && line.meaning != Meaning::kGood;
  });
  fold_->setText(
      count > 0 ? tr("Before the first recording: %n to mend", nullptr, static_cast<int>(count))
                : tr("Before the first recording"));
  fold_->setArrowType(fold_->isChecked() ? Qt::DownArrow : Qt::RightArrow);
  rows_->setVisible(fold_->isChecked());
}

void RigCheckBox::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_lines(false);
}

}  // namespace alltact
