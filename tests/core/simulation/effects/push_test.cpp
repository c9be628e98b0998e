#include "core/simulation/mechanics/ball_contact.h"
#include "core/simulation/mechanics/rubber.h"
#include "tests/core/simulation/effects/pushed_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Push, DentsTheLayerAsItsForceAndSoftnessSay) {
  Parameters random(31);
  const double modulus = modulus_from_shore_a(5).value();
  for (int i = 0; i < 8; ++i) {
    const double radius = random.between(2, 6), force = random.between(0.2, 2);
    const double x = random.between(-5, 5), y = random.between(-5, 5);
    const double d =
        BondedLayerContact::create(modulus, 1.5, radius)->indentation_mm(force).value();
    const std::string push =
        pushing(fmt::format("s_mm: {}, y_mm: {}, radius_mm: {}, force_N: {}", x, y, radius, force));
    // On a flat sensor, and on a finger that stands firm: the ball is at that depth.
    const Truth flat = plan_of(flat_text(push)).truth(0);
    ASSERT_EQ(flat.balls.size(), 1U);
    EXPECT_NEAR(flat.balls[0].depth_mm, d, 1e-9);
    EXPECT_NEAR((flat.balls[0].centre_mm - Eigen::Vector3d(x, y, 31.5 + radius - d)).norm(), 0,
                1e-9);
    const std::string there = pushing(
        fmt::format("s_mm: {}, y_mm: {}, radius_mm: {}, force_N: {}", x + 50, y, radius, force));
    const Truth firm = plan_of(scene_text(there)).truth(0);
    const double theta = 34 * M_PI / 180;
    EXPECT_NEAR(firm.ball->depth_mm * std::cos(theta), d, 1e-9);
    // With a body: as deep along its normal, where the skin has gone with it.
    const PlacedScene placed(scene_text(there + kPushedBody));
    const FrameGeometry geometry = placed.at(0);
    ASSERT_EQ(geometry.contacts.size(), 1U);
    const ContactTruth& contact = geometry.contacts[0];
    const auto& press = std::get<BallPress>(geometry.presses.at(0));
    EXPECT_NEAR(press.pose.normal_depth_mm(), d, 1e-9);
    EXPECT_EQ(contact.depth_mm, press.pose.depth_mm);
    EXPECT_EQ(contact.along_mm, press.pose.s_mm);
    EXPECT_NEAR(contact.force_N->norm(), force, 1e-9);
    const double lifted = std::abs(y * std::sin(geometry.curve()->at(x + 50).twist));
    EXPECT_NEAR((press.pose.luf_mm - contact.point_mm).norm(), 0, lifted + 0.01);
    EXPECT_GT(contact.direction.dot(-press.pose.normal), std::cos(0.03));
    EXPECT_LT(tip_of(geometry).z(), tip_of(PlacedScene(scene_text(there)).at(0)).z() - 0.05);
  }
}

// The finger bends away, leans and twists by where it is pushed.
TEST(Push, MovesTheFingerAwayFromEachFace) {
  const Eigen::Vector3d still = tip_of(PlacedScene(scene_text("")).at(0));
  const Eigen::Vector3d out(-std::sin(34 * M_PI / 180), 0, std::cos(34 * M_PI / 180));
  const auto pushed = [&](const std::string& face, const std::string& how) {
    return PlacedScene(scene_text(pushing("s_mm: 80, radius_mm: 6, force_N: 0.8" + how, face) +
                                  kPushedBody))
        .at(0);
  };
  EXPECT_LT((tip_of(pushed("contact", "")) - still).dot(out), -0.5);
  EXPECT_GT((tip_of(pushed("back", "")) - still).dot(out), 0.5);
  EXPECT_GT((tip_of(pushed("upper", "")) - still).y(), 0.3);
  EXPECT_LT((tip_of(pushed("lower", "")) - still).y(), -0.3);
  const auto twist = [](const FrameGeometry& geometry) { return geometry.curve()->at(116).twist; };
  EXPECT_EQ(twist(pushed("contact", "")), 0);
  EXPECT_LT(twist(pushed("contact", ", y_mm: 6")), -1e-3);
  EXPECT_GT(twist(pushed("contact", ", y_mm: -6")), 1e-3);
  EXPECT_NEAR(twist(pushed("upper", ", y_mm: 3")) / twist(pushed("lower", ", y_mm: 3")), -1, 1e-9);
}

