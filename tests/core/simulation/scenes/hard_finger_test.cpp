// The hard cases of contacts, dots and the finger's shape show what they say.
#include "tests/core/simulation/scenes/shipped_scene.h"

#include <set>

namespace alltact {
namespace {

TEST(ShippedScenes, HardHiddenDots) {
  const Plan plan = ShippedScene("hard_hidden_dots").plan();
  std::set<std::vector<bool>> patterns;
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    std::vector<bool> seen;
    for (const Truth::Dot& dot : plan.truth(frame).markers) seen.push_back(dot.visible);
    EXPECT_EQ(seen.size(), 12U);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 6);
    patterns.insert(seen);
  }
  EXPECT_GE(patterns.size(), 5U);
}

TEST(ShippedScenes, HardWornDots) {
  const ShippedScene scene("hard_worn_dots");
  const Plan plan = scene.plan({ALLTACT_BARE}), fresh = scene.plan({ALLTACT_BARE, "worn-marker"});
  const Plan bare = scene.plan({ALLTACT_BARE, "worn-marker", "markers"});
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    const Truth truth = plan.truth(frame);
    const cv::Mat_<float> worn = plan.render(frame), all = fresh.render(frame),
                          none = bare.render(frame);
    for (std::size_t i = 0; i < truth.markers.size(); ++i) {
      EXPECT_TRUE(truth.markers[i].visible);
      const cv::Point at(static_cast<int>(std::lround(truth.markers[i].u)),
                         static_cast<int>(std::lround(truth.markers[i].v)));
      const double kept = i == 3 ? 0 : i == 1 || i == 8 ? 0.25 : 1;
      EXPECT_NEAR((worn(at) - none(at)) / (all(at) - none(at)), kept, 1e-4) << i;
    }
  }
}

TEST(ShippedScenes, HardDotsAtTheEdge) {
  const Plan plan = ShippedScene("hard_dots_at_the_edge").plan();
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    const Truth truth = plan.truth(frame);
    for (std::size_t i = 3; i < 6; ++i) {
      // From the dot's middle down to the face; the rim is 0.4 of 1.4 mm from the edge.
      const int u = static_cast<int>(std::lround(truth.markers[i].u));
      int edge = 0;
      while (std::isnan(truth.view_z_mm.at<float>(edge, u))) ++edge;
      const double rim_px = (edge - truth.markers[i].v) * 0.4 / 1.4;
      EXPECT_GT(rim_px, 0.2) << i;
      EXPECT_LT(rim_px, 2.5) << i;
    }
  }
}

TEST(ShippedScenes, HardSteepWalls) {
  const Plan plan = ShippedScene("hard_steep_walls").plan();
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    const Truth truth = plan.truth(frame);
    double jump = 0;
    for (int v = 1; v < truth.depth_mm.rows; ++v)
      for (int u = 0; u < truth.depth_mm.cols; ++u) {
        const double step =
            std::abs(truth.depth_mm.at<float>(v, u) - truth.depth_mm.at<float>(v - 1, u));
        jump = std::isnan(step) ? jump : std::max(jump, step);
      }
    EXPECT_GT(jump, 0.75);
  }
}

TEST(ShippedScenes, HardTwoContacts) {
  const Plan plan = ShippedScene("hard_two_contacts").plan();
  for (int frame = 0; frame < 3; ++frame) {
    const Truth truth = plan.truth(frame);
    EXPECT_EQ(truth.balls.size(), 2U);
    EXPECT_EQ(region_count(deeper_than(truth, 0.02)), frame < 2 ? 2 : 1) << frame;
  }
}

TEST(ShippedScenes, HardPlate) {
  const Plan plan = ShippedScene("hard_plate").plan();
  const StraightFace face;
  for (int frame = 0; frame < 2; ++frame) {
    const Truth truth = plan.truth(frame);
    const cv::Mat_<std::uint8_t> pressed = deeper_than(truth, 0.2), all = on_face(truth);
    const auto touched = moments_of(plan, truth, [&](int v, int u) { return pressed(v, u) != 0; });
    EXPECT_NEAR(touched.area_mm2 / (24 * 116), 0.22, 0.02);
    cv::Mat by_column, face_by_column;
    cv::reduce(pressed, by_column, 0, cv::REDUCE_MAX);
    int across = 0, columns = 0;
    for (int u = 0; u < pressed.cols; ++u) {
      if (by_column.at<std::uint8_t>(0, u) == 0) continue;
      ++columns;
      across += cv::countNonZero(pressed.col(u)) == cv::countNonZero(all.col(u));
    }
    EXPECT_GT(across, 0.95 * columns);
  }
}

TEST(ShippedScenes, HardTipAndEdge) {
  const Plan plan = ShippedScene("hard_tip_and_edge").plan();
  for (int frame = 0; frame < 4; ++frame) {
    const Truth truth = plan.truth(frame);
    const cv::Mat pressed = deeper_than(truth, 0.1);
    cv::Mat outside, beside;
    // The base lies outside the picture.
    cv::copyMakeBorder(~on_face(truth), outside, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(255));
    cv::dilate(outside, beside, cv::Mat());
    const cv::Rect whole(1, 1, pressed.cols, pressed.rows);
    EXPECT_GT(cv::countNonZero(pressed & beside(whole)), 2) << frame;
    EXPECT_EQ(region_count(pressed), 1) << frame;
  }
}

