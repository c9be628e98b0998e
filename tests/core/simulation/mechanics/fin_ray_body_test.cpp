#include "core/simulation/fin_ray_body.h"

#include "core/simulation/mechanics/ball_contact.h"
#include "tests/core/simulation/effects/effect_scene.h"

#include <Eigen/Eigenvalues>

namespace alltact {
namespace {

using testing::HasSubstr;
using Forces = std::vector<PointForce>;

constexpr double kModulus_MPa = 1.69;

FinRayBody body_of(const FinRayGeometry& geometry, double modulus = kModulus_MPa) {
  return FinRayBody::create(geometry, modulus).value();
}
FinRayGeometry even(double coupling) { return {100, 24, 1.5, 4, 20, 20, coupling}; }
FaceCurve straight_face(double length = 100, double incline = 0.6) {
  return {{-25, 1, 28}, incline, length};
}

struct RandomFinger {
  FinRayGeometry geometry;
  double modulus;
  FaceCurve rest;

  explicit RandomFinger(Parameters& random)
      : geometry{random.between(60, 140), random.between(15, 40), random.between(1, 2.5),
                 random.between(2, 5),    random.between(20, 50), random.between(10, 20),
                 random.between(0.1, 1)},
        modulus(random.between(0.5, 4)),
        rest({-25, random.between(-3, 3), 28}, random.between(-0.2, 0.9), geometry.length_mm) {
    rest.bend(random.between(-5, 5), random.between(-4, 4));
    rest.sway(random.between(-3, 3));
    rest.twist(random.between(-0.2, 0.2));
  }

