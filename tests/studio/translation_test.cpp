// Every text can be translated, is translated, and has room for longer words.
#include "tests/studio/calibrate_rig.h"
#include "tests/support/program.h"
#include "tests/support/ts_file.h"
#include "tests/support/words_left.h"
#include "widgets/shell/export_dialog.h"
#include "widgets/shell/new_finger_dialog.h"
#include "widgets/shell/settings_dialog.h"
#include "widgets/words/catalogue.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTranslator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

QStringList places_in(const QString& text) {
  static const QRegularExpression form(QStringLiteral("%(n|[1-9])"));
  QStringList places;
  for (auto found = form.globalMatch(text); found.hasNext();) places << found.next().captured();
  places.removeDuplicates();
  places.sort();
  return places;
}

/// What the window says. The report, which the command line writes, is English.
const std::string kSpoken =
    "widgets/calibrating widgets/controls widgets/inspect widgets/live widgets/panels "
    "widgets/picture widgets/places widgets/plots widgets/recording "
    "widgets/report/calibration_figures.cpp "
    "widgets/shell widgets/words app/studio";

class Language : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Ts, Language, testing::Values("de", "zh_CN"));

TEST_P(Language, IsCompleteAndKeepsWhatIsFilledIn) {
  const auto messages = messages_of(ts_file(GetParam()));
  EXPECT_GT(messages.size(), 200U);
  for (const Message& message : messages) {
    EXPECT_TRUE(message.is_finished) << message.source.toStdString();
    ASSERT_FALSE(message.translations.empty()) << message.source.toStdString();
    EXPECT_EQ(places_in(message.translations.first()), places_in(message.source))
        << message.source.toStdString();
  }
}

TEST_P(Language, HoldsEveryTextOfTheProgramAndNoOther) {
  const TemporaryFolder folder;
  const std::string name = std::string("alltact_") + GetParam() + ".ts";
  const std::filesystem::path top = ALLTACT_SOURCE_DIR;
  std::filesystem::copy(top / "translations" / name, folder / name);
  const ProgramRun run = run_shell("cd '" + top.string() + "' && " + ALLTACT_LUPDATE +
                                   " -silent -no-obsolete -locations none -I . " + kSpoken +
                                   " -ts '" + (folder / name).string() + "'");
  ASSERT_EQ(run.status, 0) << run.errors;
  const auto now = messages_of(folder / name), kept = messages_of(top / "translations" / name);
  for (const Message& message : now)
    EXPECT_TRUE(message.is_finished) << "new: " << message.source.toStdString();
  EXPECT_EQ(now.size(), kept.size()) << "translations/" << name << " holds texts that nothing says";
}

/// Says everything a third longer and between brackets.
class Pseudo : public QTranslator {
 public:
  static constexpr QChar kOpen{0x27e6}, kClose{0x27e7};
  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char* context,
                                  const char* source,
                                  const char* /*disambiguation*/,
                                  int n) const override {
    if (!QByteArray(context).startsWith("alltact") && QByteArray(context) != kLibraryContext)
      return {};
    QString text = QString::fromUtf8(source);
    // Blanks of another kind, so that what a library said and nobody translated is told apart.
    if (QByteArray(context) == kLibraryContext) text.replace(QLatin1Char(' '), QChar{0x2002});
    if (n >= 0) text.replace(QLatin1String("%n"), QString::number(n));
    return kOpen + text + QString(text.size() / 3, QLatin1Char('~')) + kClose;
  }
};

/// The window and the libraries share shorter words, such as "calibrate with ball presses".
constexpr qsizetype kTelling = 28;

class PseudoLanguage : public testing::Test {
 protected:
  PseudoLanguage() { QCoreApplication::installTranslator(&pseudo_); }
  ~PseudoLanguage() override { QCoreApplication::removeTranslator(&pseudo_); }

