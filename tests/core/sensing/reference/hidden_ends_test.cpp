#include "core/sensing/depth/depth_map.h"
#include "core/sensing/reference/face_chart.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr int kWidth = 480;
constexpr double kMmPerPx = 0.2;

/// A face of columns first..last that narrows evenly; its length counts from column 0.
FaceChart chart(int first, int last, double shift_mm = 0) {
  FaceChart made;
  made.first = first;
  for (int u = first; u <= last; ++u) {
    made.along_mm.push_back(kMmPerPx * u + shift_mm);
    made.upper_v.push_back(60.0 + 0.1 * u);
    made.lower_v.push_back(210.0 - 0.1 * u);
  }
  made.middle_mm = 0.5 * (made.along_mm.front() + made.along_mm.back());
  made.half_mm = 0.5 * (made.along_mm.back() - made.along_mm.front());
  return made;
}

/// Recorded frames whose tip lies at column 400, and as far along the face; bent, it lies elsewhere
/// in the picture.
std::vector<FaceChart> recorded() {
  std::vector<FaceChart> charts;
  for (int bend = -10; bend <= 10; ++bend)
    charts.push_back(chart(0, 400 + bend, -kMmPerPx * bend + (bend % 2 == 0 ? 0.02 : -0.02)));
  return charts;
}

TEST(HiddenEnds, AFaceThatIsSeenToItsEndHidesNothing) {
  const EndLengths ends(recorded(), kWidth);
  for (const FaceChart& seen : recorded()) EXPECT_TRUE(ends.hidden_columns(seen, kWidth).empty());
}

TEST(HiddenEnds, AreTheColumnsFromWhereTheFaceIsLostToWhereItMustEnd) {
  const EndLengths ends(recorded(), kWidth);
  for (const int bend : {-7, 0, 7}) {
    const auto hidden = ends.hidden_columns(chart(0, 360 + bend, -kMmPerPx * bend), kWidth);
    ASSERT_FALSE(hidden.empty());
    EXPECT_EQ(hidden.front().u, 361 + bend);
    EXPECT_NEAR(hidden.back().u, 400 + bend, 1);
    EXPECT_EQ(hidden.size(), static_cast<std::size_t>(hidden.back().u - hidden.front().u + 1));
    for (const HiddenColumn& column : hidden) {
      EXPECT_NEAR(column.upper_v, 60.0 + 0.1 * column.u, 1e-6);
      EXPECT_NEAR(column.lower_v, 210.0 - 0.1 * column.u, 1e-6);
    }
  }
}

TEST(HiddenEnds, AtSmallColumnsAsWellAndNeverBeyondThePicture) {
  std::vector<FaceChart> both;
  for (int i = 0; i < 20; ++i) both.push_back(chart(40, 440));
  const EndLengths ends(both, kWidth);
  const auto low = ends.hidden_columns(chart(70, 440), kWidth);
  ASSERT_FALSE(low.empty());
  EXPECT_NEAR(low.front().u, 40, 1);
  EXPECT_EQ(low.back().u, 69);
  // Bent so that its tip would lie outside: the picture ends first.
  const auto high = ends.hidden_columns(chart(100, 440, -kMmPerPx * 60), kWidth);
  ASSERT_FALSE(high.empty());
  EXPECT_EQ(high.back().u, kWidth - 1);
}

TEST(HiddenEnds, AnEndThatTheRecordingDoesNotShowIsNotKnown) {
  std::vector<FaceChart> cut;  // by the picture's border, wherever the finger bends
  for (int i = 0; i < 20; ++i) cut.push_back(chart(0, kWidth - 1, 0.1 * i));
  EXPECT_TRUE(EndLengths(cut, kWidth).hidden_columns(chart(0, 300), kWidth).empty());
  EXPECT_TRUE(EndLengths({}, kWidth).hidden_columns(chart(0, 300), kWidth).empty());
}

TEST(HiddenEnds, OnlyWhatWasSaidToBeNoFaceIsFlagged) {
  cv::Mat flags(10, 4, CV_8UC1, cv::Scalar(kOffFace));
  flags.at<std::uint8_t>(5, 2) = kTooDark;
  flag_hidden({{2, 2.5, 7.5}, {3, -4.0, 40.0}}, &flags);
  for (int v = 0; v < 10; ++v) {
    EXPECT_EQ(flags.at<std::uint8_t>(v, 1), kOffFace);
    EXPECT_EQ(flags.at<std::uint8_t>(v, 2), v == 5             ? kTooDark
                                            : v >= 3 && v <= 7 ? kHiddenEnd
                                                               : kOffFace);
    EXPECT_EQ(flags.at<std::uint8_t>(v, 3), kHiddenEnd);
  }
}

}  // namespace
}  // namespace alltact