  // On any face, anywhere; each component alone would move the tip by about `tip_mm` of its way.
  PointForce force(Parameters& random, double tip_mm) const {
    const FinRayBody body = body_of(geometry, modulus);
    const double scale = tip_mm * body.stiffness()(0, 0);
    const auto face = static_cast<PushedFace>(1 + static_cast<int>(random.between(0, 3.999)));
    const double half =
        face <= PushedFace::kBack ? geometry.width_mm / 2 : geometry.tip_depth_mm / 2;
    return {face,
            geometry.length_mm * random.between(0.2, 1),
            half * random.between(-1, 1),
            scale * random.between(0.1, 1),
            scale * random.between(-1, 1) / 2,
            scale * random.between(-1, 1) / 2};
  }
};

// A cantilever of E I under a force F at its tip: F L^3 / (3 E I), and its slope F L^2 / (2 E I);
// two walls side by side, or as one.
TEST(FinRayBody, BendsAsACantilever) {
  for (const double coupling : {0.0, 0.3, 1.0}) {
    const FinRayBody body = body_of(even(coupling));
    const FaceCurve rest = straight_face();
    const double inertia = 24 * 4.0 * 4 * 4 / 12 * 2 + coupling * 2 * 24 * 4 * 8.0 * 8.0;
    const double f = 1e-4 * kModulus_MPa * inertia / 1e4, ei = kModulus_MPa * inertia;
    const PointForce force{PushedFace::kContact, 100, 0, f, 0, 0};
    const PushedFinger finger(body, rest);
    const auto at = finger.equilibrium({&force, 1});
    EXPECT_EQ(at.share, 1);
    const Eigen::Vector3d moved =
        finger.surface(force, at.q).point_mm - finger.surface(force, BodyModes::Zero()).point_mm;
    const Eigen::Vector3d into = finger.surface(force, BodyModes::Zero()).into;
    EXPECT_NEAR(moved.dot(into) / (f * 1e6 / (3 * ei)), 1, 1e-4) << coupling;
    EXPECT_NEAR((2 * at.q[0] + at.q[1]) / 100 / (-f * 1e4 / (2 * ei)), 1, 1e-4);
    EXPECT_EQ(at.q[2], 0);
    EXPECT_EQ(at.q[3], 0);
    // Pushed half-way, a beam's tip goes 5/48 F L^3 / (E I).
    const PointForce middle{PushedFace::kContact, 50, 0, f, 0, 0};
    EXPECT_NEAR(-finger.equilibrium({&middle, 1}).q[0] / (5.0 / 48 * f * 1e6 / ei), 1, 1e-4);
  }
}

// A tapered one: int F (L - s)^2 / (E I) ds at the tip, of which two modes keep the most.
TEST(FinRayBody, BendsAlmostAsATaperedCantilever) {
  Parameters random(13);
  double least = 1;
  for (int i = 0; i < 100; ++i) {
    const FinRayGeometry g{116,
                           24,
                           1.5,
                           random.between(2, 5),
                           random.between(24, 45),
                           random.between(10, 24),
                           random.between(0.1, 1)};
    const FaceCurve rest = straight_face(116);
    const FinRayBody body = body_of(g);
    const PushedFinger finger(body, rest);
    double compliance = 0;
    for (int k = 0; k < 2000; ++k) {
      const double s = 116 * (k + 0.5) / 2000, b = g.wall_mm, distance = g.depth_mm(s) - b;
      const double inertia = 48 * (b * b * b / 12 + g.coupling * b * distance * distance / 4);
      compliance += 116.0 / 2000 * (116 - s) * (116 - s) / (kModulus_MPa * inertia);
    }
    const PointForce force{PushedFace::kContact, 116, 0, 1e-3 / compliance, 0, 0};
    const double part = -finger.equilibrium({&force, 1}).q[0] / 1e-3;
    EXPECT_LT(part, 1 + 1e-6);
    least = std::min(least, part);
  }
  EXPECT_GT(least, 0.95);
}

// Aside: two walls on edge, 3 E I; one mode t^2 reaches three quarters of it (where it
// twists besides, as it does here, the middle line leans as much). A couple about the
// finger: T L / (G J), J that of two strips, or of a sandwich.
TEST(FinRayBody, LeansAndTwistsAsABeam) {
  for (const double coupling : {0.0, 0.5}) {
    const FinRayBody body = body_of(even(coupling));
    const FaceCurve rest = straight_face();
    const PushedFinger finger(body, rest);
    const double edge = kModulus_MPa * 2 * 4 * 24.0 * 24 * 24 / 12, f = 1e-6 * edge / 1e4;
    const PointForce aside{PushedFace::kUpper, 100, 0, f, 0, 0};
    const double j = 2 * 24 * (4 * 4 * 4 / 3.0 + coupling * 4 * 16.0 * 16);
    const auto leant = finger.equilibrium({&aside, 1});
    EXPECT_NEAR(leant.q[2] / (0.75 * f * 1e6 / (3 * edge)), 1, 1e-3);
    const Forces couple{{PushedFace::kContact, 100, 6, f, 0, 0},
                        {PushedFace::kBack, 100, -6, f, 0, 0}};
    const auto turned = finger.equilibrium(couple);
    EXPECT_NEAR(std::abs(turned.q[3]) / (12 * f * 100 / (kModulus_MPa / 3 * j)), 1, 1e-3);
    EXPECT_NEAR(turned.q[0], 0, 1e-9);
    // +y is pushed towards the camera: the twist takes +y away from it, so it is negative.
    EXPECT_LT(turned.q[3], 0);
  }
}

// The modes move points as FaceCurve moves the face that is drawn.
TEST(FinRayBody, MovesItsSurfaceWithTheFaceCurve) {
  Parameters random(9);
  for (int i = 0; i < 40; ++i) {
    const RandomFinger random_finger(random);
    const FinRayGeometry& g = random_finger.geometry;
    const FinRayBody body = body_of(g, random_finger.modulus);
    const BodyModes q(random.between(-15, 15), random.between(-10, 10), random.between(-8, 8),
                      random.between(-0.4, 0.4));
    FaceCurve curve = random_finger.rest;
    curve.bend(q[0], q[1]);
    curve.sway(q[2]);
    curve.twist(q[3]);
    curve.integrate();
    const PushedFinger finger(body, random_finger.rest);
    for (const PushedFace face :
         {PushedFace::kContact, PushedFace::kBack, PushedFace::kUpper, PushedFace::kLower}) {
      const double s = g.length_mm * random.between(0, 1), across = random.between(-5, 5);
      const FaceCurve::Node p = curve.at(s);
      const Eigen::Vector3d middle(p.x_mm, p.shift_mm, p.z_mm);
      const Eigen::Vector3d y = FaceCurve::across(p), n = FaceCurve::normal(p);
      const double depth = g.base_depth_mm + (g.tip_depth_mm - g.base_depth_mm) * s / g.length_mm;
      const bool is_side = face >= PushedFace::kUpper;
      const double side = face == PushedFace::kUpper ? -1 : 1;
      const Eigen::Vector3d point =
          is_side ? Eigen::Vector3d(middle + side * g.width_mm / 2 * y + (across - depth / 2) * n)
          : face == PushedFace::kContact ? Eigen::Vector3d(middle + across * y + g.layer_mm * n)
                                         : Eigen::Vector3d(middle + across * y - depth * n);
      const Eigen::Vector3d into = is_side                        ? Eigen::Vector3d(-side * y)
                                   : face == PushedFace::kContact ? Eigen::Vector3d(-n)
                                                                  : n;
      const SurfaceFrame got = finger.surface({face, s, across, 0, 0, 0}, q);
      EXPECT_NEAR((got.point_mm - point).norm(), 0, 1e-7);
      EXPECT_NEAR((got.into - into).norm(), 0, 1e-9);
      EXPECT_NEAR((got.across - (is_side ? n : y)).norm(), 0, 1e-9);
      EXPECT_NEAR((got.along - Eigen::Vector3d(p.x_s, 0, p.z_s)).norm(), 0, 1e-9);
    }
  }
}

// On any way from no load to any loads on any faces, what the balls' middles and the dragged points
// are moved by takes as much work as finger and layer hold at its end.
TEST(FinRayBody, HoldsTheWorkThatIsDoneOnIt) {
  Parameters random(10);
  double greatest_turn = 0;
  for (int i = 0; i < 60; ++i) {
    const RandomFinger random_finger(random);
    const FinRayBody body = body_of(random_finger.geometry, random_finger.modulus);
    const PushedFinger finger(body, random_finger.rest);
    const int count = 1 + i % 3, steps = 120;
    Forces ends, bumps;
    std::vector<BondedLayerContact> layers;
    for (int k = 0; k < count; ++k) {
      ends.push_back(random_finger.force(random, 30.0 / count));
      bumps.push_back(random_finger.force(random, 10.0 / count));
      layers.push_back(
          BondedLayerContact::create(20 * random_finger.modulus, random_finger.geometry.layer_mm, 3)
              .value());
    }
    double work = 0, layer_energy = 0;
    struct Way {
      Eigen::Vector3d ball, point, normal_N, drag_N;
    };
    std::vector<Way> before;
    BodyModes q;
    for (int step = 0; step <= steps; ++step) {
      const double t = static_cast<double>(step) / steps, bump = std::sin(M_PI * t);
      Forces forces = ends;
      for (int k = 0; k < count; ++k) {
        const auto n = static_cast<std::size_t>(k);
        forces[n].normal_N = t * ends[n].normal_N + bump * bumps[n].normal_N;
        forces[n].along_N = t * ends[n].along_N + bump * bumps[n].along_N;
        forces[n].across_N = t * t * ends[n].across_N - bump * bumps[n].across_N;
      }
      const auto rest = finger.equilibrium(forces);
      ASSERT_EQ(rest.share, 1);
      q = rest.q;
      std::vector<Way> now;
      layer_energy = 0;
      for (int k = 0; k < count; ++k) {
        const auto n = static_cast<std::size_t>(k);
        const SurfaceFrame at = finger.surface(forces[n], q);
        const double d =
            forces[n].face == PushedFace::kContact
                ? layers[n]
                      .indentation_mm(std::min(forces[n].normal_N, layers[n].max_force_N()))
                      .value()
                : 0;
        if (forces[n].face == PushedFace::kContact) {
          ASSERT_LE(forces[n].normal_N, layers[n].max_force_N());
          layer_energy += layers[n].energy_Nmm(d);
        }
        PointForce drag = forces[n];
        drag.normal_N = 0;
        now.push_back({at.point_mm - (3 - d) * at.into, at.point_mm, forces[n].normal_N * at.into,
                       at.vector_N(drag)});
        if (step == 0) continue;
        work += 0.5 * (before[n].normal_N + now[n].normal_N).dot(now[n].ball - before[n].ball) +
                0.5 * (before[n].drag_N + now[n].drag_N).dot(now[n].point - before[n].point);
      }
      before = now;
    }
    const double energy = body.energy_Nmm(q) + layer_energy;
    EXPECT_NEAR(work / energy, 1, 0.01) << i;
    greatest_turn = std::max(greatest_turn, std::abs(2 * q[0] + q[1]) / body.geometry().length_mm);
  }
  EXPECT_GT(greatest_turn, 0.25);  // far from small
}

// Maxwell and Betti: what the first force's point is moved by the second one, times the first...
TEST(FinRayBody, IsReciprocalAtSmallLoads) {
  Parameters random(11);
  for (int i = 0; i < 100; ++i) {
    const RandomFinger random_finger(random);
    const FinRayBody body = body_of(random_finger.geometry, random_finger.modulus);
    const PushedFinger finger(body, random_finger.rest);
    const PointForce one = random_finger.force(random, 1e-5),
                     two = random_finger.force(random, 1e-5);
    const auto moved = [&](const PointForce& at, const PointForce& by) {
      const SurfaceFrame still = finger.surface(at, BodyModes::Zero());
      const BodyModes q = finger.equilibrium({&by, 1}).q;
      return still.vector_N(at).dot(finger.surface(at, q).point_mm - still.point_mm);
    };
    const double scale = std::sqrt(moved(one, one) * moved(two, two));
    EXPECT_NEAR((moved(one, two) - moved(two, one)) / scale, 0, 1e-4);
  }
}

TEST(FinRayBody, GivesWayMoreToMore) {
  Parameters random(12);
  int beyond = 0;
  for (int i = 0; i < 200; ++i) {
    const RandomFinger random_finger(random);
    const FinRayBody body = body_of(random_finger.geometry, random_finger.modulus);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> modes(body.stiffness());
    EXPECT_GT(modes.eigenvalues()[0], 0);
    EXPECT_EQ(body.stiffness(), body.stiffness().transpose());
    const PushedFinger finger(body, random_finger.rest);
    PointForce force = random_finger.force(random, i % 2 == 0 ? 10 : 150);
    force.along_N = force.across_N = 0;
    double energy = 0, share = 1;
    for (int k = 1; k <= 8; ++k) {
      const PointForce part = force.times(k / 8.0);
      const auto rest = finger.equilibrium({&part, 1});
      ASSERT_TRUE(rest.q.allFinite());
      ASSERT_LE(rest.share, share);
      if (rest.share == 1) {
        ASSERT_GT(body.energy_Nmm(rest.q), energy);
        // It is an equilibrium.
        const BodyModes left =
            body.stiffness() * rest.q - finger.generalised_force({&part, 1}, rest.q);
        ASSERT_LT(left.norm(), 1e-8 * (body.stiffness() * rest.q).norm());
      }
      energy = body.energy_Nmm(rest.q);
      share = rest.share;
    }
    beyond += share < 1;
  }
  EXPECT_GT(beyond, 5);
  EXPECT_LT(beyond, 100);
}

TEST(FinRayBody, RefusesWhatIsNone) {
  FinRayGeometry g = even(0.5);
  EXPECT_FALSE(FinRayBody::create(g, 0));
  g.coupling = 1.5;
  EXPECT_THAT(FinRayBody::create(g, 1).error().sentence(), HasSubstr("not a fraction"));
  g = even(0.5);
  g.tip_depth_mm = 7;
  EXPECT_EQ(FinRayBody::create(g, 1).error().sentence(),
            "two walls of 4 mm do not fit into a depth of 7 mm. Try: walls of up to 3.5 mm.");
  g.tip_depth_mm = std::nan("");
  EXPECT_FALSE(FinRayBody::create(g, 1));
}

}  // namespace
}  // namespace alltact
