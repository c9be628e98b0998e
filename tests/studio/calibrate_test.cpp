// The place Calibrate, as a person uses it.
#include "core/finger/mapping.h"
#include "core/geometry/ball.h"
#include "core/io/picture.h"
#include "tests/studio/calibrate_rig.h"

#include <QAbstractItemModelTester>
#include <QListWidget>
#include <QProgressBar>

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
  EXPECT_TRUE(says(studio, "The lens has to be known first"));
  EXPECT_FALSE(studio.find<QPushButton>("Next: Finger")->isEnabled());
  for (auto* button : studio.window().findChild<CalibratePlace*>()->findChildren<QToolButton*>())
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
  EXPECT_TRUE(says(studio, "960 × 540 px, focal length 523.9 px"));
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
  rig.studio().find<ImageView>("Picture")->setFocus();
  QTest::keyClick(rig.studio().find<ImageView>("Picture"), Qt::Key_Space);
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  EXPECT_EQ(rig.desk().usable_count(), 2);
  const DeskPress& first = rig.desk().presses()[0];
  EXPECT_EQ(cv::norm(read_grey_picture(rig.finger() / "presses/press_01.png").value(),
                     first.frame->grey,
                     cv::NORM_INF),
            0);
  // Undone, they are gone from the folder; done again, they are back.
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(wait_until([&] { return !fs::exists(rig.finger() / "presses/press_02.png"); }));
  EXPECT_EQ(rig.desk().presses().size(), 1U);
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(wait_until([&] { return fs::exists(rig.finger() / "presses/press_02.png"); }));
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  // And in another window they are there, radius and all.
  rig.close();
  rig.open();
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  EXPECT_EQ(rig.desk().notes().ball_radius_mm, 4);
  EXPECT_EQ(rig.desk().usable_count(), 2);
}

TEST(Calibrate, TakesPressesByItselfWhenTheyHoldStill) {
  CalibrateStudio rig;
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  auto* box = rig.studio().find<QCheckBox>("By itself when it holds still");
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Space);
  ASSERT_TRUE(wait_until([&] { return rig.desk().presses().size() >= 4; }, 20000));
  QTest::keyClick(box, Qt::Key_Space);
  const int count = static_cast<int>(rig.desk().presses().size());
  ASSERT_TRUE(rig.wait_until_looked_at(count));
  EXPECT_EQ(rig.desk().usable_count(), count);
}

TEST(Calibrate, TheOutlineIsTheBallsAndAHandMovesIt) {
  CalibrateStudio rig(2);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  auto* list = rig.studio().find<QListView>("Presses");
  QTest::mouseClick(
      list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(0, 0)).center());
  auto* editor = rig.studio().find<OutlineEditor>("Picture with the ball's outline");
  ASSERT_NE(editor, nullptr);
  ASSERT_TRUE(editor->ball());
  EXPECT_FALSE(editor->ball()->is_by_hand);
  const Eigen::Vector3d found = editor->ball()->centre_mm;
  EXPECT_EQ(found, *rig.desk().presses()[0].looked.found_mm);
  const auto before = outline_place(*editor->ball()).value();
  const QPoint hand = editor->transform().to_widget(before.centre).toPoint();
  QTest::mousePress(editor, Qt::LeftButton, {}, hand);
  for (int i = 1; i <= 4; ++i) QTest::mouseMove(editor, hand + QPoint(3 * i, i));
  QTest::mouseRelease(editor, Qt::LeftButton, {}, hand + QPoint(12, 4));
  EXPECT_TRUE(editor->ball()->is_by_hand);
  const auto after = outline_place(*editor->ball()).value();
  EXPECT_NEAR(after.centre.x() - before.centre.x(), 12 / editor->transform().scale, 1e-6);
  EXPECT_EQ(rig.studio().window().undo_stack().undoText(), "move the outline of press_01");
  ASSERT_NE(rig.desk().placed("press_01"), nullptr);
  // It is on the disk within a second.
  EXPECT_TRUE(wait_until(
      [&] {
        const auto notes = PressNotes::load(rig.finger());
        return notes && notes->balls.size() == 1 &&
               notes->balls[0].centre_mm == editor->ball()->centre_mm;
      },
      1000));
  QTest::keyClick(editor, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(editor->ball()->centre_mm, found);
  EXPECT_EQ(rig.desk().placed("press_01"), nullptr);
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
  const Eigen::Vector3d found = *rig.desk().presses()[0].looked.found_mm;
  rig.desk().place_ball("press_01", found, 1);
  rig.type_radius("4.2");
  ASSERT_TRUE(rig.wait_until_looked_at(1));
  EXPECT_NEAR((rig.desk().placed("press_01")->centre_mm - 1.05 * found).norm(), 0, 1e-9);
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(rig.desk().notes().ball_radius_mm, 4);
  EXPECT_EQ(rig.desk().placed("press_01")->centre_mm, found);
}

