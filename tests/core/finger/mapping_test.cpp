#include "core/finger/mapping.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

/// The definition, term by term, in extended precision.
long double polynomial_by_definition(const MappingParameters& p, long double x) {
  const long double t = 2 * x / p.x_max - 1;
  long double sum = 0;
  for (std::size_t k = 0; k < p.chebyshev.size(); ++k)
    sum += p.chebyshev[k] * std::cos(k * std::acos(std::clamp(t, -1.0L, 1.0L)));
  return x * sum;
}

long double by_definition(const MappingParameters& p, long double x) {
  if (p.kind == MappingKind::kMoebius) return p.a_mm * x / (1 + p.b * x);
  return polynomial_by_definition(p, x);
}

MappingParameters random_parameters(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  MappingParameters p;
  p.x_max = 0.1 + 0.9 * unit(random);
  p.along = static_cast<MappingAlong>(1 + static_cast<int>(3 * unit(random)));
  if (unit(random) < 0.5)
    p.variation = {{0.25 - 0.5 * unit(random), 0.25 - 0.5 * unit(random)},
                   {100 * unit(random), 10 * unit(random)},
                   {1 + 50 * unit(random), 1 + 10 * unit(random)}};
  if (unit(random) < 0.3) {
    p.kind = MappingKind::kMoebius;
    p.a_mm = 0.1 + 5 * unit(random);
    p.b = -0.9 / p.x_max + 10 * unit(random);
    return p;
  }
  const int count = 1 + static_cast<int>(12 * unit(random));
  double size = 0.5 + 3 * unit(random);
  for (int k = 0; k < count; ++k, size *= 0.4 * unit(random))
    p.chebyshev.push_back(k == 0 ? size : size * (2 * unit(random) - 1));
  return p;
}

/// Valid mappings of all kinds and lengths; each draw is the same in every run.
std::vector<Mapping> random_mappings(int count) {
  std::mt19937 random(71);
  std::vector<Mapping> mappings;
  while (static_cast<int>(mappings.size()) < count) {
    auto mapping = Mapping::create(random_parameters(random));
    if (mapping) mappings.push_back(*mapping);
  }
  return mappings;
}

MappingParameters cubic() {
  MappingParameters p;
  p.x_max = 0.62;
  p.chebyshev = {1.9, 0.8, 0.1};
  return p;
}

TEST(Mapping, FollowsItsDefinitionInsideTheDomain) {
  for (const Mapping& mapping : random_mappings(300))
    for (int i = 0; i <= 50; ++i) {
      const double x = mapping.x_max() * i / 50;
      const auto expected = static_cast<double>(by_definition(mapping.parameters(), x));
      EXPECT_NEAR(mapping.depth_mm(x), expected, 2e-14 * expected + 1e-300);
    }
}

TEST(Mapping, IsFiniteMonotoneAndBoundedEverywhere) {
  for (const Mapping& mapping : random_mappings(100)) {
    const double end = mapping.depth_mm(mapping.x_max());
    double steepest = 0;  // nowhere is the curve steeper than within its domain: no jump
    for (int i = 0; i <= 4000; ++i)
      steepest = std::max(
          steepest,
          mapping.slope_mm(mapping.x_min() + i * (mapping.x_max() - mapping.x_min()) / 4000));
    double before = mapping.depth_mm(-2 - 1e-3);
    for (int i = 0; i <= 4000; ++i) {
      const double x = -2 + i * 1e-3;
      const double depth = mapping.depth_mm(x);
      ASSERT_TRUE(std::isfinite(depth));
      ASSERT_GE(depth, before) << x;
      ASSERT_LE(depth, 4 * end);
      // Skin that is brighter bulges, and only that.
      ASSERT_EQ(depth < 0, x < 0) << x;
      ASSERT_LE(depth - before, 1.05e-3 * steepest) << x;
      before = depth;
    }
    EXPECT_EQ(mapping.depth_mm(0), 0);
    for (const double huge : {1e6, 1e30, 1e300, std::numeric_limits<double>::infinity()}) {
      EXPECT_EQ(mapping.depth_mm(huge), 4 * end);
      EXPECT_EQ(mapping.depth_mm(-huge), -4 * end);
    }
    EXPECT_TRUE(std::isnan(mapping.depth_mm(std::nan(""))));
  }
}

