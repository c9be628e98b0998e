#include "core/simulation/mechanics/ball_contact.h"

#include "core/simulation/mechanics/rubber.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace alltact {
namespace {

// Ascending powers of chi, from 0 to BondedLayerContact::kMaxChi.
using ChiSeries = std::array<double, 8>;
constexpr ChiSeries kForceSeries{1,         1.160142, 0.946650,  3.943779,
                                 -3.059152, 1.402830, -0.305381, 0.025786};
constexpr ChiSeries kRadiusSeries{1,        0.353462,  0.664927, -1.206125,
                                  0.859433, -0.314643, 0.058293, -0.004327};
constexpr ChiSeries kExponentSeries{0.5,       0.018102, -0.426864, 1.542810,
                                    -1.438462, 0.609028, -0.123335, 0.009707};

// sum c_k w(k) chi^k.
template <class Weight>
double series(const ChiSeries& c, double chi, const Weight& weight) {
  double sum = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * chi + c[k] * weight(static_cast<double>(k));
  return sum;
}
double series(const ChiSeries& c, double chi) {
  return series(c, chi, [](double) { return 1.0; });
}

}  // namespace

BondedLayerContact::BondedLayerContact(double modulus_MPa, double layer_mm, double radius_mm)
    : modulus_MPa_(modulus_MPa),
      layer_mm_(layer_mm),
      radius_mm_(radius_mm),
      max_mm_(std::min(kMaxDepthShare * layer_mm,
                       kMaxChi * kMaxChi * layer_mm * layer_mm / radius_mm)) {}

Result<BondedLayerContact> BondedLayerContact::create(double modulus_MPa, double layer_mm,
                                                      double radius_mm) {
  for (const double given : {modulus_MPa, layer_mm, radius_mm})
    if (!(given > 0 && std::isfinite(given)))
      return Error{en::say("a layer cannot have a modulus or a length of {:g}", given), "",
                   en::say("numbers above 0")};
  return BondedLayerContact(modulus_MPa, layer_mm, radius_mm);
}

double BondedLayerContact::within(double indentation_mm) const {
  return indentation_mm > 0 ? std::min(indentation_mm, max_mm_) : 0.0;
}

double BondedLayerContact::chi(double indentation_mm) const {
  return std::sqrt(radius_mm_ * indentation_mm) / layer_mm_;
}

double BondedLayerContact::force_N(double indentation_mm) const {
  const double d = within(indentation_mm);
  return 16.0 / 9 * modulus_MPa_ * std::sqrt(radius_mm_ * d) * d * series(kForceSeries, chi(d));
}

// chi^k varies as d^(k/2): the derivative multiplies by 1.5 + k/2, the integral divides by 2.5 +
// k/2.
double BondedLayerContact::stiffness_N_per_mm(double indentation_mm) const {
  const double d = within(indentation_mm);
  return 16.0 / 9 * modulus_MPa_ * std::sqrt(radius_mm_ * d) *
         series(kForceSeries, chi(d), [](double k) { return 1.5 + k / 2; });
}

double BondedLayerContact::energy_Nmm(double indentation_mm) const {
  const double d = within(indentation_mm);
  return 16.0 / 9 * modulus_MPa_ * std::sqrt(radius_mm_ * d) * d * d *
         series(kForceSeries, chi(d), [](double k) { return 1 / (2.5 + k / 2); });
}

double BondedLayerContact::contact_radius_mm(double indentation_mm) const {
  const double d = within(indentation_mm);
  return std::sqrt(radius_mm_ * d) * series(kRadiusSeries, chi(d));
}

double BondedLayerContact::pressure_exponent(double indentation_mm) const {
  return std::max(0.5, series(kExponentSeries, chi(within(indentation_mm))));
}

double BondedLayerContact::pressure_MPa(double indentation_mm, double r_mm) const {
  const double d = within(indentation_mm);
  const double a = contact_radius_mm(d), r = std::abs(r_mm);
  if (!(r < a)) return 0;
  const double m = pressure_exponent(d), q = r / a;
  return (m + 1) * force_N(d) / (std::numbers::pi * a * a) * std::pow((1 - q) * (1 + q), m);
}

