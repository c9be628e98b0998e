// The scenes of experiments show what they say.
#include "tests/core/simulation/scenes/shipped_scene.h"

#include <set>

namespace alltact {
namespace {

// By how much the deepest pixel is darker than the untouched ones around it, grey levels.
double darker_than_around(const Plan& plan, int frame, const Truth& truth, int reach_px) {
  const cv::Mat_<float> light = plan.render(frame);
  const cv::Point at = deepest_pixel(truth);
  const cv::Rect around =
      cv::Rect(at.x - reach_px, at.y - reach_px, 2 * reach_px + 1, 2 * reach_px + 1) &
      cv::Rect(0, 0, light.cols, light.rows);
  const cv::Mat untouched = cv::abs(truth.depth_mm) < 0.002;
  return mean_of(light(around), untouched(around)) - light(at);
}

TEST(ShippedScenes, ExperimentLocalisation) {
  const ShippedScene scene("experiment_localisation");
  const Plan plan = scene.plan({ALLTACT_BARE});
  ASSERT_EQ(plan.frame_count(), 27);
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (int frame = 0; frame < 27; ++frame) {
    const Truth truth = plan.truth(frame);
    ASSERT_EQ(truth.balls.size(), 1U);
    const Eigen::Vector3d at = truth.ball->centre_mm;
    const int row = frame / 9 - 1;
    EXPECT_NEAR(at.y(), row * 6.0, 1e-9);
    EXPECT_EQ(truth.ball->depth_mm, 0.6);
    if (frame % 9 > 0) {
      EXPECT_NEAR((at - last).norm(), 10, 0.5) << frame;
    }
    last = at;
    // It shows: the deepest pixel is darker than one beside the contact, by the layer's law.
    const double darker = darker_than_around(plan, frame, truth, 45);
    EXPECT_GT(darker, 0.15 * plan.render(frame).at<float>(deepest_pixel(truth))) << frame;
  }
}

TEST(ShippedScenes, ExperimentPose) {
  const Plan plan = ShippedScene("experiment_pose").plan();
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    const Truth truth = plan.truth(frame);
    const cv::Mat_<std::uint8_t> pressed = deeper_than(truth, 0.4);
    EXPECT_EQ(region_count(pressed), 1);
    const auto bar = moments_of(plan, truth, [&](int v, int u) { return pressed(v, u) != 0; });
    const double off = std::remainder(bar.angle_deg() - (frame - 5) * 15.0, 180);
    EXPECT_NEAR(off, 0, 0.8) << frame;
    EXPECT_NEAR(bar.elongation(), 4, 0.5) << frame;
    EXPECT_NEAR(bar.area_mm2, 16 * 4, 6) << frame;
    EXPECT_NEAR(bar.middle_mm.x(), frame % 2 == 0 ? 40 : 70, 1) << frame;
  }
}

TEST(ShippedScenes, ExperimentLeastTouch) {
  const ShippedScene scene("experiment_least_touch");
  const Plan plan = scene.plan({ALLTACT_BARE});
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    const Truth truth = plan.truth(frame);
    EXPECT_NEAR(truth.ball->depth_mm, 0.01 * std::pow(2, frame % 6), 1e-12);
    const double darker = darker_than_around(plan, frame, truth, 30);
    if (frame % 6 == 0) {
      EXPECT_LT(darker, 1.5) << frame;  // grey levels; noise has 1
    }
    if (frame % 6 == 5) {
      EXPECT_GT(darker, 6) << frame;
    }
  }
}

TEST(ShippedScenes, ExperimentLeastForce) {
  const Plan plan = ShippedScene("experiment_least_force").plan();
  ASSERT_EQ(plan.frame_count(), 129);
  constexpr std::array kForces_N{0.05, 0.1, 0.2, 0.4, 0.7, 1.0, 1.5, 2.0};
  const Truth free = plan.truth(128);
  EXPECT_TRUE(free.contacts.empty());
  for (int frame = 0; frame < 128; frame += 5) {
    const Truth truth = plan.truth(frame);
    ASSERT_EQ(truth.contacts.size(), 1U) << frame;
    const ContactTruth& contact = truth.contacts.front();
    EXPECT_EQ(static_cast<int>(contact.face), 1 + frame / 32) << frame;
    EXPECT_NEAR(contact.force_N->norm(), kForces_N[static_cast<std::size_t>(frame % 8)], 1e-3);
    const int place = frame % 32 / 8;
    EXPECT_NEAR(contact.along_mm, 25 + 20 * place, 0.6) << "slides a little";
    // Body and skin give way, so that the dots tell.
    double moved_px = 0;
    for (std::size_t i = 0; i < free.markers.size(); ++i)
      moved_px += std::hypot(truth.markers[i].u - free.markers[i].u,
                             truth.markers[i].v - free.markers[i].v);
    EXPECT_GT(moved_px, 0.05 * contact.force_N->norm()) << frame;
  }
}