// What a push on a side moves there: dots near it, by what a half space's surface does (Hertz;
// Cattaneo and Mindlin), and no further than the friction hands on. Both sides are pushed alike, so
// that the finger stays where it is but for what drags it along.
TEST(Push, DragsTheDotsBesideIt) {
  const std::string camera =
      "model: pinhole, size: [1920, 1080], fx: 1020, fy: 1020, cx: 951, cy: 539";
  const std::string dots =
      "  - {use: sides, albedo: 0.1, depth_mm: 14}\n"
      "  - {use: markers, radius_mm: 0.1, setback_mm: 4, first: 0.1, last: 0.9, albedo: 0.9}\n";
  const double modulus = modulus_from_shore_a(40).value(), g = modulus / 3;
  struct Case {
    std::string drag;
    double along_N, across_N;
  };
  for (const Case& c : {Case{"", 0, 0}, Case{", along_N: 1.1, friction: 0.9", 1.1, 0},
                        Case{", along_N: 7, friction: 0.9", 0.9 * 1.5, 0},
                        Case{", along_N: -0.5, across_N: 0.8, friction: 0.9", -0.5, 0.8}}) {
    SCOPED_TRACE(c.drag);
    const std::string how = "s_mm: 57, y_mm: 9, radius_mm: 5, force_N: 1.5" + c.drag;
    const PlacedScene placed(
        scene_text(pushing(how, "lower") + pushing(how, "upper") + kPushedBody + dots, camera));
    const FrameGeometry geometry = placed.at(0);
    ASSERT_EQ(geometry.drags.size(), 2U);
    ASSERT_EQ(geometry.contacts.size(), 2U);
    EXPECT_TRUE(geometry.presses.empty());
    double nearest_px = 0;
    for (const ContactTruth& contact : geometry.contacts) {
      const bool is_lower = contact.face == PushedFace::kLower;
      EXPECT_EQ(contact.depth_mm, 0);
      const FaceCurve::Node here = geometry.curve()->at(57);
      const Eigen::Vector3d into = (is_lower ? -1 : 1) * Eigen::Vector3d::UnitY();
      const Eigen::Vector3d out = FaceCurve::normal(here), along(here.x_s, 0, here.z_s);
      const Eigen::Vector3d tangential = c.along_N * along + c.across_N * out;
      EXPECT_NEAR((*contact.force_N - 1.5 * into - tangential).norm(), 0, 1e-6);
      const double depth = 34 - 22 * 57.0 / 116;
      const Eigen::Vector3d middle =
          Eigen::Vector3d(here.x_mm, here.shift_mm, here.z_mm) - 12 * into + (9 - depth / 2) * out;
      EXPECT_NEAR((contact.point_mm - middle).norm(), 0, 1e-6);
      for (std::size_t i = 0; i < 6; ++i) {
        const FaceCurve::Node p = geometry.curve()->at(116 * (0.1 + 0.16 * static_cast<double>(i)));
        const Eigen::Vector3d centre =
            Eigen::Vector3d(p.x_mm, p.shift_mm, p.z_mm) - 12 * into - 4 * FaceCurve::normal(p);
        // Far enough off, a point force: Boussinesq, Cerruti.
        const double r = (centre - middle).norm();
        const Eigen::Vector3d way = (centre - middle) / r;
        const Eigen::Vector3d moved =
            (0.5 * 1.5 * into + 0.5 * tangential + 0.5 * way * way.dot(tangential)) /
            (2 * M_PI * g * r);
        const Camera& lens = placed.rays().camera();
        const Eigen::Vector2d expected = *lens.project(centre + moved);
        const double way_px = (expected - *lens.project(centre)).norm();
        const Eigen::Vector2d& got = geometry.discs[i + (is_lower ? 6 : 0)].centre_px;
        EXPECT_NEAR((got - expected).norm(), 0, 0.1 * way_px + 0.02) << i << ' ' << r;
        nearest_px = std::max(nearest_px, way_px);
      }
    }
    EXPECT_GT(nearest_px, 0.4);
  }
}

TEST(Push, IsTheSameInAnyOrderAndWithAnyThreads) {
  const auto scene = Scene::load(ALLTACT_SOURCE_DIR "/resources/scenes/pushed_finger.yaml");
  ASSERT_TRUE(scene) << scene.error().sentence();
  const Plan plan = Plan::compile(*scene, 3).value(), again = Plan::compile(*scene, 3).value();
  ASSERT_EQ(plan.frame_count(), 24);
  std::vector<cv::Mat> forth;
  for (const int frame : {0, 10, 15, 23}) forth.push_back(plan.render(frame));
  std::size_t i = 4;
  for (const int frame : {23, 15, 10, 0})
    EXPECT_TRUE(same_bytes(again.render(frame, frame == 10 ? 3 : 2), forth[--i]));
  EXPECT_GT(cv::norm(forth[0], forth[1], cv::NORM_INF), 40);
  EXPECT_GT(plan.truth(10).ball->depth_mm, 0.3);
  EXPECT_FALSE(plan.truth(20).ball);
}

