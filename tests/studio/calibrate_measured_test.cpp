// The step Presses: pictures that were held still, depths that were measured, punches with a step.
#include "core/base/atomic_file.h"
#include "core/open/open_source.h"
#include "core/simulation/plan.h"
#include "tests/studio/calibrate_rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

/// The frames of all views from now on.
std::shared_ptr<std::vector<FramePtr>> watched_frames(Studio& studio) {
  auto frames = std::make_shared<std::vector<FramePtr>>();
  QObject::connect(&studio.session(), &LiveSession::view_ready,
                   studio.window().findChild<PressesPage*>(),
                   [&studio, frames] { frames->push_back(studio.session().view()->result.frame); });
  return frames;
}

/// What a scene that holds still shows, nearly without noise and with other noise than the window.
cv::Mat noiseless(const std::filesystem::path& scene) {
  constexpr int kFrames = 40;
  const Plan plan = Plan::compile(Scene::load(scene).value(), 2).value();
  cv::Mat mean;
  for (int i = 0; i < kFrames; ++i) {
    cv::Mat grey;
    plan.render(i).convertTo(grey, CV_32F, 1.0 / kFrames);
    mean = mean.empty() ? grey : cv::Mat(mean + grey);
  }
  return mean;
}

double noise_of(const cv::Mat& grey, const cv::Mat& scene) {
  cv::Mat difference;
  cv::subtract(grey, scene, difference, cv::noArray(), CV_32F);
  cv::Scalar mean, sd;
  cv::meanStdDev(difference, mean, sd);
  return sd[0];
}

QPushButton* take_button(Studio& studio) {
  return studio.find<QPushButton>("Take a press (Space)");
}

TEST(CalibrateHeld, APressOfAFingerHeldStillHasLessNoiseThanAFrame) {
  CalibrateStudio rig;
  const auto scene = rig.folder() / "still.yaml";
  ASSERT_TRUE(write_file_atomically(scene, still_scene()).ok());
  rig.open();
  rig.go_to_step("Presses");
  Studio& studio = rig.studio();
  studio.window().open_source({scene});
  const auto frames = watched_frames(studio);
  ASSERT_TRUE(wait_until([&] { return frames->size() >= 24; }, 30000));
  take_button(studio)->click();
  const FramePtr newest = frames->back();
  const FramePtr press = rig.collection().find("press_01")->frame;
  EXPECT_TRUE(says(studio, "press_01 is taken: the mean of 16 still images."));
  const cv::Mat truth = noiseless(scene);
  const double one = noise_of(newest->grey, truth), mean = noise_of(press->grey, truth);
  std::printf("[ figures  ] noise of a frame %.3f levels, of the press %.3f\n", one, mean);
  EXPECT_LT(mean, 0.5 * one) << "a quarter, but for whole levels";
  EXPECT_EQ(press->time_ns, newest->time_ns);
  // Out of sight it forgets.
  rig.go_to_step("Finger");
  rig.go_to_step("Presses");
  take_button(studio)->click();
  EXPECT_FALSE(says(studio, "press_02"));
  EXPECT_TRUE(wait_until([&] { return says(studio, "press_02 is taken: the mean of "); }));
}

TEST(CalibrateHeld, APressOfAFingerThatMovesIsWaitedFor) {
  CalibrateStudio rig;
  const auto scene = rig.folder() / "still.yaml";
  ASSERT_TRUE(write_file_atomically(scene, still_scene()).ok());
  rig.open();
  rig.go_to_step("Presses");
  Studio& studio = rig.studio();
  studio.window().open_source({MadeFingers::get().bending()});
  const auto frames = watched_frames(studio);
  ASSERT_TRUE(wait_until([&] { return frames->size() >= 5; }, 30000));
  take_button(studio)->click();
  EXPECT_TRUE(says(studio, "The press is taken once ball and finger are held still."));
  QTest::qWait(300);
  EXPECT_TRUE(rig.collection().presses().empty());
  studio.window().open_source({scene});
  ASSERT_TRUE(wait_until([&] { return rig.collection().presses().size() == 1; }, 10000));
  EXPECT_TRUE(says(studio, "press_01 is taken: the mean of "));
}

