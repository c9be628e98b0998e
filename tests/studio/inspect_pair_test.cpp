// Two fingers in the place Inspect, and the view that is turned by hand.
#include "core/finger/finger.h"
#include "core/image/image_file.h"
#include "tests/studio/standing_view.h"
#include "tests/studio/two_fingers.h"
#include "widgets/inspect/finger_pair.h"

#include <QLabel>
#include <QLineEdit>
#include <QWheelEvent>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

void put_in_gripper(const fs::path& folder, const std::optional<RigidTransform>& mount) {
  Finger finger = Finger::load(folder).value();
  finger.gripper_from_camera = mount;
  ASSERT_TRUE(finger.save(folder));
}

class InspectPair : public testing::Test {
 protected:
  static StudioOptions options() {
    StudioOptions options;
    options.finger = TwoFingers::get().left();
    return options;
  }
  InspectPair() : studio_(options()) { studio_.window().go_to("inspect"); }
  ~InspectPair() override {
    put_in_gripper(two_.left(), std::nullopt);
    put_in_gripper(two_.right(), std::nullopt);
  }
  InspectPage& mount() { return *studio_.window().findChild<InspectPage*>(); }
  const FingerPair& pair() { return mount().pair(); }
  bool open_both() {
    mount().open(two_.left_video());
    mount().open_second(SecondFinger{two_.right(), two_.right_video()});
    return wait_until([&] { return pair().frames() && pair().mount(true) != nullptr; }, 20000);
  }
  std::string text(const QString& label) {
    return studio_.find<QLabel>(label)->text().toStdString();
  }
  const TwoFingers& two_ = TwoFingers::get();
  Studio studio_;
};

TEST_F(InspectPair, JoinsFramesByTheirTimes) {
  ASSERT_TRUE(open_both());
  auto* slider = studio_.find<QSlider>("Frame of the recording");
  for (const int frame : {3, 1, 5}) {
    slider->setValue(frame);
    ASSERT_TRUE(wait_until([&] {
      const auto frames = pair().frames();
      return frames && frames->first->number == static_cast<std::size_t>(frame) &&
             frames->second->number == 2 * static_cast<std::size_t>(frame);
    }));
    EXPECT_THAT(text("Matching of the two recordings"), HasSubstr("2 was captured 0.0 ms after 1"));
  }
}

TEST_F(InspectPair, SaysWhatIsMissingAndTakesThePlaceThatIsTyped) {
  ASSERT_TRUE(open_both());
  EXPECT_FALSE(pair().has_both_poses());
  EXPECT_THAT(studio_.problems(),
              HasSubstr("camera pose of calibrated in the gripper is not known"));
  studio_.click("Pose of the second finger in the gripper");
  auto* dialog = studio_.window().findChild<GripperDialog*>();
  ASSERT_NE(dialog, nullptr);
  for (QDoubleSpinBox* box : dialog->findChildren<QDoubleSpinBox*>())
    if (box->accessibleName() == QLatin1String("Position, x")) box->setValue(12.5);
  QTest::keyClick(dialog, Qt::Key_Return);
  const auto written = [&] { return Finger::load(two_.right()).value().gripper_from_camera; };
  ASSERT_TRUE(wait_until([&] { return written().has_value(); }));
  EXPECT_EQ(written()->translation_mm, Eigen::Vector3d(12.5, 0, 0));
  ASSERT_TRUE(wait_until([&] { return pair().mount(true)->gripper_from_camera.has_value(); }));
  EXPECT_EQ(studio_.window().undo_stack().undoText(), "pose of right in the gripper");
  studio_.window().undo_stack().undo();
  EXPECT_TRUE(wait_until([&] { return !written().has_value(); }));
  studio_.window().undo_stack().redo();
  EXPECT_TRUE(wait_until([&] { return written().has_value(); }));
}

