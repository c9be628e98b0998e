#include "core/simulation/mechanics/ball_contact.h"
#include "tests/core/simulation/effects/effect_scene.h"

#include <Eigen/Dense>

namespace alltact {
namespace {

// Nodes and weights on [0, end].
struct GaussRule {
  Eigen::VectorXd x, w;
  GaussRule(int n, double end) {
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(n, n);
    for (int i = 1; i < n; ++i)
      jacobi(i, i - 1) = jacobi(i - 1, i) = i / std::sqrt(4.0 * i * i - 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(jacobi);
    x = (solved.eigenvalues().array() + 1) * end / 2;
    w = solved.eigenvectors().row(0).array().square().transpose() * end;
  }
};

// The contact of a ball of radius 1 with a bonded, incompressible layer of thickness 1 and modulus
// 1, by the integral equation of Lebedev and Ufliand: with the layer's compliance phi(k) / k,
//   g(t) - 2/pi int (1 - phi) cos kt int_0^a g(x) cos kx dx dk = 2/pi (d - t^2),  g(a) = 0,
//   F = pi E* int g,  p(0) = -E* / 2 int g'(t) / t dt,  E* = E / 0.75.
struct LayerTruth {
  double d, force, p_0;
  std::vector<std::array<double, 2>> surface;  // beside the contact: r, w