/// The step Presses of a window with some presses of a ball, and the last one of a punch.
class CalibrateMeasured : public testing::Test {
 protected:
  void open() {
    rig_.open();
    rig_.go_to_step("Presses");
    rig_.type_radius("4");
    ASSERT_TRUE(rig_.wait_until_looked_at(kPresses));
  }
  void show(int row) {
    auto* list = rig_.studio().find<QListView>("Presses");
    list->setCurrentIndex(list->model()->index(row, 0));
  }
  /// Most presses need nothing but their ball: what is measured of one waits folded away.
  void unfold() { rig_.studio().click("Depth, ball or punch"); }
  QDoubleSpinBox* field(const char* name) { return rig_.studio().find<QDoubleSpinBox>(name); }
  void type(const char* name, const QString& text) {
    auto* box = field(name);
    ASSERT_NE(box, nullptr);
    ASSERT_TRUE(box->isEnabled()) << name;
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, text);
    QTest::keyClick(box, Qt::Key_Return);
  }
  QUndoStack& undo() { return rig_.studio().window().undo_stack(); }
  std::string state_of(const std::string& press) {
    return press_state_text(*rig_.collection().find(press), rig_.collection(), rig_.run())
        .toStdString();
  }

  static constexpr int kPresses = 7;
  static constexpr const char* kDepth = "Measured depth of this press";
  static constexpr const char* kSd = "Standard deviation of the measured depth";
  static constexpr const char* kStep = "Step of a punch";
  CalibrateStudio rig_{kPresses - 1};
  const bool has_punch_ = (rig_.add_punch("press_07"), true);
};

TEST_F(CalibrateMeasured, DepthAndStepAreSaidUndoneAndKept) {
  open();
  show(0);
  unfold();
  EXPECT_EQ(field(kDepth)->text().toStdString(), "not measured");
  EXPECT_FALSE(field(kSd)->isEnabled());
  type(kDepth, "0.67");
  EXPECT_EQ(rig_.collection().press_set().of("press_01").depth,
            (GivenDepth{0.67, kTypicalDepthSdMm}));
  EXPECT_FALSE(field(kStep)->isEnabled()) << "a depth is of a ball";
  type(kSd, "0.005");
  EXPECT_EQ(rig_.collection().press_set().of("press_01").depth, (GivenDepth{0.67, 0.005}));
  EXPECT_EQ(undo().undoText(), "change the measured depth of press_01");
  show(6);
  EXPECT_EQ(field(kStep)->text().toStdString(), "a ball");
  type(kStep, "0.5");
  ASSERT_TRUE(rig_.wait_until_looked_at(kPresses));
  EXPECT_EQ(state_of("press_07"), "a punch with a step of 0.500 mm");
  EXPECT_FALSE(field(kDepth)->isEnabled());
  EXPECT_FALSE(field("Radius of this press's ball")->isEnabled());
  EXPECT_FALSE(rig_.studio().find<OutlineEditor>("Image with the ball's outline")->ball());
  EXPECT_FALSE(rig_.collection().find("press_07")->analysis.found_mm);
  EXPECT_EQ(rig_.collection().usable_count(), kPresses);
  undo().undo();
  EXPECT_FALSE(rig_.collection().press_set().of("press_07").step_mm);
  undo().undo();
  EXPECT_EQ(rig_.collection().press_set().of("press_01").depth->sd_mm, kTypicalDepthSdMm);
  undo().undo();
  EXPECT_FALSE(rig_.collection().press_set().of("press_01").depth);
  while (undo().canRedo()) undo().redo();
  rig_.collection().disk()->wait();
  rig_.close();
  open();
  EXPECT_EQ(rig_.collection().press_set().of("press_01").depth, (GivenDepth{0.67, 0.005}));
  EXPECT_EQ(rig_.collection().press_set().of("press_07").step_mm, 0.5);
  show(6);
  EXPECT_EQ(field(kStep)->value(), 0.5);
}

