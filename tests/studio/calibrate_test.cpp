// The place Calibrate, as a person uses it.
#include "core/base/atomic_file.h"
#include "core/finger/mapping.h"
#include "core/geometry/ball.h"
#include "core/image/image_file.h"
#include "tests/studio/calibrate_rig.h"
#include "tests/support/sanitized.h"

#include <QAbstractItemModelTester>
#include <QListWidget>
#include <QProgressBar>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(Calibrate, EveryStepSaysWhatItNeedsFirst) {
  Studio studio;
  studio.window().go_to("calibrate");
  QTest::qWait(50);
  EXPECT_TRUE(says(studio, "The lens is not known yet"));
  EXPECT_FALSE(studio.find<QPushButton>("Next: Finger")->isEnabled());
  for (auto* button : studio.window().findChild<CalibratePage*>()->findChildren<QToolButton*>())
    if (button->text().startsWith("3 Presses")) {
      EXPECT_FALSE(button->isEnabled());
      EXPECT_THAT(button->toolTip().toStdString(), HasSubstr("lens"));
    }
  auto* file = studio.find<QLineEdit>("Camera file");
  QTest::keyClicks(file, "/nowhere/camera.yaml");
  QTest::keyClick(file, Qt::Key_Return);
  EXPECT_THAT(studio.problems(), HasSubstr("/nowhere/camera.yaml"));
  file->selectAll();
  QTest::keyClicks(file, QString::fromStdString(MadeFingers::get().camera().string()));
  QTest::keyClick(file, Qt::Key_Return);
  EXPECT_EQ(studio.problems(), "");
  const cv::Size size = small_size_px();
  const std::string lens = fmt::format("{} × {} px, focal length {:.1f} px", size.width,
                                       size.height, 523.9 * size.width / 960);
  EXPECT_TRUE(says(studio, lens.c_str()));
  studio.click("Next: Finger");
  EXPECT_TRUE(says(studio, "make one, or open one"));
  EXPECT_FALSE(studio.find<QPushButton>("Next: Presses")->isEnabled());
  studio.window().open_finger(MadeFingers::get().described());
  EXPECT_TRUE(wait_until([&] { return says(studio, "reference recording is missing"); }));
  EXPECT_FALSE(studio.find<QPushButton>("Next: Presses")->isEnabled());
  studio.click("Go to Record");
  EXPECT_NE(studio.find<QPushButton>("Start recording"), nullptr);
}

TEST(Calibrate, TakesPressesFromTheLivePictureAndKeepsThemAtOnce) {
  CalibrateStudio rig;
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_for_press());
  rig.studio().click("Take a press (Space)");
  EXPECT_TRUE(wait_until([&] { return fs::exists(rig.finger() / "presses/press_01.png"); }, 1000));
  ASSERT_TRUE(rig.wait_for_press());
  rig.studio().find<ImageView>("Image")->setFocus();
  QTest::keyClick(rig.studio().find<ImageView>("Image"), Qt::Key_Space);
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  EXPECT_EQ(rig.collection().usable_count(), 2);
  const CollectedPress& first = rig.collection().presses()[0];
  EXPECT_EQ(cv::norm(read_grey_image(rig.finger() / "presses/press_01.png").value(),
                     first.frame->grey, cv::NORM_INF),
            0);
  // Undone, they are gone from the folder; done again, they are back.
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(wait_until([&] { return !fs::exists(rig.finger() / "presses/press_02.png"); }));
  EXPECT_EQ(rig.collection().presses().size(), 1U);
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(wait_until([&] { return fs::exists(rig.finger() / "presses/press_02.png"); }));
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  // And in another window they are there, radius and all.
  rig.close();
  rig.open();
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  EXPECT_EQ(rig.collection().press_set().ball_radius_mm, 4);
  EXPECT_EQ(rig.collection().usable_count(), 2);
}

TEST(Calibrate, ForgetsAFingersVerdictAsSoonAsAnotherIsOpened) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  Studio studio(options);
  studio.window().go_to("calibrate");
  auto& page = *studio.window().findChild<CalibratePage*>();
  ASSERT_TRUE(wait_until([&] { return page.run().finger() && page.collection().is_ready(); }));
  const TemporaryFolder shelf;
  std::filesystem::copy(options.finger, shelf / "other", std::filesystem::copy_options::recursive);
  studio.window().open_finger(shelf / "other");
  ASSERT_EQ(studio.session().status().finger.state, FingerState::kLoading);
  EXPECT_FALSE(page.run().finger());
  EXPECT_TRUE(page.collection().folder().empty());
  EXPECT_TRUE(wait_until(
      [&] { return page.run().finger() && page.collection().folder() == shelf / "other"; }));
}