Result<double> BondedLayerContact::indentation_mm(double force) const {
  const double max_value = max_force_N();
  if (!(force >= 0 && force <= max_value))
    return Error{en::say("{:g} N press the ball into the layer beyond the known range", force), "",
                 en::say("up to {:.3g} N, a larger ball or a harder layer", max_value)};
  if (force == 0) return 0.0;
  // Newton's method on log F over log d, which is nearly straight, bracketed by `low` and `high`.
  double low = 0, high = max_mm_;
  double d =
      std::min(high, std::pow(force * 9 / (16 * modulus_MPa_ * std::sqrt(radius_mm_)), 2.0 / 3));
  for (int i = 0; i < 100; ++i) {
    const double here = force_N(d);
    (here < force ? low : high) = d;
    double next = d * std::exp(std::log(force / here) * here / (d * stiffness_N_per_mm(d)));
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double step = std::abs(next - d);
    d = next;
    if (step <= 1e-15 * d) break;
  }
  return d;
}

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
      abel_.push_back(
          {a * std::sin(angle), peak * 0.5 * std::numbers::pi * node.weight * a * std::cos(angle) *
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

std::vector<float> indented_surface_mm(const BondedLayerContact& contact, double indentation_mm,
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

namespace {

constexpr double kPoisson = 0.5;

// Displacement under a traction sqrt(1 - r^2 / a^2) along x, times the shear modulus.
Eigen::Vector2d tangential_mm(const Eigen::Vector2d& at, double a) {
  const double r2 = at.squaredNorm(), r = std::sqrt(r2), pi = std::numbers::pi;
  if (r <= a) {
    const double x = at.x(), y = at.y();
    return pi / (32 * a) *
           Eigen::Vector2d(
               4 * (2 - kPoisson) * a * a - (4 - 3 * kPoisson) * x * x - (4 - kPoisson) * y * y,
               2 * kPoisson * x * y);
  }
  const double q = a / r, angle = std::asin(q), root = std::sqrt((1 - q) * (1 + q));
  const double even = (2 - kPoisson) * ((2 * a * a - r2) * angle + a * r * root);
  const double turning = 0.5 * kPoisson * (r2 * angle + (2 * a * a - r2) * root * q);
  const double c = at.x() / r, s = at.y() / r;
  return Eigen::Vector2d(even + turning * (c - s) * (c + s), turning * 2 * s * c) / (8 * a);
}

}  // namespace

Eigen::Vector2d limited_by_friction(const Eigen::Vector2d& tangential_N, double normal_N,
                                    double friction) {
  const double requested = tangential_N.norm(), held = friction * normal_N;
  return requested > held ? Eigen::Vector2d(tangential_N * (held / requested)) : tangential_N;
}

Result<HalfSpaceContact> HalfSpaceContact::create(double modulus_MPa, double radius_mm,
                                                  double normal_N,
                                                  const Eigen::Vector2d& tangential_N,
                                                  double friction) {
  for (const double given : {modulus_MPa, radius_mm, normal_N, friction})
    if (!(given > 0 && std::isfinite(given)))
      return Error{en::say("{:g} cannot be a contact's modulus, radius, force or friction", given),
                   "", en::say("numbers above 0")};
  if (!tangential_N.allFinite())
    return Error{en::say("the tangential force is not a number"), "", en::say("newtons")};
  HalfSpaceContact contact;
  contact.modulus_MPa_ = modulus_MPa;
  contact.radius_mm_ = radius_mm;
  const double plane = modulus_MPa / (1 - kPoisson * kPoisson);
  const double a = std::cbrt(0.75 * normal_N * radius_mm / plane);
  if (a > kMaxContactShare * radius_mm) {
    const double max_value = std::pow(kMaxContactShare, 3) * radius_mm * radius_mm * plane / 0.75;
    return Error{en::say("{:g} N press the ball into the body beyond the known range", normal_N),
                 "", en::say("up to {:.3g} N, a larger ball or a harder body", max_value)};
  }
  contact.contact_mm_ = a;
  contact.slip_traction_MPa_ = friction * 1.5 * normal_N / (std::numbers::pi * a * a);
  const double part = std::min(1.0, tangential_N.norm() / (friction * normal_N));
  contact.stick_mm_ = a * std::cbrt(1 - part);
  if (part > 0) contact.direction_ = tangential_N.normalized();
  return contact;
}

Eigen::Vector3d HalfSpaceContact::displacement_mm(const Eigen::Vector2d& at_mm) const {
  const double a = contact_mm_, r = at_mm.norm();
  const double share = r <= a ? 1 - 0.5 * r * r / (a * a) : hertz_tail(a / r);
  Eigen::Vector3d result(0, 0, indentation_mm() * share);
  if (direction_.isZero()) return result;
  const Eigen::Vector2d aside(-direction_.y(), direction_.x());
  const Eigen::Vector2d at(at_mm.dot(direction_), at_mm.dot(aside));
  Eigen::Vector2d moved = tangential_mm(at, a);
  if (stick_mm_ > 0) moved -= stick_mm_ / a * tangential_mm(at, stick_mm_);
  moved *= slip_traction_MPa_ / shear_modulus(modulus_MPa_);
  result.head<2>() = moved.x() * direction_ + moved.y() * aside;
  return result;
}

}  // namespace alltact