TEST_F(InspectPair, TellsTheDistanceOfTheFaces) {
  put_in_gripper(two_.left(), TwoFingers::place_of_left());
  put_in_gripper(two_.right(), TwoFingers::place_of_right());
  ASSERT_TRUE(open_both());
  ASSERT_TRUE(wait_until([&] { return pair().gap().has_value(); }));
  // Of points of both contact faces none are nearer, and some are nearly as near.
  const auto points = [](const InspectedFrame& frame, const RigidTransform& mount) {
    std::vector<Eigen::Vector3d> points;
    const cv::Mat face = contact_face_points_mm(frame.result, frame.face);
    for (int v = 0; v < face.rows; v += 7)
      for (int u = 0; u < face.cols; u += 7)
        if (const auto& p = face.at<cv::Vec3f>(v, u); std::isfinite(p[2]))
          points.push_back(mount.point({p[0], p[1], p[2]}));
    return points;
  };
  const auto frames = *pair().frames();
  double nearest = std::numeric_limits<double>::infinity();
  const auto right = points(*frames.second, TwoFingers::place_of_right());
  for (const auto& p : points(*frames.first, TwoFingers::place_of_left()))
    for (const auto& q : right) nearest = std::min(nearest, (p - q).norm());
  const double reported = pair().gap()->distance();
  EXPECT_GT(reported, 1);
  EXPECT_LE(reported, nearest + 0.1);
  EXPECT_GT(reported, nearest - 4.5)
      << "seven pixels are one to two millimetres at the tips, where the faces are nearest";
  EXPECT_THAT(text("Distance between the faces"),
              HasSubstr(QLocale().toString(reported, 'f', 2).toStdString() + " mm"));
  EXPECT_EQ(studio_.problems(), "");
}

TEST_F(InspectPair, SavesBothInTheGrippersFrame) {
  put_in_gripper(two_.left(), TwoFingers::place_of_left());
  put_in_gripper(two_.right(), TwoFingers::place_of_right());
  ASSERT_TRUE(open_both());
  ASSERT_TRUE(wait_until([&] { return pair().has_both_poses(); }));
  const TemporaryFolder out;
  mount().save(out / "both.ply");
  ASSERT_TRUE(wait_until([&] { return !mount().is_saving(); }));
  EXPECT_FALSE(fs::exists(out / "both.ply"));
  const auto frames = *pair().frames();
  for (const auto& [name, frame, at] :
       {std::tuple{"both-1.ply", frames.first, TwoFingers::place_of_left()},
        {"both-2.ply", frames.second, TwoFingers::place_of_right()}}) {
    const std::string file = text_of(out / name);
    const std::size_t data = file.find("end_header\n") + 11;
    ASSERT_LT(data, file.size());
    cv::Vec3f first;
    std::memcpy(first.val, file.data() + data, sizeof first.val);
    const cv::Mat face = contact_face_points_mm(frame->result, frame->face);
    for (int i = 0; i < static_cast<int>(face.total()); ++i) {
      const auto& p = face.at<cv::Vec3f>(i / face.cols, i % face.cols);
      if (!std::isfinite(p[2])) continue;
      const Eigen::Vector3d expected = at.point({p[0], p[1], p[2]});
      EXPECT_LT((Eigen::Vector3d(first[0], first[1], first[2]) - expected).norm(), 1e-3) << name;
      break;
    }
  }
  EXPECT_THAT(text("What was saved"), HasSubstr("both-2.ply"));
}

TEST_F(InspectPair, IsOpenedByItsDialogAndClosedByUndo) {
  mount().open(two_.left_video());
  ASSERT_TRUE(wait_until([&] { return mount().inspection().frame() != nullptr; }));
  studio_.click("Second finger…");
  auto* dialog = studio_.window().findChild<SecondFingerDialog*>();
  ASSERT_NE(dialog, nullptr);
  for (QLineEdit* line : dialog->findChildren<QLineEdit*>())
    line->setText(QString::fromStdString(
        (line->accessibleName() == QLatin1String("Recording") ? two_.right_video() : two_.right())
            .string()));
  QTest::keyClick(dialog, Qt::Key_Return);
  ASSERT_TRUE(wait_until([&] { return pair().frames().has_value(); }));
  EXPECT_EQ(studio_.window().undo_stack().undoText(), "show a second finger");
  studio_.window().undo_stack().undo();
  EXPECT_FALSE(pair().is_open());
  studio_.window().undo_stack().redo();
  EXPECT_TRUE(wait_until([&] { return pair().frames().has_value(); }));
  studio_.click("Live finger");
  EXPECT_FALSE(pair().is_open());
  EXPECT_TRUE(mount().options().recording.empty());
  studio_.window().undo_stack().undo();
  EXPECT_TRUE(wait_until([&] { return pair().frames().has_value(); }));
}

TEST_F(InspectPair, SaysWhyTheSecondCannotBeShown) {
  mount().open(two_.left_video());
  mount().open_second(SecondFinger{"/nowhere/finger", "/nowhere/b.mkv"});
  ASSERT_TRUE(
      wait_until([&] { return studio_.problems().find("/nowhere/finger") != std::string::npos; }));
  ASSERT_TRUE(
      wait_until([&] { return studio_.problems().find("/nowhere/b.mkv") != std::string::npos; }));
}

