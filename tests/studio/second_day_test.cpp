// The day after: a finger that was calibrated earlier shows what is known of it, from what it
// keeps.
#include "app/studio/header_bar.h"
#include "calibration/checks/check_history.h"
#include "calibration/finger/calibration_file.h"
#include "calibration/finger/calibration_report.h"
#include "core/base/atomic_file.h"
#include "tests/studio/calibrate_rig.h"
#include "widgets/plots/plot.h"

#include <QClipboard>
#include <QPixmap>
#include <QSignalSpy>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

/// Calibrated and checked yesterday; the window was closed since.
class SecondDay : public testing::Test {
 protected:
  /// The day before, once for all tests.
  static void SetUpTestSuite() {
    yesterday_ = new CalibrateStudio(6);
    PressSet reported;
    reported.ball_radius_mm = 4;
    must(reported.save(yesterday_->finger()));
    FingerCalibrationInput input;
    input.folder = yesterday_->finger();
    input.presses.files = {yesterday_->finger() / kPressFolder};
    input.press_set = reported;
    input.program_version = "0.1.0";
    auto made = calibrate_finger(input, Job());
    must(made ? Status() : Status(made.error()));
    made_ = std::make_shared<const FingerCalibration>(std::move(*made));
    CheckEntry check;
    check.time = "2026-01-31T12:00:00Z";
    check.program_version = "0.1.0";
    check.presses = 3;
    check.error_mm = 0.01;
    check.drifting_above_mm = 0.05;
    check.recalibrate_above_mm = 0.1;
    must(append_check(yesterday_->finger(), check));
  }
  static void TearDownTestSuite() {
    made_.reset();
    delete yesterday_;
  }
  void SetUp() override {
    std::filesystem::remove_all(rig_.finger());
    std::filesystem::copy(yesterday_->finger(), rig_.finger(),
                          std::filesystem::copy_options::recursive);
  }
  [[nodiscard]] bool is_recalled() {
    return wait_until(
        [&] { return rig_.run().result() && !rig_.run().result()->residuals.empty(); }, 60000);
  }

  [[nodiscard]] bool has_measured() {
    return wait_until(
        [&] { return rig_.collection().is_ready() && !rig_.collection().is_analysing(); }, 60000);
  }

  static CalibrateStudio* yesterday_;
  static std::shared_ptr<const FingerCalibration> made_;
  CalibrateStudio rig_;
};
CalibrateStudio* SecondDay::yesterday_ = nullptr;
std::shared_ptr<const FingerCalibration> SecondDay::made_;

TEST_F(SecondDay, ShowsEveryFigureAgainWithoutCalibrating) {
  for (const char* report : {kReportJson, kReportHtml, kReportPdf})
    std::filesystem::remove(rig_.finger() / report);
  const auto before = press_measurements();
  rig_.open();
  ASSERT_TRUE(is_recalled());
  const FingerCalibration& now = *rig_.run().result();
  EXPECT_EQ(now.inputs.date, made_->inputs.date);
  EXPECT_EQ(now.verdict.sentence, made_->verdict.sentence);
  ASSERT_EQ(now.calibration.balls.size(), made_->calibration.balls.size());
  for (std::size_t i = 0; i < now.calibration.balls.size(); ++i) {
    EXPECT_EQ(now.calibration.balls[i].press, made_->calibration.balls[i].press);
    EXPECT_EQ(now.calibration.balls[i].held_out_mm, made_->calibration.balls[i].held_out_mm);
    EXPECT_EQ(now.calibration.balls[i].centre_mm, made_->calibration.balls[i].centre_mm);
  }
  EXPECT_EQ(now.calibration.remarks, made_->calibration.remarks);
  EXPECT_EQ(now.calibration.degree_choice, made_->calibration.degree_choice);
  EXPECT_EQ(now.fault_signs, made_->fault_signs);
  ASSERT_TRUE(now.calibration.next_press && made_->calibration.next_press);
  EXPECT_EQ(now.calibration.next_press->sentence, made_->calibration.next_press->sentence);
  EXPECT_EQ(now.calibration.next_press->along_mm, made_->calibration.next_press->along_mm);
  ASSERT_EQ(now.residuals.size(), made_->residuals.size());
  for (std::size_t i = 0; i < now.residuals.size(); ++i) {
    ASSERT_EQ(now.residuals[i].samples.size(), made_->residuals[i].samples.size());
    for (std::size_t k = 0; k < now.residuals[i].samples.size(); ++k)
      EXPECT_NEAR(now.residuals[i].samples[k].residual_mm,
                  made_->residuals[i].samples[k].residual_mm, 5e-6);
  }
  EXPECT_EQ(zone_sentence(now.zones), zone_sentence(made_->zones));
  ASSERT_TRUE(has_measured());
  EXPECT_EQ(press_measurements() - before, 6) << "the list of presses alone";
}