/// Brightness over that of the untouched layer of Kubelka and Munk without absorption over black,
/// R(t) = S t / (1 + S t): what a bulge by -d makes brighter.
TEST(Mapping, FollowsTheLayersPhysicsWhereItBulges) {
  constexpr double kLayerMm = 1.5;
  for (const double scattering_per_mm : {0.2, 0.6, 2.0}) {
    const double s = scattering_per_mm * kLayerMm;
    const auto reflected = [&](double t_mm) {
      return scattering_per_mm * t_mm / (1 + scattering_per_mm * t_mm);
    };
    MappingParameters p;
    p.kind = MappingKind::kMoebius;
    p.x_max = 0.8, p.a_mm = kLayerMm * (1 + s), p.b = s;
    const Mapping mapping = *Mapping::create(p);
    for (const double depth_mm : {-1.5, -0.7, -0.1, -0.01, 0.01, 0.1, 0.7}) {
      const double x = 1 - reflected(kLayerMm - depth_mm) / reflected(kLayerMm);
      EXPECT_NEAR(mapping.depth_mm(x), depth_mm, 1e-13) << s;
      EXPECT_NEAR(mapping.difference_at(depth_mm), x, 1e-13) << s;
    }
  }
}

TEST(Mapping, LeavesZeroWithOneSlope) {
  for (const Mapping& mapping : random_mappings(200)) {
    const double h = 1e-7 * mapping.x_max(), slope = mapping.slope_mm(0);
    EXPECT_NEAR(mapping.depth_mm(h) / h, slope, 1e-4 * slope + 1e-9);
    EXPECT_NEAR(mapping.depth_mm(-h) / -h, slope, 1e-4 * slope + 1e-9);
    if (mapping.parameters().kind == MappingKind::kMoebius) continue;
    // A polynomial is no physics beyond its data: its tangent.
    const double x = -0.01 * mapping.x_max();
    EXPECT_NEAR(mapping.depth_mm(x), slope * x, 1e-12);
  }
}

TEST(Mapping, GoesOnWithItsEndSlope) {
  const Mapping mapping = *Mapping::create(cubic());
  const double end = mapping.depth_mm(0.62), slope = mapping.slope_mm(0.62);
  EXPECT_NEAR(mapping.depth_mm(0.72), end + 0.1 * slope, 1e-14);
  EXPECT_EQ(mapping.slope_mm(5), slope);
  EXPECT_EQ(mapping.slope_mm(-5), mapping.slope_mm(0));
}

TEST(Mapping, SlopeIsTheDerivative) {
  for (const Mapping& mapping : random_mappings(100))
    for (double part : {0.1, 0.35, 0.6, 0.9}) {
      const long double x = part * mapping.x_max(), h = 1e-6L * mapping.x_max();
      const long double numeric = (by_definition(mapping.parameters(), x + h) -
                                   by_definition(mapping.parameters(), x - h)) /
                                  (2 * h);
      const double scale = mapping.depth_mm(mapping.x_max()) / mapping.x_max();
      EXPECT_NEAR(mapping.slope_mm(static_cast<double>(x)), static_cast<double>(numeric),
                  1e-8 * scale);
    }
}

