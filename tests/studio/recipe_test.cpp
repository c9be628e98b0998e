// An inspection recipe made in the window, its decisions, its table and its report; the command
// line gives the same bytes.
#include "app/studio/session.h"
#include "core/open/open_source.h"
#include "core/recording/video_file.h"
#include "tests/studio/studio_rig.h"
#include "tests/support/program.h"
#include "widgets/inspect/inspection_results.h"
#include "widgets/inspect/recipe_box.h"
#include "widgets/pages/inspect_page.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QTabWidget>
#include <QTableWidget>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

class Recipe : public testing::Test {
 protected:
  Recipe() : studio_(simulated()) { studio_.window().go_to("inspect"); }
  InspectPage& page() { return *studio_.window().findChild<InspectPage*>(); }
  /// A box around the deepest contact of the recording.
  bool choose_points() {
    page().open(MadeFingers::get().touched_pictures());
    const auto is_ready = [this] {
      const auto& frame = page().inspection().frame();
      return frame && !page().inspection().is_busy() && frame->result.depth.has_value() &&
             !page().options().recording.empty();
    };
    if (!wait_until(is_ready)) return false;
    studio_.click("Deepest");
    const InspectedFrame& frame = *page().inspection().frame();
    const cv::Point2d deepest = *pixel_of(frame, page().options().a);
    InspectOptions box = page().options();
    box.a = position_of(frame, deepest - cv::Point2d(14, 26));
    box.b = position_of(frame, deepest + cv::Point2d(14, 26));
    page().restore(box, frame.number);
    return true;
  }
  void add(int row) {
    auto* table = studio_.find<QTableWidget>("Measured between the points");
    table->selectRow(row);
    studio_.click("Add to recipe");
  }
  QTreeWidget& list() { return *studio_.find<QTreeWidget>("Readings of the recipe"); }
  void set_limits(int row, double lower, double upper) {
    list().setCurrentItem(list().topLevelItem(row));
    studio_.click("Name, tolerance…");
    auto* dialog = studio_.window().findChild<ReadingDialog*>();
    ASSERT_NE(dialog, nullptr);
    const auto fields = dialog->findChildren<NumberField*>();
    ASSERT_EQ(fields.size(), 2);
    fields[0]->setValue(lower);
    fields[1]->setValue(upper);
    studio_.click("OK");
    ASSERT_TRUE(
        wait_until([&] { return studio_.window().findChild<ReadingDialog*>() == nullptr; }));
  }
  Studio studio_;
};

