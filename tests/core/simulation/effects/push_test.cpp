#include "core/simulation/frame_plan.h"
#include "core/simulation/mechanics/bonded_layer.h"
#include "core/simulation/mechanics/shore.h"
#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

const std::string kBody =
    "  - {use: body, shore_a: 40, wall_mm: 4, base_depth_mm: 34, tip_depth_mm: 12, coupling: "
    "0.6}\n";

std::string pushing(const std::string& how, const std::string& face = "contact") {
  return "  - {use: push, face: " + face + ", " + how +
         (face == "contact" ? ", layer_shore_a: 5}\n" : "}\n");
}

// A frame as a Plan places it, with what the plan's truth does not tell.
class PlacedScene {
 public:
  explicit PlacedScene(const std::string& text)
      : scene_(Scene::parse(text, "test.yaml").value()),
        rays_(Camera::create(scene_.content().finger.camera).value()) {}

  [[nodiscard]] FrameGeometry at(int frame, double later = 0) const {
    FramePlan plan(scene_.content(), 7, frame);
    plan.move_to(later);
    const Scene::Content& content = scene_.content();
    std::optional<FaceCurve> curve;
    if (content.finger.face.kind == FaceKind::kFinRay) {
      curve.emplace(content.base_mm, content.incline_rad, content.length_mm);
      for (const auto& step : plan.geometry) step.effect->shape(step.context, *curve);
      curve->integrate();
    }
    FrameGeometry geometry(rays_, content.finger.face, std::move(curve));
    for (const auto& step : plan.geometry) step.effect->place(step.context, geometry);
    return geometry;
  }
  [[nodiscard]] const PixelRays& rays() const { return rays_; }

 private:
  Scene scene_;
  PixelRays rays_;
};

Eigen::Vector3d tip_of(const FrameGeometry& geometry) {
  const FaceCurve::Node p = geometry.curve()->at(geometry.curve()->length_mm());
  return {p.x_mm, p.shift_mm, p.z_mm};
}

std::string frames(int n, const std::string& effects) {
  std::string text = scene_text(effects);
  return text.replace(text.find("frames: 3"), 9, fmt::format("frames: {}", n));
}

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
    EXPECT_NEAR(
        (flat.balls[0].centre_mm - Eigen::Vector3d(x, y, 31.5 + radius - d)).norm(), 0, 1e-9);
    const std::string there = pushing(
        fmt::format("s_mm: {}, y_mm: {}, radius_mm: {}, force_N: {}", x + 50, y, radius, force));
    const Truth firm = plan_of(scene_text(there)).truth(0);
    const double theta = 34 * M_PI / 180;
    EXPECT_NEAR(firm.ball->depth_mm * std::cos(theta), d, 1e-9);
    // With a body: as deep along its normal, where the skin has gone with it.
    const PlacedScene placed(scene_text(there + kBody));
    const FrameGeometry geometry = placed.at(0);
    ASSERT_EQ(geometry.contacts.size(), 1U);
    const ContactTruth& contact = geometry.contacts[0];
    const auto& press = std::get<BallPress>(geometry.presses.at(0));
    EXPECT_NEAR(press.place.normal_depth_mm(), d, 1e-9);
    EXPECT_EQ(contact.depth_mm, press.place.depth_mm);
    EXPECT_EQ(contact.along_mm, press.place.s_mm);
    EXPECT_NEAR(contact.force_N->norm(), force, 1e-9);
    const double lifted = std::abs(y * std::sin(geometry.curve()->at(x + 50).twist));
    EXPECT_NEAR((press.place.luf_mm - contact.point_mm).norm(), 0, lifted + 0.01);
    EXPECT_GT(contact.direction.dot(-press.place.normal), std::cos(0.03));
    EXPECT_LT(tip_of(geometry).z(), tip_of(PlacedScene(scene_text(there)).at(0)).z() - 0.05);
  }
}

