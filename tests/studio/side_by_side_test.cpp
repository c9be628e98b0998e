// The live picture with two settings, and what more presses would bring, as a person sees them.
#include "calibration/finger/measuring_presets.h"
#include "tests/studio/calibrate_rig.h"
#include "tests/studio/measured_finger.h"
#include "widgets/accuracy/settings_comparison.h"
#include "widgets/calibrating/verdict_page.h"
#include "widgets/pages/accuracy_page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

/// For people to look at: below the build's folder, screens/.
void keep_pictures(Studio& studio, const std::string& name) {
  fs::create_directories(ALLTACT_SCREENS);
  for (const QSize size : {QSize(1024, 700), QSize(1440, 900)}) {
    studio.window().resize(size);
    QTest::qWait(400);
    EXPECT_EQ(studio.window().size(), size);
    const std::string file = fmt::format("{}/{}_{}.png", ALLTACT_SCREENS, name, size.width());
    EXPECT_TRUE(studio.window().grab().save(QString::fromStdString(file)));
  }
}

struct SideBySidePlace : testing::Test {
  TemporaryFolder folder;
  std::unique_ptr<Studio> studio;

  [[nodiscard]] AccuracyPage& place() { return *studio->window().findChild<AccuracyPage*>(); }
  void open() {
    fs::copy(MeasuredFinger::get().folder(), folder / "finger", fs::copy_options::recursive);
    StudioOptions options;
    options.finger = folder / "finger";
    options.source = {MadeFingers::get().touched()};
    studio = std::make_unique<Studio>(options);
    studio->window().go_to("accuracy");
    ASSERT_TRUE(wait_until([&] { return place().run().study() != nullptr; }, 120000));
    auto* tabs = place().findChild<QTabWidget*>();
    tabs->setCurrentWidget(&place().sides());
  }
};

TEST_F(SideBySidePlace, ShowsBothDepthsOfTheSameFrameAndWhatTheyDifferBy) {
  open();
  // The row that stands above is one without smoothing.
  const auto& rows = place().run().study()->study.rows;
  const auto row = std::find_if(rows.begin(), rows.end(), [](const StudyRow& each) {
    return each.settings.smoothing_px == 0;
  });
  ASSERT_NE(row, rows.end());
  auto* table = place().findChild<AccuracyTable*>();
  Q_EMIT table->point_picked(static_cast<std::size_t>(row - rows.begin()));
  SettingsComparison& sides = place().sides();
  ASSERT_TRUE(wait_until([&] { return sides.compared() && sides.compared()->median_mm; }, 60000));
  const ComparedFrame& both = *sides.compared();
  EXPECT_EQ(both.now.frame, both.other.frame);
  ASSERT_TRUE(both.now.depth && both.other.depth);
  // What is shown as the difference is that of the two depths, pixel by pixel.
  int compared = 0;
  for (int v = 0; v < both.difference_mm.rows; v += 3)
    for (int u = 0; u < both.difference_mm.cols; u += 3) {
      const float off = both.difference_mm.at<float>(v, u);
      if (!std::isfinite(off)) continue;
      ++compared;
      ASSERT_FLOAT_EQ(off, both.other.depth->depth_mm.at<float>(v, u) -
                               both.now.depth->depth_mm.at<float>(v, u));
    }
  EXPECT_GT(compared, 10000);
  EXPECT_GT(*both.p95_mm, *both.median_mm);
  EXPECT_GT(*both.median_mm, 0.0005) << "without smoothing depth is noisier";
  EXPECT_LT(*both.p95_mm, 0.2);
  EXPECT_TRUE(says(*studio, "This image:"));
  for (const char* name : {"Depth with the setting in use now", "Depth with the chosen setting",
                           "Difference of the two depths"})
    EXPECT_NE(studio->find<ImageView>(name), nullptr) << name;
  keep_pictures(*studio, "side_by_side");
  // Used, it is the one in use: the calibration's stands beside it then.
  place().run().use(static_cast<std::size_t>(row - rows.begin()));
  EXPECT_TRUE(wait_until(
      [&] {
        return sides.compared() && sides.compared()->other.depth &&
               says(*studio, "In use now: no smoothing");
      },
      60000));
  EXPECT_EQ(studio->problems(), "");
}

/// A scale that shrank with a lighter contact would make it look like a stronger one.
TEST_F(SideBySidePlace, TheScaleOfTheDifferenceOnlyGrows) {
  LiveSession session;
  SettingsComparison sides(session);
  double before_mm = sides.difference_top_mm();
  const auto take = [&](double p95_mm) {
    auto frame = std::make_shared<ComparedFrame>();
    frame->p95_mm = p95_mm;
    sides.take(frame);
    return sides.difference_top_mm();
  };
  EXPECT_EQ(take(0.001), before_mm);
  const double grown_mm = take(0.16);
  EXPECT_GE(grown_mm, 0.16);
  EXPECT_EQ(take(0.01), grown_mm);
  sides.take(nullptr);
  EXPECT_EQ(sides.difference_top_mm(), grown_mm);
  EXPECT_GT(take(0.9), grown_mm);
}

TEST_F(SideBySidePlace, SaysWhatToDoWhereThereIsNothingToCompare) {
  open();
  auto* table = place().findChild<AccuracyTable*>();
  Q_EMIT table->point_picked(0);
  EXPECT_EQ(place().sides().compared(), nullptr);
}

TEST(MoreThanThereIs, IsToldOfTheCalibrationAndGoesWithIt) {
  MoreDataBox box;
  EXPECT_FALSE(box.isVisibleTo(nullptr) && box.study());
  box.show();
  box.set_finger(open_finger(MadeFingers::get().calibrated()).value());
  auto* start = box.findChild<QPushButton*>();
  ASSERT_TRUE(start && start->isVisible());
  start->click();
  ASSERT_TRUE(wait_until([&] { return box.study() != nullptr; }, 300000));
  const CalibratingStudy& study = *box.study();
  const int now = study.rows.front().choice.presses;
  EXPECT_EQ(now,
            choice_of_finger(open_finger(MadeFingers::get().calibrated()).value()->finger).presses);
  QString words;
  for (const QLabel* label : box.findChildren<QLabel*>()) words += label->text();
  for (const Message& sentence : benefit_of_more_data(study, study.rows.front().choice))
    EXPECT_TRUE(words.contains(QString::fromStdString(sentence.english()).mid(1)))
        << sentence.english();
  EXPECT_FALSE(benefit_of_more_data(study, study.rows.front().choice).empty());
  EXPECT_FALSE(start->isVisible());
  box.set_finger(nullptr);
  EXPECT_EQ(box.study(), nullptr);
  EXPECT_EQ(box.finger(), nullptr) << "who shows it folds it away";
}

}  // namespace
}  // namespace alltact::test
