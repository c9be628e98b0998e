// Rows of markers of any design, whole and damaged, in recordings made of places alone.
#include "calibration/reference/marker_numbering.h"
#include "core/numerics/median.h"
#include "core/sensing/face/face_pixels.h"
#include "core/sensing/markers/marker_detector.h"
#include "tests/support/marked_recording.h"

#include <cstdio>
#include <functional>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::Bend;
using test::MarkedFinger;
using test::pose;
using test::random_bend;

/// Something on a side face that is no marker.
struct Blemish {
  double side, share, off_mm, radius_mm, contrast;
};

struct Recorded {
  std::vector<FrameDots> frames;
  std::vector<Eigen::VectorXd> truth;  // of all dots that there are
};

/// How a recording is made worse than the finger is.
struct Conditions {
  int frames = 80;
  double hidden_part = 0;  // of all dots, in every frame others
  int false_dots = 0;      // in every frame elsewhere
  bool is_shuffled = false;
  std::set<int> absent;  // by place in MarkedFinger::discs
  std::vector<Blemish> blemishes;
};

bool is_in_picture(const MarkedFinger& f, double u, double v) {
  return u > 6 && v > 6 && u < f.width - 7 && v < f.height - 7;
}

Recorded record(const MarkedFinger& f, const Conditions& conditions, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 0.05), spread(1.0, 0.03);
  std::uniform_real_distribution<double> one(0.0, 1.0);
  std::vector<int> order(static_cast<std::size_t>(conditions.frames));
  std::iota(order.begin(), order.end(), 0);
  if (conditions.is_shuffled) std::shuffle(order.begin(), order.end(), random);
  Recorded recorded;
  for (const int i : order) {
    const Bend bend = pose(i, conditions.frames);
    const FaceShape shape = f.shape(bend);
    FrameDots frame;
    frame.curves = edge_curves(shape);
    const auto points = f.arc(bend);
    const auto add = [&](const MarkedFinger::Disc& d, bool upper, double contrast) {
      if (!is_in_picture(f, d.u, d.v)) return;
      Dot dot{d.u + noise(random),
              d.v + noise(random),
              std::sqrt(d.radius_u * d.radius_v) * spread(random),
              contrast * (1.2 - 0.4 * d.u / f.width) * spread(random),
              0.05,
              upper};
      frame.bright.push_back(dot);
    };
    const auto all = f.discs(bend);
    const std::size_t upper_count = f.shares_of(-1).size();
    for (std::size_t m = 0; m < all.size(); ++m)
      if (!conditions.absent.contains(static_cast<int>(m)) && one(random) >= conditions.hidden_part)
        add(all[m], m < upper_count, f.dot_contrast);
    for (const Blemish& b : conditions.blemishes)
      add(f.disc(points, b.side, b.share, b.off_mm, b.radius_mm), b.side < 0, b.contrast);
    for (int k = 0; k < conditions.false_dots; ++k) {
      const double u = one(random) * f.width, r = 1.5 + 2 * one(random);
      const bool upper = k % 2 == 0;
      const double v = upper ? 60 * one(random) : f.height - 60 * one(random);
      add({u, v, r, r}, upper, 20 + 40 * one(random));
    }
    std::shuffle(frame.bright.begin(), frame.bright.end(), random);
    locate_on_finger(frame.bright, shape, SideEdges(shape));
    recorded.frames.push_back(std::move(frame));
    recorded.truth.push_back(f.layout(bend));
  }
  return recorded;
}