TEST_F(Recipe, MadeInTheWindowGivesTheSameBytesAsTheCommandLine) {
  ASSERT_TRUE(choose_points());
  add(1);  // radius
  ASSERT_EQ(page().options().recipe.readings.size(), 1U);
  add(3);  // volume
  ASSERT_EQ(page().options().recipe.readings.size(), 2U);
  add(1);
  ASSERT_EQ(page().options().recipe.readings.size(), 3U);
  EXPECT_EQ(page().options().recipe.readings[2].name, "Ball's radius 2");
  set_limits(0, 3, 5);
  EXPECT_EQ(list().topLevelItem(0)->text(2), "pass") << "the scene's ball has 4 mm";
  EXPECT_EQ(list().topLevelItem(0)->toolTip(2), "Tolerance: 3.000 to 5.000 mm");
  QTest::keyClick(&list(), Qt::Key_Delete);
  ASSERT_EQ(page().options().recipe.readings.size(), 2U) << "the selected one";
  EXPECT_EQ(studio_.window().undo_stack().undoText(), "remove a reading from the recipe");
  studio_.window().undo_stack().undo();
  ASSERT_EQ(page().options().recipe.readings.size(), 3U);
  EXPECT_EQ(*page().options().recipe.readings[0].lower, 3);

  studio_.click("Inspect all frames…");
  auto* results = studio_.window().findChild<InspectionResults*>();
  ASSERT_NE(results, nullptr);
  ASSERT_TRUE(wait_until([&] { return results->log() != nullptr; }, 60000));
  EXPECT_EQ(results->log()->rows.size(), 6U);
  EXPECT_EQ(results->log()->verdict(), Conformity::kPass);
  const TemporaryFolder& folder = studio_.folder();
  results->save_table(folder / "window.csv");
  results->save_report(folder / "report.pdf");
  EXPECT_THAT(text_of(folder / "report.pdf"), testing::StartsWith("%PDF"));
  must(page().options().recipe.save(folder / "recipe.yaml"));
  const ProgramRun run =
      run_alltact({"inspect", MadeFingers::get().calibrated().string(),
                   MadeFingers::get().touched_pictures().string(), "--recipe",
                   (folder / "recipe.yaml").string(), "-o", (folder / "program.csv").string(),
                   "--threads", "2", "--report", (folder / "program.pdf").string()});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("within their tolerances with 95 % certainty"));
  EXPECT_EQ(text_of(folder / "window.csv"), text_of(folder / "program.csv"));
  EXPECT_THAT(text_of(folder / "program.pdf"), testing::StartsWith("%PDF"));
  EXPECT_NEAR(std::filesystem::file_size(folder / "program.pdf"),
              std::filesystem::file_size(folder / "report.pdf"), 20000)
      << "the same pages, by another font";
  for (auto* scrolled : studio_.window().findChildren<QScrollArea*>())
    if (scrolled->isAncestorOf(&list())) scrolled->ensureWidgetVisible(&list(), 0, 300);
  ProgramAppearance appearance;
  for (const char* language : {"en", "de", "zh_CN"}) {
    appearance.apply({Theme::kLight, QLatin1String(language)});
    QTest::qWait(200);
    ASSERT_TRUE(results->grab().save(
        QStringLiteral(ALLTACT_SCREENS "/inspection_%1.png").arg(QLatin1String(language))));
    ASSERT_TRUE(studio_.window().grab().save(
        QStringLiteral(ALLTACT_SCREENS "/recipe_%1.png").arg(QLatin1String(language))));
  }
  appearance.apply({Theme::kLight, QStringLiteral("en")});

  // A tolerance that the ball is outside of.
  write_text(folder / "tight.yaml", [&] {
    InspectionRecipe tight = page().options().recipe;
    tight.readings.front().upper = 3.2;
    return tight.to_yaml();
  }());
  const ProgramRun failed =
      run_alltact({"inspect", MadeFingers::get().calibrated().string(),
                   MadeFingers::get().touched_pictures().string(), "--recipe",
                   (folder / "tight.yaml").string(), "-o", (folder / "tight.csv").string()});
  EXPECT_EQ(failed.status, 1);
  EXPECT_THAT(failed.errors, HasSubstr("outside of their tolerance"));
  EXPECT_THAT(text_of(folder / "tight.csv"), HasSubstr(",fail,"));
}

