// Outlines that jump, and others that only look as if they did.
#include "core/sensing/face/face_edges.h"
#include "tests/support/synthetic_face.h"

#include <functional>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr double kMiddleV = 270.0;

/// Every 8th column, half as wide as `half_width_px` says on either side of the middle.
FaceEdges edges_of(const std::function<double(double)>& half_width_px, double noise_px = 0.1) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, noise_px);
  FaceEdges edges;
  for (double u = 3.5; u < 960; u += 8) {
    edges.u.push_back(u);
    for (auto [edge, sign] : {std::pair{&edges.upper, -1.0}, std::pair{&edges.lower, 1.0}}) {
      edge->v.push_back(kMiddleV + sign * half_width_px(u) + noise(random));
      edge->sd.push_back(noise_px);
      edge->valid.push_back(1);
    }
  }
  return edges;
}

/// Narrower from base to tip.
double smooth(double u) { return 200.0 - 0.15 * u; }

TEST(OutlineJump, IsFoundWhereTheTipHidesTheMiddle) {
  for (const double at : {150.0, 480.0, 800.0})
    for (const double nearer : {0.8, 1.1, 1.6}) {
      const auto found =
          outline_jump(edges_of([&](double u) { return smooth(u) * (u > at ? nearer : 1.0); }));
      ASSERT_TRUE(found) << at << ", " << nearer;
      EXPECT_NEAR(found->u_px, at, 4.0);
    }
}

TEST(OutlineJump, IsFoundInAPictureOrOnlyOneSideIsTrusted) {
  int found_in = 0;
  for (const double nearer : {0.6, 0.85, 0.93, 1.07, 1.15, 1.5}) {
    const auto half_width_px = [&](double u) { return smooth(u) * (u > 600 ? nearer : 1.0); };
    test::SyntheticFace drawn;
    drawn.upper = [&](double u) { return kMiddleV - half_width_px(u); };
    drawn.lower = [&](double u) { return kMiddleV + half_width_px(u); };
    const auto edges = FaceEdgeFinder()(drawn.draw(3));
    ASSERT_TRUE(edges.ok()) << edges.error().sentence();
    int before = 0, behind = 0;
    for (std::size_t i = 0; i < edges->u.size(); ++i)
      if (edges->upper.valid[i] && edges->lower.valid[i]) ++(edges->u[i] < 600 ? before : behind);
    const auto found = outline_jump(*edges);
    EXPECT_EQ(found.has_value(), before > 2 && behind > 2)
        << nearer << ": " << before << ", " << behind;
    if (!found) continue;
    ++found_in;
    EXPECT_NEAR(found->u_px, 600, 40) << nearer;  // the finder loses the edges for a while
  }
  EXPECT_GE(found_in, 2);
}

TEST(OutlineJump, IsNoneOfASmoothFaceHoweverSteep) {
  EXPECT_FALSE(outline_jump(edges_of(smooth)));
  EXPECT_FALSE(outline_jump(edges_of(smooth, 3.0))) << "noise";
  // As an arc that turns away from sight at its end.
  EXPECT_FALSE(outline_jump(edges_of(
      [](double u) { return 60.0 + 100.0 * (1.0 - std::sqrt(std::max(0.0, 1.0 - u / 956.0))); })));
  // Nearly at the lens.
  EXPECT_FALSE(outline_jump(edges_of([](double u) { return 5.0 + 3000.0 / (u + 5.0); })));
}

TEST(OutlineJump, IsNoneWhereSomethingLiesOverTheEdges) {
  EXPECT_FALSE(outline_jump(
      edges_of([](double u) { return smooth(u) * (u > 300 && u < 500 ? 1.2 : 1.0); })));
  // A bent face of which a part is hidden.
  FaceEdges hidden = edges_of([](double u) { return 150.0 + 60.0 * std::sin(u / 150.0); });
  for (std::size_t i = 40; i < 70; ++i) hidden.lower.valid[i] = 0;
  EXPECT_FALSE(outline_jump(hidden));
  FaceEdges one_edge = edges_of(smooth);
  for (std::size_t i = 60; i < one_edge.u.size(); ++i) one_edge.upper.v[i] -= 40;
  EXPECT_FALSE(outline_jump(one_edge));
}

TEST(OutlineJump, LeavesTheShorterSideOut) {
  for (const bool at_high_u : {true, false}) {
    const auto beyond = [&](double u) { return at_high_u ? u > 910 : u < 50; };
    FaceEdges edges = edges_of([&](double u) { return smooth(u) * (beyond(u) ? 1.3 : 1.0); });
    edges.ends.first = edges.ends.last = FaceEnd{};
    const auto found = outline_jump(edges);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->shorter_fraction, 6.0 / 120, 1e-9);
    EXPECT_EQ(found->shorter_at_high_u, at_high_u);
    const FaceEdges left = longer_side(edges, *found);
    EXPECT_FALSE(outline_jump(left));
    EXPECT_EQ(left.ends.first.has_value(), at_high_u);
    EXPECT_EQ(left.ends.last.has_value(), !at_high_u);
    for (std::size_t i = 0; i < left.u.size(); ++i) {
      EXPECT_EQ(left.upper.valid[i] != 0, !beyond(left.u[i])) << i;
      EXPECT_EQ(left.lower.valid[i] != 0, !beyond(left.u[i])) << i;
    }
  }
}

TEST(OutlineJump, NeedsColumnsToTell) {
  EXPECT_FALSE(outline_jump({}));
  FaceEdges untrusted = edges_of([](double u) { return smooth(u) * (u > 480 ? 1.5 : 1.0); });
  for (std::size_t i = 5; i < untrusted.u.size(); ++i) untrusted.upper.valid[i] = 0;
  EXPECT_FALSE(outline_jump(untrusted));
}

}  // namespace
}  // namespace alltact