TEST_F(CalibrateMeasured, ABodyIsSaidUndoneAndKept) {
  open();
  show(6);
  unfold();
  auto* body = rig_.studio().find<QPushButton>("Mesh of another body");
  ASSERT_NE(body, nullptr);
  EXPECT_EQ(body->text(), "none");
  rig_.collection().set_body_of("press_07", "/some/folder/rod.stl");
  EXPECT_EQ(body->text(), "rod.stl");
  EXPECT_FALSE(field(kStep)->isEnabled());
  EXPECT_FALSE(field(kDepth)->isEnabled());
  ASSERT_TRUE(rig_.wait_until_looked_at(kPresses));
  EXPECT_EQ(state_of("press_07"), "the body rod.stl");
  EXPECT_EQ(rig_.collection().usable_count(), kPresses);
  EXPECT_EQ(undo().undoText(), "change the body of press_07");
  undo().undo();
  EXPECT_EQ(body->text(), "none");
  undo().redo();
  rig_.collection().disk()->wait();
  rig_.close();
  open();
  EXPECT_EQ(rig_.collection().press_set().of("press_07").body, "/some/folder/rod.stl");
  rig_.run().start();
  ASSERT_TRUE(wait_until([&] { return rig_.run().problem().has_value(); }, 60000));
  EXPECT_THAT(rig_.run().problem()->sentence(), HasSubstr("/some/folder/rod.stl"));
}

TEST_F(CalibrateMeasured, PunchesAloneAreNotEnough) {
  open();
  for (const CollectedPress& press : std::vector<CollectedPress>(rig_.collection().presses()))
    rig_.collection().set_step_of(press.name, 0.5);
  ASSERT_TRUE(rig_.wait_until_looked_at(kPresses));
  EXPECT_EQ(rig_.collection().usable_count(), kPresses);
  EXPECT_FALSE(rig_.studio().find<QPushButton>("Next: Mapping")->isEnabled());
}

TEST_F(CalibrateMeasured, GiveTheSameBytesAsTheCommandThatIsCopied) {
  open();
  show(0);
  unfold();
  type(kDepth, "0.67");
  show(6);
  type(kStep, "0.5");
  ASSERT_TRUE(rig_.wait_until_looked_at(kPresses));
  const std::string command = rig_.calibrate_and_compare_with_the_command();
  EXPECT_THAT(command, HasSubstr("--depth press_01=0.67+-0.02"));
  EXPECT_THAT(command, HasSubstr("--step press_07=0.5"));
}

TEST_F(CalibrateMeasured, TheSolutionIsSaidBesideWhatWasTold) {
  open();
  rig_.collection().set_depth_of("press_01", {0.67, 0.02});
  rig_.collection().set_step_of("press_07", 0.5);
  ASSERT_TRUE(rig_.wait_until_looked_at(kPresses));
  rig_.run().start();
  ASSERT_TRUE(wait_until([&] { return rig_.run().result() != nullptr; }, 60000))
      << rig_.studio().problems();
  const Calibration& solved = rig_.run().result()->calibration;
  for (const Message& reason : solved.left_out) ADD_FAILURE() << reason.english();
  std::printf("[ figures  ] %s; %s\n", state_of("press_01").c_str(), state_of("press_07").c_str());
  ASSERT_EQ(solved.steps.size(), 1U);
  EXPECT_NEAR(solved.steps[0].estimated_mm, 0.5, 0.03);
  EXPECT_THAT(state_of("press_07"), HasSubstr(fmt::format("0.500 mm step measured as {:.3f} mm",
                                                          solved.steps[0].estimated_mm)));
  EXPECT_THAT(state_of("press_01"), HasSubstr("depth measured 0.670 mm, fitted 0."));
  rig_.collection().set_step_of("press_07", 0.6);
  EXPECT_EQ(state_of("press_07"), "a punch with a step of 0.600 mm");
  EXPECT_EQ(rig_.run().state(), CalibrationState::kStale);
}

}  // namespace
}  // namespace alltact::test