TEST(ShippedScenes, ExperimentDirection) {
  const Plan plan = ShippedScene("experiment_direction").plan();
  ASSERT_EQ(plan.frame_count(), 9);
  const Truth rest = plan.truth(0);
  std::vector<double> angles;
  for (int frame = 1; frame < 9; ++frame) {
    const Truth truth = plan.truth(frame);
    EXPECT_EQ(cv::countNonZero(deeper_than(truth, 0)), 0);
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < truth.markers.size(); ++i)
      offset += Eigen::Vector2d(truth.markers[i].u - rest.markers[i].u,
                                truth.markers[i].v - rest.markers[i].v);
    EXPECT_GT(offset.norm(), 12) << frame;  // px, of twelve dots
    angles.push_back(std::atan2(offset.y(), offset.x()) * 180 / std::numbers::pi);
  }
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GT(std::abs(std::remainder(angles[i] - angles[k], 360)), 15) << i << ' ' << k;
}

// Sum of the dots' distances, as the source paper compares poses.
double distance_px(const Truth& a, const Truth& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.markers.size(); ++i)
    sum += std::hypot(a.markers[i].u - b.markers[i].u, a.markers[i].v - b.markers[i].v);
  return sum;
}

TEST(ShippedScenes, ExperimentReferences) {
  const Plan plan = ShippedScene("experiment_references").plan();
  const Plan recording = ShippedScene("demo_reference").plan();
  std::vector<Truth> recorded;
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    recorded.push_back({});
    recorded.back().markers = recording.truth(frame).markers;
  }
  int by_single = 0, by_nearest = 0;
  constexpr double kClose_px = 40;
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    const Truth now = plan.truth(frame);
    EXPECT_EQ(cv::countNonZero(deeper_than(now, 0)), 0);
    double nearest = 1e9;
    for (const Truth& then : recorded) nearest = std::min(nearest, distance_px(now, then));
    by_single += distance_px(now, recorded.front()) < kClose_px;
    by_nearest += nearest < kClose_px;
  }
  std::printf("[ figures  ] under 40 px: %d of 40 with one reference, %d with %zu\n", by_single,
              by_nearest, recorded.size());
  EXPECT_GE(by_nearest, 38);
  EXPECT_LE(by_single, 28);
}

TEST(ShippedScenes, ExperimentRoomLight) {
  const ShippedScene scene("experiment_room_light");
  const Plan plan = scene.plan({ALLTACT_BARE}), dark = scene.plan({ALLTACT_BARE, "ambient"});
  const Plan places = ShippedScene("experiment_localisation").plan();
  ASSERT_EQ(plan.frame_count(), places.frame_count());
  constexpr double kLevel = 0.004 * 300;
  for (int frame = 0; frame < plan.frame_count(); frame += 5) {
    const Truth truth = plan.truth(frame);
    EXPECT_EQ(truth.ball->centre_mm, places.truth(frame).ball->centre_mm);
    const cv::Mat untouched = within_face(truth, 2) & (truth.depth_mm == 0);
    const cv::Mat added = plan.render(frame) - dark.render(frame);
    EXPECT_NEAR(mean_of(added, untouched), kLevel * layer_reflectance(0.6, 0, 1.5), 1e-3);
  }
}

// Pushes on the contact face at places that come again every 22 frames; drag across alone.
void expect_drawn_pushes(const Plan& plan) {
  double least_N = 1e9, most_N = 0;
  for (int frame = 0; frame < plan.frame_count(); frame += 7) {
    const Truth truth = plan.truth(frame);
    ASSERT_EQ(truth.contacts.size(), 1U) << frame;
    const ContactTruth& contact = truth.contacts.front();
    EXPECT_EQ(contact.face, PushedFace::kContact);
    EXPECT_NEAR(contact.along_mm, 27 + 3 * (frame % 22), 1.0) << "slides a little";
    EXPECT_LE(std::abs(contact.across_mm), 4.6);
    EXPECT_LE(std::abs(contact.force_N->y()), 1.001);
    least_N = std::min(least_N, contact.force_N->norm());
    most_N = std::max(most_N, contact.force_N->norm());
  }
  EXPECT_GE(least_N, 0.2);
  EXPECT_LT(least_N, 0.6);
  EXPECT_GT(most_N, 2.0);
  EXPECT_LE(most_N, std::hypot(2.5, 1.0));
}

