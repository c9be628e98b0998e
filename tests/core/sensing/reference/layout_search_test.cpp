// Held against a search that looks at every layout, marker by marker, in double.
#include "core/sensing/reference/recorded_poses.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr Eigen::Index kMarkers = 12;

/// A finger that wanders through three modes of motion, a frame a thirtieth of a second.
Eigen::MatrixXd wandering(Eigen::Index frames) {
  Eigen::MatrixXd rows(frames, 2 * kMarkers);
  for (Eigen::Index i = 0; i < frames; ++i) {
    const double t = static_cast<double>(i) / 30.0;
    const double bend = 40 * std::sin(0.9 * t), curl = 15 * std::sin(0.37 * t + 1),
                 sway = 10 * std::sin(0.211 * t + 2);
    for (Eigen::Index m = 0; m < kMarkers; ++m) {
      const double along = static_cast<double>(m % 6) / 5;
      rows(i, 2 * m) = 100 + 150 * along + bend * along * along;
      rows(i, 2 * m + 1) = (m < 6 ? 80 : 460) + curl * along * (1 - along) + sway * along;
    }
  }
  return rows;
}

Eigen::MatrixXd anywhere(Eigen::Index frames, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.0, 1000.0);
  Eigen::MatrixXd rows(frames, 2 * kMarkers);
  for (Eigen::Index i = 0; i < rows.size(); ++i) rows.data()[i] = place(random);
  return rows;
}

double distance_px(const Eigen::MatrixXd& layouts, Eigen::Index row, const Markers& markers) {
  const bool any =
      std::any_of(markers.begin(), markers.end(), [](const Marker& m) { return m.seen; });
  double sum = 0;
  int used = 0;
  for (Eigen::Index m = 0; m < kMarkers; ++m) {
    const Marker& marker = markers[static_cast<std::size_t>(m)];
    if (any && !marker.seen) continue;
    sum += std::hypot(layouts(row, 2 * m) - marker.u, layouts(row, 2 * m + 1) - marker.v);
    ++used;
  }
  return sum / used;
}

Markers near_row(const Eigen::MatrixXd& layouts, Eigen::Index row, double off_px,
                 std::mt19937& random) {
  std::normal_distribution<double> off(0, off_px);
  std::bernoulli_distribution hidden(0.25);
  Markers markers;
  for (Eigen::Index m = 0; m < kMarkers; ++m)
    markers.push_back({layouts(row, 2 * m) + off(random), layouts(row, 2 * m + 1) + off(random),
                       !hidden(random), 0.05});
  return markers;
}

/// In so many queries, near recorded poses and far from all.
void expect_as_brute_force(const Eigen::MatrixXd& layouts, int queries) {
  const LayoutSearch search(layouts);
  std::mt19937 random(5);
  std::uniform_int_distribution<Eigen::Index> any_row(0, layouts.rows() - 1);
  for (int query = 0; query < queries; ++query) {
    const double off_px = query % 3 == 0 ? 0.1 : query % 3 == 1 ? 3.0 : 60.0;
    Markers markers = near_row(layouts, any_row(random), off_px, random);
    if (query % 10 == 9)
      for (Marker& marker : markers) marker.seen = false;  // then all count
    std::vector<char> without;
    if (query % 4 == 3 && layouts.rows() > 1) {
      without.assign(static_cast<std::size_t>(layouts.rows()), 0);
      without[static_cast<std::size_t>(search.nearest(markers).row)] = 1;
    }
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index row = 0; row < layouts.rows(); ++row)
      if (without.empty() || without[static_cast<std::size_t>(row)] == 0)
        least = std::min(least, distance_px(layouts, row, markers));
    const auto found = search.nearest(markers, without);
    // Places and sums are kept in float: what differs by less is a tie.
    const double rounding_px = 1e-5 * (1000 + least);
    EXPECT_NEAR(distance_px(layouts, found.row, markers), least, rounding_px) << query;
    EXPECT_NEAR(found.distance_px, least, rounding_px) << query;
    if (!without.empty()) {
      EXPECT_EQ(without[static_cast<std::size_t>(found.row)], 0);
    }
  }
}

TEST(LayoutSearch, FindsWhatLookingAtAllFinds) {
  for (const Eigen::Index frames : {1, 2, 3, 10, 1650})
    expect_as_brute_force(anywhere(frames, 3), 40);
  expect_as_brute_force(wandering(20000), 60);
}

TEST(LayoutSearch, AHundredThousandFramesAreSearchedExactlyInTheirOwnSpace) {
  const Eigen::MatrixXd layouts = wandering(100000);
  expect_as_brute_force(layouts, 30);
  // Places in float, two numbers of a row, and a thousandth for the groups.
  const double per_frame = 2 * kMarkers * sizeof(float) + sizeof(int) + sizeof(std::size_t);
  EXPECT_LT(static_cast<double>(LayoutSearch(layouts).memory_bytes()), 1.02e5 * per_frame);
}

TEST(LayoutSearch, TheFirstOfLayoutsThatAreTheSameIsTaken) {
  Eigen::MatrixXd layouts = anywhere(500, 9);
  layouts.row(499) = layouts.row(77);
  layouts.row(78) = layouts.row(77);
  const LayoutSearch search(layouts);
  Markers markers;
  for (Eigen::Index m = 0; m < kMarkers; ++m)
    markers.push_back({layouts(77, 2 * m), layouts(77, 2 * m + 1), true, 0});
  EXPECT_EQ(search.nearest(markers).row, 77);
  std::vector<char> without(500, 0);
  without[77] = 1;
  EXPECT_EQ(search.nearest(markers, without).row, 78);
  without.assign(500, 1);
  EXPECT_TRUE(std::isinf(search.nearest(markers, without).distance_px));
}

TEST(LayoutSearch, StepsAreThoseBetweenNeighbours) {
  Eigen::MatrixXd layouts(101, 2 * kMarkers);
  for (Eigen::Index i = 0; i < layouts.rows(); ++i)
    for (Eigen::Index c = 0; c < layouts.cols(); ++c)
      layouts(i, c) = c % 2 == 0 ? 10.0 * c + 3.0 * i : 50.0 * c;
  EXPECT_NEAR(LayoutSearch(layouts).median_step_px(), 3.0, 1e-4);
}

TEST(LayoutSearch, TellsHowFarAMixtureOfLayoutsLies) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> weight(-0.5, 1.0);
  for (const Eigen::MatrixXd& layouts : {wandering(3000), anywhere(500, 6)}) {
    const LayoutSearch search(layouts);
    std::uniform_int_distribution<int> any_row(0, static_cast<int>(layouts.rows()) - 1);
    for (int query = 0; query < 50; ++query) {
      std::vector<int> rows;
      Eigen::VectorXd weights(8);
      Eigen::MatrixXd mixture = Eigen::MatrixXd::Zero(1, layouts.cols());
      for (Eigen::Index i = 0; i < 8; ++i) {
        rows.push_back(any_row(random));
        weights[i] = weight(random);
        mixture += weights[i] * layouts.row(rows.back());
      }
      const Markers markers = near_row(layouts, rows.front(), 3, random);
      EXPECT_NEAR(search.distance_px(markers, rows, weights), distance_px(mixture, 0, markers),
                  1e-3);
    }
  }
}

}  // namespace
}  // namespace alltact