/// place_of: by number, the place in MarkedFinger::discs; -1: the finger has none.
void expect_numbered(const char* what, const MarkedFinger& f, const Recorded& recorded,
                     const MarkerRows& rows, const std::vector<int>& place_of) {
  const auto numbered = number_recording(recorded.frames, rows);
  ASSERT_TRUE(numbered.ok()) << what << ": " << numbered.error().sentence();
  ASSERT_FALSE(numbered->positions) << what << ": " << numbered->no_markers.english();
  std::vector<int> missing;
  for (std::size_t m = 0; m < place_of.size(); ++m)
    if (place_of[m] < 0) missing.push_back(static_cast<int>(m));
  EXPECT_EQ(numbered->missing, missing) << what;
  int slips = 0, lost = 0, seen = 0;
  double worst_seen = 0;
  std::vector<double> hidden;
  for (std::size_t i = 0; i < recorded.frames.size(); ++i) {
    if (!numbered->markers[i]) {
      ++lost;
      continue;
    }
    ASSERT_EQ(numbered->markers[i]->size(), place_of.size()) << what;
    for (std::size_t m = 0; m < place_of.size(); ++m) {
      const Marker& marker = (*numbered->markers[i])[m];
      ASSERT_TRUE(std::isfinite(marker.u) && std::isfinite(marker.v)) << what;
      if (place_of[m] < 0) {
        EXPECT_FALSE(marker.seen) << what << ", marker " << m;
        continue;
      }
      const auto truth = recorded.truth[i].segment<2>(2 * place_of[m]);
      const double off = (Eigen::Vector2d(marker.u, marker.v) - truth).norm();
      if (!is_in_picture(f, truth.x(), truth.y())) continue;
      slips += marker.seen && off > 3.0;
      seen += marker.seen;
      if (marker.seen)
        worst_seen = std::max(worst_seen, off);
      else
        hidden.push_back(off);
    }
  }
  std::printf(
      "[ figures  ] %s: %d slips, %d of %zu frames lost, %d seen; worst %.2f px seen, median %.2f "
      "px "
      "hidden\n",
      what, slips, lost, recorded.frames.size(), seen, worst_seen,
      hidden.empty() ? 0.0 : upper_median(hidden));
  EXPECT_EQ(slips, 0) << what;
  EXPECT_LT(worst_seen, 0.5) << what;
  EXPECT_LE(lost, static_cast<int>(recorded.frames.size()) / 50) << what;
}

std::vector<int> in_order(int count) {
  std::vector<int> positions(static_cast<std::size_t>(count));
  std::iota(positions.begin(), positions.end(), 0);
  return positions;
}

/// Steps and sizes that grow along the finger: dots that look alike in the picture.
MarkedFinger growing(double growth) {
  MarkedFinger f;
  std::vector<double> shares;
  double at = 0, step = 1;
  for (int i = 0; i < f.per_row; ++i, at += step, step *= growth) {
    shares.push_back(at);
    f.sizes.push_back(std::pow(growth, i));
  }
  for (double& share : shares) share = 0.06 + 0.86 * share / shares.back();
  f.upper_shares = f.lower_shares = shares;
  return f;
}

TEST(NumberRecording, RowsByAnySmoothLaw) {
  for (const double growth : {0.8, 1.0, 1.15, 1.3, 1.45}) {
    const MarkedFinger f = growing(growth);
    expect_numbered(("steps that grow by " + std::to_string(growth)).c_str(), f, record(f, {}, 1),
                    {6, Polarity::kAuto}, in_order(12));
  }
}

TEST(NumberRecording, FromTwoToFortyDotsARow) {
  for (const int per_row : {2, 3, 12, 40}) {
    MarkedFinger f;
    f.per_row = per_row;
    if (per_row > 20) f.dot_mm = 0.3;
    Conditions conditions;
    conditions.hidden_part = per_row > 2 ? 0.05 : 0.0;
    conditions.false_dots = 4;
    expect_numbered((std::to_string(per_row) + " a row").c_str(), f, record(f, conditions, 2),
                    {per_row, Polarity::kAuto}, in_order(2 * per_row));
  }
}

TEST(NumberRecording, OneDotARowTellsNoPoseWhereOneIsHiddenSoTheShapeDoes) {
  MarkedFinger f;
  f.per_row = 1;
  const auto recorded = record(f, {}, 2);
  const auto numbered = number_recording(recorded.frames, {1, Polarity::kAuto});
  ASSERT_TRUE(numbered.ok());
  EXPECT_TRUE(numbered->positions);
  EXPECT_EQ(numbered->no_markers.english(), "with 2 markers, none may be hidden");
}

TEST(NumberRecording, InAnyOrderWithDotsHiddenInEveryFrameAndFalseOnesAmongThem) {
  Conditions conditions;
  conditions.hidden_part = 0.2;
  conditions.false_dots = 8;
  conditions.is_shuffled = true;
  expect_numbered("hidden and false", MarkedFinger{}, record(MarkedFinger{}, conditions, 3),
                  {6, Polarity::kAuto}, in_order(12));
}

TEST(NumberRecording, ADamagedFingerWorksWithTheMarkersItHasAndSaysWhichAreMissing) {
  Conditions conditions;
  conditions.absent = {3, 10};
  // A bubble beside a dot, one between two, a scratch elsewhere, as bright as the dots.
  conditions.blemishes = {{-1, 0.06 + 0.86 * 0.25, 9, 0.5, 60},
                          {1, 0.06 + 0.86 * 0.5, 9, 0.6, 50},
                          {1, 0.7, 6, 0.8, 80}};
  auto positions = in_order(12);
  positions[3] = positions[10] = -1;
  expect_numbered("damaged", MarkedFinger{}, record(MarkedFinger{}, conditions, 4),
                  {6, Polarity::kAuto}, positions);

  Conditions ends;
  ends.absent = {0, 11};
  auto inner = in_order(12);
  inner[0] = inner[11] = -1;
  expect_numbered("without an end", MarkedFinger{}, record(MarkedFinger{}, ends, 5),
                  {6, Polarity::kAuto}, inner);
}

