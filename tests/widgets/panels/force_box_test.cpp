// The force in figures and over time.
#include "widgets/panels/force_box.h"

#include "widgets/live/touch_history.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;
using testing::Not;

FrameResult pressed(double time_s, bool is_in_range = true) {
  FrameResult result;
  Force force;
  force.axes = 2;
  force.force_N = {2 + std::sin(time_s), -1, 0};
  force.half_95_N = {0.25, 0.125, 0};
  force.in_range = is_in_range;
  result.force = force;
  return result;
}

TouchHistory half_a_minute() {
  TouchHistory history;
  for (int i = 0; i <= 900; ++i) history.add(pressed(i / 30.0), i / 30.0);
  return history;
}

class ForceBoxTest : public testing::Test {
 protected:
  std::string text(const char* label) {
    for (const QLabel* one : box_.findChildren<QLabel*>())
      if (one->accessibleName() == QLatin1String(label)) return one->text().toStdString();
    ADD_FAILURE() << "no label " << label;
    return {};
  }
  QPushButton& button(const char* name) {
    for (QPushButton* one : box_.findChildren<QPushButton*>())
      if (one->text().remove(QLatin1Char('&')) == QLatin1String(name)) return *one;
    throw std::runtime_error(name);
  }
  void show() {
    box_.resize(320, 360);
    box_.show();
    QTest::qWait(2 * ForceBox::kDrawInterval_ms);
  }
  void show(const ShownForce& shown) {
    shown_ = shown;
    show();
    box_.schedule_update();
    QTest::qWait(2 * ForceBox::kDrawInterval_ms);
  }
  ShownForce shown_;
  ForceBox box_{[this] { return shown_; }};
};

TEST_F(ForceBoxTest, TellsAxesWithIntervals) {
  const TouchHistory history = half_a_minute();
  show({pressed(30).force, &history, {}, true, {}});
  EXPECT_THAT(text("Force now"), HasSubstr("1.01 ± 0.25 N"));  // 2 + sin 30
  EXPECT_THAT(text("Force now"), HasSubstr("-1.00 ± 0.13 N"));
  EXPECT_THAT(text("Force now"), Not(HasSubstr("Fz")));
  EXPECT_THAT(text("Zero of the forces"), HasSubstr("the model's own"));
  EXPECT_TRUE(button("Re-zero").isEnabled());
  EXPECT_FALSE(button("As measured").isEnabled());
}

TEST_F(ForceBoxTest, CountsFromAZeroAndSaysSinceWhen) {
  const TouchHistory history = half_a_minute();
  SessionZero zero;
  zero.zero.force_N = {2, -1, 0};
  zero.zero.half_95_N = {0.25, 0.125, 0};
  zero.since = QDateTime(QDate(2026, 11, 23), QTime(14, 5, 9));
  show({pressed(30).force, &history, zero, true, {}});
  EXPECT_THAT(text("Force now"), HasSubstr("-0.99 ± 0.35 N"));  // 0.25 times the root of 2
  EXPECT_THAT(text("Force now"), HasSubstr("0.00 ± 0.18 N"));
  EXPECT_THAT(text("Force now"), Not(HasSubstr("-0.00")));
  EXPECT_THAT(text("Zero of the forces"), HasSubstr("14:05:09"));
  EXPECT_TRUE(button("As measured").isEnabled());
  EXPECT_LE(box_.plot().span_N().first, -1.35);
  EXPECT_GE(box_.plot().span_N().second, 1.35);
}

TEST_F(ForceBoxTest, FlagsAForceOutOfRangeAndTakesItForNoZero) {
  TouchHistory history;
  history.add(pressed(1, false), 1);
  show({pressed(1, false).force, &history, {}, true, {}});
  EXPECT_THAT(text("Force now"), HasSubstr("Out of range"));
  EXPECT_THAT(text("Force now"), Not(HasSubstr("±")));
  EXPECT_FALSE(button("Re-zero").isEnabled());
}

TEST_F(ForceBoxTest, SaysWhyThereIsNone) {
  const TouchHistory history;
  show({std::nullopt, &history, {}, true, QStringLiteral("no model: alltact force")});
  EXPECT_EQ(text("Force now"), "no model: alltact force");
  EXPECT_FALSE(box_.plot().isVisible());
  EXPECT_FALSE(button("Re-zero").isVisible());
}

TEST_F(ForceBoxTest, ARecordingHasNoZero) {
  const TouchHistory history = half_a_minute();
  show({pressed(30).force, &history, {}, false, {}});
  EXPECT_FALSE(button("Re-zero").isEnabled());
}

TEST_F(ForceBoxTest, DrawsFiveTimesASecondHoweverManyFramesCome) {
  TouchHistory history = half_a_minute();
  shown_ = {pressed(30).force, &history, {}, true, {}};
  show();
  const int before = box_.drawings();
  QElapsedTimer clock;
  clock.start();
  int frames = 0;
  while (clock.elapsed() < 1000) {
    history.add(pressed(30 + 1e-3 * frames), 30 + 1e-3 * frames);
    ++frames;
    box_.schedule_update();
    QTest::qWait(1);
  }
  // The clock runs on while the last one waits.
  EXPECT_LE(box_.drawings() - before, 1 + clock.elapsed() / ForceBox::kDrawInterval_ms);
  EXPECT_GE(box_.drawings() - before, 2);
}

