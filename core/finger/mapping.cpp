#include "core/finger/mapping.h"

#include "core/numerics/dispatch.h"

#include <array>

namespace alltact {
namespace {

constexpr int kMaxCoefficients = 12;
constexpr double kMaxDepthMm = 1000;
constexpr double kLimitFactor = 4;  // of M(x_max)
constexpr double kMinRoot = 0.5;    // minimum of 1 + b x on the side of the bulge
constexpr int kGrid = 2048;         // number of samples of the slope

struct ValueAndDerivative {
  double value, derivative;
};

/// sum_k c_k T_k(t) and its derivative in t, by Clenshaw's recurrence.
ValueAndDerivative chebyshev_sum(const std::vector<double>& c, double t) {
  double b1 = 0, b2 = 0, d1 = 0, d2 = 0;
  for (std::size_t k = c.size(); k-- > 1;) {
    const double b = c[k] + 2 * t * b1 - b2;
    const double d = 2 * b1 + 2 * t * d1 - d2;
    b2 = b1, b1 = b;
    d2 = d1, d1 = d;
  }
  return {c[0] + t * b1 - b2, b1 + t * d1 - d2};
}

/// Coefficients of sum_k c_k T_k(scale * y + shift) in ascending powers of y.
std::vector<double> ascending_powers(const std::vector<double>& c, double scale, double shift) {
  const std::size_t n = c.size();
  std::vector<double> before(n, 0.0), now(n, 0.0), sum(n, 0.0);
  now[0] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j < n; ++j) sum[j] += c[k] * now[j];
    std::vector<double> next(n, 0.0);
    const double factor = k == 0 ? 1 : 2;  // T_1 = t T_0, T_{k+1} = 2 t T_k - T_{k-1}
    for (std::size_t j = 0; j < n; ++j) {
      next[j] += factor * shift * now[j] - (k == 0 ? 0 : before[j]);
      if (j + 1 < n) next[j + 1] += factor * scale * now[j];
    }
    before = std::move(now);
    now = std::move(next);
  }
  return sum;
}

/// Parameters of the loops, besides the coefficients.
struct Loop {
  double x_min, x_max, start_slope, end_slope, limit;
};

// NaN passes both of these, and each is one instruction.
template <class Number>
[[gnu::always_inline]] inline Number at_least(Number low, std::type_identity_t<Number> x) {
  return low > x ? low : x;
}
template <class Number>
[[gnu::always_inline]] inline Number at_most(Number high, std::type_identity_t<Number> x) {
  return high < x ? high : x;
}

/// Clamps x to the curve's domain.
template <class Number>
[[gnu::always_inline]] inline Number clamped(Number low, std::type_identity_t<Number> high,
                                             std::type_identity_t<Number> x) {
  return at_most(high, at_least(low, x));
}

/// In single precision: t lies within -1 and 1, where the error of the sum is about 1e-7 of its
/// largest coefficient. `powers` holds exactly N values; unrolled, so that only x and the result
/// access memory.
template <int N>
[[gnu::always_inline]] inline void polynomial_loop(const double* powers, Loop loop, const float* x,
                                                   float* depth_mm, int n) {
  float p[N];
  for (int k = 0; k < N; ++k) p[k] = static_cast<float>(powers[k]);
  const auto x_max = static_cast<float>(loop.x_max), limit = static_cast<float>(loop.limit),
             scale = static_cast<float>(2 / loop.x_max),
             start_slope = static_cast<float>(loop.start_slope),
             end_slope = static_cast<float>(loop.end_slope);
#pragma GCC ivdep  // also where x and depth_mm are the same array
  for (int i = 0; i < n; ++i) {
    const float inside = clamped(0.0F, x_max, x[i]);
    const float outside = x[i] - inside;
    const float t = inside * scale - 1.0F;
    float sum = p[N - 1];
    for (int k = N - 2; k >= 0; --k) sum = sum * t + p[k];
    const float slope = outside < 0.0F ? start_slope : end_slope;
    depth_mm[i] = clamped(-limit, limit, inside * sum + slope * outside);
  }
}

ALLTACT_WIDE void polynomial_depths_4(const double* powers, Loop loop, const float* x,
                                      float* depth_mm, int n) {
  polynomial_loop<4>(powers, loop, x, depth_mm, n);
}
ALLTACT_WIDE void polynomial_depths_8(const double* powers, Loop loop, const float* x,
                                      float* depth_mm, int n) {
  polynomial_loop<8>(powers, loop, x, depth_mm, n);
}
ALLTACT_WIDE void polynomial_depths_12(const double* powers, Loop loop, const float* x,
                                       float* depth_mm, int n) {
  polynomial_loop<kMaxCoefficients>(powers, loop, x, depth_mm, n);
}