TEST(Calibrate, OnePressMayHaveABallOfItsOwn) {
  CalibrateStudio rig(2);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  auto* list = rig.studio().find<QListView>("Presses");
  list->setCurrentIndex(list->model()->index(1, 0));
  auto* own = rig.studio().find<QDoubleSpinBox>("Radius of this press' ball");
  ASSERT_NE(own, nullptr);
  own->setFocus();
  own->selectAll();
  QTest::keyClicks(own, "5");
  QTest::keyClick(own, Qt::Key_Return);
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  EXPECT_EQ(rig.desk().notes().radius_of("press_01"), 4);
  EXPECT_EQ(rig.desk().notes().radius_of("press_02"), 5);
  EXPECT_THAT(rig.run().command_line().toStdString(), HasSubstr("--other-ball press_02=5"));
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(rig.desk().notes().radius_of("press_02"), 4);
}

TEST(Calibrate, PressesAddedFromFilesKeepTheirNames) {
  CalibrateStudio rig(2);
  fs::create_directories(rig.folder() / "mine");
  fs::copy(rig.finger() / "presses/press_01.png", rig.folder() / "mine/glass ball.png");
  fs::copy(rig.finger() / "presses/press_01.png", rig.folder() / "mine/press_02.png");
  rig.open();
  rig.go_to_step("Presses");
  rig.studio().click("Add pictures…");
  auto* dialog = rig.place().findChild<QFileDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
  ASSERT_NE(name, nullptr);
  const auto quoted = [&](const char* file) {
    return "\"" + QString::fromStdString((rig.folder() / "mine" / file).string()) + "\"";
  };
  name->setText(quoted("glass ball.png") + " " + quoted("press_02.png"));
  QTest::keyClick(name, Qt::Key_Return);
  ASSERT_TRUE(wait_until([&] { return rig.desk().presses().size() == 3; }));
  EXPECT_NE(rig.desk().find("glass ball"), nullptr);
  EXPECT_TRUE(
      wait_until([&] { return rig.studio().problems().find("press_02") != std::string::npos; }));
  EXPECT_TRUE(wait_until([&] { return fs::exists(rig.finger() / "presses/glass ball.png"); }));
}

