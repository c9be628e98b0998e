// The curves of the fit against the physics they stand for, and the scale of depth that comes out
// of noisy presses: truths from tests/support/made_press.h, which shares no formula with them.
#include "calibration/joint/mapping_curve.h"

#include "calibration/joint/calibrate.h"
#include "tests/support/made_press.h"
#include "tests/support/slow_run.h"

#include <cmath>
#include <cstdio>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;

constexpr CurveFamily kLayerFamily{MappingKind::kMoebius, 3};

/// The curve with which a layer's darkness gives its depth, `absorption` over scattering known.
MappingCurve curve_of_layer(const Layer& layer) {
  MappingCurve curve(kLayerFamily, layer.difference_at(1.2));
  curve.values() << layer.thickness_mm * (1.0 + layer.s), layer.s, layer.k;
  return curve;
}

TEST(MappingCurve, OfALayerIsThatOfKubelkaAndMunk) {
  for (const double s : {0.05, 0.3, 1.0, 3.0})
    for (const double k : {0.0, 1e-9, 0.02, 0.2, 0.6}) {
      const Layer layer{s, k};
      const MappingCurve curve = curve_of_layer(layer);
      for (double depth = 0.05; depth < 1.21; depth += 0.05) {
        const double x = layer.difference_at(depth);
        EXPECT_NEAR(curve.depth_mm(x), depth, 1e-6) << s << ' ' << k;
        EXPECT_NEAR(curve.at().inverse(depth, {0, 0}, 0.0).x, x, 1e-6) << s << ' ' << k;
      }
    }
}

TEST(MappingCurve, WithoutAbsorptionIsTheMoebiusCurve) {
  MappingCurve layer(kLayerFamily, 0.6), moebius({MappingKind::kMoebius, 2}, 0.6);
  for (const double b : {-0.6, 0.0, 0.7, 3.0}) {
    layer.values() << 2.3, b, 0.0;
    moebius.values() << 2.3, b;
    for (double x = -0.1; x < 0.65; x += 0.03) {
      EXPECT_NEAR(layer.depth_mm(x), moebius.depth_mm(x), 1e-12);
      EXPECT_NEAR(layer.slope_mm(x), moebius.slope_mm(x), 1e-12);
    }
  }
}

TEST(MappingCurve, IsTurnedRoundWithItsDerivatives) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const CurveFamily family :
       {CurveFamily{MappingKind::kMoebius, 2}, CurveFamily{MappingKind::kMoebius, 3},
        CurveFamily{MappingKind::kMoebius, 3, true}, CurveFamily{MappingKind::kPolynomial, 4}})
    for (int round = 0; round < 20; ++round) {
      MappingCurve curve(family, 0.6);
      curve.values().setConstant(0.1);
      curve.values()[0] = 2.0 + 0.5 * uniform(random);
      curve.values()[1] = 0.5 + 0.3 * uniform(random);
      const Eigen::Vector2d place(uniform(random), uniform(random));
      const double x = 0.3 + 0.29 * uniform(random), depth = curve.at().depth_mm(x, place);
      Eigen::VectorXd gradient(family.numbers());
      const auto found = curve.at().inverse(depth, place, 0.3, gradient.data());
      EXPECT_NEAR(found.x, x, 1e-10);
      constexpr double kStep = 1e-6;
      EXPECT_NEAR(found.slope_mm,
                  (curve.at().depth_mm(x + kStep, place) - curve.at().depth_mm(x - kStep, place)) /
                      (2.0 * kStep),
                  1e-6);
      for (int k = 0; k < family.numbers(); ++k) {
        MappingCurve up = curve, down = curve;
        up.values()[k] += kStep;
        down.values()[k] -= kStep;
        EXPECT_NEAR(gradient[k],
                    (up.at().inverse(depth, place, x).x - down.at().inverse(depth, place, x).x) /
                        (2.0 * kStep),
                    1e-6);
      }
    }
}

TEST(MappingCurve, IsStoredAsAPolynomialThatRunsAlongIt) {
  for (const double s : {0.3, 1.0, 2.0})
    for (const double k : {0.0, 0.1, 0.3}) {
      const MappingCurve curve = curve_of_layer({s, k});
      Eigen::MatrixXd by_values;
      const MappingCurve stored = stored_form(curve, &by_values);
      EXPECT_EQ(stored.family().kind, MappingKind::kPolynomial);
      for (int i = 1; i <= 37; ++i) {
        const double x = curve.x_max() * i / 37;
        EXPECT_NEAR(stored.depth_mm(x), curve.depth_mm(x), 6e-4) << s << ' ' << k;
        // What the numbers of the layer move, its coefficients move alike.
        Eigen::VectorXd by_numbers(3), by_coefficients(stored.values().size());
        (void)curve.depth_mm(x, by_numbers.data());
        (void)stored.depth_mm(x, by_coefficients.data());
        EXPECT_LT((by_values.transpose() * by_coefficients - by_numbers).norm(), 0.02);
      }
    }
}

/// Depth that a calibration on six flat presses reads over the truth, of 0.3 to 1 mm.
double scale_of(const Layer& layer, const Contact& contact, double noise, unsigned seed) {
  std::mt19937 random(seed);
  const MadeScene scene = flat_scene();
  std::vector<Press> presses;
  for (int i = 0; i < 6; ++i)
    presses.push_back(make_press(scene, layer, contact,
                                 {Ball{130.0 + 28.0 * i, 110.0 + 16.0 * i, 4.0, 0.45 + 0.13 * i}},
                                 noise, random, fmt::format("p{}", i))
                          .press);
  const auto done = calibrate(presses, scene.camera, scene.face, {}, Job{});
  EXPECT_TRUE(done.ok()) << (done ? "" : done.error().sentence());
  if (!done) return 0;
  const auto mapping = Mapping::create(done->mapping).value();
  double ratio = 0;
  for (int i = 3; i <= 10; ++i) ratio += mapping.depth_mm(layer.difference_at(0.1 * i)) / (0.8 * i);
  std::printf("[ figures  ] s %.1f k %.2f, noise %.0f: depth reads %.4f of what it is\n", layer.s,
              layer.k, noise, ratio);
  return ratio;
}

// With residuals of depth instead of brightness noise makes depths too small: 0.95 at 3 levels.
TEST(ScaleOfDepth, DoesNotDependOnTheNoise) {
  const int runs = test::as_many_as(2, 8);  // one is a draw: 0.02 at 5 levels
  for (const double noise : {1.0, 3.0, 5.0}) {
    double mean = 0;
    for (int run = 0; run < runs; ++run)
      mean += scale_of({0.6, 0.02}, {Skin::kTail, 0.8}, noise, 5 + run) / runs;
    std::printf("[ figures  ] noise %.0f: depth reads %.4f of what it is on average\n", noise,
                mean);
    EXPECT_NEAR(mean, 1.0, 0.02) << noise;
  }
}

TEST(ScaleOfDepth, DoesNotDependOnTheAbsorption) {
  for (const double absorption : {0.0, 0.06, 0.15})
    EXPECT_NEAR(scale_of({1.0, absorption}, {Skin::kHertz}, 1.0, 6), 1.0, 0.018) << absorption;
}

}  // namespace
}  // namespace alltact
