// A force model is trained in the window: from a table to its errors, installed or discarded.
#include "widgets/shell/force_dialog.h"

#include "core/finger/finger_store.h"
#include "tests/studio/force_finger.h"

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

class TrainingDialog : public testing::Test {
 protected:
  TrainingDialog() {
    fs::copy(ForceFinger::get().folder(), folder_ / "finger", fs::copy_options::recursive);
    must(write_file_atomically(table(), stored_force_table(finger()).value().to_csv()));
    training_.comparison_only = true;
    training_.network.steps = 20;
    training_.network.members = 1;
  }
  [[nodiscard]] fs::path finger() const { return folder_ / "finger"; }
  [[nodiscard]] fs::path table() const { return folder_ / "table.csv"; }
  [[nodiscard]] std::string model() const {
    return open_finger(finger()).value()->finger.force_model;
  }
  static QPushButton& button(const QWidget& dialog, const QString& text) {
    for (auto* one : dialog.findChildren<QPushButton*>())
      if (one->text().remove(QLatin1Char('&')) == text) return *one;
    throw std::runtime_error(text.toStdString());
  }
  void train(ForceDialog& dialog) {
    dialog.show();
    dialog.train({table()}, training_);
    EXPECT_TRUE(button(dialog, "Stop").isEnabled());
    EXPECT_FALSE(button(dialog, "Install").isEnabled());
    ASSERT_TRUE(wait_until([&] { return dialog.trained() != nullptr; }, 60000));
  }
  TemporaryFolder folder_;
  ForceTraining training_;
  QUndoStack undo_;
};

TEST_F(TrainingDialog, ShowsTheErrorsAndInstallsAsAnUndoStep) {
  training_.kind = ForceKind::kQuadratic;
  const std::string before = model();
  ForceDialog dialog(finger(), undo_);
  train(dialog);
  const auto truth = *dialog.trained();
  EXPECT_EQ(model(), before) << "nothing changes before it is installed";
  const auto* rows = dialog.findChild<QTreeWidget*>();
  ASSERT_EQ(rows->topLevelItemCount(), 4);
  EXPECT_EQ(rows->topLevelItem(2)->text(1),
            QStringLiteral("%1; %2")
                .arg(truth.of(ForceKind::kQuadratic).mae_N[0], 0, 'f', 3)
                .arg(truth.of(ForceKind::kQuadratic).mae_N[1], 0, 'f', 3));
  EXPECT_EQ(rows->topLevelItem(2)->text(3), "yes");
  dialog.resize(640, 460);
  fs::create_directories(ALLTACT_SCREENS);
  dialog.grab().save(ALLTACT_SCREENS "/force_training.png");
  button(dialog, "Install").click();
  ASSERT_TRUE(wait_until([&] { return undo_.count() == 1; }));
  const std::string after = model();
  EXPECT_NE(after, before);
  EXPECT_EQ(open_finger(finger()).value()->force->kind, ForceKind::kQuadratic);
  EXPECT_FALSE(button(dialog, "Install").isEnabled());
  undo_.undo();
  EXPECT_EQ(model(), before);
  undo_.redo();
  EXPECT_EQ(model(), after);
}

TEST_F(TrainingDialog, LeavesTheFingerWhenDiscarded) {
  const std::string before = model();
  ForceDialog dialog(finger(), undo_);
  train(dialog);
  button(dialog, "Discard").click();
  EXPECT_EQ(dialog.trained(), nullptr);
  EXPECT_FALSE(button(dialog, "Install").isEnabled());
  EXPECT_EQ(model(), before);
  EXPECT_EQ(undo_.count(), 0);
}

TEST_F(TrainingDialog, ReportsATableThatDoesNotFit) {
  must(write_file_atomically(table(), "u0,v0,fx_n\n1,2,3\n"));
  ForceDialog dialog(finger(), undo_);
  dialog.show();
  dialog.train({table()}, training_);
  ASSERT_TRUE(wait_until([&] { return !dialog.findChild<ProblemList*>()->problems().empty(); }));
  EXPECT_EQ(dialog.trained(), nullptr);
}

TEST(ForceTrainingInLive, IsOfferedForAFingerWithMarkers) {
  StudioOptions options = simulated();
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  ASSERT_TRUE(wait_until([&] { return can_train_force(studio.session().status().finger); }));
  studio.click("Train the forces…");
  EXPECT_NE(studio.window().findChild<ForceDialog*>(), nullptr);
}

}  // namespace
}  // namespace alltact::test