TEST(Calibrate, TakesPressesByItselfWhenTheyHoldStill) {
  const PressesWhenStill unchanged;
  CalibrateStudio rig;
  // Each is held for 0.8 s: longer than the half second that is asked for.
  must(write_file_atomically(rig.folder() / "pressing.yaml", pressing_scene(24)));
  rig.open();
  rig.go_to_step("Presses");
  auto* box = rig.studio().find<QCheckBox>("Automatically when still");
  EXPECT_TRUE(box->isChecked());
  EXPECT_TRUE(wait_until([&] { return says(rig.studio(), "Waiting for the ball's radius."); }));
  rig.type_radius("4");
  ASSERT_TRUE(wait_until([&] { return rig.collection().presses().size() == 1; }, 20000));
  // Nobody who looks at a press is sent away from it.
  const std::size_t count = rig.collection().presses().size();
  auto* list = rig.studio().find<QListView>("Presses");
  list->setCurrentIndex(list->model()->index(0, 0));
  const auto* editor = rig.place().findChild<OutlineEditor*>();
  ASSERT_TRUE(editor->isVisible());
  EXPECT_TRUE(wait_until([&] { return says(rig.studio(), "Paused while a press is shown."); }));
  const std::uint64_t before = rig.studio().session().status().source.delivered;
  ASSERT_TRUE(wait_until(
      [&] { return rig.studio().session().status().source.delivered > before + 100; }, 40000));
  EXPECT_TRUE(editor->isVisible());
  EXPECT_EQ(rig.collection().presses().size(), count);
  // It goes on with the live image, and ends with six, although the ball presses on.
  rig.studio().click("Live image");
  ASSERT_TRUE(wait_until([&] { return !box->isChecked(); }, 60000));
  EXPECT_TRUE(wait_until([&] { return says(rig.studio(), "Six presses are taken."); }));
  ASSERT_TRUE(rig.wait_until_looked_at(6));
  EXPECT_EQ(rig.collection().presses().size(), 6U);
  EXPECT_EQ(rig.collection().usable_count(), 6);
}

TEST(Calibrate, TheOutlineIsTheBallsAndAHandMovesIt) {
  CalibrateStudio rig(2);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  auto* list = rig.studio().find<QListView>("Presses");
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                    list->visualRect(list->model()->index(0, 0)).center());
  auto* editor = rig.studio().find<OutlineEditor>("Image with the ball's outline");
  ASSERT_NE(editor, nullptr);
  ASSERT_TRUE(editor->ball());
  EXPECT_FALSE(editor->ball()->is_by_hand);
  const Eigen::Vector3d found = editor->ball()->centre_mm;
  EXPECT_EQ(found, *rig.collection().presses()[0].analysis.found_mm);
  const auto before = image_outline(*editor->ball()).value();
  const QPoint hand = editor->transform().to_widget(before.centre).toPoint();
  QTest::mousePress(editor, Qt::LeftButton, {}, hand);
  for (int i = 1; i <= 4; ++i) QTest::mouseMove(editor, hand + QPoint(3 * i, i));
  QTest::mouseRelease(editor, Qt::LeftButton, {}, hand + QPoint(12, 4));
  EXPECT_TRUE(editor->ball()->is_by_hand);
  const auto after = image_outline(*editor->ball()).value();
  EXPECT_NEAR(after.centre.x() - before.centre.x(), 12 / editor->transform().scale, 1e-6);
  EXPECT_EQ(rig.studio().window().undo_stack().undoText(), "move the outline of press_01");
  ASSERT_TRUE(rig.collection().press_set().of("press_01").ball_mm);
  // It is on the disk within a second.
  EXPECT_TRUE(wait_until(
      [&] {
        const auto press_set = PressSet::load(rig.finger());
        return press_set && press_set->notes.size() == 1 &&
               press_set->of("press_01").ball_mm == editor->ball()->centre_mm;
      },
      1000));
  QTest::keyClick(editor, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(editor->ball()->centre_mm, found);
  EXPECT_FALSE(rig.collection().press_set().of("press_01").ball_mm);
  QTest::keyClick(editor, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(editor->ball()->is_by_hand);
  rig.studio().click("Find the ball again");
  EXPECT_EQ(editor->ball()->centre_mm, found);
}

TEST(Calibrate, AnotherRadiusLooksAgainAndTakesOutlinesAlong) {
  CalibrateStudio rig(1);
  rig.open();
  rig.go_to_step("Presses");
  EXPECT_TRUE(says(rig.studio(), "The ball's radius is missing"));
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(1));
  const Eigen::Vector3d found = *rig.collection().presses()[0].analysis.found_mm;
  rig.collection().set_ball("press_01", found, 1);
  rig.type_radius("4.2");
  ASSERT_TRUE(rig.wait_until_looked_at(1));
  EXPECT_NEAR((*rig.collection().press_set().of("press_01").ball_mm - 1.05 * found).norm(), 0,
              1e-9);
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(rig.collection().press_set().ball_radius_mm, 4);
  EXPECT_EQ(rig.collection().press_set().of("press_01").ball_mm, found);
}

