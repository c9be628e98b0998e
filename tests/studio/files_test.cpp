// Files dropped on the window, and many presses changed at a time.
#include "app/studio/main_window.h"
#include "app/studio/workspace.h"
#include "core/base/atomic_file.h"
#include "core/inspection/inspection_recipe.h"
#include "core/recording/video_file.h"
#include "tests/studio/calibrate_rig.h"
#include "widgets/inspect/recordings_dialog.h"
#include "widgets/language.h"
#include "widgets/pages/inspect_page.h"

#include <QDropEvent>
#include <QListWidget>
#include <QMessageBox>
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

TEST(Drop, OnInspectARecipeIsLoadedAndABodyIsComparedWith) {
  const TemporaryFolder folder;
  InspectionRecipe recipe;
  recipe.readings.push_back({"gap", Measurand::kDistance, {10, 0}, {20, 0}, {}, {}, {}});
  must(recipe.save(folder / "gap.yaml"));
  must(write_file_atomically(folder / "broken.yaml", "format: alltact-inspection-recipe/1\n"));
  must(write_file_atomically(folder / "Ball.STL", "solid ball\nendsolid ball\n"));
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  options.source = {MadeFingers::get().touched()};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("inspect");
  const auto& shown = studio.window().findChild<InspectPage*>()->options();
  drop(studio.window(), {folder / "gap.yaml"});
  EXPECT_TRUE(wait_until([&] { return shown.recipe == recipe; }));
  drop(studio.window(), {folder / "Ball.STL"});
  EXPECT_TRUE(wait_until([&] { return shown.with.file == folder / "Ball.STL"; }));
  EXPECT_EQ(shown.with.method, OtherMethod::kBody);
  EXPECT_EQ(shown.comparison, Comparison::kDifference);
  studio.window().undo_stack().undo();
  EXPECT_TRUE(shown.with.file.empty());
  EXPECT_EQ(shown.recipe, recipe);
  drop(studio.window(), {folder / "broken.yaml"});
  EXPECT_TRUE(
      wait_until([&] { return studio.problems().find("broken.yaml") != std::string::npos; }, 10000))
      << studio.problems();
  EXPECT_EQ(shown.recipe, recipe);
  EXPECT_EQ(studio.session().status().source.inputs,
            std::vector<fs::path>{MadeFingers::get().touched()})
      << "none of them is a source";
}

TEST(Recordings, AreListedNewestFirstWithAFrameAndOpened) {
  const TemporaryFolder folder;
  fs::copy(MadeFingers::get().described(), folder / "finger", fs::copy_options::recursive);
  const fs::path finger = folder / "finger";
  const auto make_video = [&](const char* name, int grey, int days_old) {
    Frame frame;
    frame.grey = cv::Mat(48, 64, CV_8UC1, cv::Scalar(grey));
    auto writer = VideoWriter::create(finger / name, frame, VideoCodec::kAuto, 10.0);
    ASSERT_TRUE(writer.ok());
    for (int i = 0; i < 20; ++i) must(writer->add(frame));
    must(writer->finish());
    fs::last_write_time(finger / name,
                        fs::file_time_type::clock::now() - std::chrono::hours(24 * days_old));
  };
  make_video("reference.mkv", 50, 3);
  make_video("old.mkv", 100, 2);
  make_video("new.mkv", 200, 0);
  StudioOptions options;
  options.finger = finger;
  Studio studio(options);
  ASSERT_TRUE(
      wait_until([&] { return studio.session().status().finger.state == FingerState::kReady; }));
  studio.window().go_to("inspect");
  studio.click("Recordings…");
  auto* dialog = studio.window().findChild<RecordingsDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* list = dialog->findChild<QListWidget*>();
  ASSERT_TRUE(wait_until([&] { return list->count() == 3; }));
  const auto text = [&](int row) { return list->item(row)->text().toStdString(); };
  ASSERT_TRUE(wait_until([&] { return text(2).find("0:02 min") != std::string::npos; }));
  EXPECT_EQ(text(0).substr(0, 7), "new.mkv");
  EXPECT_EQ(text(1).substr(0, 7), "old.mkv");
  EXPECT_EQ(text(2).substr(0, 13), "reference.mkv");
  EXPECT_NE(text(0).find(moment_text(QDateTime::currentDateTime()).left(6).toStdString()),
            std::string::npos);
  const QImage image = list->item(0)->icon().pixmap(list->iconSize()).toImage();
  EXPECT_NEAR(image.pixelColor(image.width() / 2, image.height() / 2).red(), 200, 3);
  // The reference cannot be removed.
  QAction* trash = nullptr;
  for (QAction* action : list->actions())
    if (action->shortcut() == QKeySequence(Qt::Key_Delete)) trash = action;
  ASSERT_NE(trash, nullptr);
  list->setCurrentRow(2);
  EXPECT_FALSE(trash->isEnabled());
  // The others are, once that is confirmed.
  list->setCurrentRow(1);
  ASSERT_TRUE(trash->isEnabled());
  trash->trigger();
  auto* box = dialog->findChild<QMessageBox*>();
  ASSERT_NE(box, nullptr);
  EXPECT_TRUE(fs::exists(finger / "old.mkv"));
  for (auto* button : box->findChildren<QPushButton*>())
    if (without_mnemonic(button->text()) == "Move to the trash") button->click();
  EXPECT_TRUE(wait_until([&] { return list->count() == 2; }));
  EXPECT_FALSE(fs::exists(finger / "old.mkv"));
  list->setCurrentRow(0);
  QTest::keyClick(list, Qt::Key_Return);
  EXPECT_EQ(studio.window().findChild<InspectPage*>()->options().recording, finger / "new.mkv");
  EXPECT_TRUE(
      wait_until([&] { return studio.window().findChild<RecordingsDialog*>() == nullptr; }));
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