TEST(NumberRecording, RowsOfDifferentLength) {
  MarkedFinger f;
  f.lower_shares = {0.06 + 0.86 * 0.2, 0.06 + 0.86 * 0.4, 0.06 + 0.86 * 0.6, 0.06 + 0.86 * 0.8};
  expect_numbered("6 and 4", f, record(f, {}, 6), {6, Polarity::kAuto},
                  {0, 1, 2, 3, 4, 5, -1, 6, 7, 8, 9, -1});
}

TEST(NumberRecording, ANumberOfDotsThatIsOffByOne) {
  expect_numbered("one too many", MarkedFinger{}, record(MarkedFinger{}, {}, 7),
                  {7, Polarity::kAuto}, {0, 1, 2, 3, 4, 5, -1, 6, 7, 8, 9, 10, 11, -1});
  const auto recorded = record(MarkedFinger{}, {}, 8);
  const auto fewer = number_recording(recorded.frames, {5, Polarity::kAuto});
  ASSERT_TRUE(fewer.ok());
  ASSERT_FALSE(fewer->positions);
  EXPECT_TRUE(fewer->missing.empty());
  for (std::size_t i = 0; i < recorded.frames.size(); ++i) {
    ASSERT_TRUE(fewer->markers[i]) << i;
    // Five neighbours of six, in every frame the same ones.
    const Marker& first = fewer->markers[i]->front();
    const double at_0 = (Eigen::Vector2d(first.u, first.v) - recorded.truth[i].head<2>()).norm();
    const double at_1 =
        (Eigen::Vector2d(first.u, first.v) - recorded.truth[i].segment<2>(2)).norm();
    EXPECT_LT(std::min(at_0, at_1), 1.0) << i;
  }
}

TEST(NumberRecording, TwoFramesAndCopiesOfOne) {
  Conditions two;
  two.frames = 2;
  expect_numbered("two frames", MarkedFinger{}, record(MarkedFinger{}, two, 9),
                  {6, Polarity::kAuto}, in_order(12));
  Recorded copies = record(MarkedFinger{}, two, 10);
  for (int i = 0; i < 30; ++i) {
    copies.frames.push_back(copies.frames[0]);
    copies.truth.push_back(copies.truth[0]);
  }
  expect_numbered("copies", MarkedFinger{}, copies, {6, Polarity::kAuto}, in_order(12));
}

TEST(NumberRecording, WithoutMarkersByPlacesOfTheFace) {
  const MarkedFinger f;
  Conditions bare;
  for (int m = 0; m < 12; ++m) bare.absent.insert(m);
  const Recorded recorded = record(f, bare, 11);
  for (const int per_row : {0, 6}) {
    const auto numbered = number_recording(recorded.frames, {per_row, Polarity::kAuto});
    ASSERT_TRUE(numbered.ok()) << numbered.error().sentence();
    ASSERT_TRUE(numbered->positions);
    EXPECT_EQ(numbered->no_markers.empty(), per_row == 0);
    EXPECT_TRUE(numbered->missing.empty());
    for (std::size_t i = 0; i < recorded.frames.size(); ++i) {
      ASSERT_TRUE(numbered->markers[i]) << i;
      // On the true edges, wherever along them.
      const auto upper = f.edge(pose(static_cast<int>(i), 80), -1, 0);
      for (std::size_t m = 0; m < EdgePositions::kPerEdge; ++m) {
        const Marker& marker = (*numbered->markers[i])[m];
        if (!marker.seen) continue;
        const auto u = static_cast<std::size_t>(marker.u);
        const double t = marker.u - static_cast<double>(u);
        EXPECT_NEAR(marker.v, (1 - t) * upper[u] + t * upper[u + 1], 0.2) << i;
      }
    }
  }
}

TEST(NumberRecording, SaysThatNoFrameShowsTheFace) {
  std::vector<FrameDots> frames(3);
  for (FrameDots& frame : frames) frame.problem = Message::typed("it is dark");
  const auto numbered = number_recording(frames, {6, Polarity::kAuto});
  ASSERT_FALSE(numbered.ok());
  EXPECT_NE(numbered.error().what.english().find("it is dark"), std::string::npos);
}

}  // namespace
}  // namespace alltact
