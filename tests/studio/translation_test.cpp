// Every text can be translated, is translated, and has room for longer words.
#include "tests/studio/calibrate_rig.h"
#include "tests/support/program.h"
#include "tests/support/source_texts.h"
#include "tests/support/ts_file.h"
#include "tests/support/words_left.h"
#include "widgets/shell/export_dialog.h"
#include "widgets/shell/new_finger_dialog.h"
#include "widgets/shell/settings_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTranslator>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

const fs::path kTop = ALLTACT_SOURCE_DIR;

QStringList places_in(const QString& text) {
  static const QRegularExpression form(QStringLiteral("%(n|[1-9])"));
  QStringList places;
  for (auto found = form.globalMatch(text); found.hasNext();) places << found.next().captured();
  places.removeDuplicates();
  places.sort();
  return places;
}

/// The parts that the holes {}, {0:.2f} and so on of a template stand for.
std::multiset<int> holes_in(QString text) {
  static const QRegularExpression form(QStringLiteral("\\{([0-9]*)(:[^{}]*)?\\}"));
  text.remove(QStringLiteral("{{")).remove(QStringLiteral("}}"));
  std::multiset<int> holes;
  int next = 0;
  for (auto found = form.globalMatch(text); found.hasNext();) {
    const QString number = found.next().captured(1);
    holes.insert(number.isEmpty() ? next++ : number.toInt());
  }
  EXPECT_EQ(static_cast<qsizetype>(holes.size()), text.count(QLatin1Char('{')))
      << text.toStdString();
  return holes;
}

/// What the window says, and what the libraries say in it.
const char* const kSpoken[] = {"core", "calibration", "widgets", "app/studio"};

/// lupdate's look at files or folders: `ts`, brought up to date with them.
std::vector<TsMessage> looked_at(const std::string& sources, const fs::path& ts) {
  const ProgramRun run = run_shell("cd '" + kTop.string() + "' && " + ALLTACT_LUPDATE +
                                   " -silent -no-obsolete -locations none -I . "
                                   "-tr-function-alias tr+=say,tr+=count,tr+=word " +
                                   sources + " -ts '" + ts.string() + "'");
  EXPECT_EQ(run.status, 0) << run.errors;
  return messages_of(ts);
}

std::string all_spoken() {
  std::string folders;
  for (const char* folder : kSpoken) folders += std::string(folder) + " ";
  return folders;
}

class Language : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] std::string name() const { return std::string("alltact_") + GetParam() + ".ts"; }
};
INSTANTIATE_TEST_SUITE_P(Ts, Language, testing::Values("de", "zh_CN"));

TEST_P(Language, IsCompleteAndKeepsWhatIsFilledIn) {
  const auto messages = messages_of(ts_file(GetParam()));
  EXPECT_GT(messages.size(), 200U);
  for (const TsMessage& message : messages) {
    EXPECT_TRUE(message.is_finished) << message.source.toStdString();
    ASSERT_FALSE(message.translations.empty()) << message.source.toStdString();
    EXPECT_EQ(places_in(message.translations.first()), places_in(message.source))
        << message.source.toStdString();
  }
}

TEST_P(Language, FillsEveryHoleThatIsSaid) {
  int counted = 0, reported = 0;
  for (const TsMessage& message : messages_of(ts_file(GetParam()))) {
    if (message.context != QLatin1String(kSaidContext)) continue;
    ++reported;
    const std::string where = message.source.toStdString();
    const auto holes = holes_in(message.source);
    for (const QString& form : message.translations) {
      EXPECT_EQ(holes_in(form), holes) << where << "\n" << form.toStdString();
      EXPECT_FALSE(form.trimmed().isEmpty()) << where;
    }
    if (!message.is_counted) {
      EXPECT_EQ(message.translations.size(), 1) << where;
      continue;
    }
    ++counted;
    EXPECT_EQ(message.translations.size(), GetParam() == std::string("de") ? 2 : 1) << where;
    EXPECT_EQ(holes_in(message.comment), holes) << where;
    EXPECT_GT(holes.count(0), 0U) << "says no count: " << where;
    for (const QString& form : message.translations + QStringList{message.source})
      EXPECT_FALSE(form.contains(QLatin1String("%n"))) << "Qt fills this in: " << where;
  }
  EXPECT_GT(reported, 700);
  EXPECT_GT(counted, 2);
}

/// But for versions, and for what is typed into files and commands, which have a point.
TEST(Translations, WriteNumbersWithTheLanguagesDecimalMark) {
  static const QRegularExpression number(QStringLiteral("[0-9]\\.[0-9]"));
  static const QRegularExpression typed(
      QStringLiteral("OpenGL|OpenCV|for example|such as|e\\.g\\.|with a point|\\[|=|half_mm|"
                     "must be a (number|column)|1 for air|x/y/z|'y 1\\.2 N'"));
  int numbers = 0;
  for (const TsMessage& message : messages_of(ts_file("de")))
    for (const QString& text : message.translations) {
      static const QRegularExpression holes(QStringLiteral("\\{[^}]*\\}"));
      numbers += QRegularExpression(QStringLiteral("[0-9],[0-9]")).match(text).hasMatch() ? 1 : 0;
      if (typed.match(message.source).hasMatch()) continue;
      EXPECT_FALSE(number.match(QString(text).remove(holes)).hasMatch()) << text.toStdString();
    }
  EXPECT_GE(numbers, 4);
}