TEST(Mapping, ManyAtOnceAgreeWithOneByOne) {
  double worst = 0;  // in parts of what is promised
  for (const Mapping& mapping : random_mappings(300)) {
    const MappingParameters& p = mapping.parameters();
    // Of a polynomial the rounding of sums of powers: those of T_k have magnitudes of together at
    // most (1 + sqrt(2))^k.
    double magnitudes = 0;
    for (std::size_t k = 0; k < p.chebyshev.size(); ++k)
      magnitudes += std::abs(p.chebyshev[k]) * std::pow(1 + std::sqrt(2.0), k);
    const auto promised = [&](double at, double expected) {
      return p.kind == MappingKind::kMoebius
                 ? 4e-7 / (1 + std::min(p.b, 0.0) * p.x_max) * expected
                 : 3e-6 * std::clamp(std::abs(at), 0.0, p.x_max) * magnitudes + 4e-7 * expected;
    };
    std::vector<float> x, depth(3017);
    for (int i = 0; i < 3017; ++i) x.push_back(static_cast<float>(-0.5 + i * (2.5 / 3016)));
    mapping.depths_mm(x.data(), depth.data(), 3017);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double expected = mapping.depth_mm(x[i]);
      // Where 1 + b x may be 1/2, a relative error of x counts twice.
      const double most = (x[i] < 0 ? 2 : 1) * promised(x[i], std::abs(expected));
      ASSERT_NEAR(depth[i], expected, most) << x[i];
      if (std::abs(expected) > 1e-30) worst = std::max(worst, std::abs(depth[i] - expected) / most);
    }
  }
  RecordProperty("worst_part_of_promised", fmt::format("{:.3g}", worst));
  EXPECT_LE(worst, 1.0);
}

TEST(Mapping, ManyAtOnceAreTheSameBytesHoweverTheyAreSplit) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> any(-0.2F, 1.2F);
  const auto bytes = [](const std::vector<float>& values) {
    return std::string_view(reinterpret_cast<const char*>(values.data()),
                            values.size() * sizeof(float));
  };
  for (const Mapping& mapping : random_mappings(60)) {
    std::vector<float> x(257), at_once(257), alone(257);
    for (float& value : x) value = any(random);
    x[3] = std::nanf("");
    x[100] = std::numeric_limits<float>::infinity();
    mapping.depths_mm(x.data(), at_once.data(), 257);
    for (int i = 0; i < 257; ++i) mapping.depths_mm(&x[i], &alone[i], 1);
    EXPECT_TRUE(bytes(at_once) == bytes(alone));
    EXPECT_TRUE(std::isnan(at_once[3]));
    EXPECT_TRUE(std::isfinite(at_once[100]));
    mapping.depths_mm(x.data(), x.data(), 257);
    EXPECT_TRUE(bytes(at_once) == bytes(x));
  }
}

TEST(Mapping, DifferenceAtIsTheInverse) {
  for (const Mapping& mapping : random_mappings(100)) {
    const double end = mapping.depth_mm(mapping.x_max());
    for (double part : {-4.0, -1.0, -0.1, -1e-6, 0.0, 1e-6, 0.2, 0.7, 1.0})
      EXPECT_NEAR(mapping.depth_mm(mapping.difference_at(part * end)), part * end, 1e-13 * end);
    EXPECT_NEAR(mapping.depth_mm(mapping.difference_at(-1e9)), -4 * end, 1e-13 * end);
    EXPECT_EQ(mapping.difference_at(2 * end), mapping.x_max());
  }
}

TEST(Mapping, PowersGiveTheSameCurve) {
  for (const Mapping& mapping : random_mappings(200)) {
    const std::vector<double> powers = mapping.powers();
    if (mapping.parameters().kind == MappingKind::kMoebius) {
      EXPECT_TRUE(powers.empty());
      continue;
    }
    ASSERT_EQ(powers.size(), mapping.parameters().chebyshev.size() + 1);
    EXPECT_EQ(powers[0], 0);
    for (double part : {0.2, 0.5, 1.0}) {
      const double x = part * mapping.x_max();
      long double sum = 0, size = 0;
      for (std::size_t i = powers.size(); i-- > 0;) {
        sum = sum * x + powers[i];
        size = size * x + std::abs(powers[i]);
      }
      EXPECT_NEAR(static_cast<double>(sum), mapping.depth_mm(x), 1e-14 * static_cast<double>(size));
    }
  }
}

