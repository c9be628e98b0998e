// Two fingers in one gripper: their places typed in.
#include "widgets/inspect/finger_pair.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

class GripperForm : public testing::Test {
 protected:
  static void type(GripperDialog& dialog, const char* name, const char* number) {
    for (QDoubleSpinBox* box : dialog.findChildren<QDoubleSpinBox*>())
      if (box->accessibleName() == QLatin1String(name)) {
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QLatin1String(number));
        return;
      }
    FAIL() << "no field is called " << name;
  }
};

TEST_F(GripperForm, TellsWhatWasTyped) {
  GripperDialog dialog(QStringLiteral("left-07"), std::nullopt);
  type(dialog, "Position, x", "-42.5");
  type(dialog, "Position, z", "18");
  type(dialog, "Rotation about y", "90");
  const RigidTransform place = dialog.pose();
  EXPECT_EQ(place.translation_mm, Eigen::Vector3d(-42.5, 0, 18));
  // What lies 30 mm before the camera lies 30 mm along the gripper's x.
  EXPECT_LT((place.point({0, 0, 30}) - Eigen::Vector3d(-12.5, 0, 18)).norm(), 1e-12);
}

TEST_F(GripperForm, KeepsTheDigitsOfWhatNobodyTouched) {
  const RigidTransform known{rotation_from_rpy_deg({12.345678, -33.3333333, 170.0001}),
                             {1.23456789, 0, -7.00000001}};
  GripperDialog dialog(QStringLiteral("left-07"), known);
  EXPECT_EQ(dialog.pose(), known);
  type(dialog, "Position, y", "5");
  EXPECT_EQ(dialog.pose().rotation.coeffs(), known.rotation.coeffs());
  EXPECT_EQ(dialog.pose().translation_mm, Eigen::Vector3d(1.23456789, 5, -7.00000001));
}

}  // namespace
}  // namespace alltact::test
