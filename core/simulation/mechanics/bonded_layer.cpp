#include "core/simulation/mechanics/bonded_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace alltact {

namespace {

// Ascending powers of chi, from 0 to BondedLayerContact::kMaxChi.
using ChiSeries = std::array<double, 8>;
constexpr ChiSeries kForceSeries{
    1, 1.160142, 0.946650, 3.943779, -3.059152, 1.402830, -0.305381, 0.025786};
constexpr ChiSeries kRadiusSeries{
    1, 0.353462, 0.664927, -1.206125, 0.859433, -0.314643, 0.058293, -0.004327};
constexpr ChiSeries kExponentSeries{
    0.5, 0.018102, -0.426864, 1.542810, -1.438462, 0.609028, -0.123335, 0.009707};

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

Result<BondedLayerContact> BondedLayerContact::create(double modulus_MPa,
                                                      double layer_mm,
                                                      double radius_mm) {
  for (const double given : {modulus_MPa, layer_mm, radius_mm})
    if (!(given > 0 && std::isfinite(given)))
      return Error{en::say("a modulus or a length of {:g} is not one of a layer", given),
                   "",
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
    return Error{en::say("{:g} N press the ball further into the layer than is known", force),
                 "",
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

}  // namespace alltact
