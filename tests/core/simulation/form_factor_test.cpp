// Form factors against the closed forms of J. Howell's "A catalog of radiation heat transfer
// configuration factors" (B-3, B-4, C-14) and against quadrature, in long double.
#include "core/simulation/illumination.h"
#include "tests/core/simulation/effects/effect_scene.h"
#include "tests/core/simulation/howell.h"

#include <Eigen/Geometry>

namespace alltact {
namespace {

using Eigen::Vector3d;

Vector3d a_direction(Parameters& random) {
  for (;;) {
    const Vector3d v(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
  }
}

// Turns and shifts at random, which changes no form factor.
struct Elsewhere {
  explicit Elsewhere(Parameters& random)
      : turn(Eigen::AngleAxisd(random.between(-3, 3), a_direction(random)).toRotationMatrix()),
        shift(random.between(-50, 50), random.between(-50, 50), random.between(-50, 50)) {}
  [[nodiscard]] Vector3d operator()(const Vector3d& p) const { return turn * p + shift; }
  [[nodiscard]] double of(const Vector3d& point, const Vector3d& normal,
                          const Quadrilateral& q) const {
    return form_factor((*this)(point), turn * normal,
                       {(*this)(q[0]), (*this)(q[1]), (*this)(q[2]), (*this)(q[3])});
  }
  Eigen::Matrix3d turn;
  Vector3d shift;
};

TEST(FormFactor, OfARectangleOppositeIsHowellsB3) {
  Parameters random(11);
  for (int i = 0; i < 200; ++i) {
    const double a = random.between(0.01, 30), b = random.between(0.01, 30),
                 c = random.between(0.01, 30);
    const Quadrilateral above{Vector3d(0, 0, c), Vector3d(0, b, c), Vector3d(a, b, c),
                              Vector3d(a, 0, c)};
    EXPECT_NEAR(Elsewhere(random).of({0, 0, 0}, {0, 0, 1}, above), howell_b3(a, b, c), 1e-13);
    Quadrilateral turned_away = above;
    std::swap(turned_away[1], turned_away[3]);
    EXPECT_EQ(Elsewhere(random).of({0, 0, 0}, {0, 0, 1}, turned_away), 0);
    EXPECT_NEAR(Elsewhere(random).of({0, 0, 0}, {0, 0, -1}, above), 0, 1e-13);
  }
}

TEST(FormFactor, OfARectangleUprightIsHowellsB4) {
  Parameters random(12);
  for (int i = 0; i < 200; ++i) {
    const double height = random.between(0.01, 30), width = random.between(0.01, 30),
                 away = random.between(0.01, 30);
    // Half of it lies below the point's plane and does not count.
    const Quadrilateral wall{Vector3d(away, 0, -height), Vector3d(away, 0, height),
                             Vector3d(away, width, height), Vector3d(away, width, -height)};
    EXPECT_NEAR(Elsewhere(random).of({0, 0, 0}, {0, 0, 1}, wall), howell_b4(height, width, away),
                1e-12);
  }
}

TEST(FormFactor, AveragedOverARectangleIsHowellsC14) {
  EXPECT_NEAR(static_cast<double>(howell_c14(1, 1, 1)), 0.20004, 5e-6);  // as the textbooks have it
  for (const auto& [a, b, c] : {std::array{1.0, 1.0, 1.0}, {2.0, 1.0, 0.5}, {24.0, 116.0, 14.0}}) {
    const Quadrilateral wall{Vector3d(0, 0, 0), Vector3d(0, 0, c), Vector3d(0, b, c),
                             Vector3d(0, b, 0)};
    constexpr int kCells = 300;
    double sum = 0;
    for (int i = 0; i < kCells; ++i)
      for (int k = 0; k < kCells; ++k)
        sum += form_factor({-a * (i + 0.5) / kCells, b * (k + 0.5) / kCells, 0}, {0, 0, 1}, wall);
    EXPECT_NEAR(sum / (kCells * kCells), static_cast<double>(howell_c14(a, b, c)), 2e-5);
  }
}

TEST(FormFactor, OfAllThatIsAroundIsOne) {
  Parameters random(13);
  for (int i = 0; i < 100; ++i) {
    const Elsewhere elsewhere(random);
    const Vector3d point(random.between(0.01, 0.99), random.between(0.01, 1.99),
                         random.between(0.01, 2.99));
    const Vector3d normal = a_direction(random);
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (const double end : {0.0, 1.0}) {
        Quadrilateral wall;
        constexpr double kAround[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (std::size_t k = 0; k < 4; ++k) {
          Vector3d p;
          p[axis] = end * (axis + 1);
          p[(axis + 1) % 3] = kAround[k][0] * ((axis + 1) % 3 + 1);
          p[(axis + 2) % 3] = kAround[k][1] * ((axis + 2) % 3 + 1);
          wall[k] = p;
        }
        if (end == 1) std::swap(wall[1], wall[3]);
        sum += elsewhere.of(point, normal, wall);
      }
    EXPECT_NEAR(sum, 1, 1e-11);
  }
}

TEST(FormFactor, IsFiniteOnEdgesAndCorners) {
  const Quadrilateral wall{Vector3d(0, 0, 0), Vector3d(0, 0, 1), Vector3d(0, 1, 1),
                           Vector3d(0, 1, 0)};
  for (const double y : {-1.0, 0.0, 0.5, 1.0, 2.0})
    for (const double x : {0.0, 1e-300, 1e-9})
      for (const double z : {0.0, 1e-12}) {
        const double f = form_factor({x, y, z}, {0, 0, 1}, wall);
        EXPECT_GE(f, 0) << x << y << z;
        EXPECT_LE(f, 0.5 + 1e-9) << x << y << z;
      }
}

}  // namespace
}  // namespace alltact