  explicit LayerTruth(double a) {
    const GaussRule t(40, a), k(160, 20);
    const auto table = [&](const auto& f) {
      Eigen::MatrixXd m(t.x.size(), k.x.size());
      for (int i = 0; i < m.rows(); ++i)
        for (int j = 0; j < m.cols(); ++j) m(i, j) = f(t.x[i] * k.x[j]);
      return m;
    };
    const Eigen::MatrixXd cos = table([](double x) { return std::cos(x); });
    const Eigen::MatrixXd sin = table([](double x) { return std::sin(x); });
    Eigen::VectorXd weight(k.x.size());
    for (int j = 0; j < k.x.size(); ++j) {
      const double o = k.x[j];
      const double phi = (std::sinh(2 * o) - 2 * o) / (std::cosh(2 * o) + 2 * o * o + 1);
      weight[j] = 2 / M_PI * k.w[j] * (1 - phi);
    }
    const Eigen::MatrixXd kernel = cos * weight.asDiagonal() * cos.transpose() * t.w.asDiagonal();
    const auto lu =
        (Eigen::MatrixXd::Identity(t.x.size(), t.x.size()) - kernel).eval().partialPivLu();
    const Eigen::VectorXd one = lu.solve(Eigen::VectorXd::Constant(t.x.size(), 2 / M_PI));
    const Eigen::VectorXd square = lu.solve((2 / M_PI * t.x.array().square()).matrix());
    const Eigen::VectorXd at_rim =
        (cos * weight.cwiseProduct((k.x * a).array().cos().matrix())).cwiseProduct(t.w);
    d = (2 / M_PI * a * a + at_rim.dot(square)) / (2 / M_PI + at_rim.dot(one));
    const Eigen::VectorXd g = d * one - square;
    force = M_PI / 0.75 * t.w.dot(g);
    const Eigen::VectorXd moments = weight.cwiseProduct(cos.transpose() * t.w.cwiseProduct(g));
    const Eigen::VectorXd g_t = -4 / M_PI * t.x - sin * k.x.cwiseProduct(moments);
    p_0 = -0.5 / 0.75 * t.w.dot(g_t.cwiseQuotient(t.x));
    for (const double off : {0.05, 0.2, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0}) {
      const double r = a + off;
      double w = t.w.dot(g.cwiseQuotient((r * r - t.x.array().square()).sqrt().matrix()));
      for (int j = 0; j < k.x.size(); ++j)
        w -= M_PI / 2 * weight[j] * t.w.dot(cos.col(j).cwiseProduct(g)) *
             std::cyl_bessel_j(0, k.x[j] * r);
      surface.push_back({r, w});
    }
  }
};

BondedLayerContact layer_of(double modulus, double layer, double radius) {
  return BondedLayerContact::create(modulus, layer, radius).value();
}

TEST(BondedLayer, IsTheSolutionOfTheContactsIntegralEquation) {
  for (const double a : {0.05, 0.2, 0.5, 0.8, 1.1, 1.6, 2.2, 3.0, 4.0, 5.0}) {
    const LayerTruth truth(a);
    // A layer of 2 mm, a ball of radius k mm and the modulus 0.3, so that d stays below the layer.
    const double h = 2, radius = h * std::max(1.0, 2 * truth.d), modulus = 0.3;
    const double d = truth.d * h * h / radius;
    const BondedLayerContact contact = layer_of(modulus, h, radius);
    ASSERT_LT(d, contact.max_indentation_mm());
    EXPECT_NEAR(contact.force_N(d) / (truth.force * modulus * h * h * h / radius), 1, 2.5e-3) << a;
    EXPECT_NEAR(contact.contact_radius_mm(d) / (a * h), 1, 2.5e-3) << a;
    EXPECT_NEAR(contact.pressure_MPa(d, 0) / (truth.p_0 * modulus * h / radius), 1, 0.01) << a;
  }
}

// Beside the ball, too; and the layer keeps its volume.
TEST(BondedLayer, BendsItsSurfaceAsItsPressureDoes) {
  for (const double a : {0.1, 0.4, 0.8, 1.2, 1.6, 2.2}) {
    const LayerTruth truth(a);
    const double h = 1.5, radius = h * 20, d = truth.d * h * h / radius;
    const BondedLayerContact contact = layer_of(0.28, h, radius);
    ASSERT_LT(d, contact.max_indentation_mm());
    const double step = 0.005;
    const std::vector<float> profile = indented_surface_mm(contact, d, step);
    EXPECT_FLOAT_EQ(profile[0], static_cast<float>(d));
    EXPECT_EQ(profile.back(), 0);
    for (const auto& [r, w] : truth.surface) {
      const double at = r * h / step;
      const auto i = static_cast<std::size_t>(at);
      const double got = i + 1 < profile.size() ? profile[i] + (at - static_cast<double>(i)) *
                                                                   (profile[i + 1] - profile[i])
                                                : 0;
      EXPECT_NEAR(got, w * h * h / radius, 0.01 * d + 1e-4) << a << ' ' << r;
    }
  }
  for (const double chi : {0.9, 1.2, 1.5, 1.8}) {
    const double radius = 10, d = chi * chi * 1.5 * 1.5 / radius, step = 0.005;
    const BondedLayerContact contact = layer_of(0.28, 1.5, radius);
    const std::vector<float> profile = indented_surface_mm(contact, d, step);
    double volume = 0, dent = 0;
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const double ring = 2 * M_PI * static_cast<double>(i) * step * step * double{profile[i]};
      volume += ring;
      dent += std::max(0.0, ring);
    }
    EXPECT_NEAR(volume / dent, 0, 0.06) << chi;
  }
}

// What others found: Hertz on a thick layer; the series of Dimitriadis et al. and of Garcia and
// Garcia where theirs converge; the latter is the better one.
TEST(BondedLayer, AgreesWithPublishedSeriesWhereTheyHold) {
  Parameters random(3);
  for (int i = 0; i < 50; ++i) {
    const double modulus = random.between(0.05, 3), radius = random.between(0.5, 10);
    const double hertz_d = random.between(0.01, 0.1);
    const double hertz = 16.0 / 9 * modulus * std::sqrt(radius) * std::pow(hertz_d, 1.5);
    EXPECT_NEAR(layer_of(modulus, 1e5, radius).force_N(hertz_d) / hertz, 1, 1e-4);
    const double layer = random.between(3, 9) * std::sqrt(radius * hertz_d);
    const double x = std::sqrt(radius * hertz_d) / layer;
    const double garcia = 1 + x * (1.133 + x * (1.497 + x * (1.469 + x * 0.755)));
    const double force = layer_of(modulus, layer, radius).force_N(hertz_d);
    EXPECT_NEAR(force / (hertz * garcia), 1, 5e-3) << x;
    if (x > 0.15) continue;
    const double dimitriadis = 1 + x * (1.133 + x * (1.283 + x * (0.769 + x * 0.0975)));
    EXPECT_NEAR(force / (hertz * dimitriadis), 1, 8e-3) << x;
  }
}

TEST(BondedLayer, PressureAddsUpToTheForceAndEnergyGrowsByIt) {
  Parameters random(4);
  for (int i = 0; i < 60; ++i) {
    const BondedLayerContact contact =
        layer_of(random.between(0.1, 2), random.between(0.5, 4), random.between(1, 10));
    const double d = contact.max_indentation_mm() * random.between(0.02, 0.98);
    const double a = contact.contact_radius_mm(d), force = contact.force_N(d);
    double sum = 0;
    const int n = 200;
    for (int u = -n; u < n; ++u)
      for (int v = -n; v < n; ++v)
        sum += contact.pressure_MPa(d, a / n * std::hypot(u + 0.5, v + 0.5));
    EXPECT_NEAR(sum * a * a / (n * n) / force, 1, 2e-3);
    EXPECT_EQ(contact.pressure_MPa(d, a * 1.0001), 0);
    const double step = 1e-4 * d;
    EXPECT_NEAR((contact.energy_Nmm(d + step) - contact.energy_Nmm(d - step)) / (2 * step * force),
                1, 1e-6);
    EXPECT_NEAR((contact.force_N(d + step) - contact.force_N(d - step)) / (2 * step) /
                    contact.stiffness_N_per_mm(d),
                1, 1e-6);
  }
}

TEST(BondedLayer, FindsTheIndentationOfAForce) {
  Parameters random(5);
  for (int i = 0; i < 300; ++i) {
    const BondedLayerContact contact =
        layer_of(random.between(0.01, 9), random.between(0.1, 9), random.between(0.1, 50));
    double before = 0;
    for (int k = 0; k <= 20; ++k) {
      const double force = contact.max_force_N() * std::pow(k / 20.0, 4);
      const double d = contact.indentation_mm(force).value();
      EXPECT_NEAR(contact.force_N(d), force, 1e-12 * force);
      EXPECT_TRUE(k == 0 ? d == 0 : d > before);
      before = d;
    }
    EXPECT_NEAR(before, contact.max_indentation_mm(), 1e-9);
  }
}

TEST(BondedLayer, RefusesWhatItDoesNotKnow) {
  EXPECT_FALSE(BondedLayerContact::create(0, 1, 1));
  EXPECT_FALSE(BondedLayerContact::create(1, -1, 1));
  EXPECT_FALSE(BondedLayerContact::create(1, 1, std::nan("")));
  const BondedLayerContact contact = layer_of(0.28, 1.5, 4);
  EXPECT_FALSE(contact.indentation_mm(-1));
  EXPECT_FALSE(contact.indentation_mm(std::nan("")));
  EXPECT_THAT(contact.indentation_mm(1000).error().sentence(), testing::HasSubstr("1000 N press"));
}

}  // namespace
}  // namespace alltact
