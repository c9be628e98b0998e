// What becomes of the frames of a recording, in one strip.
#include "widgets/panels/frame_strip.h"

#include "widgets/theme.h"

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

}  // namespace
}  // namespace alltact::test
