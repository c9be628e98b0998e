#include "calibration/reference/marker_numbering.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

DotTrack dot(bool upper, double along_mm) {
  DotTrack track;
  track.upper = upper;
  track.along_mm = along_mm;
  track.off_face = 0.2;
  track.log_size = -4.0;
  track.log_contrast = 4.3;
  track.support = 1.0;
  return track;
}

void order(std::vector<DotTrack>* tracks) {
  std::stable_sort(tracks->begin(), tracks->end(),
                   [](const DotTrack& a, const DotTrack& b) { return a.along_mm < b.along_mm; });
}

/// Places of the numbered dots, NaN where a number has none.
std::vector<double> positions(const std::vector<DotTrack>& tracks, const NumberedRows& rows) {
  std::vector<double> along_mm;
  for (const int track : rows.track_of)
    along_mm.push_back(track < 0 ? NAN : tracks[static_cast<std::size_t>(track)].along_mm);
  return along_mm;
}

void expect_same(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(std::isfinite(found[i]), std::isfinite(expected[i])) << "number " << i;
    if (std::isfinite(expected[i])) {
      EXPECT_EQ(found[i], expected[i]) << "number " << i;
    }
  }
}

// Five dots a side were asked for; four steps of 15 mm, one dot of them missing, on the other side
// of a row of 11 mm. Two long steps of which the second is half the first would need no missing
// dot, but the row beside it is even.
TEST(RowLaw, AGapIsReadByTheLawOfTheOtherSide) {
  std::vector<DotTrack> tracks;
  for (const double along : {1.0, 12.0, 23.0, 34.5}) tracks.push_back(dot(true, along));
  for (const double along : {1.0, 30.6, 46.8}) tracks.push_back(dot(false, along));
  order(&tracks);
  expect_same(positions(tracks, choose_rows(tracks, 5)),
              {1.0, 12.0, 23.0, 34.5, NAN, 1.0, NAN, 30.6, 46.8, NAN});
}

// Rows of different steps: that two dots far from the base happen to lie opposite each other does
// not put the shorter row's first number before the base.
TEST(RowLaw, RowsOfDifferentStepsBeginAtTheBase) {
  std::vector<DotTrack> tracks;
  for (int i = 0; i < 7; ++i) tracks.push_back(dot(true, 2.0 + 8.0 * i));
  for (int i = 0; i < 4; ++i) tracks.push_back(dot(false, 2.0 + 14.0 * i));
  order(&tracks);
  const auto found = positions(tracks, choose_rows(tracks, 7));
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(found[static_cast<std::size_t>(7 + i)], 2.0 + 14.0 * i) << "number " << 7 + i;
}

// Any smooth law of steps, any dot but the outermost missing on each side: every dot keeps its
// number.
TEST(RowLaw, NumbersSurviveMissingDotsUnderAnySmoothLaw) {
  constexpr int kWorlds = 300;
  std::mt19937 random(41);
  RecordProperty("seed", 41);
  int right = 0;
  for (int world = 0; world < kWorlds; ++world) {
    const int per_row = std::uniform_int_distribution<int>(5, 16)(random);
    const double growth = std::uniform_real_distribution<double>(0.0, 0.12)(random);
    const double first_mm = std::uniform_real_distribution<double>(2.0, 6.0)(random);
    std::normal_distribution<double> jitter(0.0, 0.01 * first_mm);
    std::vector<DotTrack> tracks;
    std::vector<double> expected;
    for (const bool upper : {true, false}) {
      const int missing = std::uniform_int_distribution<int>(1, per_row - 2)(random);
      double along = 1.0;
      for (int i = 0; i < per_row; ++i) {
        if (i > 0) along += first_mm * std::exp(growth * (i - 1));
        const double place = along + jitter(random);
        expected.push_back(i == missing ? NAN : place);
        if (i != missing) tracks.push_back(dot(upper, place));
      }
    }
    order(&tracks);
    const auto found = positions(tracks, choose_rows(tracks, per_row));
    bool same = true;
    for (std::size_t i = 0; i < expected.size(); ++i)
      same = same && (std::isnan(expected[i]) ? std::isnan(found[i]) : found[i] == expected[i]);
    right += same;
  }
  EXPECT_GE(right, kWorlds * 99 / 100) << right << " of " << kWorlds;
}

}  // namespace
}  // namespace alltact
