#include "core/simulation/noise.h"
#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

double normal(int k) {
  float value = 0;
  RowNoise("gain-drift").normals(effect_seed(), k, 0, 1, &value);
  return value;
}

TEST(GainDrift, GoesSoftlyFromOneDrawToTheNext) {
  Parameters random(14);
  for (int i = 0; i < 4; ++i) {
    const double sd = random.between(0.001, 0.1), every = random.between(0.2, 20);
    const Plan plan = plan_of(
        flat_text(fmt::format("  - {{use: gain-drift, sd: {}, every_s: {}}}\n", sd, every)));
    for (const int frame : {0, 3, 100, 4321}) {
      const double at = frame / 30.0 / every, k = std::floor(at), angle = M_PI / 2 * (at - k);
      const double g = normal(static_cast<int>(k)) * std::cos(angle) +
                       normal(static_cast<int>(k) + 1) * std::sin(angle);
      EXPECT_NEAR(plan.render(frame).at<float>(5, 7), 1 + sd * g, 2e-7);
    }
  }
}

TEST(GainDrift, HasVarianceOneAtAnyTime) {
  for (const double part : {0.0, 0.2, 0.5, 0.9}) {
    Moments g;
    float a = 0, b = 0;
    const RowNoise noise("gain-drift");
    const double cos = std::cos(M_PI / 2 * part), sin = std::sin(M_PI / 2 * part);
    // Pairs that share no draw.
    for (int k = 0; k < 250000; ++k)
      for (const std::uint64_t seed : {1, 2, 3, 4}) {
        noise.normals(seed, 2 * k, 0, 1, &a);
        noise.normals(seed, 2 * k + 1, 0, 1, &b);
        g.add(cos * a + sin * b);
      }
    expect_normal(g, 0, 1);
  }
}

}  // namespace
}  // namespace alltact
