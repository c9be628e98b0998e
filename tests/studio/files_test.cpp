// Files dropped on the window, and many presses changed at a time.
#include "app/studio/main_window.h"
#include "app/studio/workspace.h"
#include "tests/studio/calibrate_rig.h"
#include "widgets/pages/inspect_page.h"

#include <QDropEvent>
#include <QMimeData>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

void drop(QWidget& window, const std::vector<fs::path>& files) {
  QMimeData data;
  QList<QUrl> urls;
  for (const fs::path& file : files)
    urls << QUrl::fromLocalFile(QString::fromStdString(file.string()));
  data.setUrls(urls);
  const QPoint at(window.width() / 2, window.height() / 2);
  QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent dropped(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &dropped);
  EXPECT_TRUE(dropped.isAccepted());
}

TEST(Drop, OpensFingersSourcesAndRecordings) {
  const auto& made = MadeFingers::get();
  Studio studio;
  drop(studio.window(), {made.calibrated()});
  EXPECT_TRUE(
      wait_until([&] { return studio.session().status().finger.folder == made.calibrated(); }));
  drop(studio.window(), {made.described() / "finger.yaml"});
  EXPECT_TRUE(
      wait_until([&] { return studio.session().status().finger.folder == made.described(); }));
  drop(studio.window(), {made.touched()});
  const std::vector<fs::path> touched{made.touched()};
  ASSERT_TRUE(wait_until([&] { return studio.session().status().source.inputs == touched; }));
  studio.window().go_to("inspect");
  drop(studio.window(), {made.touched_pictures()});
  EXPECT_TRUE(wait_until([&] {
    return studio.window().findChild<InspectPage*>()->options().recording ==
           made.touched_pictures();
  }));
  EXPECT_EQ(studio.session().status().source.inputs, touched)
      << "a recording to inspect is no source";
  QStringList offered;
  for (const QAction* action : studio.window().findChildren<QAction*>())
    offered << action->toolTip();
  EXPECT_TRUE(offered.contains(QString::fromStdString(made.touched().string())))
      << "among the recent sources";
}

TEST(Drop, AddsImagesOfPressesToTheStepThatIsShown) {
  CalibrateStudio rig(2);
  rig.open();
  rig.go_to_step("Presses");
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  const fs::path image = MadeFingers::get().touched_pictures() / "frame_00000.png";
  drop(rig.studio().window(), {image});
  EXPECT_TRUE(wait_until([&] { return rig.collection().presses().size() == 3; }));
}

/// Several presses at a time, each time in one step.
TEST(PressList, RemovesAndLeavesOutWhatIsSelected) {
  CalibrateStudio rig(4);
  rig.open();
  rig.collection().set_radius(4);
  rig.go_to_step("Presses");
  ASSERT_TRUE(rig.wait_until_looked_at(4));
  auto* list = rig.studio().find<QListView>("Presses");
  const auto select = [list](int first, int last) {
    list->setCurrentIndex(list->model()->index(first, 0));
    list->selectionModel()->select({list->model()->index(first, 0), list->model()->index(last, 0)},
                                   QItemSelectionModel::ClearAndSelect);
  };
  select(1, 3);
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Delete);
  EXPECT_EQ(rig.collection().presses().size(), 1U);
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(rig.collection().presses().size(), 4U);
  ASSERT_TRUE(wait_until([&] { return rig.collection().usable_count() == 4; }));
  select(0, 1);
  for (QAction* action : list->actions())
    if (action->text().contains(QLatin1String("Leave"))) action->trigger();
  EXPECT_EQ(rig.collection().usable_count(), 2);
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(rig.collection().usable_count(), 4);
}

/// A folder that is only called what it holds is named with the one above; nothing says "finger
/// finger".
TEST(FingerNames, AreNoWordTwice) {
  EXPECT_EQ(short_name("/lab/left-01").toStdString(), "left-01");
  EXPECT_EQ(short_name("/lab/left-01/finger").toStdString(), "left-01/finger");
  EXPECT_EQ(short_name("/lab/left-01/").toStdString(), "left-01");
  StudioOptions options;
  const TemporaryFolder lab;
  options.finger = lab / "gripper" / "finger";
  std::filesystem::create_directories(lab / "gripper");
  std::filesystem::copy(MadeFingers::get().calibrated(), options.finger,
                        std::filesystem::copy_options::recursive);
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.finger.has_value(); }));
  QTest::qWait(200);
  int texts = 0;
  for (const QWidget* widget : studio.window().findChildren<QWidget*>())
    for (const QString& text : {widget->property("text").toString(), widget->accessibleName()}) {
      texts += text.contains(QLatin1String("finger"), Qt::CaseInsensitive) ? 1 : 0;
      EXPECT_FALSE(text.contains(QLatin1String("finger finger"), Qt::CaseInsensitive))
          << text.toStdString();
    }
  EXPECT_GT(texts, 5);
}

}  // namespace
}  // namespace alltact::test
