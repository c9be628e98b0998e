#include "core/simulation/mechanics/ball_contact.h"
#include "core/simulation/mechanics/rubber.h"
#include "tests/core/simulation/effects/pushed_scene.h"

#include <map>

namespace alltact {
namespace {

// The work that the balls do, their middles against the forces that the truth tells, is what finger
// and layer hold, and they give all of it back.
TEST(Body, HoldsTheWorkAndGivesItBack) {
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
      kPushedBody;
  const PlacedScene placed(with_frames(n, effects));
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
        ball.centre += (std::get<BallPress>(geometry.presses.at(0)).pose.normal_depth_mm() - 4) *
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
                            : std::get<BallPress>(geometry.presses[0]).pose.normal_depth_mm();
    const double held = body.energy_Nmm(*geometry.curve()->response) + layer.energy_Nmm(dent);
    greatest_error = std::max(greatest_error, std::abs(work - held));
    most = std::max(most, work);
  }
  EXPECT_GT(most, 3);
  EXPECT_LT(greatest_error / most, 0.01);
  EXPECT_NEAR(work / most, 0, 0.01);
}

TEST(Body, CreepsAndIsDampedAsItsUnitsSay) {
  const std::string push = pushing("s_mm: 80, y_mm: 2, radius_mm: 4, force_N: 0.05");
  const auto body = [](const std::string& late) {
    return kPushedBody.substr(0, kPushedBody.size() - 2) + late + "}\n";
  };
  const auto bent = [&](const PlacedScene& placed, int frame, double later = 0) {
    const FrameGeometry geometry = placed.at(frame, later);
    return geometry.curve()->at(116).theta - 34 * M_PI / 180;
  };
  const double elastic = bent(PlacedScene(with_frames(400, push + kPushedBody)), 100);
  EXPECT_LT(elastic, -1e-3);
  const PlacedScene creeping(with_frames(
      400, push + body(", creep: [{share: 0.3, time_s: 1}, {share: 0.2, time_s: 0.05}]")));
  const PlacedScene damped(with_frames(400, push + body(", damping_s: 0.4")));
  EXPECT_NEAR(bent(creeping, 0) / elastic, 1, 1e-9);
  EXPECT_EQ(bent(damped, 0), 0);
  for (const int frame : {1, 7, 30, 399}) {
    const double t = frame / 30.0;
    const double j = 1.3 - 0.3 * std::exp(-t) + 0.2 - 0.2 * std::exp(-t / 0.05);
    EXPECT_NEAR(bent(creeping, frame) / elastic, j, 2e-3 * j);
    EXPECT_NEAR(bent(damped, frame) / elastic, 1 - std::exp(-t / 0.4), 2e-3);
  }
  EXPECT_NEAR(bent(creeping, 30, 0.5) / elastic,
              1.5 - 0.3 * std::exp(-30.5 / 30) - 0.2 * std::exp(-30.5 / 1.5), 3e-3);
  // A scene that is played without end begins anew each time.
  EXPECT_EQ(bent(creeping, 407), bent(creeping, 7));
  // Nothing is lost of what is long ago: a load that once was twenty times as large.
  const std::string fast = body(", creep: [{share: 0.3, time_s: 0.05}]");
  const auto once = [&](double first_N) {
    return PlacedScene(
        with_frames(400, pushing(fmt::format("s_mm: 80, y_mm: 2, radius_mm: 4, force_N: [{{at: "
                                             "300, is: {}}}, {{at: 301, is: 0.05}}]",
                                             first_N)) +
                             fast));
  };
  EXPECT_NEAR(bent(once(1), 390) / bent(once(0.05), 390), 1, 1e-12);
  EXPECT_GT(bent(once(1), 305) / bent(once(0.05), 305), 1.1);
  // A push that begins later, and one that is over and leaves its creep.
  const PlacedScene later(with_frames(
      400, "  - {use: push, face: back, from: 30, s_mm: 80, radius_mm: 4, force_N: 0.05}\n" +
               body(", from: 30, creep: [{share: 0.3, time_s: 1}]")));
  EXPECT_EQ(bent(later, 29), 0);
  const double at_once = bent(later, 30);
  EXPECT_GT(at_once, 1e-3);
  EXPECT_NEAR(bent(later, 60) / at_once, 1.3 - 0.3 * std::exp(-1), 2e-3);
  const PlacedScene over(with_frames(
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

// Each of them the finger bears, both of them not: the truth tells what it bears, and that is what
// its bending holds against.
TEST(Body, CountsForWhatTheFingerBears) {
  const auto push = [](double force, double s) {
    return pushing(fmt::format("s_mm: {}, radius_mm: 40, force_N: {}", s, force), "back");
  };
  double most = 1;
  while (refusal(scene_text(push(most, 110) + kPushedBody)).empty()) most *= 1.1;
  const double force = 0.85 * most / 1.1;
  const FrameGeometry geometry =
      PlacedScene(scene_text(push(force, 110) + push(force, 100) + kPushedBody)).at(0);
  ASSERT_EQ(geometry.contacts.size(), 2U);
  const double response = geometry.contacts[0].force_N->norm();
  EXPECT_LT(response, 0.95 * force);
  EXPECT_GT(response, 0.4 * force);
  EXPECT_NEAR(geometry.contacts[1].force_N->norm(), response, 1e-9 * response);
  const FinRayBody body = ElasticFinger{modulus_from_shore_a(40).value(), 4, 34, 12, 0.6, {}}
                              .body({FaceKind::kFinRay, 24, 1.5}, 116)
                              .value();
  const FaceCurve rest({-25, 0, 28}, 34 * M_PI / 180, 116);
  const std::vector<PointForce> forces{{PushedFace::kBack, 110, 0, response, 0, 0},
                                       {PushedFace::kBack, 100, 0, response, 0, 0}};
  const BodyModes q = *geometry.curve()->response;
  const BodyModes load = PushedFinger(body, rest).generalised_force(forces, q);
  EXPECT_NEAR((body.stiffness() * q - load).norm() / load.norm(), 0, 1e-6);
}

}  // namespace
}  // namespace alltact