// Single precision throughout: nothing here cancels but 1 + b x near the pole.
ALLTACT_WIDE void moebius_depths(float a_mm, float b, Loop loop, const float* x, float* depth_mm,
                                 int n) {
  const auto x_min = static_cast<float>(loop.x_min), x_max = static_cast<float>(loop.x_max),
             limit = static_cast<float>(loop.limit),
             start_slope = static_cast<float>(loop.start_slope),
             end_slope = static_cast<float>(loop.end_slope);
#pragma GCC ivdep  // also where x and depth_mm are the same array
  for (int i = 0; i < n; ++i) {
    const float inside = clamped(x_min, x_max, x[i]);
    const float outside = x[i] - inside;
    const float slope = outside < 0.0F ? start_slope : end_slope;
    depth_mm[i] = clamped(-limit, limit, a_mm * inside / (1.0F + b * inside) + slope * outside);
  }
}

std::optional<Error> covariance_problem(const Eigen::MatrixXd& covariance, Eigen::Index expected) {
  if (covariance.size() == 0) return std::nullopt;
  const auto problem = [](Message what) {
    return Error{std::move(what), std::string("mapping.covariance"),
                 en::say("leave it out, or calibrate again")};
  };
  if (covariance.rows() != expected || covariance.cols() != expected)
    return problem(en::say("must be {0} rows of {0} numbers", expected));
  if (!covariance.allFinite() || covariance.cwiseAbs().maxCoeff() > 1e12)
    return problem(en::say("holds values that no covariance has"));
  if ((covariance.diagonal().array() < 0).any()) return problem(en::say("has a negative variance"));
  const double asymmetry = (covariance - covariance.transpose()).cwiseAbs().maxCoeff();
  if (asymmetry > 1e-9 * covariance.cwiseAbs().maxCoeff())
    return problem(en::say("is not symmetric"));
  return std::nullopt;
}

std::optional<Error> variation_problem(const FaceVariation& variation) {
  const bool is_one = variation.part.allFinite() && variation.part.lpNorm<1>() <= 0.5 &&
                      variation.middle_mm.allFinite() && variation.half_mm.allFinite() &&
                      variation.half_mm.minCoeff() > 0;
  if (is_one) return std::nullopt;
  return Error{
      en::say("must hold finite numbers, half_mm above 0, along and across together at most 0.5"),
      std::string("mapping.varies"), en::say("leave it out, or calibrate again")};
}

std::optional<Error> spread_problem(const MappingParameters& parameters) {
  const LightSpread& spread = parameters.spread;
  const bool is_one = spread.optical_thickness >= 0 &&
                      spread.optical_thickness <= LightSpread::kMaxOpticalThickness &&
                      spread.optical_thickness_sd >= 0 && spread.optical_thickness_sd <= 10 &&
                      spread.width_factor >= LightSpread::kMinWidth &&
                      spread.width_factor <= LightSpread::kMaxWidth && spread.b_straight >= 0 &&
                      spread.b_straight <= 1e3 && std::abs(spread.log_b_along) <= 5 &&
                      std::abs(spread.middle_mm) <= 1e6 && spread.half_mm > 0 &&
                      spread.half_mm <= 1e6;
  if (!is_one)
    return Error{
        en::say("must hold an optical_thickness of 0 to {:g} and a width_factor of {:g} to {:g}",
                LightSpread::kMaxOpticalThickness, LightSpread::kMinWidth, LightSpread::kMaxWidth),
        std::string("mapping.spread"), en::say("leave it out, or calibrate again")};
  if (spread.is_local() || (parameters.kind == MappingKind::kMoebius &&
                            parameters.along == MappingAlong::kNormal && parameters.b > -1))
    return std::nullopt;
  return Error{en::say("belongs to a moebius along the normal"), std::string("mapping.spread"),
               en::say("leave it out, or calibrate again")};
}