TEST(Calibrate, OnePressMayHaveABallOfItsOwn) {
  CalibrateStudio rig(2);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  auto* list = rig.studio().find<QListView>("Presses");
  list->setCurrentIndex(list->model()->index(1, 0));
  rig.studio().click("Depth, ball or punch");
  auto* own = rig.studio().find<QDoubleSpinBox>("Radius of this press's ball");
  ASSERT_NE(own, nullptr);
  own->setFocus();
  own->selectAll();
  QTest::keyClicks(own, "5");
  QTest::keyClick(own, Qt::Key_Return);
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  EXPECT_EQ(rig.collection().press_set().radius_of("press_01"), 4);
  EXPECT_EQ(rig.collection().press_set().radius_of("press_02"), 5);
  EXPECT_THAT(rig.run().command_line().toStdString(), HasSubstr("--other-ball press_02=5"));
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(rig.collection().press_set().radius_of("press_02"), 4);
}

TEST(Calibrate, PressesAddedFromFilesKeepTheirNames) {
  CalibrateStudio rig(2);
  fs::create_directories(rig.folder() / "mine");
  fs::copy(rig.finger() / "presses/press_01.png", rig.folder() / "mine/glass ball.png");
  fs::copy(rig.finger() / "presses/press_01.png", rig.folder() / "mine/press_02.png");
  rig.open();
  rig.go_to_step("Presses");
  rig.studio().click("Add images…");
  auto* dialog = rig.place().findChild<QFileDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
  ASSERT_NE(name, nullptr);
  const auto quoted = [&](const char* file) {
    return "\"" + QString::fromStdString((rig.folder() / "mine" / file).string()) + "\"";
  };
  name->setText(quoted("glass ball.png") + " " + quoted("press_02.png"));
  QTest::keyClick(name, Qt::Key_Return);
  ASSERT_TRUE(wait_until([&] { return rig.collection().presses().size() == 3; }));
  EXPECT_NE(rig.collection().find("glass ball"), nullptr);
  EXPECT_TRUE(
      wait_until([&] { return rig.studio().problems().find("press_02") != std::string::npos; }));
  EXPECT_TRUE(wait_until([&] { return fs::exists(rig.finger() / "presses/glass ball.png"); }));
}

TEST(Calibrate, GivesTheSameBytesAsTheCommandThatItCopies) {
  CalibrateStudio rig(6);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  auto* person = rig.studio().find<QLineEdit>("Operator");
  QTest::keyClicks(person, "Ada Lovelace");
  QTest::keyClick(person, Qt::Key_Return);
  ASSERT_TRUE(rig.wait_until_looked_at(6));
  // A ball moved by hand and a press left out travel with the command, too.
  auto* list = rig.studio().find<QListView>("Presses");
  list->setCurrentIndex(list->model()->index(1, 0));
  auto* editor = rig.studio().find<OutlineEditor>("Image with the ball's outline");
  editor->setFocus();
  for (int i = 0; i < 3; ++i) QTest::keyClick(editor, Qt::Key_Right);
  list->setCurrentIndex(list->model()->index(3, 0));
  rig.studio().click("Leave out");
  const std::string command = rig.calibrate_and_compare_with_the_command();
  EXPECT_THAT(command, HasSubstr("--exclude press_04"));
  EXPECT_THAT(command, HasSubstr("--ball 'press_02="));
  EXPECT_THAT(command, HasSubstr("--operator 'Ada Lovelace'"));
}

