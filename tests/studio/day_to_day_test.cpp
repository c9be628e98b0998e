// Small things of every day: the space bar, notices, windows that are small, a program without a
// language, a finger that is not calibrated yet.
#include "app/studio/onboarding.h"
#include "core/image/image_file.h"
#include "tests/studio/calibrate_rig.h"
#include "widgets/pages/live_page.h"
#include "widgets/shell/finger_card.h"
#include "widgets/shell/problem_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

TEST(SpaceBar, TakesAPressWhereverTheFocusIsAndTypesIntoNoNumber) {
  CalibrateStudio rig;
  rig.open();
  rig.go_to_step("Presses");  // the focus is where the step was chosen
  auto* focused = rig.studio().window().focusWidget();
  ASSERT_NE(focused, nullptr);
  QTest::keyClick(focused, Qt::Key_Space);
  EXPECT_TRUE(wait_until([&] { return rig.collection().presses().size() == 1; }));
  rig.type_radius("4");
  auto* radius = rig.studio().find<QDoubleSpinBox>("Ball's radius");
  for (const std::size_t presses : {2U, 3U}) {
    QTest::keyClick(radius, Qt::Key_Space);
    EXPECT_TRUE(wait_until([&] { return rig.collection().presses().size() == presses; }));
  }
  EXPECT_EQ(radius->text().toStdString(), "4.000 mm");
  EXPECT_EQ(rig.collection().press_set().ball_radius_mm, 4);
  // A name may have one.
  auto* who = rig.studio().find<QLineEdit>("Operator");
  who->setFocus();
  QTest::keyClicks(who, "Ada L");
  EXPECT_EQ(who->text().toStdString(), "Ada L");
  EXPECT_EQ(rig.collection().presses().size(), 3U);
  // And a box is ticked with it.
  auto* box = rig.studio().find<QCheckBox>("Automatically when still");
  QTest::keyClick(box, Qt::Key_Space);
  EXPECT_TRUE(box->isChecked());
  EXPECT_EQ(rig.collection().presses().size(), 3U);
  QTest::keyClick(box, Qt::Key_Space);
}

TEST(Refusals, AreAWordInTheListAndASentenceBesideThePicture) {
  CalibrateStudio rig(1);
  must(write_image(rig.finger() / "presses/zz.png",
                   cv::Mat(small_size_px(), CV_8U, cv::Scalar(90))));
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  auto* list = rig.studio().find<QListView>("Presses");
  const int last = list->model()->rowCount() - 1;
  const QString told = list->model()->index(last, 0).data().toString();
  EXPECT_LE(told.size(), 3 + 24) << told.toStdString();
  list->setCurrentIndex(list->model()->index(last, 0));
  const CollectedPress* press = rig.collection().find("zz");
  ASSERT_TRUE(press != nullptr && press->analysis.problem);
  EXPECT_TRUE(says(rig.studio(), press->analysis.problem->what.english().substr(1).c_str()));
}

TEST(Notices, OfRecordStandInTheOneBar) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  options.source = {MadeFingers::get().touched()};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("record");
  ASSERT_TRUE(wait_until(
      [&] {
        return studio.problems().find("Something touches the contact face") != std::string::npos;
      },
      60000));
  QTest::qWait(50);  // rows are shown when the window is idle
  int lists = 0, rows = 0;
  for (const auto* list : studio.window().findChildren<ProblemList*>())
    lists += list->isVisible() ? 1 : 0;
  for (const auto* row : studio.window().findChildren<QFrame*>(QStringLiteral("problem")))
    rows += row->isVisible() ? 1 : 0;
  EXPECT_EQ(lists, 1);
  EXPECT_EQ(rows, 1);
}

TEST(SmallWindow, FitsAScreenOf1024In) {
  CalibrateStudio rig(1);
  rig.open();
  for (const char* language : {"en", "de", "zh_CN"}) {
    ProgramAppearance appearance;
    appearance.apply({Theme::kLight, QLatin1String(language)});
    QTest::qWait(50);
    EXPECT_LE(rig.studio().window().minimumSizeHint().width(), 1024) << language;
    EXPECT_LE(rig.studio().window().minimumSizeHint().height(), 700) << language;
  }
  ProgramAppearance appearance;
  appearance.apply({Theme::kLight, QStringLiteral("en")});
}

TEST(LanguageC, CountsAsEnglishDoes) {
  ProgramAppearance appearance;
  appearance.apply({Theme::kLight, QStringLiteral("C")});
  EXPECT_EQ(RecordPage::tr("%n frame(s)", nullptr, 1).toStdString(), "1 frame");
  EXPECT_EQ(RecordPage::tr("%n frame(s)", nullptr, 2).toStdString(), "2 frames");
  appearance.apply({Theme::kLight, QStringLiteral("en")});
}

TEST(InspectUncalibrated, ShowsTheWholeFaceAndNoPoints) {
  StudioOptions options;
  const CalibrateStudio rig;  // not calibrated
  options.finger = rig.finger();
  Studio studio(options);
  studio.window().go_to("inspect");
  auto& place = *studio.window().findChild<InspectPage*>();
  auto* along = studio.find<QDoubleSpinBox>("Point A, along the finger");
  ASSERT_NE(along, nullptr);
  EXPECT_EQ(along->text().toStdString(), "\xE2\x80\x93");
  place.open(MadeFingers::get().touched_pictures());
  ASSERT_TRUE(wait_until([&] { return place.inspection().frame() != nullptr; }, 30000));
  const auto& frame = place.inspection().frame();
  EXPECT_FALSE(frame->surface.has_value());
  ASSERT_TRUE(frame->bare.has_value());
  double shortest = 1e9, longest = 0;
  for (int i = 0; i < frame->bare->columns(); ++i) {
    const double z = frame->bare->untouched_mm.at<cv::Vec3f>(frame->bare->rows() / 2, i)[2];
    shortest = std::min(shortest, z);
    longest = std::max(longest, z);
  }
  // The scene's finger is 116 mm long and goes away from the camera at 34 degrees.
  EXPECT_NEAR(longest - shortest, 116 * std::sin(34 * 3.14159265 / 180), 2);
  EXPECT_TRUE(says(studio, "the shape of the entire finger"));
}

TEST(Start, OffersTheFingersOfBeforeAndAWholeDay) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  Studio studio(options);
  auto* cards = studio.window().findChild<FingerCards*>();
  ASSERT_NE(cards, nullptr);
  ASSERT_TRUE(wait_until([&] { return cards->cards().size() == 1; }));
  EXPECT_TRUE(cards->isVisible());
  EXPECT_NE(studio.find<QPushButton>("Try with a simulated finger"), nullptr);
}

TEST(Start, TryingMakesAFingerAndSaysWhatComesNext) {
  Studio studio;
  studio.click("Try with a simulated finger");
  auto* guide = studio.window().findChild<Tutorial*>();
  ASSERT_NE(guide, nullptr);
  ASSERT_TRUE(wait_until([&] { return guide->step() == Tutorial::Step::kRecord; }, 30000))
      << studio.problems();
  EXPECT_TRUE(says(studio, "1 of 4"));
  const auto& finger = studio.session().status().finger;
  EXPECT_TRUE(std::filesystem::exists(finger.folder / "finger.yaml"));
  EXPECT_EQ(finger.finger->face.kind, FaceKind::kFinRay);
  studio.click("Go to Record");
  EXPECT_NE(studio.find<QPushButton>("Start recording"), nullptr);
  studio.click("End the guide");
  EXPECT_FALSE(guide->isVisible());
}

}  // namespace
}  // namespace alltact::test