// The work that the balls do, their middles against the forces that the truth tells, is what finger
// and layer hold, and they give all of it back.
TEST(Push, HoldsTheWorkAndGivesItBack) {
  const int n = 240;
  const std::string effects =
      pushing(
          "s_mm: 70, y_mm: 5, radius_mm: 4, force_N: [{at: 0, is: 0}, {at: 80, is: 2, by: "
          "smooth}, {at: 160, is: 1}, {at: 239, is: 0}]") +
      pushing(
          "s_mm: 90, y_mm: -2, radius_mm: 5, force_N: [{at: 0, is: 0}, {at: 60, is: 0.2}, {at: "
          "140, is: 1.5, by: smooth}, {at: 239, is: 0}]",
          "upper") +
      pushing(
          "s_mm: 60, y_mm: -6, radius_mm: 5, force_N: [{at: 20, is: 0}, {at: 180, is: 1.2}, "
          "{at: 239, is: 0, by: smooth}]",
          "back") +
      kBody;
  const PlacedScene placed(frames(n, effects));
  struct Ball {
    Eigen::Vector3d centre, force_N;
  };
  std::map<PushedFace, Ball> before;
  const FinRayBody body = ElasticFinger{modulus_from_shore_a(40).value(), 4, 34, 12, 0.6, {}}
                              .body({FaceKind::kFinRay, 24, 1.5}, 116)
                              .value();
  const auto layer = BondedLayerContact::create(modulus_from_shore_a(5).value(), 1.5, 4).value();
  double work = 0, most = 0, greatest_error = 0;
  for (int frame = 0; frame < n; ++frame) {
    const FrameGeometry geometry = placed.at(frame);
    std::map<PushedFace, Ball> now;
    for (const ContactTruth& contact : geometry.contacts) {
      Ball ball{contact.point_mm, *contact.force_N};
      if (contact.face == PushedFace::kContact)
        ball.centre += (std::get<BallPress>(geometry.presses.at(0)).place.normal_depth_mm() - 4) *
                       contact.direction;
      now[contact.face] = ball;
      if (before.contains(contact.face)) {
        const Ball& last = before[contact.face];
        work += 0.5 * (last.force_N + ball.force_N).dot(ball.centre - last.centre);
      }
    }
    before = now;
    const double dent = geometry.presses.empty()
                            ? 0
                            : std::get<BallPress>(geometry.presses[0]).place.normal_depth_mm();
    const double held = body.energy_Nmm(*geometry.curve()->borne) + layer.energy_Nmm(dent);
    greatest_error = std::max(greatest_error, std::abs(work - held));
    most = std::max(most, work);
  }
  EXPECT_GT(most, 3);
  EXPECT_LT(greatest_error / most, 0.01);
  EXPECT_NEAR(work / most, 0, 0.01);
}

