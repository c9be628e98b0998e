// What holds for the whole window: it never blocks, always closes, and everyone can use it.
#include "app/studio/main_window.h"
#include "core/open/open_source.h"
#include "tests/studio/loop_watch_rig.h"
#include "tests/studio/studio_rig.h"
#include "tests/support/program.h"
#include "widgets/shell/export_dialog.h"
#include "widgets/shell/new_finger_dialog.h"
#include "widgets/shell/settings_dialog.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QTimer>
#include <chrono>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A whole use of the window.
void use_window(LoopWatch& watch) {
  Studio studio;
  QTest::qWait(300);
  // Qt paints a first window in software; from here on nothing may hold the loop.
  const auto during = [&](const char* what, const std::function<void()>& act, int wait_ms) {
    watch.during(what, act, wait_ms);
  };
  MainWindow& window = studio.window();
  const auto& made = MadeFingers::get();
  during(
      "opening a finger", [&] { window.open_finger(made.calibrated()); }, 300);
  during(
      "opening a source", [&] { window.open_source({made.touched()}); }, 300);
  ASSERT_TRUE(studio.wait_for_picture());
  during(
      "the live picture", [] {}, 1500);
  during(
      "another place", [&] { window.go_to("record"); }, 300);
  during(
      "recording", [&] { studio.session().start_recording(studio.folder() / "a.mkv"); }, 500);
  during(
      "the recording's end", [&] { studio.session().stop_recording(); }, 300);
  during(
      "the first place", [&] { window.go_to("live"); }, 300);
  during(
      "another finger", [&] { window.open_finger(made.described()); }, 500);
  during(
      "undo", [&] { window.undo_stack().undo(); }, 500);
  ProgramAppearance appearance;
  during(
      "a dark window",
      [&] {
        appearance.apply({Theme::kDark, QStringLiteral("en")});
      },
      300);
  during(
      "German",
      [&] {
        appearance.apply({Theme::kDark, QStringLiteral("de")});
      },
      300);
  appearance.apply({Theme::kLight, QStringLiteral("en")});
  QTest::qWait(100);
  const auto choose = [&](const char* entry) {
    for (QAction* action : window.findChildren<QAction*>())
      if (action->text().remove(QLatin1Char('&')) == QString::fromUtf8(entry))
        return action->trigger();
    ADD_FAILURE() << "no entry " << entry;
  };
  for (const char* entry : {"Video file…", "Folder of images…", "Open finger…", "New finger…",
                            "Settings…", "Help on this page", "About AllTact Studio"}) {
    during(
        entry, [&] { choose(entry); }, 200);
    for (QDialog* dialog : window.findChildren<QDialog*>()) dialog->close();
    QTest::qWait(10);
  }
  during(
      "no such source", [&] { window.open_source({"/nowhere.mkv"}); }, 300);
  during(
      "no source", [&] { window.open_source({}); }, 300);
}

TEST(Window, NeverBlocksForMoreThan30Milliseconds) {
  static_cast<void>(MadeFingers::get());
  LoopWatch::expect_free(use_window);
}

class Closing : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(State, Closing,
                         testing::Values("empty", "opening", "live", "loading", "recording",
                                         "failed", "record_place", "stuck"),
                         [](const auto& state) { return std::string(state.param); });