TEST_F(SecondDay, EveryStepIsOpenAndNothingHasChanged) {
  rig_.open();
  const auto before = contents(rig_.finger());
  ASSERT_TRUE(is_recalled());
  EXPECT_EQ(rig_.run().state(), CalibrationState::kCurrent);
  EXPECT_THAT(rig_.run().command_line().toStdString(), HasSubstr("--ball-radius-mm 4 "));
  rig_.go_to_step("Presses");
  EXPECT_THAT(rig_.studio()
                  .find<QListView>("Presses")
                  ->model()
                  ->index(0, 0)
                  .data()
                  .toString()
                  .toStdString(),
              HasSubstr("mm deep, error"));
  rig_.go_to_step("Mapping");
  EXPECT_NE(rig_.studio().find<QWidget>("Mapping from brightness to depth"), nullptr);
  EXPECT_FALSE(says(rig_.studio(), "changed since"));
  EXPECT_FALSE(says(rig_.studio(), "Calibrate again to show"));
  rig_.go_to_step("Verdict");
  EXPECT_TRUE(says(rig_.studio(), "By zone of the face"));
  EXPECT_FALSE(says(rig_.studio(), "changed since"));
  rig_.studio().click("Copy as command line");
  EXPECT_THAT(QGuiApplication::clipboard()->text().toStdString(), HasSubstr("-radius-mm 4 "));
  rig_.go_to_step("Check");
  ASSERT_TRUE(wait_until([&] { return says(rig_.studio(), "Pass"); }));
  EXPECT_TRUE(contents(rig_.finger()) == before) << "looking changes nothing";
}

TEST_F(SecondDay, TheWindowSaysAtOnceWhatIsKnownAndLeadsToWhatIsDue) {
  std::filesystem::remove(rig_.finger() / kCheckFile);
  rig_.open();
  auto* summary = rig_.studio().window().findChild<FingerSummary*>();
  ASSERT_NE(summary, nullptr);
  ASSERT_TRUE(wait_until([&] { return summary->card().has_value(); }));
  EXPECT_TRUE(summary->isVisible());
  EXPECT_TRUE(says(rig_.studio(), "Due: a check"));
  ASSERT_TRUE(wait_until([&] { return rig_.run().state() == CalibrationState::kCurrent; }));
  EXPECT_TRUE(rig_.place().findChild<CheckPage*>()->isVisible()) << "the place opens what is due";
  rig_.go_to_step("Presses");
  rig_.studio().window().go_to("live");
  rig_.studio().click("Go to the check");
  EXPECT_TRUE(rig_.place().findChild<CheckPage*>()->isVisible());
}

TEST_F(SecondDay, PlotsTakeTheRoomOfTheMapping) {
  rig_.open();
  ASSERT_TRUE(is_recalled());
  rig_.go_to_step("Mapping");
  for (const QSize size : {QSize(1024, 700), QSize(1440, 900)}) {
    rig_.studio().window().resize(size);
    QTest::qWait(100);
    EXPECT_EQ(rig_.studio().window().size(), size);
    const auto* page = rig_.place().findChild<MappingPage*>();
    double plotted = 0;
    int count = 0;
    for (const auto* plot : page->findChildren<Plot*>()) {
      if (!plot->isVisible()) continue;
      ++count;
      plotted += plot->width() * plot->height();
      EXPECT_GE(plot->width(), 400);
      EXPECT_GE(plot->height(), 200);
    }
    EXPECT_EQ(count, 4);
    EXPECT_GE(plotted, 0.6 * page->width() * page->height());
  }
}

