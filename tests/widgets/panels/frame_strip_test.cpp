// What becomes of the frames of a recording, in one strip.
#include "widgets/panels/frame_strip.h"

#include "widgets/theme.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

/// 100 frames: 20 to 29 in contact, 50 left out by the user, from 90 on without a face.
ReferenceReport a_hundred_frames() {
  ReferenceReport report;
  report.uses.assign(100, FrameUse::kRetained);
  std::fill_n(report.uses.begin() + 20, 10, FrameUse::kInContact);
  report.uses[50] = FrameUse::kExcluded;
  std::fill_n(report.uses.begin() + 90, 10, FrameUse::kUnusable);
  ReferenceStretch stretch;
  stretch.first = 20, stretch.last = 29, stretch.darkest = 24;
  stretch.sentence = en::say("frames {} to {}", 20, 29);
  report.stretches = {stretch};
  report.rest_frame = 5;
  return report;
}

class FrameStripTest : public testing::Test {
 protected:
  FrameStripTest() {
    strip_.resize(200, strip_.sizeHint().height());  // two pixels for each frame
    strip_.show_report(a_hundred_frames());
  }
  std::string words(int frame) { return strip_.words_at(2 * frame + 1).toStdString(); }
  QColor colour(int frame) { return strip_.grab().toImage().pixelColor(2 * frame + 1, 16); }

  FrameStrip strip_;
};

TEST_F(FrameStripTest, SaysOfEachFrameWhatBecomesOfIt) {
  EXPECT_EQ(words(10), "Frame 10: used");
  EXPECT_EQ(words(5), "Frame 5, the rest pose: used");
  EXPECT_EQ(words(25), "frames 20 to 29");
  EXPECT_EQ(words(50), "Frame 50: left out by you");
  EXPECT_EQ(words(95), "Frame 95: no face or markers");
  EXPECT_EQ(words(-3), "");
  EXPECT_EQ(words(100), "");
  EXPECT_THAT(strip_.accessibleDescription().toStdString(), HasSubstr("used: 79"));
}

TEST_F(FrameStripTest, EachUseHasAColourOfItsOwn) {
  const std::vector<QColor> colours{colour(10), colour(25), colour(50), colour(95)};
  for (std::size_t a = 0; a < colours.size(); ++a)
    for (std::size_t b = a + 1; b < colours.size(); ++b) EXPECT_NE(colours[a], colours[b]);
}

TEST_F(FrameStripTest, OneFaultyFrameAmongThousandsIsSeen) {
  ReferenceReport report;
  report.uses.assign(20000, FrameUse::kRetained);
  const QColor used = [&] {
    strip_.show_report(report);
    return strip_.grab().toImage().pixelColor(100, 16);
  }();
  report.uses[10040] = FrameUse::kInContact;  // 100 frames in a pixel
  strip_.show_report(report);
  EXPECT_NE(strip_.grab().toImage().pixelColor(100, 16), used);
}

TEST_F(FrameStripTest, AClickNamesTheStretch) {
  const QSignalSpy clicked(&strip_, &FrameStrip::stretch_clicked);
  QTest::mouseClick(&strip_, Qt::LeftButton, {}, {2 * 10, 16});
  EXPECT_EQ(clicked.count(), 0);
  QTest::mouseClick(&strip_, Qt::LeftButton, {}, {2 * 25, 16});
  ASSERT_EQ(clicked.count(), 1);
  EXPECT_EQ(clicked.front().front().toInt(), 0);
}

TEST_F(FrameStripTest, DraggingSelectsFramesAndAClickShowsOne) {
  const QSignalSpy shown(&strip_, &FrameStrip::frame_selected);
  QTest::mouseClick(&strip_, Qt::LeftButton, {}, {2 * 10 + 1, 16});
  ASSERT_TRUE(strip_.selection());
  EXPECT_EQ(strip_.selection()->first, 10);
  EXPECT_EQ(strip_.selection()->last, 10);
  EXPECT_EQ(shown.back().front().toInt(), 10);
  const QImage before = strip_.grab().toImage();
  QTest::mousePress(&strip_, Qt::LeftButton, {}, {2 * 40 + 1, 16});
  QMouseEvent move(QEvent::MouseMove, QPointF(2 * 30 + 1, 16), QPointF(), Qt::NoButton,
                   Qt::LeftButton, {});
  QApplication::sendEvent(&strip_, &move);
  QTest::mouseRelease(&strip_, Qt::LeftButton, {}, {2 * 30 + 1, 16});
  EXPECT_EQ(strip_.selection()->first, 30);
  EXPECT_EQ(strip_.selection()->last, 40);
  EXPECT_EQ(shown.back().front().toInt(), 30);
  EXPECT_NE(strip_.grab().toImage(), before) << "the selection is seen";
}

TEST_F(FrameStripTest, KeysSelectAndLeaveOut) {
  const QSignalSpy changes(&strip_, &FrameStrip::change_requested);
  QTest::keyClick(&strip_, Qt::Key_Home);
  for (int i = 0; i < 3; ++i) QTest::keyClick(&strip_, Qt::Key_Right);
  for (int i = 0; i < 4; ++i) QTest::keyClick(&strip_, Qt::Key_Right, Qt::ShiftModifier);
  ASSERT_TRUE(strip_.selection());
  EXPECT_EQ(strip_.selection()->first, 3);
  EXPECT_EQ(strip_.selection()->last, 7);
  QTest::keyClick(&strip_, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(strip_.selection()->last, 6);
  QTest::keyClick(&strip_, Qt::Key_Delete);
  EXPECT_EQ(changes.count(), 1);
  QTest::keyClick(&strip_, Qt::Key_End, Qt::ShiftModifier);
  EXPECT_EQ(strip_.selection()->last, 99);
}

TEST_F(FrameStripTest, ATriangleSelectsTheDarkestFrame) {
  const QSignalSpy shown(&strip_, &FrameStrip::frame_selected);
  QTest::mouseClick(&strip_, Qt::LeftButton, {}, {2 * 24 + 4, 3});
  ASSERT_EQ(shown.count(), 1);
  EXPECT_EQ(shown.front().front().toInt(), 24);
}

TEST_F(FrameStripTest, ShowsAChoiceOverWhatWasReported) {
  FrameChoice choice;
  for (int frame = 8; frame < 12; ++frame) choice[frame] = false;
  choice[25] = true;
  choice[95] = true;
  strip_.show_choice(choice);
  EXPECT_EQ(words(9), "Frame 9: left out by you");
  EXPECT_EQ(words(25), "Frame 25: used");
  EXPECT_EQ(words(26), "frames 20 to 29");
  EXPECT_EQ(words(50), "Frame 50: used") << "it was left out before, and is not any more";
  EXPECT_EQ(words(95), "Frame 95: no face or markers") << "it cannot be used";
  const QColor chosen = colour(9);
  strip_.show_choice({{50, false}});
  EXPECT_EQ(chosen, colour(50)) << "as what was left out before";
  const auto out = frames_of(choice, false), in = frames_of(choice, true);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].first, 8);
  EXPECT_EQ(out[0].last, 11);
  EXPECT_EQ(in.size(), 2U);
}

}  // namespace
}  // namespace alltact::test