TEST(Calibrate, GivesTheSameBytesAsTheCommandThatItCopies) {
  CalibrateStudio rig(6);
  rig.open(ALLTACT_PROGRAM);
  rig.go_to_step("Presses");
  rig.type_radius("4");
  auto* person = rig.studio().find<QLineEdit>("Operator");
  QTest::keyClicks(person, "Ada Lovelace");
  QTest::keyClick(person, Qt::Key_Return);
  ASSERT_TRUE(rig.wait_until_looked_at(6));
  // A ball moved by hand and a press taken out travel with the command, too.
  auto* list = rig.studio().find<QListView>("Presses");
  list->setCurrentIndex(list->model()->index(1, 0));
  auto* editor = rig.studio().find<OutlineEditor>("Picture with the ball's outline");
  editor->setFocus();
  for (int i = 0; i < 3; ++i) QTest::keyClick(editor, Qt::Key_Right);
  list->setCurrentIndex(list->model()->index(3, 0));
  rig.studio().click("Take out");
  const std::string command = rig.calibrate_and_compare_with_the_command();
  EXPECT_THAT(command, HasSubstr("--exclude press_04"));
  EXPECT_THAT(command, HasSubstr("--ball 'press_02="));
  EXPECT_THAT(command, HasSubstr("--operator 'Ada Lovelace'"));
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
  rig.studio().click("Take out");
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
  EXPECT_EQ(rig.run().state(), CalibrationState::kStale) << "the press is still taken out";
  undo.undo();
  EXPECT_EQ(rig.run().state(), CalibrationState::kCurrent);
  rig.desk().disk()->wait();
  auto back = contents(rig.finger());
  for (const char* name : {"finger.yaml", "calibration_inputs.yaml", "calibration_report.json"})
    EXPECT_TRUE(back.at(name) == first.at(name)) << name;
  while (undo.canUndo()) undo.undo();
  rig.desk().disk()->wait();
  back = contents(rig.finger());
  EXPECT_EQ(back.at("finger.yaml"), untouched);
  EXPECT_FALSE(back.count("calibration_inputs.yaml"));
  EXPECT_EQ(rig.run().state(), CalibrationState::kNone);
  while (undo.canRedo()) undo.redo();
  rig.desk().disk()->wait();
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
                            rig.run().result()->calibration.remarks.end(),
                            [](const auto& remark) { return remark.rfind("stopped", 0) == 0; }));
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
  auto* plot = rig.studio().find<ConvergencePlot>("How the solution settles");
  ASSERT_NE(plot, nullptr);
  std::size_t most_seen = 0;
  ASSERT_TRUE(wait_until(
      [&] {
        if (plot->isVisible()) most_seen = rig.run().work().rounds().size();
        return rig.run().result() != nullptr;
      },
      120000));
  EXPECT_GT(most_seen, 0U);
  EXPECT_TRUE(plot->accessibleDescription().contains(QStringLiteral("mm are left")));
  EXPECT_FALSE(plot->isVisible());
  const auto& rounds = rig.run().work().rounds();
  EXPECT_NEAR(rounds.back().residual_mm, rig.run().result()->calibration.residual_mm, 1e-9);
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
  rig.desk().take_out("press_02", "glove");
  rig.desk().remove("press_03");
  rig.studio().window().undo_stack().undo();
  EXPECT_EQ(list->model()->rowCount(), 3);
  EXPECT_THAT(list->model()->index(1, 0).data().toString().toStdString(),
              HasSubstr("taken out: glove"));
}

TEST(Calibrate, ThreePressesTellWhetherItStillHolds) {
  CalibrateStudio rig(6);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(6));
  rig.go_to_step("Mapping");
  rig.studio().click("Calibrate now");
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  ASSERT_TRUE(wait_until([&] {
    const auto& view = rig.studio().session().view();
    return view && view->watched.result.depth.has_value();
  }));
  rig.go_to_step("Check");
  EXPECT_FALSE(rig.studio().find<QPushButton>("Check now")->isEnabled());
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(rig.wait_for_press());
    rig.studio().click("Take a press (Space)");
  }
  rig.studio().click("Check now");
  ASSERT_TRUE(wait_until([&] { return says(rig.studio(), "Pass"); }, 60000))
      << rig.studio().problems();
  const auto checks = load_checks(rig.finger(), nullptr).value();
  ASSERT_EQ(checks.size(), 1U);
  EXPECT_EQ(checks[0].verdict, CheckVerdict::kPass);
  EXPECT_EQ(checks[0].presses, 3);
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(wait_until([&] { return says(rig.studio(), "Not checked yet"); }));
  EXPECT_TRUE(load_checks(rig.finger(), nullptr).value().empty());
}