TEST(Mapping, SpreadOfTheDepthIsThatOfDrawnCoefficients) {
  MappingParameters p = cubic();
  Eigen::Matrix3d root;
  root << 0.010, 0, 0, -0.004, 0.006, 0, 0.001, -0.002, 0.003;
  p.covariance = root * root.transpose();
  const Mapping mapping = *Mapping::create(p);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  constexpr int kDraws = 4000;
  const std::array places{-0.2, -0.01, 0.05, 0.31, 0.62, 0.75};
  Eigen::ArrayXXd depths(kDraws, places.size());
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector3d change =
        root * Eigen::Vector3d(normal(random), normal(random), normal(random));
    MappingParameters drawn = cubic();
    for (int k = 0; k < 3; ++k) drawn.chebyshev[k] += change[k];
    const Mapping moved = *Mapping::create(drawn);
    for (std::size_t j = 0; j < places.size(); ++j)
      depths(i, static_cast<int>(j)) = moved.depth_mm(places[j]);
  }
  for (std::size_t j = 0; j < places.size(); ++j) {
    const Eigen::ArrayXd column = depths.col(static_cast<int>(j));
    const double sd = std::sqrt((column - column.mean()).square().mean());
    EXPECT_NEAR(mapping.depth_sd_mm(places[j]), sd, 0.05 * sd) << places[j];
  }
  EXPECT_EQ(Mapping::create(cubic())->depth_sd_mm(0.3), 0);
}

TEST(Mapping, SpreadOfAMoebiusIsThatOfItsLinearisation) {
  MappingParameters p;
  p.kind = MappingKind::kMoebius;
  p.x_max = 0.7, p.a_mm = 2.5, p.b = 1.3;
  p.covariance = (Eigen::Matrix2d() << 4e-4, 1e-4, 1e-4, 9e-4).finished();
  const Mapping mapping = *Mapping::create(p);
  const auto depth = [&](double a, double b, double x) {
    MappingParameters moved = p;
    moved.a_mm = a, moved.b = b;
    return Mapping::create(moved)->depth_mm(x);
  };
  for (double x : {-0.3, -0.1, 0.1, 0.4, 0.7, 0.8}) {
    const double h = 1e-6;
    const Eigen::Vector2d gradient(
        (depth(p.a_mm + h, p.b, x) - depth(p.a_mm - h, p.b, x)) / (2 * h),
        (depth(p.a_mm, p.b + h, x) - depth(p.a_mm, p.b - h, x)) / (2 * h));
    EXPECT_NEAR(mapping.depth_sd_mm(x), std::sqrt(gradient.dot(p.covariance * gradient)), 1e-8);
  }
}

TEST(Mapping, SpreadOverTheFaceIsThatOfItsLinearisation) {
  MappingParameters p;
  p.kind = MappingKind::kMoebius;
  p.x_max = 0.7, p.a_mm = 2.5, p.b = 1.3;
  p.variation = {{0.1, -0.05}, {50.0, 1.0}, {30.0, 6.0}};
  Eigen::Matrix4d root = Eigen::Matrix4d::Identity() * 0.02;
  root(2, 0) = root(3, 1) = 0.01;
  p.covariance = root * root.transpose();
  const Mapping mapping = *Mapping::create(p);
  const auto depth = [&](const Eigen::Vector4d& step, double x, const Eigen::Vector2d& place) {
    MappingParameters moved = p;
    moved.a_mm += step[0], moved.b += step[1], moved.variation.part += step.tail<2>();
    return Mapping::create(moved)->depth_mm(x) * moved.variation.at(place);
  };
  for (const Eigen::Vector2d& place :
       {Eigen::Vector2d(50, 1), Eigen::Vector2d(70, -4), Eigen::Vector2d(200, 3)})
    for (const double x : {-0.2, 0.1, 0.6, 0.8}) {
      Eigen::Vector4d gradient;
      for (int k = 0; k < 4; ++k) {
        const Eigen::Vector4d h = 1e-6 * Eigen::Vector4d::Unit(k);
        gradient[k] = (depth(h, x, place) - depth(-h, x, place)) / 2e-6;
      }
      EXPECT_NEAR(mapping.depth_sd_mm(x, place), std::sqrt(gradient.dot(p.covariance * gradient)),
                  1e-8);
    }
  EXPECT_EQ(mapping.depth_sd_mm(0.3), mapping.depth_sd_mm(0.3, {50.0, 1.0}));
}