TEST(ShippedScenes, HardLightPress) {
  const ShippedScene scene("hard_light_press");
  const Plan plan = scene.plan({ALLTACT_BARE}), free = scene.plan({ALLTACT_BARE, "ball"});
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_EQ(plan.truth(frame).ball->depth_mm, 0.05);
    double darker = 0;
    cv::minMaxLoc(free.render(frame) - plan.render(frame), nullptr, &darker);
    EXPECT_GT(darker, 1);
    EXPECT_LT(darker, 4);
  }
}

TEST(ShippedScenes, HardDeepPress) {
  const ShippedScene scene("hard_deep_press");
  const Plan plan = scene.plan({ALLTACT_BARE});
  const Plan free = scene.plan({ALLTACT_BARE, "ball", "rolloff", "bulge"});
  for (int frame = 0; frame < 3; ++frame) {
    const Truth truth = plan.truth(frame);
    const cv::Mat_<float> share = ratio_of(plan.render(frame), free.render(frame));
    const cv::Point at = deepest_pixel(truth);
    const double cos = std::cos(34 * std::numbers::pi / 180);
    const double left = 1.5 - truth.depth_mm.at<float>(at) * cos;
    EXPECT_NEAR(truth.depth_mm.at<float>(at), 1.3, 0.02);
    EXPECT_NEAR(share(at), layer_reflectance(0.6, 0, left) / layer_reflectance(0.6, 0, 1.5), 1e-3);
    double least = 0;
    cv::minMaxLoc(truth.depth_mm, &least, nullptr, nullptr, nullptr, on_face(truth));
    EXPECT_LT(least, -0.02) << "swollen beside the ball";
  }
}

TEST(ShippedScenes, HardRoundAndLong) {
  const Plan plan = ShippedScene("hard_round_and_long").plan();
  for (int frame = 0; frame < 2; ++frame) {
    const Truth truth = plan.truth(frame);
    cv::Mat_<int> labels;
    ASSERT_EQ(cv::connectedComponents(deeper_than(truth, 0.05), labels), 3);
    std::vector<RegionMoments> regions;
    for (const int label : {1, 2})
      regions.push_back(
          moments_of(plan, truth, [&](int v, int u) { return labels(v, u) == label; }));
    if (regions[0].elongation() > regions[1].elongation()) std::swap(regions[0], regions[1]);
    EXPECT_LT(regions[0].elongation(), 1.2);
    EXPECT_NEAR(regions[1].elongation(), 4, 0.4);
    EXPECT_NEAR(regions[1].angle_deg(), 30, 1);
  }
}

TEST(ShippedScenes, HardTwist) {
  const Plan plan = ShippedScene("hard_twist").plan();
  for (int frame = 0; frame < 5; ++frame) {
    const Truth truth = plan.truth(frame);
    const double twist = (frame - 2) * 4 * std::numbers::pi / 180;
    EXPECT_NEAR(truth.pose.at("twist_deg"), (frame - 2) * 4, 1e-9);
    EXPECT_EQ(region_count(deeper_than(truth, 0.05)), 1);
    // Across the face, near its tip, z changes by the sine of the twist there.
    const int u = 800;
    int top = 0, bottom = 539;
    while (std::isnan(truth.view_z_mm.at<float>(top, u))) ++top;
    while (std::isnan(truth.view_z_mm.at<float>(bottom, u))) --bottom;
    const double z_top = truth.view_z_mm.at<float>(top, u),
                 z_bottom = truth.view_z_mm.at<float>(bottom, u);
    const double across = ((bottom - 269.5) * z_bottom - (top - 269.5) * z_top) / 523.9;
    const double slope = (z_bottom - z_top) / across;
    if (frame == 2) {
      EXPECT_NEAR(slope, 0, 1e-6);
    } else {
      EXPECT_GT(slope / std::tan(twist), 0.5) << frame;
      EXPECT_LT(slope / std::tan(twist), 1.6) << frame;
    }
  }
}

TEST(ShippedScenes, HardSteepFace) {
  const Plan plan = ShippedScene("hard_steep_face").plan();
  const Truth truth = plan.truth(0);
  double nearest = 0, farthest = 0;
  cv::minMaxLoc(truth.view_z_mm, &nearest, &farthest, nullptr, nullptr, on_face(truth));
  EXPECT_NEAR(nearest, 28, 0.5);
  EXPECT_NEAR(farthest, 28 + 110 * std::sin(std::numbers::pi / 4), 0.5);
  // A pixel at the tip: 1 mm along the face is less than two.
  int tip = 0;
  for (int u = 0; u < truth.view_z_mm.cols; ++u)
    if (!std::isnan(truth.view_z_mm.at<float>(270, u))) tip = u;
  const double z =
      truth.view_z_mm.at<float>(270, tip - 1) - truth.view_z_mm.at<float>(270, tip - 11);
  EXPECT_LT(10 / (z * std::numbers::sqrt2), 2);
  const cv::Mat image = plan.render(0);
  EXPECT_LT(cv::countNonZero(image == 255), 0.002 * image.total());
}

TEST(ShippedScenes, HardFaintEdges) {
  const ShippedScene scene("hard_faint_edges");
  const Plan plan = scene.plan({ALLTACT_BARE, "defocus", "ball"});
  const cv::Mat_<float> light = plan.render(0);
  const Truth truth = plan.truth(0);
  for (const int u : {150, 300, 450, 600}) {
    int edge = 0;
    while (std::isnan(truth.view_z_mm.at<float>(edge, u))) ++edge;
    const double step = light(edge + 2, u) - light(edge - 3, u);
    EXPECT_LT(step / light(edge + 2, u), 0.66) << u;
  }
}

}  // namespace
}  // namespace alltact