// What another process does until it is killed.
TEST(CalibrateKilled, DISABLED_TakesPressesForEver) {
  const char* folder = std::getenv("ALLTACT_KILLED_FINGER");
  ASSERT_NE(folder, nullptr);
  StudioOptions options;
  options.finger = folder;
  options.source = {fs::path(folder) / "pressing.yaml"};
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.has_reference; }, 30000));
  studio.window().go_to("calibrate");
  auto* place = studio.window().findChild<CalibratePlace*>();
  ASSERT_TRUE(wait_until([&] { return place->desk().is_ready(); }, 30000));
  place->desk().set_radius(4);
  for (int i = 1;; ++i) {
    ASSERT_TRUE(wait_until([&] { return studio.session().view() != nullptr; }));
    const std::string name = place->desk().add({studio.session().view()->watched.result.frame});
    place->desk().place_ball(name, {0.5 * i, 0, 50}, i);
    std::printf("taken %d\n", i);
    std::fflush(stdout);
    QTest::qWait(150);
  }
}

TEST(Calibrate, AKillInTheMiddleOfPressesLosesNothingButTheLastSecond) {
  CalibrateStudio rig;
  fs::copy(rig.folder() / "pressing.yaml", rig.finger() / "pressing.yaml");
  QProcess child;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("ALLTACT_KILLED_FINGER", QString::fromStdString(rig.finger().string()));
  child.setProcessEnvironment(environment);
  child.start("/proc/self/exe",
              {"--gtest_also_run_disabled_tests", "--gtest_filter=CalibrateKilled.*"});
  int taken = 0, a_second_before = 0;
  QElapsedTimer clock;
  std::deque<std::pair<qint64, int>> history;
  ASSERT_TRUE(wait_until(
      [&] {
        while (child.canReadLine()) {
          const QByteArray line = child.readLine();
          if (!line.startsWith("taken ")) continue;
          if (taken == 0) clock.start();
          taken = line.mid(6).trimmed().toInt();
          history.emplace_back(clock.elapsed(), taken);
        }
        return taken >= 14;
      },
      60000));
  child.kill();  // SIGKILL
  child.waitForFinished();
  for (const auto& [when, number] : history)
    if (when < clock.elapsed() - 1000) a_second_before = number;
  ASSERT_GE(a_second_before, 5);
  rig.open();
  ASSERT_GE(static_cast<int>(rig.desk().presses().size()), a_second_before);
  EXPECT_TRUE(rig.wait_until_looked_at(static_cast<int>(rig.desk().presses().size())));
  for (int i = 1; i <= a_second_before; ++i) {
    const std::string name = fmt::format("press_{:02}", i);
    ASSERT_NE(rig.desk().find(name), nullptr) << name;
    EXPECT_FALSE(rig.desk().find(name)->looked.grey.empty()) << name;
    ASSERT_NE(rig.desk().placed(name), nullptr) << name;
    EXPECT_EQ(rig.desk().placed(name)->centre_mm.x(), 0.5 * i);
  }
  EXPECT_EQ(rig.desk().notes().ball_radius_mm, 4);
}

/// Somebody who has only the window: every click and every line typed counts.
class Person {
 public:
  explicit Person(Studio& studio) : studio_(studio) {}
  void click(const QString& button) {
    ++actions_;
    studio_.click(button);
  }
  void click_place(const QString& name) {
    ++actions_;
    QTest::mouseClick(studio_.find<QToolButton>(name), Qt::LeftButton);
  }
  template <class Field>
  void type(Field* field, const QString& text, Qt::Key end = Qt::Key_Tab) {
    ++actions_;
    ASSERT_NE(field, nullptr);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, end);
  }
  [[nodiscard]] int actions() const { return actions_; }

 private:
  Studio& studio_;
  int actions_ = 0;
};