// The finger bends away, leans and twists by where it is pushed.
TEST(Push, MovesTheFingerAwayFromEachFace) {
  const Eigen::Vector3d still = tip_of(PlacedScene(scene_text("")).at(0));
  const Eigen::Vector3d out(-std::sin(34 * M_PI / 180), 0, std::cos(34 * M_PI / 180));
  const auto pushed = [&](const std::string& face, const std::string& how) {
    return PlacedScene(
               scene_text(pushing("s_mm: 80, radius_mm: 6, force_N: 0.8" + how, face) + kBody))
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
  for (const Case& c : {Case{"", 0, 0},
                        Case{", along_N: 1.1, friction: 0.9", 1.1, 0},
                        Case{", along_N: 7, friction: 0.9", 0.9 * 1.5, 0},
                        Case{", along_N: -0.5, across_N: 0.8, friction: 0.9", -0.5, 0.8}}) {
    SCOPED_TRACE(c.drag);
    const std::string how = "s_mm: 57, y_mm: 9, radius_mm: 5, force_N: 1.5" + c.drag;
    const PlacedScene placed(
        scene_text(pushing(how, "lower") + pushing(how, "upper") + kBody + dots, camera));
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

TEST(Push, CreepsAndIsDampedAsItsUnitsSay) {
  const std::string push = pushing("s_mm: 80, y_mm: 2, radius_mm: 4, force_N: 0.05");
  const auto body = [](const std::string& late) {
    return kBody.substr(0, kBody.size() - 2) + late + "}\n";
  };
  const auto bent = [&](const PlacedScene& placed, int frame, double later = 0) {
    const FrameGeometry geometry = placed.at(frame, later);
    return geometry.curve()->at(116).theta - 34 * M_PI / 180;
  };
  const double elastic = bent(PlacedScene(frames(400, push + kBody)), 100);
  EXPECT_LT(elastic, -1e-3);
  const PlacedScene creeping(
      frames(400, push + body(", creep: [{share: 0.3, time_s: 1}, {share: 0.2, time_s: 0.05}]")));
  const PlacedScene damped(frames(400, push + body(", damping_s: 0.4")));
  EXPECT_NEAR(bent(creeping, 0) / elastic, 1, 1e-9);
  EXPECT_EQ(bent(damped, 0), 0);
  for (const int frame : {1, 7, 30, 399}) {
    const double t = frame / 30.0;
    const double j = 1.3 - 0.3 * std::exp(-t) + 0.2 - 0.2 * std::exp(-t / 0.05);
    EXPECT_NEAR(bent(creeping, frame) / elastic, j, 2e-3 * j);
    EXPECT_NEAR(bent(damped, frame) / elastic, 1 - std::exp(-t / 0.4), 2e-3);
  }
  EXPECT_NEAR(bent(creeping, 30, 0.5) / elastic,
              1.5 - 0.3 * std::exp(-30.5 / 30) - 0.2 * std::exp(-30.5 / 1.5),
              3e-3);
  // A scene that is played without end begins anew each time.
  EXPECT_EQ(bent(creeping, 407), bent(creeping, 7));
  // A push that begins later, and one that is over and leaves its creep.
  const PlacedScene later(
      frames(400,
             "  - {use: push, face: back, from: 30, s_mm: 80, radius_mm: 4, force_N: 0.05}\n" +
                 body(", from: 30, creep: [{share: 0.3, time_s: 1}]")));
  EXPECT_EQ(bent(later, 29), 0);
  const double at_once = bent(later, 30);
  EXPECT_GT(at_once, 1e-3);
  EXPECT_NEAR(bent(later, 60) / at_once, 1.3 - 0.3 * std::exp(-1), 2e-3);
  const PlacedScene over(frames(
      400,
      pushing(
          "s_mm: 80, radius_mm: 4, force_N: [{at: 0, is: 0.05}, {at: 60, is: 0.05}, {at: 61, is: "
          "0}]") +
          body(", creep: [{share: 0.3, time_s: 1}]")));
  EXPECT_NEAR(bent(over, 90) / elastic,
              0.3 * (std::exp(-29.5 / 30) - std::exp(-3.0)),  // let go between two frames
              2e-3);
  EXPECT_TRUE(over.at(90).contacts.empty());
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
  const FrameGeometry both = PlacedScene(motion + scene_text(push + kBody + others)).at(1);
  const FrameGeometry alone = PlacedScene(motion + scene_text(others)).at(1);
  ASSERT_EQ(both.presses.size(), 2U);
  EXPECT_EQ(both.contacts.size(), 1U);
  EXPECT_EQ(std::get<BallPress>(both.presses[0]).place.depth_mm, 0.8);
  // The rest that forces start from is bent: about as far away as from a straight one.
  const double moved = (tip_of(both) - tip_of(alone)).norm();
  const double straight = (tip_of(PlacedScene(scene_text(push + kBody)).at(0)) -
                           tip_of(PlacedScene(scene_text("")).at(0)))
                              .norm();
  EXPECT_NEAR(moved / straight, 1, 0.1);
}

// Each of them the finger bears, both of them not: the truth tells what it bears, and that is what
// its bending holds against.
TEST(Push, CountsForWhatTheFingerBears) {
  const auto push = [](double force, double s) {
    return pushing(fmt::format("s_mm: {}, radius_mm: 40, force_N: {}", s, force), "back");
  };
  double most = 1;
  while (refusal(scene_text(push(most, 110) + kBody)).empty()) most *= 1.1;
  const double force = 0.85 * most / 1.1;
  const FrameGeometry geometry =
      PlacedScene(scene_text(push(force, 110) + push(force, 100) + kBody)).at(0);
  ASSERT_EQ(geometry.contacts.size(), 2U);
  const double borne = geometry.contacts[0].force_N->norm();
  EXPECT_LT(borne, 0.95 * force);
  EXPECT_GT(borne, 0.4 * force);
  EXPECT_NEAR(geometry.contacts[1].force_N->norm(), borne, 1e-9 * borne);
  const FinRayBody body = ElasticFinger{modulus_from_shore_a(40).value(), 4, 34, 12, 0.6, {}}
                              .body({FaceKind::kFinRay, 24, 1.5}, 116)
                              .value();
  const FaceCurve rest({-25, 0, 28}, 34 * M_PI / 180, 116);
  const std::vector<PointForce> forces{{PushedFace::kBack, 110, 0, borne, 0, 0},
                                       {PushedFace::kBack, 100, 0, borne, 0, 0}};
  const BodyModes q = *geometry.curve()->borne;
  const BodyModes load = PushedFinger(body, rest).generalised_force(forces, q);
  EXPECT_NEAR((body.stiffness() * q - load).norm() / load.norm(), 0, 1e-6);
}

TEST(Push, SaysWhatIsWrong) {
  const std::string push = pushing("s_mm: 60, radius_mm: 4, force_N: 1");
  const auto said = [](const std::string& effects) { return refusal(scene_text(effects)); };
  EXPECT_EQ(said(push), "");
  EXPECT_EQ(said(push + kBody), "");
  EXPECT_THAT(said(kBody), HasSubstr("test.yaml:10: body: nothing pushes"));
  EXPECT_THAT(said(pushing("s_mm: 60, radius_mm: 4, force_N: 1", "back")),
              HasSubstr("test.yaml:10: push: without its body"));
  EXPECT_THAT(said(pushing("s_mm: 60, radius_mm: 4, force_N: 0")),
              HasSubstr("push.force_N: nothing"));
  EXPECT_THAT(said(pushing("s_mm: 60, radius_mm: 4, force_N: -1")), HasSubstr("push.force_N"));
  EXPECT_THAT(said(pushing("s_mm: 60, radius_mm: 4, force_N: 99")),
              HasSubstr("further into the layer"));
  EXPECT_THAT(said(pushing("s_mm: 130, radius_mm: 4, force_N: 1")), HasSubstr("beyond the ends"));
  EXPECT_THAT(said(pushing("s_mm: 60, y_mm: 13, radius_mm: 4, force_N: 1")), HasSubstr("beside"));
  EXPECT_THAT(said(pushing("s_mm: 110, y_mm: 9, radius_mm: 4, force_N: 1", "upper") + kBody),
              HasSubstr("beside the face"));
  EXPECT_THAT(said(pushing("s_mm: 60, radius_mm: 4, force_N: 50", "upper") + kBody),
              HasSubstr("further into the body"));
  EXPECT_THAT(said(pushing("s_mm: 110, radius_mm: 40, force_N: 90", "back") + kBody),
              HasSubstr("bends the finger further"));
  EXPECT_THAT(said(pushing("s_mm: 60, radius_mm: 4, force_N: 1, along_N: 1")),
              HasSubstr("friction"));
  EXPECT_THAT(said(pushing("s_mm: 60, radius_mm: 4, force_N: 1, friction: 1")),
              HasSubstr("friction"));
  EXPECT_THAT(said(pushing("s_mm: 60, radius_mm: 4, force_N: 1, along_N: 0, friction: 1")),
              HasSubstr("push.along_N: nothing drags"));
  EXPECT_THAT(said(pushing("s_mm: 60, radius_mm: 4, force_N: 1", "front")), HasSubstr("push.face"));
  EXPECT_THAT(said(pushing("s_mm: 60, radius_mm: 4, force_N: 1, layer_shore_a: 5", "back") + kBody),
              HasSubstr("layer_shore_a"));
  EXPECT_THAT(said(pushing("s_mm: 60, radius_mm: 4, force_N: 1, until: 2") +
                   kBody.substr(0, kBody.size() - 2) + ", damping_s: 1, until: 2}\n"),
              HasSubstr("remembers a push"));
  EXPECT_THAT(said(push + "  - {use: body, shore_a: 400, wall_mm: 4, base_depth_mm: 34, "
                          "tip_depth_mm: 12, coupling: 0.6}\n"),
              HasSubstr("test.yaml:11: body.shore_a"));
  EXPECT_THAT(said(push + "  - {use: body, shore_a: 40, wall_mm: 9, base_depth_mm: 34, "
                          "tip_depth_mm: 12, coupling: 0.6}\n"),
              HasSubstr("two walls of 9 mm"));
  EXPECT_THAT(refusal(flat_text(push + kBody)), HasSubstr("leave body out"));
  EXPECT_THAT(refusal(flat_text(pushing("s_mm: 1, radius_mm: 4, force_N: 1", "back"))),
              HasSubstr("contact face only"));
  EXPECT_EQ(refusal(flat_text(push)), "");
}

}  // namespace
}  // namespace alltact