  /// Before the plurals of English, which a window brings.
  void speak() {
    QCoreApplication::removeTranslator(&pseudo_);
    QCoreApplication::installTranslator(&pseudo_);
    QTest::qWait(300);
  }
  static bool is_text(const QString& text) {
    static const QRegularExpression letters(QStringLiteral("[A-Za-z]{2,}"));
    return text.contains(letters);
  }
  static void expect_translated(const QString& text, const char* what) {
    if (!is_text(text)) return;
    EXPECT_TRUE(text.contains(Pseudo::kOpen)) << what << ": " << text.toStdString();
    EXPECT_TRUE(words_left(text, kTelling).isEmpty())
        << what << ": " << text.toStdString() << "\n"
        << words_left(text, kTelling).join("; ").toStdString();
  }
  static void look_through(const QWidget& root) {
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
      if (!widget->isVisible()) continue;
      expect_translated(widget->accessibleName(), "accessible name");
      expect_translated(
          widget->toolTip().startsWith(QLatin1Char('/')) ? QString() : widget->toolTip(),
          "tool tip");
      if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
        const auto* tool = qobject_cast<const QToolButton*>(button);
        // Those with a menu show a finger's or a source's own name.
        if (tool == nullptr || tool->menu() == nullptr) expect_translated(button->text(), "button");
        if (qobject_cast<const QPushButton*>(button) != nullptr) {
          EXPECT_GE(button->width(), button->minimumSizeHint().width())
              << "clipped: " << button->text().toStdString();
        }
      }
      if (const auto* list = qobject_cast<const QListWidget*>(widget))
        for (int i = 0; i < list->count(); ++i) expect_translated(list->item(i)->text(), "item");
      if (const auto* group = qobject_cast<const QGroupBox*>(widget))
        expect_translated(group->title(), "group");
      if (const auto* label = qobject_cast<const QLabel*>(widget)) {
        if (!label->text().startsWith(QLatin1String("alltact calibrate ")))  // a command
          expect_translated(label->text(), "label");
        if (label->wordWrap()) {
          // A label that was just said anew is laid out with the next turns of the loop.
          EXPECT_TRUE(wait_until(
              [&] { return label->height() >= label->heightForWidth(label->width()); }, 2000))
              << "clipped: " << label->text().toStdString();
        }
      }
    }
  }
  Pseudo pseudo_;
};

TEST_F(PseudoLanguage, NothingIsLeftOutAndNothingIsClipped) {
  {
    Studio empty;
    speak();
    look_through(empty.window());
    for (const QAction* action : empty.window().menuBar()->actions()) {
      expect_translated(action->text(), "menu");
      for (const QAction* entry : action->menu()->actions())
        expect_translated(entry->text(), "entry");
    }
  }
  StudioOptions options;
  options.source = {MadeFingers::get().touched()};
  options.finger = MadeFingers::get().calibrated();
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  speak();
  for (const char* place : {"live", "record", "inspect"}) {
    studio.window().go_to(place);
    QTest::qWait(600);
    look_through(studio.window());
    std::filesystem::create_directories(ALLTACT_SCREENS);
    studio.window().grab().save(
        QStringLiteral(ALLTACT_SCREENS "/pseudo_%1.png").arg(QLatin1String(place)));
  }
  NewFingerDialog finger([](const NewFinger&) { return Status(); });
  finger.show();
  QTest::qWait(50);
  look_through(finger);
  ExportDialog exported(MadeFingers::get().calibrated());
  exported.show();
  QTest::qWait(50);
  look_through(exported);
  exported.grab().save(QStringLiteral(ALLTACT_SCREENS "/pseudo_export.png"));
}

TEST_F(PseudoLanguage, NothingIsLeftOutOfCalibrate) {
  CalibrateStudio rig(2);
  rig.open();
  rig.desk().set_radius(4);
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  rig.run().start();
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  speak();
  int step = 0;
  for (auto* button : rig.place().findChild<StepList*>()->findChildren<QToolButton*>()) {
    if (!button->isEnabled()) continue;
    QTest::mouseClick(button, Qt::LeftButton);
    QTest::qWait(300);
    look_through(rig.place());
    rig.studio().window().grab().save(
        QStringLiteral(ALLTACT_SCREENS "/pseudo_calibrate_%1.png").arg(++step));
  }
  EXPECT_EQ(step, 6) << "lens, finger, presses, mapping, verdict, check";
}

TEST_F(PseudoLanguage, NothingIsLeftOutOfWhatIsWrong) {
  StudioOptions options;
  options.source = {"/nowhere/video.mkv"};
  options.finger = "/nowhere/finger";
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] { return !studio.problems().empty(); }));
  speak();
  look_through(studio.window());
}

}  // namespace
}  // namespace alltact::test
