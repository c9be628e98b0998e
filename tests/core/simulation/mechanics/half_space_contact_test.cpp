#include "core/simulation/mechanics/ball_contact.h"
#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

HalfSpaceContact contact_of(double modulus, double radius, double normal,
                            Eigen::Vector2d tangential, double friction) {
  return HalfSpaceContact::create(modulus, radius, normal, tangential, friction).value();
}

// What a traction along x moves the surface at `at` by: Cerruti's solution of a point force
// (Poisson's ratio 0.5), summed in polar coordinates about `at`, where it has no singularity.
template <class Traction>
Eigen::Vector2d cerruti(const Eigen::Vector2d& at, double reach, double g, const Traction& q) {
  const int turns = 360, steps = 1500;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int i = 0; i < turns; ++i) {
    const double angle = 2 * M_PI * (i + 0.5) / turns, c = std::cos(angle), s = std::sin(angle);
    double along = 0;
    for (int k = 0; k < steps; ++k)
      along += q((at + reach * (k + 0.5) / steps * Eigen::Vector2d(c, s)).norm());
    sum += along * Eigen::Vector2d(0.5 + 0.5 * c * c, 0.5 * c * s);
  }
  return sum * (reach / steps) * (2 * M_PI / turns) / (2 * M_PI * g);
}

TEST(HalfSpaceContact, MovesTheSurfaceAsItsTractionsDo) {
  Parameters random(8);
  for (int i = 0; i < 6; ++i) {
    const double modulus = random.between(0.3, 3), radius = random.between(2, 8);
    const double normal = random.between(0.1, 0.2) * modulus * radius * radius;
    const double friction = random.between(0.3, 1.2);
    const double part = i == 0 ? 1.5 : random.between(0.1, 0.95);
    const HalfSpaceContact contact =
        contact_of(modulus, radius, normal, {part * friction * normal, 0}, friction);
    const double a = contact.contact_radius_mm();
    const double c = a * std::cbrt(1 - std::min(1.0, part));
    EXPECT_NEAR(contact.stick_radius_mm(), c, 1e-12 * a);
    const double p_0 = 1.5 * normal / (M_PI * a * a);
    const auto traction = [&](double r) {
      double q = r < a ? std::sqrt(1 - r * r / (a * a)) : 0;
      if (r < c) q -= c / a * std::sqrt(1 - r * r / (c * c));
      return friction * p_0 * q;
    };
    for (const double r : {0.0, 0.4, 0.9, 1.1, 2.0, 5.0}) {
      const double angle = random.between(0, 7);
      const Eigen::Vector2d at = r * a * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      const Eigen::Vector2d truth = cerruti(at, at.norm() + a, modulus / 3, traction);
      EXPECT_NEAR((contact.displacement_mm(at).head<2>() - truth).norm() / truth.norm(), 0, 5e-3)
          << r << ' ' << part;
    }
  }
}

// R. D. Mindlin, "Compliance of elastic bodies in contact", 1949: what sticks moves as one, by
// 3 mu P (2 - nu) / (16 a G) (1 - (1 - Q / (mu P))^(2/3)).
TEST(HalfSpaceContact, SticksAsMindlinSays) {
  const HalfSpaceContact contact = contact_of(1.7, 3, 1, {0.3, 0.4}, 0.9);
  const double a = contact.contact_radius_mm(), g = 1.7 / 3, held = 0.9;
  const double moved = 3 * held * 1.5 / (16 * a * g) * (1 - std::pow(1 - 0.5 / held, 2.0 / 3));
  for (const double angle : {0.0, 1.0, 4.0})
    for (const double share : {0.0, 0.5, 0.99}) {
      const Eigen::Vector2d at =
          share * contact.stick_radius_mm() * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      EXPECT_NEAR(
          (contact.displacement_mm(at).head<2>() - moved * Eigen::Vector2d(0.6, 0.8)).norm(), 0,
          1e-12);
    }
  // Hertz: P = 4/3 E* sqrt(R) d^1.5; the rim goes half as deep; far away it is a point force.
  const double d = contact.indentation_mm();
  EXPECT_NEAR(4.0 / 3 * 1.7 / 0.75 * std::sqrt(3) * std::pow(d, 1.5), 1, 1e-12);
  EXPECT_NEAR(contact.displacement_mm({0, 0}).z(), d, 1e-15);
  EXPECT_NEAR(contact.displacement_mm({a, 0}).z(), d / 2, 1e-12);
  EXPECT_NEAR(contact.displacement_mm({0, 50 * a}).z(), 0.75 / (M_PI * 1.7 * 50 * a), 1e-6);
  EXPECT_NEAR(contact_of(1.7, 3, 1, {1e-6, 0}, 0.9).displacement_mm({0, 0}).x(),
              1e-6 * 1.5 / (8 * a * g),  // all sticks: Q (2 - nu) / (8 a G)
              1e-12);
}

TEST(HalfSpaceContact, SlidesWhereFrictionIsLess) {
  const HalfSpaceContact more = contact_of(1, 4, 1, {5, 0}, 0.5),
                         just = contact_of(1, 4, 1, {0.5, 0}, 0.5);
  EXPECT_EQ(more.stick_radius_mm(), 0);
  EXPECT_NEAR((more.displacement_mm({2, 1}) - just.displacement_mm({2, 1})).norm(), 0, 1e-6);
  EXPECT_NEAR((limited_by_friction({3, 4}, 2, 0.5) - Eigen::Vector2d(0.6, 0.8)).norm(), 0, 1e-15);
  EXPECT_EQ(limited_by_friction({0.3, 0.4}, 2, 0.5), Eigen::Vector2d(0.3, 0.4));
  EXPECT_EQ(contact_of(1, 4, 1, {0, 0}, 1).displacement_mm({1, 2}).head<2>().norm(), 0);
}

TEST(HalfSpaceContact, RefusesWhatItDoesNotKnow) {
  EXPECT_FALSE(HalfSpaceContact::create(0, 1, 1, {0, 0}, 1));
  EXPECT_FALSE(HalfSpaceContact::create(1, 1, 0.1, {std::nan(""), 0}, 1));
  const auto deep = HalfSpaceContact::create(1, 1, 10, {0, 0}, 1);
  ASSERT_FALSE(deep);
  EXPECT_THAT(deep.error().sentence(), HasSubstr("up to 0.61 N"));
}

}  // namespace
}  // namespace alltact
