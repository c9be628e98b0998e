// Somebody who has never seen the window, and reads nothing but it: which button is the largest,
// what the guide's line says, what a field asks for. Every click, every key and every line typed
// counts.
#include "tests/studio/calibrate_rig.h"
#include "widgets/shell/finger_card.h"
#include "widgets/theme.h"

#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QRegularExpression>
#include <cstdlib>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr int kMostActions = 9;

/// Knows the window only: it is handed no place, no page and no widget by name.
class Newcomer {
 public:
  explicit Newcomer(QWidget& window) : window_(window) { since_.start(); }

  [[nodiscard]] const QStringList& actions() const { return actions_; }

  /// All that can be read now, a text each, from the top.
  [[nodiscard]] QStringList read() const {
    QStringList texts;
    for (const QLabel* label : window_.findChildren<QLabel*>())
      if (label->isVisible() && !label->text().isEmpty()) texts << label->text();
    return texts;
  }
  [[nodiscard]] bool reads(const QString& words) const {
    for (const QString& text : read())
      if (text.contains(words)) return true;
    return false;
  }
  /// What the line says that leads through the day.
  [[nodiscard]] QString guided_by() const {
    static const QRegularExpression step(QStringLiteral("^[0-9] of [0-9]: "));
    for (const QString& text : read())
      if (text.contains(step)) return text;
    return {};
  }
  /// The one that stands out: largest, and of those the upper one.
  [[nodiscard]] QPushButton* standing_out() const {
    QPushButton* best = nullptr;
    const auto top = [this](const QWidget* widget) {
      return widget->mapTo(&window_, QPoint()).y();
    };
    for (auto* button : window_.findChildren<QPushButton*>()) {
      if (!button->isVisible() || !button->isEnabled() || !is_primary(*button)) continue;
      if (best == nullptr || button->height() > best->height() ||
          (button->height() == best->height() && top(button) < top(best)))
        best = button;
    }
    return best;
  }
  void click(QPushButton& button) {
    note(button.text().remove(QLatin1Char('&')));
    QTest::mouseClick(&button, Qt::LeftButton);
  }
  /// A number that the guide tells for a quantity, into the field of that name.
  bool type_what_is_asked_for(const QString& quantity) {
    const QRegularExpression told(quantity + QStringLiteral(", ([0-9.]+) mm"),
                                  QRegularExpression::CaseInsensitiveOption);
    const auto number = told.match(guided_by());
    if (!number.hasMatch()) return false;
    for (auto* field : window_.findChildren<QDoubleSpinBox*>()) {
      const bool is_it = field->isVisible() && field->isEnabled() &&
                         field->accessibleName().compare(quantity, Qt::CaseInsensitive) == 0;
      if (!is_it || field->value() > 0) continue;
      note(quantity + QLatin1Char(' ') + number.captured(1));
      QTest::mouseClick(field, Qt::LeftButton);
      field->selectAll();
      QTest::keyClicks(field, number.captured(1));
      QTest::keyClick(field, Qt::Key_Return);
      return true;
    }
    return false;
  }

 private:
  void note(const QString& action) {
    actions_ << QStringLiteral("%1 s %2").arg(1e-3 * since_.elapsed(), 0, 'f', 0).arg(action);
  }

  QWidget& window_;
  QStringList actions_;
  QElapsedTimer since_;
};

/// As wait_until, as often as somebody looks: reading all of a window takes its time.
bool looks_until(const std::function<bool()>& is_so, int patience_ms) {
  QElapsedTimer since;
  since.start();
  while (!is_so()) {
    if (since.elapsed() > patience_ms) return false;
    QTest::qWait(150);
  }
  return true;
}

QString verdict_read_by(const Newcomer& newcomer) {
  for (const Grade grade : {Grade::kGood, Grade::kUsable, Grade::kUnproven, Grade::kUnfit}) {
    const QRegularExpression headline("^" + QRegularExpression::escape(grade_text(grade)) +
                                      "(, \u00b1[0-9.]+ mm)?$");
    for (const QString& text : newcomer.read())
      if (headline.match(text).hasMatch()) return text;
  }
  return {};
}

TEST(FirstUser, ReachesAVerdictByReadingOnlyWhatIsOnTheScreen) {
  if (std::getenv("ALLTACT_SLOW") == nullptr) GTEST_SKIP() << "long: set ALLTACT_SLOW";
  const PressesWhenStill unchanged;
  Studio studio;
  Newcomer newcomer(studio.window());
  QElapsedTimer recording, all;
  all.start();
  const auto is_busy = [&] {
    return newcomer.reads("Recording</b>") && recording.elapsed() < 30000 &&
           !newcomer.reads("Enough: all directions");
  };
  for (int turn = 0; turn < 4 * kMostActions && verdict_read_by(newcomer).isEmpty(); ++turn) {
    if (newcomer.type_what_is_asked_for("Ball's radius")) {
      QTest::qWait(400);  // what a hand takes
      continue;
    }
    ASSERT_TRUE(
        looks_until([&] { return newcomer.standing_out() != nullptr && !is_busy(); }, 240000))
        << "nothing stands out after: " << newcomer.actions().join("; ").toStdString() << "\n"
        << studio.problems() << newcomer.guided_by().toStdString();
    QPushButton& next = *newcomer.standing_out();
    if (next.text().contains("Start")) recording.start();
    newcomer.click(next);
    QTest::qWait(400);  // what a hand takes
  }
  std::printf("[ figures  ] %.0f s, %d actions: %s; verdict: %s\n", 1e-3 * all.elapsed(),
              static_cast<int>(newcomer.actions().size()),
              newcomer.actions().join("; ").toUtf8().constData(),
              verdict_read_by(newcomer).toUtf8().constData());
  EXPECT_FALSE(verdict_read_by(newcomer).isEmpty()) << studio.problems();
  EXPECT_LE(newcomer.actions().size(), kMostActions);
  // And it measures where the scene presses its ball in, by 0.9 mm along the face's normal. Near
  // the tip, which half a minute of recording does not cover well, it may see what is not there.
  const auto* calibrated = studio.window().findChild<CalibratePage*>()->run().result().get();
  ASSERT_NE(calibrated, nullptr);
  double deepest_mm = 0;
  const auto look = [&] {
    for (const ContactRegion& region : studio.session().view()->result.regions)
      if (region.position_mm.z() < 75) deepest_mm = std::max(deepest_mm, region.deepest_mm);
    return deepest_mm > 0.7;
  };
  EXPECT_TRUE(wait_until(look, 60000));
  wait_until([&] { return !look(); }, 1500);  // to the depth at which the ball stays
  std::printf("[ figures  ] deepest %.3f mm; %s\n", deepest_mm,
              calibrated->verdict.sentence.english().c_str());
  // Which moments were caught decides; one calibration of them is a draw, and so is a reading.
  EXPECT_NEAR(deepest_mm, 0.9, 0.15 + 2 * calibrated->verdict.error_mm);
}

}  // namespace
}  // namespace alltact::test
