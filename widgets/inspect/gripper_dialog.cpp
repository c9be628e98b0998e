#include "widgets/inspect/gripper_dialog.h"

#include <QGridLayout>
#include <QVBoxLayout>

namespace alltact {
namespace {

NumberField* field(double limit, int decimals) {
  auto* box = new NumberField;
  box->setRange(-limit, limit);
  box->set_shown_decimals(decimals);
  return box;
}

Eigen::Vector3d values(const std::array<NumberField*, 3>& fields) {
  Eigen::Vector3d numbers;  // typed numbers, finished or not
  for (std::size_t i = 0; i < 3; ++i)
    numbers[static_cast<Eigen::Index>(i)] = fields[i]->typed().value_or(fields[i]->value());
  return numbers;
}

void fill(const std::array<NumberField*, 3>& fields, const Eigen::Vector3d& values) {
  for (std::size_t i = 0; i < 3; ++i) fields[i]->setValue(values[static_cast<Eigen::Index>(i)]);
}

}  // namespace

GripperDialog::GripperDialog(const QString& finger,
                             const std::optional<RigidTransform>& now,
                             QWidget* parent)
    : FittedDialog(parent),
      finger_(finger),
      now_(now),
      intro_(new QLabel),
      at_label_(new QLabel),
      turn_label_(new QLabel),
      at_{field(10000, 2), field(10000, 2), field(10000, 2)},
      turn_{field(180, 2), field(180, 2), field(180, 2)},
      forget_(new QPushButton),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  auto* column = new QVBoxLayout(this);
  intro_->setWordWrap(true);
  column->addWidget(intro_);
  auto* grid = new QGridLayout;
  int row = 0;
  for (const auto& [label, fields] : {std::pair{at_label_, &at_}, {turn_label_, &turn_}}) {
    grid->addWidget(label, row, 0);
    label->setBuddy((*fields)[0]);
    for (std::size_t i = 0; i < 3; ++i) grid->addWidget((*fields)[i], row, static_cast<int>(i) + 1);
    ++row;
  }
  column->addLayout(grid);
  column->addStretch();
  buttons_->addButton(forget_, QDialogButtonBox::ResetRole);
  forget_->setEnabled(now.has_value());
  column->addWidget(buttons_);
  if (now) {
    fill(at_, now->translation_mm);
    fill(turn_, rpy_deg(now->rotation));
  }
  connect(buttons_, &QDialogButtonBox::accepted, this, [this] {
    for (NumberField* field : {at_[0], at_[1], at_[2], turn_[0], turn_[1], turn_[2]}) {
      if (!field->typed()) return field->setFocus();
      field->interpretText();
    }
    Q_EMIT chosen(pose());
    accept();
  });
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(forget_, &QPushButton::clicked, this, [this] {
    Q_EMIT chosen(std::nullopt);
    accept();
  });
  say([this] {
    setWindowTitle(tr("%1 in the gripper").arg(finger_));
    intro_->setText(
        tr("Where the camera of %1 sits in the gripper's frame: its place, and how it is turned "
           "about the gripper's axes, first x, then y, then z. A camera that is not turned looks "
           "along the gripper's z, with x along its picture and y across it.")
            .arg(finger_));
    at_label_->setText(tr("&Place"));
    turn_label_->setText(tr("&Turned about"));
    static const std::array axes{QStringLiteral("x "), QStringLiteral("y "), QStringLiteral("z ")};
    const std::array<QString, 3> position_names{tr("Place, x"), tr("Place, y"), tr("Place, z")};
    const std::array<QString, 3> turns{
        tr("Turned about x"), tr("Turned about y"), tr("Turned about z")};
    for (std::size_t i = 0; i < 3; ++i) {
      at_[i]->setPrefix(axes[i]);
      at_[i]->setSuffix(tr(" mm"));
      at_[i]->setAccessibleName(position_names[i]);
      turn_[i]->setPrefix(axes[i]);
      turn_[i]->setSuffix(QStringLiteral("°"));
      turn_[i]->setAccessibleName(turns[i]);
    }
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("&Set"));
    buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    forget_->setText(tr("&Not known"));
    forget_->setToolTip(tr("Takes the place out of the finger's file."));
  });
}

RigidTransform GripperDialog::pose() const {
  if (!now_) return {rotation_from_rpy_deg(values(turn_)), values(at_)};
  // The fields round; unchanged values must stay exact.
  const auto unless_changed = [](const std::array<NumberField*, 3>& fields,
                                 const Eigen::Vector3d& was) {
    constexpr double kRounded = 0.0051;
    const Eigen::Vector3d now = values(fields);
    return Eigen::Vector3d(((now - was).array().abs() < kRounded).select(was, now));
  };
  const Eigen::Vector3d degrees = rpy_deg(now_->rotation),
                        view_settled = unless_changed(turn_, degrees);
  return {view_settled == degrees ? now_->rotation : rotation_from_rpy_deg(view_settled),
          unless_changed(at_, now_->translation_mm)};
}

}  // namespace alltact
