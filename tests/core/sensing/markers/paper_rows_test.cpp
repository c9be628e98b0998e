#include "core/sensing/markers/marker_tracker.h"
#include "tests/support/marked_finger.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::Bend;
using test::MarkedFinger;
using test::random_bend;

std::vector<Dot> drawn_dots(const MarkedFinger& finger, const Bend& bend,
                            const std::set<int>& hidden) {
  std::vector<Dot> dots;
  const auto discs = finger.discs(bend);
  for (std::size_t m = 0; m < discs.size(); ++m) {
    if (hidden.contains(static_cast<int>(m))) continue;
    Dot dot{discs[m].u, discs[m].v, discs[m].radius_u, 60, 0.05};
    dot.upper = static_cast<int>(m) < finger.per_row;
    dots.push_back(dot);
  }
  return dots;
}

Markers markers_of(const MarkedFinger& finger, const Bend& bend) {
  Markers markers;
  for (const auto& disc : finger.discs(bend)) markers.push_back({disc.u, disc.v, true, 0.05});
  return markers;
}

double off_px(const Marker& marker, const MarkedFinger::Disc& disc) {
  return std::hypot(marker.u - disc.u, marker.v - disc.v);
}

TEST(PaperRows, NumbersDotsInAnyOrderFromBaseToTip) {
  std::mt19937 random(31);
  for (const bool is_mirrored : {false, true}) {
    MarkedFinger finger;
    finger.mirrored = is_mirrored;
    const Bend bend = random_bend(random);
    auto dots = drawn_dots(finger, bend, {});
    std::shuffle(dots.begin(), dots.end(), random);
    const auto markers = paper_rows(dots, finger.per_row, !is_mirrored);
    ASSERT_TRUE(markers.has_value());
    const auto discs = finger.discs(bend);
    ASSERT_EQ(markers->size(), discs.size());
    for (std::size_t m = 0; m < discs.size(); ++m) {
      EXPECT_TRUE((*markers)[m].seen);
      EXPECT_EQ(off_px((*markers)[m], discs[m]), 0.0) << m;
    }
  }
}

TEST(PaperRows, TellsAnyInnerHiddenMarkerFromItsNeighbours) {
  std::mt19937 random(32);
  double error_square = 0;  // in standard deviations that it was told with
  for (int world = 0; world < 200; ++world) {
    MarkedFinger finger;
    finger.per_row = 4 + world % 9;
    const Bend bend = random_bend(random), moved = random_bend(random, 0.1);
    const Markers before = markers_of(finger, {bend.curl + moved.curl, bend.hook + moved.hook,
                                               bend.sway + moved.sway, bend.lean + moved.lean});
    const auto discs = finger.discs(bend);
    const int inner = 1 + static_cast<int>(random() % static_cast<unsigned>(finger.per_row - 2));
    const int hidden = world % 2 == 0 ? inner : finger.per_row + inner;
    const auto markers =
        paper_rows(drawn_dots(finger, bend, {hidden}), finger.per_row, true, &before);
    ASSERT_TRUE(markers.has_value());
    for (std::size_t m = 0; m < discs.size(); ++m) {
      const bool is_hidden = static_cast<int>(m) == hidden;
      EXPECT_EQ((*markers)[m].seen, !is_hidden) << world << ' ' << m;
      if (is_hidden) continue;
      EXPECT_EQ(off_px((*markers)[m], discs[m]), 0.0) << world << ' ' << m;
    }
    // The middle of the neighbours, not what the finger's motion tells.
    const auto m = static_cast<std::size_t>(hidden);
    EXPECT_DOUBLE_EQ((*markers)[m].u, 0.5 * (discs[m - 1].u + discs[m + 1].u));
    EXPECT_DOUBLE_EQ((*markers)[m].v, 0.5 * (discs[m - 1].v + discs[m + 1].v));
    error_square += std::pow(off_px((*markers)[m], discs[m]) / (*markers)[m].sd_px, 2) / 2;
  }
  std::printf("[ figures  ] hidden, error over promised: %.2f\n", std::sqrt(error_square / 200));
  EXPECT_LT(error_square / 200, 1.5 * 1.5);
  EXPECT_GT(error_square / 200, 0.3 * 0.3);
}