TEST(Calibrate, ComparesWithOtherMethodsWhereAsked) {
  CalibrateStudio rig(4);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(4));
  rig.go_to_step("Mapping");
  rig.studio().click("Calibrate now");
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  ASSERT_TRUE(rig.wait_for_report());
  EXPECT_TRUE(rig.run().result()->methods.empty());
  const int steps = rig.studio().window().undo_stack().count();
  const auto before = contents(rig.finger());
  // Stopped, it changes nothing.
  rig.studio().click("Compare with other methods");
  rig.run().stop();
  ASSERT_TRUE(wait_until([&] { return !rig.run().is_running(); }, 60000));
  EXPECT_TRUE(contents(rig.finger()) == before);
  rig.studio().click("Compare with other methods");
  ASSERT_TRUE(wait_until([&] { return !rig.run().is_running(); }, 60000));
  ASSERT_TRUE(rig.wait_for_report());
  EXPECT_EQ(rig.run().result()->methods.size(), 4U);
  EXPECT_TRUE(says(rig.studio(), "The report has all methods"));
  EXPECT_THAT(rig.run().command_line().toStdString(), HasSubstr("--compare"));
  EXPECT_EQ(rig.studio().window().undo_stack().count(), steps);
  const auto after = contents(rig.finger());
  for (const auto& [name, bytes] : before)
    EXPECT_EQ(after.at(name) == bytes, !name.starts_with("calibration_report")) << name;
}

TEST(Calibrate, TakingOutAPressShowsAsAChangeAndEverythingCanBeUndone) {
  CalibrateStudio rig(4);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(4));
  const auto untouched = contents(rig.finger()).at("finger.yaml");
  rig.go_to_step("Mapping");
  rig.studio().click("Calibrate now");
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  EXPECT_EQ(rig.run().state(), CalibrationState::kCurrent);
  ASSERT_TRUE(wait_until([&] {
    const auto& finger = rig.studio().session().status().finger;
    return finger.state == FingerState::kReady && finger.finger->mapping;
  })) << "the live picture uses it";
  const auto first = contents(rig.finger());
  const double all_mm = rig.run().result()->calibration.held_out_mm;
  rig.go_to_step("Presses");
  auto* list = rig.studio().find<QListView>("Presses");
  list->setCurrentIndex(list->model()->index(0, 0));  // the worst
  rig.studio().click("Leave out");
  EXPECT_EQ(rig.run().state(), CalibrationState::kStale);
  rig.go_to_step("Mapping");
  EXPECT_TRUE(says(rig.studio(), "The presses have changed since this calibration"));
  rig.studio().click("Calibrate again");
  ASSERT_TRUE(wait_until(
      [&] { return rig.run().result() && rig.run().result()->calibration.balls.size() == 3; },
      60000));
  EXPECT_NE(rig.run().result()->calibration.held_out_mm, all_mm);
  QUndoStack& undo = rig.studio().window().undo_stack();
  EXPECT_EQ(undo.undoText(), "calibrate");
  undo.undo();
  EXPECT_EQ(rig.run().state(), CalibrationState::kStale) << "the press is still left out";
  undo.undo();
  EXPECT_EQ(rig.run().state(), CalibrationState::kCurrent);
  rig.collection().disk()->wait();
  auto back = contents(rig.finger());
  for (const char* name :
       {"finger.yaml", "calibration.yaml", "calibration_inputs.yaml", "calibration_report.json"})
    EXPECT_TRUE(back.at(name) == first.at(name)) << name;
  while (undo.canUndo()) undo.undo();
  rig.collection().disk()->wait();
  back = contents(rig.finger());
  EXPECT_EQ(back.at("finger.yaml"), untouched);
  EXPECT_FALSE(back.count("calibration_inputs.yaml"));
  EXPECT_EQ(rig.run().state(), CalibrationState::kNone);
  while (undo.canRedo()) undo.redo();
  rig.collection().disk()->wait();
  EXPECT_EQ(rig.run().result()->calibration.balls.size(), 3U);
  EXPECT_THAT(contents(rig.finger()).at("calibration_inputs.yaml"), HasSubstr("excluded: [press_"));
}

TEST(Calibrate, StoppingKeepsWhatWasThere) {
  CalibrateStudio rig(6);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(6));
  const auto before = contents(rig.finger()).at("finger.yaml");
  rig.go_to_step("Mapping");
  rig.studio().click("Calibrate now");
  EXPECT_NE(rig.studio().find<QProgressBar>("Progress of the calibration"), nullptr);
  rig.studio().click("Stop");
  ASSERT_TRUE(wait_until([&] { return !rig.run().is_running(); }, 30000));
  if (rig.run().result() == nullptr) {
    EXPECT_THAT(rig.studio().problems(), HasSubstr("topped"));
    EXPECT_EQ(contents(rig.finger()).at("finger.yaml"), before);
  } else {
    EXPECT_TRUE(std::any_of(rig.run().result()->calibration.remarks.begin(),
                            rig.run().result()->calibration.remarks.end(), [](const auto& remark) {
                              return remark.english().starts_with("stopped");
                            }));
  }
}