std::optional<Error> coefficient_problem(const MappingParameters& p) {
  if (p.kind == MappingKind::kMoebius) {
    if (!(p.a_mm > 0 && std::isfinite(p.a_mm)))
      return Error{en::say("must be a positive number"), std::string("mapping.a_mm"),
                   en::say("calibrate again")};
    if (!(p.b > -1 / p.x_max && p.b <= 1e6))
      return Error{en::say("must be greater than {:.6g}, where the curve has its pole, and at "
                           "most 1000000",
                           -1 / p.x_max),
                   std::string("mapping.b"), en::say("calibrate again")};
    return std::nullopt;
  }
  if (p.chebyshev.empty() || p.chebyshev.size() > kMaxCoefficients)
    return Error{en::say("must hold 1 to {} numbers", kMaxCoefficients),
                 std::string("mapping.chebyshev"), en::say("calibrate again")};
  for (double c : p.chebyshev)
    if (!(std::abs(c) <= 1e6))
      return Error{en::say("holds a number that is no coefficient in mm"),
                   std::string("mapping.chebyshev"), en::say("calibrate again")};
  return std::nullopt;
}

}  // namespace

std::string_view to_string(MappingAlong along) {
  constexpr std::array<std::string_view, 3> words{"z", "normal", "projected"};
  return words[static_cast<std::size_t>(along) - 1];
}

Mapping::Mapping(MappingParameters parameters) : parameters_(std::move(parameters)) {
  const double x_max = parameters_.x_max;
  if (parameters_.kind == MappingKind::kPolynomial)
    centred_powers_ = ascending_powers(parameters_.chebyshev, 1, 0);
  if (parameters_.kind == MappingKind::kMoebius)
    x_min_ = parameters_.b > 0 ? std::max(-1.0, (kMinRoot - 1) / parameters_.b) : -1.0;
  start_slope_mm_ = slope_mm(x_min_);
  end_slope_mm_ = slope_mm(x_max);
  end_depth_mm_ = std::numeric_limits<double>::infinity();  // no limit for the next line
  end_depth_mm_ = depth_mm(x_max);
  // Padded to the next loop length, so that the loops need no remainder.
  centred_powers_.resize((centred_powers_.size() + 3) / 4 * 4, 0.0);
}

Result<Mapping> Mapping::create(MappingParameters parameters) {
  if (!(parameters.x_max > 0 && parameters.x_max <= 1))
    return Error{
        en::say("must end above 0 and at 1 or below: it is a relative difference of brightness"),
        std::string("mapping.domain"), en::say("calibrate again")};
  if (auto problem = coefficient_problem(parameters)) return *problem;
  const bool is_moebius = parameters.kind == MappingKind::kMoebius;
  if (auto problem = variation_problem(parameters.variation)) return *problem;
  if (auto problem = spread_problem(parameters)) return *problem;
  const auto unknowns = (is_moebius ? 2 : static_cast<Eigen::Index>(parameters.chebyshev.size())) +
                        (parameters.variation.is_none() ? 0 : 2);
  if (auto problem = covariance_problem(parameters.covariance, unknowns)) return *problem;

  const std::string key = is_moebius ? "mapping.a_mm" : "mapping.chebyshev";
  const Mapping mapping(std::move(parameters));
  // Half of the samples by the cosine, which crowds them at both ends, where a polynomial turns.
  for (int i = 0; i <= kGrid; ++i) {
    const double even = static_cast<double>(i) / kGrid;
    const double crowded = 0.5 - 0.5 * std::cos(even * std::numbers::pi);
    for (double part : {even, crowded}) {
      const double x = part * mapping.x_max();
      const double slope = mapping.slope_mm(x);
      if (!(slope > 0 && std::isfinite(slope)))
        return Error{
            en::say("the curve does not rise at x = {:.4g} (slope {:.4g} mm)", x, slope), key,
            en::say("calibrate with fewer coefficients or as moebius, or with deeper presses")};
    }
  }
  if (!(mapping.end_depth_mm_ > 0 && mapping.end_depth_mm_ <= kMaxDepthMm))
    return Error{en::say("gives a depth of {:.4g} mm at the end of its domain; it must lie "
                         "above 0 and below {:g} mm",
                         mapping.end_depth_mm_, kMaxDepthMm),
                 key, en::say("calibrate again")};
  return mapping;
}

double Mapping::depth_mm(double x) const {
  const double inside = clamped(x_min_, parameters_.x_max, x);
  const double outside = x - inside;
  const double curve =
      parameters_.kind == MappingKind::kMoebius
          ? parameters_.a_mm * inside / (1 + parameters_.b * inside)
          : inside * chebyshev_sum(parameters_.chebyshev, 2 * inside / parameters_.x_max - 1).value;
  const double limit_mm = kLimitFactor * end_depth_mm_;
  return clamped(-limit_mm, limit_mm,
                 curve + (outside < 0 ? start_slope_mm_ : end_slope_mm_) * outside);
}