TEST_P(Closing, TakesLessThanASecond) {
  static_cast<void>(MadeFingers::get());
  const std::string state = GetParam();
  StudioOptions options;
  if (state == "stuck")  // a driver that does not answer
    options.opener = [](const auto&, const auto&) -> Result<std::unique_ptr<Source>> {
      std::this_thread::sleep_for(std::chrono::seconds(3));
      return Error{en::say("too late"), "", ""};
    };
  if (state != "empty") options.source = {MadeFingers::get().touched()};
  if (state == "failed") options.source = {"/nowhere.mkv"};
  if (state == "loading") options.finger = MadeFingers::get().calibrated();
  auto studio = std::make_unique<Studio>(options);
  const TemporaryFolder folder;
  if (state == "live" || state == "recording" || state == "record_place") {
    ASSERT_TRUE(studio->wait_for_picture());
  }
  if (state == "record_place") studio->window().go_to("record");
  if (state == "recording") {
    studio->session().start_recording(folder / "a.mkv");
    ASSERT_TRUE(
        wait_until([&] { return studio->session().status().recording.counts.recorded > 3; }));
  }
  QElapsedTimer timer;
  timer.start();
  studio->close();
  if (auto* asked = studio->window().findChild<QMessageBox*>())
    for (QAbstractButton* answer : asked->buttons())
      if (asked->buttonRole(answer) == QMessageBox::AcceptRole) answer->click();
  studio.reset();
  EXPECT_LT(timer.elapsed(), 1000);
  if (state == "recording") {
    EXPECT_TRUE(std::filesystem::exists(folder / "a.mkv"));
  }
}

bool is_for_people(const QWidget& widget) {
  const auto* label = qobject_cast<const QLabel*>(&widget);
  if (label != nullptr && label->text().isEmpty() && label->pixmap().isNull())
    return false;  // room for a message
  return widget.isVisible() &&
         (widget.focusPolicy() != Qt::NoFocus || qobject_cast<const ImageView*>(&widget) ||
          qobject_cast<const QAbstractButton*>(&widget)) &&
         // Parts of Qt's own that stand for the whole they belong to.
         !widget.objectName().startsWith(QStringLiteral("qt_")) &&
         qobject_cast<const QAbstractSpinBox*>(widget.parentWidget()) == nullptr &&
         qobject_cast<const QComboBox*>(widget.parentWidget()) == nullptr;
}

void expect_names(const QWidget& root) {
  for (QWidget* widget : root.findChildren<QWidget*>()) {
    if (!is_for_people(*widget) || qobject_cast<QMenuBar*>(widget) != nullptr) continue;
    QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(widget);
    ASSERT_NE(seen, nullptr);
    const auto what = std::string(widget->metaObject()->className()) + " '" +
                      widget->objectName().toStdString() + "'";
    EXPECT_FALSE(seen->text(QAccessible::Name).isEmpty()) << what << " has no name";
    EXPECT_NE(seen->role(), QAccessible::NoRole) << what << " has no role";
    EXPECT_NE(seen->role(), QAccessible::Client) << what << " has no role";
  }
}

TEST(Window, EveryControlHasANameAndARole) {
  Studio studio(simulated());
  ASSERT_TRUE(studio.wait_for_picture());
  expect_names(studio.window());
  for (const char* place : {"calibrate", "record", "accuracy"}) {
    studio.window().go_to(place);
    QTest::qWait(50);
    expect_names(studio.window());
  }
  NewFingerDialog finger;
  finger.show();
  expect_names(finger);
  SettingsDialog settings({}, nullptr);
  settings.show();
  expect_names(settings);
  ExportDialog exported(MadeFingers::get().calibrated());
  exported.show();
  expect_names(exported);
  Studio empty;
  expect_names(empty.window());
}

/// Of buttons that exclude each other Tab goes to the chosen one, arrow keys to the others.
bool is_stop(const QWidget& widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const bool is_one_of_several = button != nullptr && button->group() != nullptr &&
                                 button->group()->exclusive() && !button->isChecked();
  return (widget.focusPolicy() & Qt::TabFocus) != 0 && !is_one_of_several &&
         qobject_cast<const QMenuBar*>(&widget) == nullptr;
}