TEST(Calibrate, AFirstTimeUserComesFromAnEmptyFolderToAVerdict) {
  const TemporaryFolder empty;
  Studio studio;
  Person person(studio);
  person.click("Simulated finger");
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.finger.has_value(); }));
  person.click_place("Calibrate");
  person.click("Use the simulated camera's lens");
  person.click("Next: Finger");
  person.click("Make the finger's folder…");
  auto* dialog = studio.window().findChild<NewFingerDialog*>();
  ASSERT_NE(dialog, nullptr);
  const auto line = [&](const char* name) -> QLineEdit* {
    for (auto* field : dialog->findChildren<QLineEdit*>())
      if (field->accessibleName() == QLatin1String(name)) return field;
    return nullptr;
  };
  person.type(line("Folder to make"), QString::fromStdString((empty / "left-07").string()));
  person.click("Make the finger");
  ASSERT_TRUE(wait_until([&] {
    return studio.session().status().finger.folder == empty / "left-07" &&
           studio.session().status().finger.state == FingerState::kReady;
  })) << studio.problems();
  person.click("Go to Record");
  person.click("Start recording");
  // The ball comes and goes: in between the finger is free.
  ASSERT_TRUE(wait_until([&] { return studio.session().status().recording.counts.recorded >= 300; },
                         240000));
  person.click("Stop recording");
  ASSERT_TRUE(wait_until(
      [&] { return studio.session().status().recording.state == RecordingState::kDone; }));
  person.click("Install as this finger's reference");
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.has_reference; }, 240000))
      << studio.problems();
  person.click_place("Calibrate");
  auto* place = studio.window().findChild<CalibratePlace*>();
  ASSERT_TRUE(wait_until([&] { return place->desk().is_ready(); }, 120000));
  person.click("Next: Presses");
  person.type(studio.find<QDoubleSpinBox>("Ball's radius"), "4", Qt::Key_Return);
  std::vector<DarkPatch> taken;
  while (taken.size() < 8) {
    // As the picture shows it: the ball is in, elsewhere or deeper than before.
    ASSERT_TRUE(wait_until(
        [&] {
          const auto patch = dark_patch(studio.session().view()->watched.result);
          if (!patch || patch->darkness < 0.06) return false;
          for (const DarkPatch& one : taken)
            if ((one.place_mm - patch->place_mm).norm() < 5 &&
                std::abs(one.darkness - patch->darkness) < 0.2 * patch->darkness)
              return false;
          taken.push_back(*patch);
          return true;
        },
        60000));
    person.click("Take a press (Space)");
  }
  const auto all_states = [&] {
    std::string states;
    for (const DeskPress& press : place->desk().presses())
      states += press.name + ": " +
                press_state_text(press, place->desk(), place->run()).toStdString() + "\n";
    return states;
  };
  ASSERT_TRUE(wait_until([&] { return place->desk().usable_count() >= 4; }, 60000)) << all_states();
  person.click("Next: Mapping");
  person.click("Calibrate now");
  ASSERT_TRUE(wait_until([&] { return place->run().result() != nullptr; }, 240000))
      << studio.problems();
  person.click("Next: Verdict");
  const Verdict& verdict = place->run().result()->verdict;
  EXPECT_TRUE(verdict.grade == Grade::kGood || verdict.grade == Grade::kUsable) << verdict.sentence;
  EXPECT_TRUE(says(studio, verdict.grade == Grade::kGood ? "Good" : "Usable"));
  EXPECT_LE(person.actions(), 40);
  RecordProperty("actions", person.actions());
  // And it measures where the scene presses its ball in, by 0.9 mm along the face's normal. Near
  // the tip, which half a minute of recording does not cover well, it may see what is not there.
  double deepest_mm = 0;
  const auto look = [&] {
    for (const ContactRegion& region : studio.session().view()->watched.result.regions)
      if (region.place_mm.z() < 75) deepest_mm = std::max(deepest_mm, region.deepest_mm);
    return deepest_mm > 0.7;
  };
  EXPECT_TRUE(wait_until(look, 60000));
  wait_until([&] { return !look(); }, 1500);  // to the depth at which the ball stays
  std::printf("[ figures  ] deepest %.3f mm; %s\n", deepest_mm, verdict.sentence.c_str());
  // Which eight moments were caught decides; one calibration of them is a draw, and so is a
  // reading.
  EXPECT_NEAR(deepest_mm, 0.9, 0.15 + 2 * verdict.error_mm);
}

}  // namespace
}  // namespace alltact::test
