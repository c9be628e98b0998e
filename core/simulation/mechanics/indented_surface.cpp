#include "core/simulation/mechanics/indented_surface.h"

#include <array>
#include <cmath>
#include <numbers>

namespace alltact {

namespace {

constexpr double kReach = 7;             // of the layer's thickness, beyond the rim
constexpr double kMinVisible_mm = 1e-4;  // smallest displacement that is visible
constexpr double kCoarse = 0.05;         // of the thickness: step between computed samples
constexpr double kFade = 0.3;    // of the thickness: decay length of the correction at the rim
constexpr double kMaxWave = 14;  // k h; 1 - phi is 1e-9 there

struct GaussNode {
  double position, weight;  // on [0, 1]
};
template <std::size_t N>
std::array<GaussNode, N> gauss_nodes() {
  std::array<GaussNode, N> nodes{};
  for (std::size_t i = 0; i < N; ++i) {
    double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (N + 0.5)), slope = 1;
    for (int newton = 0; newton < 8; ++newton) {
      double p = 1, before = 0;
      for (std::size_t k = 1; k <= N; ++k) {
        const auto n = static_cast<double>(k);
        const double next = ((2 * n - 1) * x * p - (n - 1) * before) / n;
        before = p;
        p = next;
      }
      slope = N * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    nodes[i] = {0.5 * (1 - x), 1 / ((1 - x * x) * slope * slope)};
  }
  return nodes;
}

// The surface beyond the rim for a pressure of (1 - r^2 / a^2)^m E* / pi; lengths in thicknesses.
class Outside {
 public:
  Outside(double a, double exponent) {
    static const auto kAngles = gauss_nodes<24>();
    static const auto kWaves = gauss_nodes<64>();
    // Its Abel transform g, times dt.
    // B(1/2, m + 1): std::beta would let threads write the C library's shared sign of lgamma.
    const double beta =
        std::sqrt(std::numbers::pi) * std::tgamma(exponent + 1) / std::tgamma(exponent + 1.5);
    const double peak = 2 * a * beta / (std::numbers::pi * std::numbers::pi);
    for (const GaussNode& node : kAngles) {
      const double angle = 0.5 * std::numbers::pi * node.position;
      abel_.push_back({a * std::sin(angle),
                       peak * 0.5 * std::numbers::pi * node.weight * a * std::cos(angle) *
                           std::pow(std::cos(angle), 2 * exponent + 1)});
    }
    for (const GaussNode& node : kWaves) {
      const double k = kMaxWave * node.position;
      const double phi = (std::sinh(2 * k) - 2 * k) / (std::cosh(2 * k) + 1 + 2 * k * k);
      double transform = 0;
      for (const Term& term : abel_) transform += term.value * std::cos(k * term.at);
      waves_.push_back({k, kMaxWave * node.weight * (1 - phi) * transform});
    }
  }
  [[nodiscard]] double at(double r) const {
    double sum = 0;
    for (const Term& term : abel_) sum += term.value / std::sqrt(r * r - term.at * term.at);
    for (const Term& wave : waves_) sum -= wave.value * ::j0(wave.at * r);
    return sum;
  }

 private:
  struct Term {
    double at, value;
  };
  std::vector<Term> abel_, waves_;
};

// Cubic through four equidistant samples, between the second and the third.
double cubic(const std::array<double, 4>& y, double t) {
  const double slope_0 = 0.5 * (y[2] - y[0]), slope_1 = 0.5 * (y[3] - y[1]), u = 1 - t;
  return u * u * (y[1] * (1 + 2 * t) + slope_0 * t) + t * t * (y[2] * (3 - 2 * t) - slope_1 * u);
}

}  // namespace

std::vector<float> indented_surface_mm(const BondedLayerContact& contact,
                                       double indentation_mm,
                                       double step_mm) {
  const double h = contact.layer_mm(), radius = contact.radius_mm();
  const double a = std::min(contact.contact_radius_mm(indentation_mm), radius);
  const auto on_ball = [&](double r) {
    return indentation_mm - r * r / (radius + std::sqrt(radius * radius - r * r));
  };
  const Outside outside(a / h, contact.pressure_exponent(indentation_mm));
  const double strain =
      std::numbers::pi * 0.75 * contact.pressure_MPa(indentation_mm, 0) / contact.modulus_MPa();
  const double miss = on_ball(a) - h * strain * outside.at(a / h);
  // Coarse samples from the rim on, evenly in the root of the distance, because the surface leaves
  // the ball as that root.
  const auto root_at = [&](double r) { return std::sqrt((r - a) / h); };
  const int coarse = static_cast<int>(std::sqrt(kReach) / kCoarse) + 3;
  std::vector<double> w;
  for (int i = 0; i < coarse; ++i) {
    const double off = std::pow(i * kCoarse, 2);
    w.push_back(h * strain * outside.at(a / h + off) + miss * std::exp(-off / kFade));
  }
  std::vector<float> profile;
  std::size_t visible = 0;
  for (int i = 0;; ++i) {
    const double r = i * step_mm;
    if (r <= a) {
      profile.push_back(static_cast<float>(on_ball(r)));
      continue;
    }
    const double at = root_at(r) / kCoarse;
    const auto cell = static_cast<std::size_t>(at);
    if (cell + 3 > w.size()) break;
    const double before = cell == 0 ? w[1] : w[cell - 1];  // symmetric in the root
    const double here = cubic({before, w[cell], w[cell + 1], w[std::min(cell + 2, w.size() - 1)]},
                              at - static_cast<double>(cell));
    profile.push_back(static_cast<float>(here));
    if (std::abs(here) > kMinVisible_mm) visible = profile.size();
  }
  profile.resize(std::max<std::size_t>(visible, static_cast<std::size_t>(a / step_mm) + 2));
  profile.push_back(0);
  return profile;
}

}  // namespace alltact