/// "Prüfen" is the check of a finger; what is done on the page Inspect has the page's name.
TEST(Translations, HaveOneWordForInspecting) {
  int words = 0;
  for (const TsMessage& message : messages_of(ts_file("de"))) {
    if (message.context != QLatin1String("alltact::InspectPage")) continue;
    for (const QString& text : message.translations) {
      EXPECT_FALSE(text.contains(QStringLiteral("prüfen"), Qt::CaseInsensitive))
          << text.toStdString();
      words += text.contains(QStringLiteral("auswerten"), Qt::CaseInsensitive) ? 1 : 0;
    }
  }
  EXPECT_GE(words, 3);
}

TEST_P(Language, HoldsEveryTextOfTheProgramAndNoOther) {
  const TemporaryFolder folder;
  fs::copy(kTop / "translations" / name(), folder / name());
  const auto now = looked_at(all_spoken(), folder / name());
  const auto kept = messages_of(kTop / "translations" / name());
  for (const TsMessage& message : now)
    EXPECT_TRUE(message.is_finished) << "new: " << message.source.toStdString();
  EXPECT_EQ(now.size(), kept.size())
      << "translations/" << name() << " holds texts that nothing says";
}

TEST_P(Language, MissesATemplateOfWhichOneLetterIsOther) {
  const TemporaryFolder folder;
  const fs::path source = kTop / "core/camera/camera.cpp";
  const auto reported = said_in(source);
  ASSERT_GT(reported.size(), 3U);
  for (const SaidText& text : {reported.front(), reported.back()}) {
    SCOPED_TRACE(text.words);
    std::string changed = text_of(source);
    const std::size_t begin = changed.find('"' + text.words.substr(0, 12));
    ASSERT_NE(begin, std::string::npos);
    changed[begin + 1] = '#';
    write_text(folder / "camera.cpp", changed);
    fs::copy_file(kTop / "translations" / name(), folder / name(),
                  fs::copy_options::overwrite_existing);
    QStringList unknown;
    for (const TsMessage& message :
         looked_at("'" + (folder / "camera.cpp").string() + "'", folder / name()))
      if (!message.is_finished) unknown << message.source;
    EXPECT_EQ(unknown, QStringList{QString::fromStdString('#' + text.words.substr(1))});
  }
}

TEST(Translations, FindWhateverIsSaid) {
  const TemporaryFolder folder;
  using Said = std::set<std::pair<std::string, std::string>>;
  Said found, reported;
  for (const TsMessage& message : looked_at(all_spoken(), folder / "found.ts")) {
    const std::string words = message.source.toStdString();
    EXPECT_FALSE(message.context.isEmpty())
        << "said within another message, directly behind its template: give it a name: " << words;
    EXPECT_NE(message.context, QLatin1String("en"))
        << "lupdate takes a constant of std:: with '=' above it for a class: write {} there: "
        << words;
    if (message.context == QLatin1String(kSaidContext))
      found.emplace(words, message.comment.toStdString());
  }
  for (const char* sources : kSpoken)
    for (const SaidText& text : said_below(kTop / sources)) {
      EXPECT_NE(text.words, "") << text.file << ":" << text.line << ": says no literal";
      if (text.words.empty()) continue;
      reported.emplace(text.words, text.comment);
      EXPECT_TRUE(found.contains({text.words, text.comment}))
          << text.file << ":" << text.line << ": lupdate overlooks: " << text.words;
    }
  for (const auto& text : found)
    EXPECT_TRUE(reported.contains(text)) << "the sources do not say: " << text.first;
  EXPECT_GT(reported.size(), 700U);
}

/// Says everything a third longer and between brackets.
class Pseudo : public QTranslator {
 public:
  static constexpr QChar kOpen{0x27e6}, kClose{0x27e7};
  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char* context, const char* source,
                                  const char* /*disambiguation*/, int n) const override {
    if (!QByteArray(context).startsWith("alltact")) return {};
    QString text = QString::fromUtf8(source);
    // Blanks of another kind, so that what a library said and nobody translated is told apart.
    if (QByteArray(context) == kSaidContext) text.replace(QLatin1Char(' '), QChar{0x2002});
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
  /// The window's own commands are the same in all languages.
  static bool is_command(const QString& text) {
    return text.startsWith(QLatin1String("alltact calibrate ")) ||
           text.startsWith(QLatin1String("alltact export "));
  }
  static void expect_translated(const QString& text, const char* what) {
    if (!is_text(text) || is_command(text)) return;
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
  for (const char* place : {"live", "record", "inspect", "accuracy"}) {
    studio.window().go_to(place);
    QTest::qWait(600);
    look_through(studio.window());
    std::filesystem::create_directories(ALLTACT_SCREENS);
    studio.window().grab().save(
        QStringLiteral(ALLTACT_SCREENS "/pseudo_%1.png").arg(QLatin1String(place)));
  }
  NewFingerDialog finger;
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
  rig.collection().set_radius(4);
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