TEST(PaperRows, AnEarlierFrameTellsAtWhichEndARowIsShort) {
  const MarkedFinger finger;
  const Bend now{0.1, 0, 1, 0};
  const Markers before = markers_of(finger, Bend{});
  const auto discs = finger.discs(now);
  for (const int hidden : {0, 5, 6, 11}) {
    const auto markers =
        paper_rows(drawn_dots(finger, now, {hidden}), finger.per_row, true, &before);
    ASSERT_TRUE(markers.has_value());
    for (std::size_t m = 0; m < discs.size(); ++m) {
      const bool is_hidden = static_cast<int>(m) == hidden;
      EXPECT_EQ((*markers)[m].seen, !is_hidden) << hidden << ' ' << m;
      if (is_hidden) continue;
      EXPECT_EQ(off_px((*markers)[m], discs[m]), 0.0) << hidden << ' ' << m;
    }
    EXPECT_GT((*markers)[static_cast<std::size_t>(hidden)].sd_px, 1.0);
  }
  // Without it the base's are taken to be seen.
  const auto markers = paper_rows(drawn_dots(finger, now, {0}), finger.per_row, true);
  ASSERT_TRUE(markers.has_value());
  EXPECT_TRUE((*markers)[0].seen);
  EXPECT_FALSE((*markers)[5].seen);
}

TEST(PaperRows, LeavesOutTheFaintestOfTooMany) {
  const MarkedFinger finger;
  auto dots = drawn_dots(finger, Bend{}, {});
  Dot speck = dots[2];
  speck.u += 11, speck.contrast = -20;
  dots.insert(dots.begin(), speck);
  const auto markers = paper_rows(dots, finger.per_row, true);
  ASSERT_TRUE(markers.has_value());
  const auto discs = finger.discs(Bend{});
  for (std::size_t m = 0; m < discs.size(); ++m)
    EXPECT_EQ(off_px((*markers)[m], discs[m]), 0.0) << m;
}

TEST(PaperRows, SaysNothingOfARowWithOneDot) {
  const MarkedFinger finger;
  EXPECT_FALSE(paper_rows(drawn_dots(finger, Bend{}, {0, 1, 2, 3, 4}), 6, true).has_value());
  EXPECT_TRUE(paper_rows(drawn_dots(finger, Bend{}, {0, 1, 2, 3}), 6, true).has_value());
  EXPECT_FALSE(paper_rows({}, 6, true).has_value());
  EXPECT_FALSE(paper_rows({}, 0, true).has_value());
}

// A row of 64 with half of them hidden is numbered in no time: a search of all choices would not
// end.
TEST(PaperRows, LongRowsWithManyHidden) {
  std::vector<Dot> dots;
  for (const bool is_upper : {true, false})
    for (int i = 0; i < 64; ++i) {
      if (i % 2 == 1) continue;
      Dot dot{15.0 * i, is_upper ? 40.0 : 400.0, 4, 60, 0.05};
      dot.upper = is_upper;
      dots.push_back(dot);
    }
  Markers before(128);
  for (std::size_t m = 0; m < 128; ++m)
    before[m] = {15.0 * static_cast<double>(m % 64), m < 64 ? 40.0 : 400.0, true, 0};
  const auto markers = paper_rows(dots, 64, true, &before);
  ASSERT_TRUE(markers.has_value());
  int seen = 0;
  for (const Marker& marker : *markers) {
    seen += marker.seen;
    EXPECT_TRUE(std::isfinite(marker.u) && std::isfinite(marker.v) && std::isfinite(marker.sd_px));
  }
  EXPECT_EQ(seen, 64);
}

}  // namespace
}  // namespace alltact
