// Two fingers in one gripper: frames joined by time, places typed in.
#include "widgets/inspect/gripper_dialog.h"
#include "widgets/inspect/time_match.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(TimeMatch, TakesTheFrameNearestInTime) {
  const FrameTimes ours{1000 * kMs, 1033 * kMs, 1067 * kMs, 1100 * kMs};
  const FrameTimes other{990 * kMs, 1040 * kMs, 1090 * kMs, 1140 * kMs};
  const std::vector<std::size_t> expected{0, 1, 2, 2};
  const std::vector<double> later{-10, 7, 23, -10};
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const FrameBeside beside = frame_beside(i, ours, other, other.size());
    EXPECT_EQ(beside.number, expected[i]) << i;
    EXPECT_EQ(beside.by, JoinedBy::kTime);
    EXPECT_NEAR(beside.later_ms, later[i], 1e-9);
  }
}

TEST(TimeMatch, LostFramesLeaveNoShiftBehind) {
  FrameTimes ours, other;
  for (int i = 0; i < 100; ++i) {
    ours.push_back(i * 20 * kMs);
    if (i < 30 || i >= 50) other.push_back(i * 20 * kMs + kMs);
  }
  EXPECT_EQ(other[frame_beside(90, ours, other, other.size()).number], 90 * 20 * kMs + kMs);
  EXPECT_EQ(frame_beside(35, ours, other, other.size()).number, 29U);
}

TEST(TimeMatch, RecordingsOfDifferentTimesBeginTogether) {
  const FrameTimes ours{0, 100 * kMs, 200 * kMs}, other{9000 * kMs, 9050 * kMs, 9100 * kMs};
  const FrameBeside beside = frame_beside(1, ours, other, other.size());
  EXPECT_EQ(beside.by, JoinedBy::kBeginning);
  EXPECT_EQ(beside.number, 2U);
  EXPECT_NEAR(beside.later_ms, 0, 1e-9);
  EXPECT_EQ(frame_beside(2, ours, other, other.size()).number, 2U) << "the last of a shorter one";
}

TEST(TimeMatch, WithoutTimesTheNumberCounts) {
  EXPECT_EQ(frame_beside(3, {}, {0, kMs}, 2).number, 1U);
  EXPECT_EQ(frame_beside(3, {}, {}, 10).number, 3U);
  EXPECT_EQ(frame_beside(0, {kMs}, {}, 10).by, JoinedBy::kNumber);
}

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
  type(dialog, "Place, x", "-42.5");
  type(dialog, "Place, z", "18");
  type(dialog, "Turned about y", "90");
  const RigidTransform place = dialog.place();
  EXPECT_EQ(place.translation_mm, Eigen::Vector3d(-42.5, 0, 18));
  // What lies 30 mm before the camera lies 30 mm along the gripper's x.
  EXPECT_LT((place.point({0, 0, 30}) - Eigen::Vector3d(-12.5, 0, 18)).norm(), 1e-12);
}

TEST_F(GripperForm, KeepsTheDigitsOfWhatNobodyTouched) {
  const RigidTransform known{rotation_of_degrees({12.345678, -33.3333333, 170.0001}),
                             {1.23456789, 0, -7.00000001}};
  GripperDialog dialog(QStringLiteral("left-07"), known);
  EXPECT_EQ(dialog.place(), known);
  type(dialog, "Place, y", "5");
  EXPECT_EQ(dialog.place().rotation.coeffs(), known.rotation.coeffs());
  EXPECT_EQ(dialog.place().translation_mm, Eigen::Vector3d(1.23456789, 5, -7.00000001));
}

}  // namespace
}  // namespace alltact::test