TEST(Window, EveryControlCanBeReachedByTab) {
  Studio studio(simulated());
  ASSERT_TRUE(studio.wait_for_picture());
  for (const auto& [place, least] : {std::pair{"live", 9U},
                                     {"calibrate", 4U},
                                     {"record", 9U},
                                     {"inspect", 9U},
                                     {"accuracy", 3U}}) {
    studio.window().go_to(place);
    QTest::qWait(300);
    std::set<QWidget*> wanted;
    for (QWidget* widget : studio.window().findChildren<QWidget*>())
      if (is_for_people(*widget) && widget->isEnabled() && is_stop(*widget)) wanted.insert(widget);
    EXPECT_GE(wanted.size(), least) << place;
    studio.window().setFocus();
    for (int i = 0; i < 100; ++i) {
      QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : &studio.window(),
                      Qt::Key_Tab);
      wanted.erase(QApplication::focusWidget());
    }
    for (const QWidget* widget : wanted)
      ADD_FAILURE() << place << ": cannot reach " << widget->metaObject()->className() << " "
                    << widget->accessibleName().toStdString();
  }
}

TEST(Window, ShortcutsAreNotTakenTwice) {
  Studio studio(simulated());
  std::map<QString, QString> taken;
  for (const QAction* action : studio.window().findChildren<QAction*>()) {
    if (action->shortcut().isEmpty()) continue;
    const auto [place, is_new] = taken.emplace(action->shortcut().toString(), action->text());
    EXPECT_TRUE(is_new) << action->shortcut().toString().toStdString() << " is taken by "
                        << place->second.toStdString() << " and " << action->text().toStdString();
  }
  EXPECT_GE(taken.size(), 9U);
}

TEST(NewFinger, IsMadeWithTheSameChecksAsByTheCommandLine) {
  const TemporaryFolder folder;
  Studio studio;
  QTest::keyClick(&studio.window(), Qt::Key_N, Qt::ControlModifier);
  auto* dialog = studio.window().findChild<NewFingerDialog*>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog));
  EXPECT_FALSE(dialog->isModal());
  const auto type = [&](const char* name, const std::string& text) {
    for (QLineEdit* line : dialog->findChildren<QLineEdit*>())
      if (line->accessibleName() == QLatin1String(name)) {
        line->clear();
        QTest::keyClicks(line, QString::fromStdString(text));
      }
  };
  const auto press = [&] {
    for (QPushButton* button : dialog->findChildren<QPushButton*>())
      if (button->text() == QLatin1String("&Make the finger"))
        QTest::mouseClick(button, Qt::LeftButton);
  };
  const auto says = [&](const char* words) {
    return wait_until([&] {
      for (const Problem& problem : dialog->findChild<ProblemList*>()->problems())
        if (problem.what.contains(QLatin1String(words))) return true;
      return false;
    });
  };
  press();
  EXPECT_TRUE(says("No folder is chosen"));
  type("New folder", (folder / "left-07").string());
  type("Camera file", (folder / "none.yaml").string());
  press();
  EXPECT_TRUE(says("none.yaml"));
  type("Camera file", MadeFingers::get().camera().string());
  press();
  ASSERT_TRUE(wait_until([&] {
    const auto& finger = studio.session().status().finger;
    return finger.state == FingerState::kReady && finger.finger->name == "left-07";
  }));
  const auto finger = Finger::load(folder / "left-07");
  ASSERT_TRUE(finger) << finger.error().sentence();
  EXPECT_DOUBLE_EQ(finger->face.width_mm, 24);
  EXPECT_EQ(finger->markers.per_row, 6);
  EXPECT_THAT(studio.problems(), HasSubstr("no reference recording"));
  EXPECT_NE(studio.find<QToolButton>("Finger: left-07"), nullptr);
}

/// What the window's fields show of numbers with decimals.
std::string decimals_in(const QWidget& window) {
  QString all;
  for (const auto* field : window.findChildren<QDoubleSpinBox*>())
    if (field->text() != field->specialValueText()) all += field->text() + QLatin1Char(' ');
  return all.toStdString();
}

