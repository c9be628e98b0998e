// A finger exported from the window: the same files as from the command line.
#include "tests/studio/studio_rig.h"
#include "widgets/shell/export_dialog.h"

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QLineEdit>
#include <QProgressBar>

#include <gmock/gmock.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ExportTest : public testing::Test {
 protected:
  ExportDialog& open(const fs::path& finger = MadeFingers::get().calibrated()) {
    StudioOptions options;
    options.finger = finger;
    studio_ = std::make_unique<Studio>(options);
    QTest::keyClick(&studio_->window(), Qt::Key_E, Qt::ControlModifier);
    auto* dialog = studio_->window().findChild<ExportDialog*>();
    if (dialog == nullptr) throw std::runtime_error("Ctrl+E shows no dialog");
    EXPECT_TRUE(QTest::qWaitForWindowExposed(dialog));
    EXPECT_FALSE(dialog->isModal());
    return *dialog;
  }
  static void choose(ExportDialog& dialog, const std::vector<const char*>& forms) {
    for (const char* name : {"opencv", "ros", "json", "zip"}) {
      auto* box = dialog.findChild<QCheckBox*>(QLatin1String(name));
      const bool is_wanted = std::any_of(
          forms.begin(), forms.end(), [&](const char* form) { return std::string(form) == name; });
      if (box->isChecked() != is_wanted) QTest::keyClick(box, Qt::Key_Space);
    }
  }
  static QLineEdit& field(ExportDialog& dialog, const char* name) {
    for (QLineEdit* line : dialog.findChildren<QLineEdit*>())
      if (line->accessibleName() == QLatin1String(name)) return *line;
    throw std::runtime_error(name);
  }
  static QPushButton& button(ExportDialog& dialog, const char* text) {
    for (QPushButton* one : dialog.findChildren<QPushButton*>())
      if (one->text().remove(QLatin1Char('&')) == QLatin1String(text)) return *one;
    throw std::runtime_error(text);
  }
  static std::string told(ExportDialog& dialog) {
    std::string words;
    for (const Problem& row : dialog.findChild<ProblemList*>()->problems())
      words += row.what.toStdString() + " " + row.advice.toStdString() + "\n";
    return words;
  }
  TemporaryFolder folder_;
  std::unique_ptr<Studio> studio_;
};

TEST_F(ExportTest, WritesTheSameBytesAsTheCommandItCopies) {
  ExportDialog& dialog = open();
  choose(dialog, {"opencv", "ros", "json", "zip"});
  const fs::path by_hand = folder_ / "by hand's";
  field(dialog, "Folder for the files").setText(QString::fromStdString(by_hand.string()));
  button(dialog, "Copy as command line").click();
  const std::string command = QGuiApplication::clipboard()->text().toStdString();
  EXPECT_EQ(command, dialog.command_line().toStdString());
  EXPECT_THAT(command, HasSubstr("--to opencv,ros,json,zip"));
  QTest::keyClick(&dialog, Qt::Key_Return);
  EXPECT_FALSE(button(dialog, "Export").isEnabled());
  ASSERT_TRUE(wait_until([&] { return !told(dialog).empty(); }));
  EXPECT_THAT(told(dialog),
              HasSubstr("Written: camera.opencv.yaml, camera_info.yaml, parameters.yaml, "
                        "calibration.json, finger.zip."));
  EXPECT_EQ(dialog.findChild<ProblemList*>()->problems().front().meaning, Meaning::kGood);
  EXPECT_EQ(dialog.findChild<ProblemList*>()->problems().front().action, "Open the folder");
  EXPECT_TRUE(button(dialog, "Export").isEnabled());
  const auto from_window = contents_of(by_hand);
  EXPECT_EQ(from_window.size(), 5U);
  fs::remove_all(by_hand);
  const fs::path program = fs::path(ALLTACT_PROGRAM).parent_path();
  const ProgramRun run = run_shell("PATH='" + program.string() + "':$PATH " + command);
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_TRUE(contents_of(by_hand) == from_window);
}

TEST_F(ExportTest, TellsInPlaceWhatIsMissingOrWrong) {
  ExportDialog& dialog = open();
  choose(dialog, {});
  EXPECT_FALSE(button(dialog, "Copy as command line").isEnabled());
  button(dialog, "Export").click();
  EXPECT_THAT(told(dialog), HasSubstr("Nothing is selected."));
  choose(dialog, {"json"});
  field(dialog, "Folder for the files").setText(QString());
  button(dialog, "Export").click();
  EXPECT_THAT(told(dialog), HasSubstr("No folder is chosen."));
  write_text(folder_ / "file", "");
  field(dialog, "Folder for the files")
      .setText(QString::fromStdString((folder_ / "file/out").string()));
  button(dialog, "Export").click();
  ASSERT_TRUE(wait_until([&] { return told(dialog).find("Try: ") != std::string::npos; }));
  EXPECT_THAT(told(dialog), HasSubstr((folder_ / "file/out").string()));
  EXPECT_TRUE(button(dialog, "Export").isEnabled());
}

TEST_F(ExportTest, StopLeavesNoHalfFile) {
  const fs::path finger = folder_ / "large";
  fs::copy(MadeFingers::get().calibrated(), finger);
  std::string noise(40'000'000, '\0');
  std::uint32_t state = 1;
  for (char& byte : noise) byte = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24);
  write_text(finger / "notes.txt", noise);
  ExportDialog& dialog = open(finger);
  choose(dialog, {"zip"});
  const fs::path out = folder_ / "large-export";
  EXPECT_EQ(field(dialog, "Folder for the files").text().toStdString(), out.string());
  button(dialog, "Export").click();
  auto* progress = dialog.findChild<QProgressBar*>();
  ASSERT_TRUE(wait_until([&] { return progress->value() > 0; }));
  button(dialog, "Stop").click();
  ASSERT_TRUE(wait_until([&] { return !told(dialog).empty(); }));
  EXPECT_THAT(told(dialog), HasSubstr("stopped"));
  EXPECT_TRUE(contents_of(out).empty());
  EXPECT_FALSE(progress->isVisible());
}

TEST_F(ExportTest, IsOfferedOnlyForAnOpenFinger) {
  studio_ = std::make_unique<Studio>();
  QTest::keyClick(&studio_->window(), Qt::Key_E, Qt::ControlModifier);
  EXPECT_EQ(studio_->window().findChild<ExportDialog*>(), nullptr);
  studio_->window().open_finger(MadeFingers::get().calibrated());
  QTest::keyClick(&studio_->window(), Qt::Key_E, Qt::ControlModifier);
  EXPECT_NE(studio_->window().findChild<ExportDialog*>(), nullptr);
}

}  // namespace
}  // namespace alltact::test
