// The second day: from the first page to the depth of what touches, in one action; and the window
// says at once what is known of the finger.
#include "app/studio/header_bar.h"
#include "app/studio/session.h"
#include "core/base/atomic_file.h"
#include "tests/studio/calibrate_rig.h"
#include "widgets/shell/finger_card.h"
#include "widgets/widget_base.h"

#include <QElapsedTimer>
#include <QMenu>
#include <QMessageBox>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr double kSoon_s = 2;

/// A window as it was closed the day before.
StudioOptions of_yesterday(const TemporaryFolder& folder) {
  SessionState state;
  state.finger = MadeFingers::get().calibrated();
  state.source = {MadeFingers::get().touched()};
  state.recent_fingers = {MadeFingers::get().calibrated(), "/nowhere/a-finger-that-was-deleted",
                          MadeFingers::get().described()};
  must(make_folder(folder / "session"));
  must(write_file_atomically(folder / "session/session.json", session_to_json(state)));
  StudioOptions options;
  options.session_folder = folder / "session";
  return options;
}

TEST(SecondDayNeverBlocks, ShowsDepthInOneActionAndTwoSeconds) {
  const TemporaryFolder folder;
  Studio studio(of_yesterday(folder));
  auto* cards = studio.window().findChild<FingerCards*>();
  ASSERT_TRUE(wait_until([&] { return cards->cards().size() == 2; }));
  auto* card = cards->findChild<QToolButton*>();
  ASSERT_NE(card, nullptr);
  QElapsedTimer clock;
  clock.start();
  QTest::mouseClick(card, Qt::LeftButton);
  ASSERT_TRUE(wait_until(
      [&] {
        const auto& view = studio.session().view();
        return view && view->depth_layer;
      },
      30000));
  const double waited_s = static_cast<double>(clock.elapsed()) / 1000;
  std::printf("[ figures  ] first depth %.2f s after one click\n", waited_s);
  EXPECT_LT(waited_s, kSoon_s);
}

TEST(SecondDayStart, MeasuresTheLastPictureOfASourceThatHasEnded) {
  StudioOptions options;
  options.source = {MadeFingers::get().touched_pictures()};
  Studio studio(options);
  ASSERT_TRUE(wait_until(
      [&] { return studio.session().status().source.state == SourceState::kEnded; }, 30000));
  EXPECT_FALSE(studio.session().view()->depth_layer) << "nobody knows the finger";
  studio.window().open_finger(MadeFingers::get().calibrated());
  EXPECT_TRUE(wait_until([&] { return studio.session().view()->depth_layer.has_value(); }, 30000));
}

TEST(SecondDayStart, AFingerIsRemovedFromTheListAndItsFolderStays) {
  const TemporaryFolder folder;
  Studio studio(of_yesterday(folder));
  auto* cards = studio.window().findChild<FingerCards*>();
  ASSERT_TRUE(wait_until([&] { return cards->cards().size() == 2; }));
  const auto trigger = [&](const char* what) {
    for (QAction* action : cards->findChild<QToolButton*>()->actions())
      if (without_mnemonic(action->text()) == QLatin1String(what)) return action->trigger();
    ADD_FAILURE() << "no action " << what;
  };
  const auto first = cards->cards().front().folder;
  EXPECT_EQ(first, MadeFingers::get().calibrated());
  trigger("Remove from this list");
  ASSERT_TRUE(wait_until([&] { return cards->cards().size() == 1; }));
  EXPECT_EQ(cards->cards().front().folder, MadeFingers::get().described());
  EXPECT_TRUE(std::filesystem::exists(first / "finger.yaml"));
  for (const QAction* action : studio.window().findChildren<QAction*>())
    EXPECT_NE(action->toolTip().toStdString(), first.string()) << "nor in the menus";
  QTest::qWait(50);  // the removed card is deleted
  trigger("Open");
  EXPECT_TRUE(wait_until(
      [&] { return studio.session().status().finger.folder == MadeFingers::get().described(); }));
}

TEST(SecondDayStart, OffersOnlyFingersThatCanBeOpened) {
  const TemporaryFolder folder;
  Studio studio(of_yesterday(folder));
  auto* cards = studio.window().findChild<FingerCards*>();
  ASSERT_TRUE(wait_until([&] { return cards->cards().size() == 2; }));
  QStringList offered;
  for (const QAction* action : studio.window().findChildren<QAction*>())
    if (action->toolTip().startsWith(QLatin1Char('/'))) offered << action->toolTip();
  EXPECT_TRUE(offered.contains(QString::fromStdString(MadeFingers::get().calibrated().string())));
  EXPECT_FALSE(offered.contains(QStringLiteral("/nowhere/a-finger-that-was-deleted")));
}

TEST(SecondDayStart, ListsAllFingersOfTheLabTheMostUrgentFirst) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  Studio studio(options);
  QTest::keyClick(&studio.window(), Qt::Key_L, Qt::ControlModifier);
  auto* list = studio.window().findChild<FingerListDialog*>();
  ASSERT_NE(list, nullptr);
  // The described finger was never opened here; it lies beside the calibrated one.
  ASSERT_TRUE(wait_until([&] { return list->cards().size() == 2; }));
  EXPECT_EQ(list->cards().front().folder, MadeFingers::get().calibrated());
  // Its mapping was written without a date: nothing shows that it is newer than the reference.
  EXPECT_EQ(list->cards().front().due, FingerDue::kRepeat);
  EXPECT_EQ(list->cards().back().due, FingerDue::kRecording);
  auto* rows = list->findChild<QTreeWidget*>();
  rows->setCurrentItem(rows->topLevelItem(1));
  QTest::keyClick(rows, Qt::Key_Return);
  EXPECT_TRUE(wait_until(
      [&] { return studio.session().status().finger.folder == MadeFingers::get().described(); }));
}

TEST(Quitting, AsksWhileARecordingIsUnderWay) {
  StudioOptions options;
  options.source = {MadeFingers::get().bending()};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  const TemporaryFolder folder;
  studio.session().start_recording(folder / "a.mkv");
  ASSERT_TRUE(wait_until([&] { return studio.session().status().recording.counts.recorded > 3; }));
  QTest::keyClick(&studio.window(), Qt::Key_Q, Qt::ControlModifier);
  auto* box = studio.window().findChild<QMessageBox*>();
  ASSERT_NE(box, nullptr);
  EXPECT_TRUE(studio.window().isVisible());
  const auto press = [&](const char* words) {
    for (QAbstractButton* button : box->buttons())
      if (button->text().remove(QLatin1Char('&')) == QLatin1String(words)) button->click();
  };
  press("Go on recording");
  EXPECT_TRUE(studio.window().isVisible());
  EXPECT_EQ(studio.session().status().recording.state, RecordingState::kRunning);
  QTest::qWait(20);
  QApplication::setActiveWindow(&studio.window());
  QTest::keyClick(&studio.window(), Qt::Key_Q, Qt::ControlModifier);
  box = studio.window().findChild<QMessageBox*>();
  ASSERT_NE(box, nullptr);
  press("End it and quit");
  EXPECT_FALSE(studio.window().isVisible());
  EXPECT_TRUE(std::filesystem::exists(folder / "a.mkv"));
}

}  // namespace
}  // namespace alltact::test