TEST(Calibrate, ShowsHowTheSolutionSettlesWhileItRuns) {
  CalibrateStudio rig(6);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(6));
  rig.go_to_step("Mapping");
  rig.studio().click("Calibrate now");
  auto* plot = rig.studio().find<ConvergencePlot>("Convergence of the solution");
  ASSERT_NE(plot, nullptr);
  std::size_t most_seen = 0;
  ASSERT_TRUE(wait_until(
      [&] {
        if (plot->isVisible()) most_seen = rig.run().rounds().size();
        return rig.run().result() != nullptr;
      },
      120000));
  EXPECT_GT(most_seen, 0U);
  EXPECT_TRUE(plot->accessibleDescription().contains(QStringLiteral("Residual after")));
  EXPECT_FALSE(plot->isVisible());
  const auto rounds = rig.run().rounds();
  // The result's residual is of balls fitted anew to the part that surely touches.
  const double residual_mm = rig.run().result()->calibration.residual_mm;
  EXPECT_GT(rounds.back().residual_mm, 0.5 * residual_mm);
  EXPECT_LT(rounds.back().residual_mm, 2.0 * residual_mm);
  EXPECT_NEAR(rounds.back().residual_mm, rounds[rounds.size() - 2].residual_mm, 1e-6);
  EXPECT_LT(rounds.back().change_mm, 1e-7);
}

TEST(Calibrate, TheListIsAProperModel) {
  CalibrateStudio rig(3);
  rig.open();
  rig.go_to_step("Presses");
  auto* list = rig.studio().find<QListView>("Presses");
  const QAbstractItemModelTester tester(list->model(),
                                        QAbstractItemModelTester::FailureReportingMode::Fatal);
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(3));
  rig.collection().leave_out("press_02", "glove");
  rig.collection().remove({"press_03"});
  rig.studio().window().undo_stack().undo();
  EXPECT_EQ(list->model()->rowCount(), 3);
  EXPECT_THAT(list->model()->index(1, 0).data().toString().toStdString(),
              HasSubstr("left out: glove"));
}

TEST(Calibrate, ThreePressesTellWhetherItStillHolds) {
  CalibrateStudio rig(6);
  // Long enough that a slow machine sees several frames of each.
  const int frames_each = kIsSanitized ? 120 : 20;
  must(write_file_atomically(rig.folder() / "pressing.yaml", held_pressing_scene(frames_each)));
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(6));
  rig.go_to_step("Mapping");
  rig.studio().click("Calibrate now");
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  ASSERT_TRUE(wait_until([&] {
    const auto& view = rig.studio().session().view();
    return view && view->result.depth.has_value();
  }));
  rig.go_to_step("Check");
  EXPECT_FALSE(rig.studio().find<QPushButton>("Check now")->isEnabled());
  // Base, middle and tip: a pass needs all of them.
  for (const auto& [count, from_mm, to_mm] : {std::tuple{"1 of 3 taken", 0.0, 30.0},
                                              {"2 of 3 taken", 43.0, 53.0},
                                              {"3 presses taken: enough", 76.0, 100.0}}) {
    ASSERT_TRUE(rig.wait_for_press(from_mm, to_mm));
    rig.studio().click("Take a press (Space)");
    ASSERT_TRUE(wait_until([&] { return says(rig.studio(), count); })) << count;
  }
  rig.studio().find<QLineEdit>("Operator")->setText("Ann");
  rig.studio().click("Check now");
  ASSERT_TRUE(wait_until(
      [&] {
        const auto done = load_checks(rig.finger(), nullptr);
        return done && !done->empty();
      },
      60000))
      << rig.studio().problems();
  const auto checks = load_checks(rig.finger(), nullptr).value();
  ASSERT_EQ(checks.size(), 1U);
  EXPECT_TRUE(wait_until([&] { return says(rig.studio(), "Pass"); }))
      << to_string(checks[0].verdict) << ": " << checks[0].error_mm << " mm off in "
      << checks[0].presses << " presses";
  EXPECT_EQ(checks[0].verdict, CheckVerdict::kPass);
  EXPECT_EQ(checks[0].presses, 3);
  EXPECT_EQ(checks[0].operator_name, "Ann");
  ASSERT_TRUE(checks[0].bias_mm.has_value());
  EXPECT_LE(std::abs(*checks[0].bias_mm), checks[0].drifting_above_mm) << "it passed";
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(wait_until([&] { return says(rig.studio(), "Not checked yet"); }));
  EXPECT_TRUE(load_checks(rig.finger(), nullptr).value().empty());
}

}  // namespace
}  // namespace alltact::test
