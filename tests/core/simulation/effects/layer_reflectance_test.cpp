#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

/// Kubelka and Munk's differential equation dR/dt = S - 2 (S + K) R + S R^2 from the coat up, by
/// Runge and Kutta's method.
long double reflectance(long double s, long double k, long double coat, long double thickness) {
  constexpr int kSteps = 4000;
  const long double h = thickness / kSteps;
  const auto slope = [&](long double r) { return s - 2 * (s + k) * r + s * r * r; };
  long double r = coat;
  for (int i = 0; i < kSteps; ++i) {
    const long double a = slope(r), b = slope(r + h / 2 * a), c = slope(r + h / 2 * b),
                      d = slope(r + h * c);
    r += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return r;
}

TEST(Layer, ReflectsByItsEquationOverAnyCoat) {
  Parameters random(32);
  for (int i = 0; i < 12; ++i) {
    const double scatter = random.between(0.1, 3), absorb = i % 2 ? random.between(0.01, 1) : 0;
    const double coat = i % 3 ? random.between(0.05, 0.9) : 0;
    std::string text = fmt::format("  - {{use: layer, scatter_per_mm: {}, along: normal", scatter);
    if (absorb > 0) text += fmt::format(", absorb_per_mm: {}", absorb);
    if (coat > 0) text += fmt::format(", coat: {}", coat);
    const float got = rendered(flat_text(text + "}\n"))(90, 160);
    EXPECT_NEAR(got, reflectance(scatter, absorb, coat, 1.5), 3e-6)
        << scatter << ' ' << absorb << ' ' << coat;
  }
}

TEST(Layer, ACoatIsDarkerThanWhiteAndNotNamedWhereItIsBlack) {
  for (const char* coat : {"1", "0", "-0.1"})
    EXPECT_THAT(refusal(flat_text(fmt::format(
                    "  - {{use: layer, scatter_per_mm: 1, along: z, coat: {}}}\n", coat))),
                HasSubstr("coat"))
        << coat;
}

}  // namespace
}  // namespace alltact
