// Dialog for the pose of a finger's camera in the gripper, in millimetres and degrees.
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
  /// now: the known pose.
  GripperDialog(const QString& finger,
                const std::optional<RigidTransform>& now,
                QWidget* parent = nullptr);
  /// The pose in the fields; exactly the initial pose where no field was changed.
  [[nodiscard]] RigidTransform pose() const;

 Q_SIGNALS:
  /// none: the pose is unknown.
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
