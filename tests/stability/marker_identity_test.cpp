// How often a marker is taken for another one, with up to a quarter of them hidden and a third as
// many false dots among them, over fingers drawn at random.
#include "core/sensing/markers/marker_model.h"
#include "core/sensing/markers/marker_tracker.h"
#include "core/sensing/markers/markers.h"
#include "tests/support/marked_finger.h"
#include "tests/support/slow_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::Bend;
using test::MarkedFinger;
using test::random_bend;

double drawn_between(double low, double high, std::mt19937& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A small picture, so that many frames are quick.
MarkedFinger any_finger(std::mt19937& random) {
  MarkedFinger finger;
  const std::array<int, 5> lengths{4, 5, 6, 8, 12};
  finger.per_row = lengths[random() % lengths.size()];
  finger.width = 480, finger.height = 270;
  finger.focal = drawn_between(220, 300, random);
  finger.half_width_mm = drawn_between(10, 14, random);
  finger.length_mm = drawn_between(75, 105, random);
  finger.off_face_mm = drawn_between(6, 10, random);
  finger.dot_mm = drawn_between(0.7, 1.0, random);
  finger.dot_aspect = drawn_between(1.0, 1.6, random);
  finger.mirrored = random() % 2 == 0;
  finger.dot_contrast = random() % 3 == 0 ? -32 : drawn_between(30, 70, random);
  if (finger.dot_contrast < 0) finger.side_level = 50;
  finger.noise = drawn_between(0.4, 2.0, random);
  for (auto* shares : {&finger.upper_shares, &finger.lower_shares}) {
    const double step = 0.84 / (finger.per_row - 1);
    for (int i = 0; i < finger.per_row; ++i)
      shares->push_back(0.07 + step * (i + drawn_between(-0.12, 0.12, random)));
  }
  return finger;
}

MarkerModel model_of(const MarkedFinger& finger, int frames, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, 0.05);
  Eigen::MatrixXd layouts(frames, 4 * finger.per_row);
  for (int i = 0; i < frames; ++i) {
    layouts.row(i) = finger.layout(random_bend(random)).transpose();
    for (double& value : layouts.row(i)) value += noise(random);
  }
  return MarkerModel::learn(layouts, finger.typical(Bend{})).value();
}

std::vector<int> up_to_a_quarter(int markers, std::mt19937& random) {
  std::vector<int> all(static_cast<std::size_t>(markers));
  std::iota(all.begin(), all.end(), 0);
  std::shuffle(all.begin(), all.end(), random);
  all.resize(random() % static_cast<std::size_t>(markers / 4 + 1));
  return all;
}

/// A place on the side faces: every other one within a step and a half of a marker.
MarkedFinger::Disc false_disc(const MarkedFinger& finger,
                              const std::vector<MarkedFinger::Point>& arc, std::mt19937& random) {
  const double side = random() % 2 == 0 ? -1 : 1;
  const double off = random() % 2 == 0 ? finger.off_face_mm + drawn_between(-2, 2, random)
                                       : drawn_between(4, 12, random);
  return finger.disc(arc, side, drawn_between(0.04, 0.96, random), off, finger.dot_mm);
}

double apart(const MarkedFinger::Disc& a, const MarkedFinger::Disc& b) {
  return std::hypot(a.u - b.u, a.v - b.v);
}

/// False ones that leave the true ones as they are.
std::vector<MarkedFinger::Disc> third_as_many_false(const MarkedFinger& finger, const Bend& bend,
                                                    std::mt19937& random) {
  const auto dots = finger.discs(bend);
  std::vector<MarkedFinger::Disc> discs;
  constexpr int kTries = 400;  // long rows of large dots leave little room
  const auto arc = finger.arc(bend);
  for (int i = 0; i < kTries && discs.size() < dots.size() / 3; ++i) {
    const auto disc = false_disc(finger, arc, random);
    const auto is_near = [&](const MarkedFinger::Disc& dot) {
      return apart(dot, disc) < 1.6 * (dot.radius_u + disc.radius_u);
    };
    if (std::none_of(dots.begin(), dots.end(), is_near) &&
        std::none_of(discs.begin(), discs.end(), is_near))
      discs.push_back(disc);
  }
  return discs;
}

struct IdentityTally {
  int frames = 0, lost = 0, slipped = 0, false_seen = 0;
  long seen = 0, markers = 0, false_dots = 0, true_dots = 0;