/// One press, wherever it is shown.
TEST_F(SecondDay, APressIsTheSameInEveryPlotAndCanBeLeftOutThere) {
  rig_.open();
  ASSERT_TRUE(is_recalled());
  ASSERT_TRUE(has_measured());
  rig_.go_to_step("Mapping");
  auto* page = rig_.place().findChild<MappingPage*>();
  auto* errors = page->findChild<PressErrorPlot*>();
  const auto images = [&] {
    std::vector<QImage> all;
    for (auto* plot : page->findChildren<Plot*>())
      if (plot->isVisible()) all.push_back(plot->image(plot->size()));
    return all;
  };
  const auto before = images();
  ASSERT_EQ(before.size(), 4U);
  QTest::keyClick(errors, Qt::Key_Down);
  const std::string worst = errors->chosen();
  EXPECT_TRUE(says(rig_.studio(), (worst + ": its points").c_str()));
  const auto chosen = images();
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NE(before[i], chosen[i]) << i;
  rig_.studio().click("Leave out");
  EXPECT_EQ(rig_.run().state(), CalibrationState::kStale);
  EXPECT_TRUE(says(rig_.studio(), (worst + " is left out").c_str()));
  rig_.studio().click("Put back");
  EXPECT_EQ(rig_.run().state(), CalibrationState::kCurrent);
  rig_.studio().click("Show this press");
  auto* list = rig_.studio().find<QListView>("Presses");
  ASSERT_TRUE(list->isVisible());
  EXPECT_THAT(list->currentIndex().data().toString().toStdString(), HasSubstr(worst));
}

/// While the reference is read, which takes long where it is long.
TEST_F(SecondDay, KnowsTheVerdictBeforeThePressesAreRead) {
  rig_.open();
  QUndoStack undo;
  PressCollection collection(undo);
  CalibrationRun run(collection, undo, "1");
  std::vector<CalibrationState> states;
  QObject::connect(&run, &CalibrationRun::changed, [&] {
    if (!run.finger()) return;
    states.push_back(run.state());
    EXPECT_EQ(run.command_line().contains("--ball-radius-mm 0"), false);
  });
  QObject::connect(&collection, &PressCollection::changed, [&] {
    if (!run.finger()) return;
    states.push_back(run.state());
  });
  collection.open(rig_.finger());
  run.reload();
  ASSERT_TRUE(wait_until([&] { return run.result() && collection.is_ready(); }, 30000));
  ASSERT_FALSE(states.empty());
  for (const CalibrationState state : states) EXPECT_EQ(state, CalibrationState::kCurrent);
}

TEST_F(SecondDay, SaysWhatHasChangedWhereItHas) {
  std::filesystem::remove(rig_.finger() / "presses" / "press_03.png");
  rig_.open();
  ASSERT_TRUE(is_recalled()) << "the figures are known all the same";
  ASSERT_TRUE(wait_until([&] { return rig_.run().state() == CalibrationState::kStale; }));
  EXPECT_EQ(rig_.run().result()->calibration.balls.size(), 6U);
}

TEST_F(SecondDay, AnEarlierVersionsFingerIsUsableAndItsFiguresComeWithTheNextCalibration) {
  std::filesystem::remove(rig_.finger() / kCalibrationFile);
  rig_.open();
  ASSERT_TRUE(wait_until([&] { return rig_.run().state() == CalibrationState::kCurrent; }));
  EXPECT_EQ(rig_.run().result(), nullptr);
  ASSERT_TRUE(rig_.run().finger());
  EXPECT_TRUE(rig_.run().finger()->mapping.has_value());
  for (const char* page : {"Mapping", "Verdict"}) {
    rig_.go_to_step(page);
    EXPECT_TRUE(says(rig_.studio(), "Calibrate again to show the figures.")) << page;
  }
}

TEST_F(SecondDay, AFileOfAnotherCalibrationIsNotBelieved) {
  std::string yaml = contents(rig_.finger()).at(kCalibrationFile);
  const auto at = yaml.find("residual_mm: ");
  yaml.replace(at, yaml.find('\n', at) - at, "residual_mm: 0.5");
  must(write_file_atomically(rig_.finger() / kCalibrationFile, yaml));
  rig_.open();
  ASSERT_TRUE(wait_until([&] { return rig_.run().state() == CalibrationState::kCurrent; }));
  QTest::qWait(300);
  EXPECT_EQ(rig_.run().result(), nullptr);
}

}  // namespace
}  // namespace alltact::test