TEST(ShippedScenes, ExperimentForce) {
  const Plan plan = ShippedScene("experiment_force").plan();
  ASSERT_EQ(plan.frame_count(), 484);
  expect_drawn_pushes(plan);
}

TEST(ShippedScenes, ExperimentRoomForce) {
  const Plan plan = ShippedScene("experiment_room_force").plan();
  ASSERT_EQ(plan.frame_count(), 44);
  expect_drawn_pushes(plan);
}

TEST(ShippedScenes, ExperimentThreadM8) {
  const Plan plan = ShippedScene("experiment_thread_m8").plan();
  ASSERT_EQ(plan.frame_count(), 4);
  EXPECT_EQ(plan.truth(0).pose.at("q1_mm"), 0);
  EXPECT_EQ(plan.truth(2).pose.at("q1_mm"), 3);
  // Crests along the face, where the thread lies along it.
  const Truth truth = plan.truth(0);
  const StraightFace face;
  const int v = 269;
  std::vector<double> crests;
  for (int u = 1; u + 1 < truth.depth_mm.cols; ++u) {
    const float* depth = truth.depth_mm.ptr<float>(v);
    if (depth[u] > 0.3 && depth[u] > depth[u - 1] && depth[u] >= depth[u + 1])
      crests.push_back(face.place(plan, u, v, truth.view_z_mm.at<float>(v, u)).x());
  }
  ASSERT_GE(crests.size(), 9U);
  EXPECT_NEAR((crests.back() - crests.front()) / static_cast<double>(crests.size() - 1), 1.25,
              0.03);
}

TEST(ShippedScenes, ExperimentUsbPlug) {
  const Plan plan = ShippedScene("experiment_usb_plug").plan();
  for (int frame = 0; frame < 4; ++frame) {
    const Truth truth = plan.truth(frame);
    const cv::Mat_<std::uint8_t> pressed = deeper_than(truth, 0.35);
    EXPECT_EQ(region_count(pressed), 1);
    EXPECT_EQ(region_count(~pressed), 3) << "all around, and two windows";
    if (frame >= 2) continue;  // bent
    const auto plug = moments_of(plan, truth, [&](int v, int u) { return pressed(v, u) != 0; });
    EXPECT_NEAR(plug.area_mm2, 12 * 16 - 2 * 2.5 * 2, 8);
  }
}

TEST(ShippedScenes, ExperimentTime) {
  const Plan plan = ShippedScene("experiment_time").plan();
  EXPECT_EQ(plan.render(0).size(), cv::Size(1920, 1080));
  for (int frame = 0; frame < 4; ++frame) {
    const Truth truth = plan.truth(frame);
    EXPECT_EQ(truth.markers.size(), 24U);
    EXPECT_EQ(truth.balls.size(), frame < 2 ? 0U : 1U);
  }
}

// Every experiment and every hard case has a test of its name here: hard_dead_lamp is HardDeadLamp.
TEST(ShippedScenes, AllAreTested) {
  std::set<std::string> tests;
  const auto& unit = *testing::UnitTest::GetInstance();
  for (int i = 0; i < unit.total_test_suite_count(); ++i) {
    const auto& suite = *unit.GetTestSuite(i);
    if (std::string_view(suite.name()) != "ShippedScenes") continue;
    for (int k = 0; k < suite.total_test_count(); ++k) tests.insert(suite.GetTestInfo(k)->name());
  }
  int scenes = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(ALLTACT_SOURCE_DIR "/resources/scenes")) {
    const std::string stem = entry.path().stem().string();
    if (!stem.starts_with("experiment_") && !stem.starts_with("hard_")) continue;
    std::string name;
    bool begins = true;
    for (const char c : stem) {
      if (c != '_') name += begins ? static_cast<char>(std::toupper(c)) : c;
      begins = c == '_';
    }
    EXPECT_TRUE(tests.contains(name)) << stem;
    ++scenes;
  }
  EXPECT_GT(scenes, 30);
}

}  // namespace
}  // namespace alltact