TEST_F(ForceBoxTest, KeepsItsHeightWhileForcesComeAndGoOutOfRange) {
  const TouchHistory history = half_a_minute();
  show({pressed(30).force, &history, {}, true, {}});
  const int before = box_.sizeHint().height();
  show({pressed(30, false).force, &history, {}, true, {}});
  EXPECT_EQ(box_.sizeHint().height(), before);
}

TEST_F(ForceBoxTest, HiddenItAsksNothing) {
  const int before = box_.drawings();
  for (int i = 0; i < 10; ++i) box_.schedule_update();
  QTest::qWait(3 * ForceBox::kDrawInterval_ms);
  EXPECT_EQ(box_.drawings(), before);
}

/// Pixels that differ by more than a shade.
int unlike(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 4;
  return count;
}

TEST(ForcePlotTest, DrawsIntervalsContactsSlipAndWhatIsOutOfRange) {
  ForcePlot plot;
  const QSize size(400, 200);
  const auto drawn = [&](const TouchHistory& history, const std::optional<ForceZero>& zero = {}) {
    plot.set_data(history, zero);
    return plot.image(size);
  };
  const auto made = [](double half, bool is_touched, bool is_slipping, bool is_in_range) {
    TouchHistory history;
    for (int i = 0; i <= 900; ++i) {
      FrameResult result = pressed(i / 30.0, is_in_range || i < 600);
      result.force->half_95_N = {half, half, 0};
      if (is_touched && i > 300 && i < 600) {
        result.contact = FingerContact();
        result.contact->is_slipping = is_slipping;
      }
      history.add(result, i / 30.0);
    }
    return history;
  };
  const QImage plain = drawn(made(0.01, false, false, true));
  EXPECT_GT(unlike(plain, drawn(made(0.3, false, false, true))), 1000);
  const QImage touched = drawn(made(0.01, true, false, true));
  EXPECT_GT(unlike(plain, touched), 3000);
  EXPECT_GT(unlike(touched, drawn(made(0.01, true, true, true))), 500);
  EXPECT_GT(unlike(plain, drawn(made(0.01, false, false, false))), 200);
  EXPECT_GT(unlike(plain, drawn(TouchHistory())), 500);
  ForceZero zero;
  zero.force_N = {2, -1, 0};
  EXPECT_GT(unlike(plain, drawn(made(0.01, false, false, true), zero)), 500);
}

TEST(ForcePlotTest, AReadingOutOfRangeDoesNotSqueezeTheOthers) {
  TouchHistory history = half_a_minute();
  FrameResult mad = pressed(31, false);
  mad.force->force_N = {900, 0, 0};
  history.add(mad, 30.5);
  ForcePlot plot;
  plot.set_data(history, std::nullopt);
  static_cast<void>(plot.image({300, 160}));
  EXPECT_LE(plot.span_N().second, 5);
  EXPECT_GE(plot.span_N().second, 3.25);
  EXPECT_LE(plot.span_N().first, -1.125);
}

TEST(ContactWordsTest, TellWhereHowAndThatItSlips) {
  FrameResult result;
  FingerContact contact;
  contact.face = PushedFace::kBack;
  contact.direction = Eigen::Vector3d(0, 0.6, -0.8);
  contact.direction_sd_deg = 2.34;
  contact.position = PositionOnFinger{46.214, -0.001, 0.806, 0.12, 0.05, 0.021};
  contact.held_s = 1.26;
  contact.is_slipping = true;
  result.contact = contact;
  TouchHistory history;
  history.add(result, 10);
  const auto words_of = [&] {  // "1.3 s" never breaks
    return contact_words(result, &history)
        .replace(QChar(QChar::Nbsp), QLatin1Char(' '))
        .toStdString();
  };
  const std::string text = words_of();
  for (const char* words : {"from the back", "for 1.3 s", "46.21 ± 0.12 mm", ">0.00 ± 0.05 mm",
                            "0.81 ± 0.02 mm", "x 0.00, y 0.60, z -0.80 ± 2.3°", "slips"})
    EXPECT_THAT(text, HasSubstr(words));
  result.contact.reset();
  result.reference = Reference();
  history.add(result, 12);
  const std::string after = words_of();
  EXPECT_THAT(after, HasSubstr("Nothing touches the finger."));
  EXPECT_THAT(after, HasSubstr("lasted 1.3 s and ended 2.0 s ago"));
  EXPECT_THAT(after, HasSubstr("It slipped."));
  result.reference.reset();
  EXPECT_THAT(contact_words(result, nullptr).toStdString(), HasSubstr("reference recording"));
  contact = {};
  contact.no_position = en::say("the visible part of the contact face is not indented");
  result.contact = contact;
  const std::string bent = contact_words(result, nullptr).toStdString();
  EXPECT_THAT(bent, HasSubstr("Pushed from the contact face"));
  EXPECT_EQ(bent.find("Contact on"), std::string::npos) << "no contact is seen there";
  EXPECT_EQ(number_and_sd(-0.001, 0.002, 2).toStdString(), "0.00 ± under 0.01");
  EXPECT_EQ(number_and_sd(17.549, 0.0, 3).toStdString(), "17.549 ± unknown");
  EXPECT_EQ(limit_and_sd(1.5, 0.04, 2).toStdString(), "at least 1.50 ± 0.04");
  EXPECT_EQ(limit_and_sd(-1.5, {}, 2).toStdString(), "at most -1.50");
}

}  // namespace
}  // namespace alltact::test