// Beside what else bends and presses.
TEST(Push, GoesWithBendingAndOtherPresses) {
  const std::string others =
      "  - {use: bend, q1_mm: {from: -5, to: 5}, q2_mm: {from: -4, to: 4}}\n"
      "  - {use: sway, sway_mm: {from: -2, to: 2}}\n"
      "  - {use: ball, radius_mm: 3, s_mm: 30, y_mm: 2, depth_mm: 0.8, give_mm: 1}\n";
  const std::string motion = "motion: {kind: hold, pose: {q1_mm: 4, q2_mm: -3, sway_mm: 1.5}}\n";
  const std::string push = pushing("s_mm: 80, y_mm: -4, radius_mm: 4, force_N: 1");
  const FrameGeometry both = PlacedScene(motion + scene_text(push + kPushedBody + others)).at(1);
  const FrameGeometry alone = PlacedScene(motion + scene_text(others)).at(1);
  ASSERT_EQ(both.presses.size(), 2U);
  EXPECT_EQ(both.contacts.size(), 2U);
  EXPECT_EQ(std::get<BallPress>(both.presses[0]).pose.depth_mm, 0.8);
  // The rest that forces start from is bent: about as far away as from a straight one.
  const double moved = (tip_of(both) - tip_of(alone)).norm();
  const double straight = (tip_of(PlacedScene(scene_text(push + kPushedBody)).at(0)) -
                           tip_of(PlacedScene(scene_text("")).at(0)))
                              .norm();
  EXPECT_NEAR(moved / straight, 1, 0.1);
}

TEST(Push, SaysWhatIsWrong) {
  const std::string push = pushing("s_mm: 60, radius_mm: 4, force_N: 1");
  const auto reported = [](const std::string& effects) { return refusal(scene_text(effects)); };
  EXPECT_EQ(reported(push), "");
  EXPECT_EQ(reported(push + kPushedBody), "");
  EXPECT_THAT(reported(kPushedBody), HasSubstr("test.yaml:10: body: nothing pushes"));
  EXPECT_THAT(reported(pushing("s_mm: 60, radius_mm: 4, force_N: 1", "back")),
              HasSubstr("test.yaml:10: push: without its body"));
  EXPECT_THAT(reported(pushing("s_mm: 60, radius_mm: 4, force_N: 0")),
              HasSubstr("push.force_N: the force is 0"));
  EXPECT_THAT(reported(pushing("s_mm: 60, radius_mm: 4, force_N: -1")), HasSubstr("push.force_N"));
  EXPECT_THAT(reported(pushing("s_mm: 60, radius_mm: 4, force_N: 99")),
              HasSubstr("into the layer beyond the known range"));
  EXPECT_THAT(reported(pushing("s_mm: 130, radius_mm: 4, force_N: 1")),
              HasSubstr("beyond the ends"));
  EXPECT_THAT(reported(pushing("s_mm: 60, y_mm: 13, radius_mm: 4, force_N: 1")),
              HasSubstr("outside the face"));
  EXPECT_THAT(
      reported(pushing("s_mm: 110, y_mm: 9, radius_mm: 4, force_N: 1", "upper") + kPushedBody),
      HasSubstr("outside the face"));
  EXPECT_THAT(reported(pushing("s_mm: 60, radius_mm: 4, force_N: 50", "upper") + kPushedBody),
              HasSubstr("into the body beyond the known range"));
  EXPECT_THAT(reported(pushing("s_mm: 110, radius_mm: 40, force_N: 90", "back") + kPushedBody),
              HasSubstr("bends the finger beyond"));
  EXPECT_THAT(reported(pushing("s_mm: 60, radius_mm: 4, force_N: 1, along_N: 1")),
              HasSubstr("friction"));
  EXPECT_THAT(reported(pushing("s_mm: 60, radius_mm: 4, force_N: 1, friction: 1")),
              HasSubstr("friction"));
  EXPECT_THAT(reported(pushing("s_mm: 60, radius_mm: 4, force_N: 1, along_N: 0, friction: 1")),
              HasSubstr("push.along_N: the drag is 0"));
  EXPECT_THAT(reported(pushing("s_mm: 60, radius_mm: 4, force_N: 1", "front")),
              HasSubstr("push.face"));
  EXPECT_THAT(reported(pushing("s_mm: 60, radius_mm: 4, force_N: 1, layer_shore_a: 5", "back") +
                       kPushedBody),
              HasSubstr("layer_shore_a"));
  EXPECT_THAT(
      reported(pushing("s_mm: 60, radius_mm: 4, force_N: 1, until: 2") +
               kPushedBody.substr(0, kPushedBody.size() - 2) + ", damping_s: 1, until: 2}\n"),
      HasSubstr("still moves after a push"));
  EXPECT_THAT(reported(push + "  - {use: body, shore_a: 400, wall_mm: 4, base_depth_mm: 34, "
                              "tip_depth_mm: 12, coupling: 0.6}\n"),
              HasSubstr("test.yaml:11: body.shore_a"));
  EXPECT_THAT(reported(push + "  - {use: body, shore_a: 40, wall_mm: 9, base_depth_mm: 34, "
                              "tip_depth_mm: 12, coupling: 0.6}\n"),
              HasSubstr("two walls of 9 mm"));
  EXPECT_THAT(refusal(flat_text(push + kPushedBody)), HasSubstr("leave body out"));
  EXPECT_THAT(refusal(flat_text(pushing("s_mm: 1, radius_mm: 4, force_N: 1", "back"))),
              HasSubstr("contact face only"));
  EXPECT_EQ(refusal(flat_text(push)), "");
}

}  // namespace
}  // namespace alltact