TEST(Settings, ThemeAndLanguageChangeAtOnce) {
  Studio studio;
  for (const char* place : {"inspect", "live"}) studio.window().go_to(place);
  QTest::keyClick(&studio.window(), Qt::Key_Comma, Qt::ControlModifier);
  auto* dialog = studio.window().findChild<SettingsDialog*>();
  ASSERT_NE(dialog, nullptr);
  const auto boxes = dialog->findChildren<QComboBox*>();
  ASSERT_EQ(boxes.size(), 2);
  boxes[0]->setCurrentIndex(2);
  EXPECT_TRUE(wait_until([&] { return is_dark(studio.window().palette()); }));
  boxes[0]->setCurrentIndex(1);
  EXPECT_TRUE(wait_until([&] { return !is_dark(studio.window().palette()); }));
  boxes[1]->setCurrentIndex(2);
  QTest::qWait(100);
  EXPECT_NE(studio.find<QPushButton>("Simulierter Finger"), nullptr);
  EXPECT_THAT(decimals_in(studio.window()), AllOf(HasSubstr("1,00"), Not(HasSubstr("1.00"))));
  boxes[1]->setCurrentIndex(3);
  QTest::qWait(100);
  EXPECT_EQ(QLocale().language(), QLocale::Chinese);
  EXPECT_EQ(studio.window().windowTitle(), QString::fromUtf8("AllTact Studio"));
  boxes[1]->setCurrentIndex(1);
  QTest::qWait(100);
  EXPECT_NE(studio.find<QPushButton>("Simulated finger"), nullptr);
  EXPECT_THAT(decimals_in(studio.window()), AllOf(HasSubstr("1.00"), Not(HasSubstr("1,00"))));
}

TEST(Program, SaysHowItIsUsed) {
  const std::string studio = ALLTACT_STUDIO;
  const ProgramRun help = run_shell(studio + " --help");
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.output, HasSubstr("--source"));
  EXPECT_EQ(help.errors, "");
  EXPECT_EQ(run_shell(studio + " --version").status, 0);
  const ProgramRun wrong = run_shell(studio + " --no-such-flag");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.errors, HasSubstr("--no-such-flag"));
  EXPECT_EQ(run_shell(studio + " one two").status, 2);
}

TEST(Program, SaysThatThereIsNoDisplay) {
  const ProgramRun run = run_shell(
      std::string("env -u QT_QPA_PLATFORM -u DISPLAY -u WAYLAND_DISPLAY ") + ALLTACT_STUDIO);
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("no display"));
}

TEST(Program, SaysThatADisplayHasGone) {
  for (const char* display : {"DISPLAY=:5377", "WAYLAND_DISPLAY=wayland-5377"}) {
    const ProgramRun run =
        run_shell(std::string("env -u QT_QPA_PLATFORM -u DISPLAY -u WAYLAND_DISPLAY ") + display +
                  " " + ALLTACT_STUDIO);
    EXPECT_EQ(run.status, 1) << display;
    EXPECT_THAT(run.errors, HasSubstr("There is no display to open a window on."));
    EXPECT_THAT(run.errors, testing::Not(HasSubstr("installing")));
  }
}

TEST(Program, TheEndOfASessionIsNoCrash) {
  const test::TemporaryFolder folder;
  const ProgramRun run =
      run_shell("XDG_DATA_HOME='" + folder.path().string() + "' timeout 4 " + ALLTACT_STUDIO);
  EXPECT_EQ(run.status, 124);
  const auto session = folder / "alltact/alltact-studio";
  EXPECT_TRUE(std::filesystem::exists(session));
  EXPECT_FALSE(std::filesystem::exists(session / "running.lock"));
}

TEST(Program, StartsAndGoesOnUntilItIsEnded) {
  const ProgramRun run = run_shell(std::string("timeout 2 ") + ALLTACT_STUDIO + " --source '" +
                                   MadeFingers::get().bending().string() + "'");
  EXPECT_EQ(run.status, 124) << run.errors;  // timeout's own: it had to end it
}

}  // namespace
}  // namespace alltact::test