  void add(const std::optional<Markers>& markers_found,
           const std::vector<MarkedFinger::Disc>& discs) {
    ++frames;
    true_dots += static_cast<long>(discs.size());
    if (!markers_found) {
      ++lost;
      return;
    }
    bool is_slip = false, is_false = false;
    markers += static_cast<long>(discs.size());
    for (std::size_t m = 0; m < discs.size(); ++m) {
      const Marker& marker = (*markers_found)[m];
      if (!marker.seen) continue;
      ++seen;
      const MarkedFinger::Disc place{marker.u, marker.v, 0, 0};
      if (apart(discs[m], place) < 3) continue;
      for (std::size_t other = 0; other < discs.size(); ++other)
        is_slip |= other != m && apart(discs[other], place) < 3;
      is_false = true;
    }
    slipped += is_slip;
    false_seen += is_false && !is_slip;
  }
  void print(const char* what) const {
    std::printf(
        "[ figures  ] %s: of %d frames %d with a marker taken for another, %d with a false dot "
        "taken for one, %d lost; %.1f %% of the markers seen, "
        "%.2f false dots for each marker\n",
        what, frames, slipped, false_seen, lost,
        100.0 * static_cast<double>(seen) / static_cast<double>(std::max(1L, markers)),
        static_cast<double>(false_dots) / static_cast<double>(std::max(1L, true_dots)));
  }
};

/// As a detector gives them, in no order.
std::vector<Dot> dots_among_false(const MarkedFinger& finger, const Bend& bend, long* false_dots,
                                  std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, 0.05);
  const auto discs = finger.discs(bend);
  const auto hidden = up_to_a_quarter(2 * finger.per_row, random);
  std::vector<Dot> dots;
  const double middle = 0.5 * (finger.height - 1);
  const auto add = [&](const MarkedFinger::Disc& disc) {
    Dot dot{disc.u + noise(random), disc.v + noise(random), disc.radius_u, finger.dot_contrast,
            0.05};
    dot.upper = disc.v < middle;
    dots.push_back(dot);
  };
  for (std::size_t m = 0; m < discs.size(); ++m) {
    if (std::find(hidden.begin(), hidden.end(), static_cast<int>(m)) != hidden.end()) continue;
    add(discs[m]);
    dots.back().upper = static_cast<int>(m) < finger.per_row;
  }
  const auto others = third_as_many_false(finger, bend, random);
  for (const auto& disc : others) add(disc);
  *false_dots += static_cast<long>(others.size());
  std::shuffle(dots.begin(), dots.end(), random);
  return dots;
}

TEST(MarkerIdentity, NumbersSlipInLessThanOneOfAThousandFrames) {
  std::mt19937 random(51);
  const int fingers = test::is_slow_run() ? 300 : 40;
  constexpr int kFrames = 100;
  IdentityTally tally;
  for (int f = 0; f < fingers; ++f) {
    const MarkedFinger finger = any_finger(random);
    const MarkerModel model = model_of(finger, 250, random);
    for (int i = 0; i < kFrames; ++i) {
      const Bend bend = random_bend(random, 0.9);
      tally.add(model.number(dots_among_false(finger, bend, &tally.false_dots, random)),
                finger.discs(bend));
    }
  }
  tally.print("numbering");
  EXPECT_LT(tally.slipped, tally.frames / 1000);
  EXPECT_LT(tally.false_seen, tally.frames / 200);
  EXPECT_LT(tally.lost, tally.frames / 1000);
}

// The whole default way, from pictures: detected anew in every tenth frame, followed in between.
TEST(MarkerIdentity, FollowedMarkersSlipInLessThanOneOfAThousandFrames) {
  std::mt19937 random(52);
  const int fingers = test::is_slow_run() ? 200 : 20;
  constexpr int kFrames = 50;
  IdentityTally tally;
  for (int f = 0; f < fingers; ++f) {
    const MarkedFinger finger = any_finger(random);
    MarkerTracker tracker(
        {finger.per_row, finger.dot_contrast > 0 ? Polarity::kBright : Polarity::kDark},
        model_of(finger, 250, random));
    const Bend from = random_bend(random, 0.9), to = random_bend(random, 0.9);
    std::vector<int> hidden;
    unsigned seed = 0;
    for (int i = 0; i < kFrames; ++i) {
      const double t = 0.5 - 0.5 * std::cos(2 * M_PI * i / kFrames);
      const auto mixed = [t](double a, double b) { return a + t * (b - a); };
      const Bend bend{mixed(from.curl, to.curl), mixed(from.hook, to.hook),
                      mixed(from.sway, to.sway), mixed(from.lean, to.lean)};
      if (i % 10 == 0) {  // others are hidden, and dirt is elsewhere
        hidden = up_to_a_quarter(2 * finger.per_row, random);
        seed = random();
        if (i % 20 == 0) tracker.forget();
      }
      std::mt19937 places(seed);
      std::vector<MarkedFinger::Extra> dirt;
      for (const auto& disc : third_as_many_false(finger, bend, places))
        dirt.push_back({disc, (finger.side_level + finger.dot_contrast) *
                                  (1.2 - 0.4 * disc.u / finger.width)});
      tally.false_dots += static_cast<long>(dirt.size());
      const cv::Mat grey = finger.with_noise(finger.clean(bend, hidden, dirt), random);
      tally.add(tracker(grey, finger.shape(bend), nullptr), finger.discs(bend));
    }
  }
  tally.print("followed in pictures");
  EXPECT_LE(tally.slipped, tally.frames / 1000);
  EXPECT_LT(tally.lost, tally.frames / 100);
}

}  // namespace
}  // namespace alltact