TEST_F(Recipe, ListsAllReadingsOfEachFrameAndShowsAFrame) {
  ASSERT_TRUE(choose_points());
  const QTableWidget& between = *studio_.find<QTableWidget>("Measured between the points");
  EXPECT_EQ(between.item(9, 0)->text(), "Section's width");
  add(8);  // the section's depth
  add(10);
  studio_.click("Inspect all frames…");
  auto* results = studio_.window().findChild<InspectionResults*>();
  ASSERT_NE(results, nullptr);
  ASSERT_TRUE(wait_until([&] { return results->log() != nullptr; }, 60000));
  for (const InspectedRow& row : results->log()->rows)
    for (const InspectedReading& one : row.readings)
      EXPECT_TRUE(one.reading.measured) << one.reading.reason.english();
  results->findChild<QTabWidget*>()->setCurrentIndex(1);
  auto& frames = *results->findChild<FrameTable*>();
  ASSERT_EQ(frames.topLevelItemCount(), 6);
  EXPECT_EQ(frames.headerItem()->text(2), "Section's depth, mm");
  frames.sortByColumn(2, Qt::DescendingOrder);
  const auto value = [&](int row) {
    return frames.topLevelItem(row)->data(2, Qt::UserRole).toDouble();
  };
  for (int row = 1; row < 6; ++row) EXPECT_GE(value(row - 1), value(row));
  // All are copied where none is selected, in the order that is shown.
  const QStringList lines = frames.text().split('\n');
  ASSERT_EQ(lines.size(), 8);
  EXPECT_EQ(lines[0].section('\t', 0, 2), "Frame\tTime, s\tSection's depth, mm");
  EXPECT_EQ(lines[1].section('\t', 0, 0), frames.topLevelItem(0)->text(0));
  results->grab().save(QStringLiteral(ALLTACT_SCREENS "/inspection_frames.png"));
  frames.sortByColumn(0, Qt::AscendingOrder);
  QTest::mouseClick(frames.viewport(), Qt::LeftButton, {},
                    frames.visualItemRect(frames.topLevelItem(4)).center());
  EXPECT_TRUE(wait_until([&] {
    const auto& frame = page().inspection().frame();
    return frame && frame->number == 4 && !page().inspection().is_busy();
  }));
  QTest::keyClick(&frames, Qt::Key_Up);
  EXPECT_TRUE(wait_until([&] {
    const auto& frame = page().inspection().frame();
    return frame && frame->number == 3 && !page().inspection().is_busy();
  }));
  EXPECT_EQ(frames.text().split('\n').size(), 3) << "the head and the selected one";
  QTest::keyClick(&frames, Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), frames.text());
}

TEST_F(Recipe, MeasuresTheRecordingsOfAFolderAsTheCommandLineDoes) {
  ASSERT_TRUE(choose_points());
  add(0);
  add(4);
  const auto recordings = studio_.folder() / "recordings";
  std::filesystem::create_directory(recordings);
  std::optional<VideoWriter> writer;
  const auto source = open_source({MadeFingers::get().touched_pictures()}).value();
  for (auto frame = source->next(); frame && *frame; frame = source->next()) {
    if (!writer)
      writer =
          VideoWriter::create(recordings / "b.mkv", **frame, VideoCodec::kMagicYuv, 30).value();
    ASSERT_TRUE(writer->add(**frame).ok());
  }
  ASSERT_TRUE(writer->finish().ok());
  std::filesystem::copy(recordings / "b.mkv", recordings / "c.mkv");
  must(write_file_atomically(recordings / "a.mkv", "no video"));
  const auto recipe = studio_.folder() / "recipe.yaml";
  must(page().options().recipe.save(recipe));
  RecordingsInspection dialog(
      {MadeFingers::get().calibrated(), {recordings}, page().options().recipe}, &studio_.window());
  ASSERT_TRUE(wait_until([&] { return !dialog.recordings().empty(); }, 60000));
  ASSERT_EQ(dialog.recordings().size(), 3U);
  EXPECT_FALSE(dialog.recordings()[0].log);
  const auto* table = dialog.findChild<RowList*>();
  EXPECT_EQ(table->topLevelItemCount(), 1 + 2 * 2) << "a problem, and two readings of two";
  dialog.save_table(studio_.folder() / "window.csv");
  const auto command = studio_.folder() / "command.csv";
  const ProgramRun ran =
      run_alltact({"inspect", MadeFingers::get().calibrated().string(), recordings.string(),
                   "--recipe", recipe.string(), "--each", "-o", command.string()});
  EXPECT_NE(ran.status, 0) << "one of them is no video";
  EXPECT_THAT(ran.errors, HasSubstr("a.mkv"));
  EXPECT_EQ(text_of(command), text_of(studio_.folder() / "window.csv"));
}

TEST_F(Recipe, IsPartOfTheSession) {
  ASSERT_TRUE(choose_points());
  add(6);
  const InspectionRecipe recipe = page().options().recipe;
  ASSERT_EQ(recipe.readings.size(), 1U);
  SessionState state;
  state.inspect.options = page().options();
  const auto back = session_from_json(session_to_json(state), "session.json");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->inspect.options.recipe, recipe);
}

}  // namespace
}  // namespace alltact::test