/// On a screen with OpenGL only.
class InspectIn3D : public InspectPair {
 protected:
  void SetUp() override {
    if (!VtkView::is_supported()) GTEST_SKIP() << "needs a screen with OpenGL: xvfb-run";
  }
  FacePane& view() { return *studio_.window().findChild<FacePane*>(); }
  bool open_one() {
    mount().open(two_.left_video());
    return wait_for_standing_view(studio_);
  }
  void drag(QPoint from, QPoint to) {
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 4; ++i) {
      const QPoint at = from + (to - from) * i / 4;
      QMouseEvent move(QEvent::MouseMove, at, at, Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(&view(), &move);
    }
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
  }
  void roll(int clicks) {
    const QPointF at(200, 200);
    for (int i = 0; i < clicks; ++i) {
      QWheelEvent event(at, view().mapToGlobal(at), {}, {0, 120}, Qt::NoButton, {},
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(&view(), &event);
    }
  }
  QUndoStack& stack() { return studio_.window().undo_stack(); }
  void expect_view_pose(const ViewPose& pose) {
    EXPECT_LT((view().scene().view_pose().eye - pose.eye).norm(), 1e-6);
    EXPECT_LT((view().scene().view_pose().at - pose.at).norm(), 1e-6);
  }
};

TEST_F(InspectIn3D, ADragIsOneStepBack) {
  ASSERT_TRUE(open_one());
  const int before = stack().count();
  const ViewPose first = view().scene().view_pose();
  drag({200, 200}, {320, 240});
  const ViewPose second = view().scene().view_pose();
  EXPECT_GT((second.eye - first.eye).norm(), 1);
  drag({200, 200}, {150, 260});
  const ViewPose third = view().scene().view_pose();
  EXPECT_EQ(stack().count(), before + 2);
  EXPECT_EQ(stack().undoText(), "turn the 3D view");
  stack().undo();
  expect_view_pose(second);
  stack().undo();
  expect_view_pose(first);
  stack().redo();
  stack().redo();
  expect_view_pose(third);
}

TEST_F(InspectIn3D, StepsOfTheWheelAndOfKeysBelongTogetherForAMoment) {
  ASSERT_TRUE(open_one());
  const int before = stack().count();
  const ViewPose first = view().scene().view_pose();
  roll(3);
  EXPECT_EQ(stack().count(), before + 1);
  QTest::qWait(800);
  const ViewPose closer = view().scene().view_pose();
  view().setFocus();
  for (int i = 0; i < 3; ++i) QTest::keyClick(&view(), Qt::Key_Left);
  EXPECT_EQ(stack().count(), before + 2);
  EXPECT_GT((view().scene().view_pose().eye - closer.eye).norm(), 1);
  stack().undo();
  expect_view_pose(closer);
  stack().undo();
  expect_view_pose(first);
  roll(1);
  QTest::keyClick(&view(), Qt::Key_0);
  EXPECT_EQ(stack().undoText(), "show all again");
  expect_view_pose(first);
  stack().undo();
  EXPECT_GT((view().scene().view_pose().eye - first.eye).norm(), 0.1);
}

TEST_F(InspectIn3D, AClickThatTremblesTurnsNothing) {
  ASSERT_TRUE(open_one());
  const ViewPose first = view().scene().view_pose();
  const int before = stack().count();
  const QPoint middle = view().rect().center();
  drag(middle, middle + QPoint(1, 1));
  expect_view_pose(first);
  EXPECT_LE(stack().count(), before + 1) << "a point perhaps, no turn";
  EXPECT_NE(stack().undoText(), "turn the 3D view");
}

TEST_F(InspectIn3D, ShowsBothInOnePicture) {
  put_in_gripper(two_.left(), TwoFingers::place_of_left());
  put_in_gripper(two_.right(), TwoFingers::place_of_right());
  ASSERT_TRUE(open_both());
  ASSERT_TRUE(wait_until([&] { return pair().gap().has_value(); }));
  int panes = 0;
  for (const InspectPane* pane : mount().findChildren<InspectPane*>()) panes += pane->isVisible();
  EXPECT_EQ(panes, 1);
  QTest::qWait(300);
  fs::create_directories(ALLTACT_SCREENS);
  studio_.window().grab().save(QStringLiteral(ALLTACT_SCREENS "/inspect_pair_3d.png"));
  put_in_gripper(two_.right(), std::nullopt);
}

}  // namespace
}  // namespace alltact::test