double Mapping::slope_mm(double x) const {
  const double inside = clamped(x_min_, parameters_.x_max, x);
  if (parameters_.kind == MappingKind::kMoebius) {
    const double root = 1 + parameters_.b * inside;
    return parameters_.a_mm / (root * root);
  }
  const double t = 2 * inside / parameters_.x_max - 1;
  const auto [value, derivative] = chebyshev_sum(parameters_.chebyshev, t);
  return value + (t + 1) * derivative;  // x dt/dx = t + 1
}

double Mapping::depth_sd_mm(double x, const Eigen::Vector2d& position_mm) const {
  const Eigen::MatrixXd& covariance = parameters_.covariance;
  if (covariance.size() == 0) return std::isnan(x) ? x : 0;
  const double x_max = parameters_.x_max;
  const double inside = clamped(x_min_, x_max, x);
  const double excess = x - inside;  // < 0 below x_min
  // Derivative of the depth by each coefficient.
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxCoefficients + 2, 1> gradient(covariance.rows());
  const Eigen::Index numbers = gradient.size() - (parameters_.variation.is_none() ? 0 : 2);
  if (parameters_.kind == MappingKind::kMoebius) {
    const double a = parameters_.a_mm, b = parameters_.b;
    const double root = 1 + b * inside;
    gradient[0] = inside / root + excess / (root * root);
    gradient[1] =
        -a * inside * inside / (root * root) - 2 * a * inside * excess / (root * root * root);
  } else {
    const double t = 2 * inside / x_max - 1;
    double before = t, now = 1;  // T_{-1} = T_1
    for (Eigen::Index k = 0; k < numbers; ++k) {
      // The lines beyond the domain: T_k(1) = 1 and T_k'(1) = k^2, T_k(-1) = (-1)^k.
      const double end = 1 + 2.0 * static_cast<double>(k * k), start = k % 2 == 0 ? 1 : -1;
      gradient[k] = inside * now + excess * (excess < 0 ? start : end);
      const double next = 2 * t * now - before;
      before = now, now = next;
    }
  }
  if (numbers < gradient.size()) {
    gradient.head(numbers) *= parameters_.variation.at(position_mm);
    gradient.tail<2>() = depth_mm(x) * parameters_.variation.within(position_mm);
  }
  double variance = 0;
  for (Eigen::Index i = 0; i < gradient.size(); ++i)
    variance += gradient[i] * covariance.col(i).dot(gradient);
  return std::sqrt(std::max(0.0, variance));
}

double Mapping::difference_at(double depth_mm) const {
  if (std::isnan(depth_mm) || depth_mm == 0) return depth_mm;
  if (depth_mm >= end_depth_mm_) return parameters_.x_max;
  const double x_min_depth_mm = this->depth_mm(x_min_);
  if (depth_mm < x_min_depth_mm)
    return x_min_ +
           (std::max(depth_mm, -kLimitFactor * end_depth_mm_) - x_min_depth_mm) / start_slope_mm_;
  double low = depth_mm < 0 ? x_min_ : 0, high = depth_mm < 0 ? 0 : parameters_.x_max;
  while (true) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return middle;
    (this->depth_mm(middle) < depth_mm ? low : high) = middle;
  }
}

void Mapping::depths_mm(const float* x, float* depth_mm, int n) const {
  const Loop loop{x_min_, parameters_.x_max, start_slope_mm_, end_slope_mm_,
                  kLimitFactor * end_depth_mm_};
  if (parameters_.kind == MappingKind::kMoebius)
    return moebius_depths(static_cast<float>(parameters_.a_mm), static_cast<float>(parameters_.b),
                          loop, x, depth_mm, n);
  switch (centred_powers_.size()) {
    case 4:
      return polynomial_depths_4(centred_powers_.data(), loop, x, depth_mm, n);
    case 8:
      return polynomial_depths_8(centred_powers_.data(), loop, x, depth_mm, n);
    default:
      return polynomial_depths_12(centred_powers_.data(), loop, x, depth_mm, n);
  }
}

std::vector<double> Mapping::powers() const {
  if (parameters_.kind == MappingKind::kMoebius) return {};
  // In powers of x / x_max first, where the coefficients of T_k are integers.
  std::vector<double> powers = ascending_powers(parameters_.chebyshev, 2, -1);
  double scale = 1;
  for (double& p : powers) p *= scale, scale /= parameters_.x_max;
  powers.insert(powers.begin(), 0.0);
  return powers;
}

}  // namespace alltact