TEST(Mapping, RefusesWhatIsNoMapping) {
  const auto key_of = [](const MappingParameters& p) {
    const auto mapping = Mapping::create(p);
    return mapping ? std::string("accepted") : mapping.error().where.english();
  };
  EXPECT_EQ(key_of(cubic()), "accepted");
  for (double x_max : {0.0, -0.3, 1.01, std::nan(""), HUGE_VAL}) {
    MappingParameters p = cubic();
    p.x_max = x_max;
    EXPECT_EQ(key_of(p), "mapping.domain") << x_max;
  }
  for (const std::vector<double>& c : {std::vector<double>{},
                                       std::vector<double>(13, 0.1),
                                       {0.0},
                                       {-1.0},
                                       {1.0, std::nan("")},
                                       {1.0, HUGE_VAL},
                                       {1e300},
                                       {1.0, 0.0, 2.0},  // falls in the middle
                                       {1.0, -0.5},      // falls at the end
                                       {1.0, 0.0, 0.0, 0.9}}) {
    MappingParameters p = cubic();
    p.chebyshev = c;
    EXPECT_EQ(key_of(p), "mapping.chebyshev");
  }
  for (const auto& [a, b, key] : {std::tuple{0.0, 1.0, "mapping.a_mm"},
                                  {-2.0, 1.0, "mapping.a_mm"},
                                  {std::nan(""), 1.0, "mapping.a_mm"},
                                  {2.0, -2.0, "mapping.b"},
                                  {2.0, std::nan(""), "mapping.b"},
                                  {1e9, 1.0, "mapping.a_mm"}}) {
    MappingParameters p;
    p.kind = MappingKind::kMoebius;
    p.x_max = 0.5, p.a_mm = a, p.b = b;
    EXPECT_EQ(key_of(p), key) << a << ' ' << b;
  }
  for (const Eigen::Matrix3d& covariance :
       {Eigen::Matrix3d(-Eigen::Matrix3d::Identity()),
        Eigen::Matrix3d(std::nan("") * Eigen::Matrix3d::Ones()),
        Eigen::Matrix3d((Eigen::Matrix3d() << 1, 2, 3, 4, 5, 6, 7, 8, 9).finished())}) {
    MappingParameters p = cubic();
    p.covariance = covariance;
    EXPECT_EQ(key_of(p), "mapping.covariance");
  }
  MappingParameters p = cubic();
  p.covariance = Eigen::Matrix2d::Identity();
  EXPECT_EQ(key_of(p), "mapping.covariance");
}

TEST(Mapping, SpreadOfLightIsRefusedWhereItHasNoMeaning) {
  const auto spreading = [](auto change) {
    MappingParameters p;
    p.kind = MappingKind::kMoebius;
    p.along = MappingAlong::kNormal;
    p.a_mm = 2.0, p.b = 0.5, p.x_max = 0.5;
    p.spread.optical_thickness = 0.8;
    change(p);
    return Mapping::create(p);
  };
  EXPECT_TRUE(spreading([](MappingParameters&) {}).ok());
  const std::vector<std::function<void(MappingParameters&)>> wrong{
      [](MappingParameters& p) { p.kind = MappingKind::kPolynomial, p.chebyshev = {1.0}; },
      [](MappingParameters& p) { p.along = MappingAlong::kZ; },
      [](MappingParameters& p) { p.b = -1.2; },
      [](MappingParameters& p) { p.spread.optical_thickness = 4.5; },
      [](MappingParameters& p) { p.spread.optical_thickness = NAN; },
      [](MappingParameters& p) { p.spread.width_factor = 0.1; },
      [](MappingParameters& p) { p.spread.half_mm = 0.0; },
      [](MappingParameters& p) { p.spread.b_straight = INFINITY; },
      [](MappingParameters& p) { p.spread.log_b_along = NAN; }};
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    const auto mapping = spreading(wrong[i]);
    ASSERT_FALSE(mapping.ok()) << i;
    EXPECT_EQ(mapping.error().where.english(), "mapping.spread") << i;
  }
}

}  // namespace
}  // namespace alltact
