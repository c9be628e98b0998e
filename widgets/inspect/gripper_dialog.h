// Where a finger's camera sits in the gripper: asked for in millimetres and degrees.
#pragma once

#include "core/geometry/rigid_transform.h"
#include "widgets/controls/number_field.h"
#include "widgets/shell/fitted_dialog.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <array>
#include <optional>

namespace alltact {

class GripperDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// now: what is known.
  GripperDialog(const QString& finger,
                const std::optional<RigidTransform>& now,
                QWidget* parent = nullptr);
  /// What stands in the fields. Where nobody changed them, exactly what it was made with.
  [[nodiscard]] RigidTransform place() const;

 Q_SIGNALS:
  /// none: it is not known any more.
  void chosen(const std::optional<alltact::RigidTransform>& gripper_from_camera);

 private:
  QString finger_;
  std::optional<RigidTransform> now_;
  QLabel *intro_, *at_label_, *turn_label_;
  std::array<NumberField*, 3> at_, turn_;
  QPushButton* forget_;
  QDialogButtonBox* buttons_;
};

}  // namespace alltact
