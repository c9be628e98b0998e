#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

// Kubelka and Munk's reflectance over black.
long double reflectance(long double scatter, long double absorb, long double thickness) {
  if (absorb == 0) return scatter * thickness / (1 + scatter * thickness);
  const long double a = (scatter + absorb) / scatter, b = std::sqrt(a * a - 1);
  const long double x = b * scatter * thickness;
  return std::sinh(x) / (a * std::sinh(x) + b * std::cosh(x));
}

TEST(Layer, ReflectsByKubelkaAndMunkAtAnyIncline) {
  Parameters random(31);
  for (int i = 0; i < 12; ++i) {
    const double incline = random.between(5, 50), scatter = random.between(0.05, 5);
    const double thickness = random.between(0.3, 4);
    const double absorb = i % 3 == 0 ? 0 : scatter * random.between(0.001, 2);
    const bool along_z = i % 2 == 0;
    std::string text = scene_text(fmt::format(
        "  - {{use: layer, scatter_per_mm: {}, along: {}{}}}\n", scatter, along_z ? "z" : "normal",
        absorb > 0 ? fmt::format(", absorb_per_mm: {}", absorb) : std::string()));
    text.replace(text.find("layer_mm: 1.5"), 13, fmt::format("layer_mm: {}", thickness));
    text.replace(text.find("incline_deg: 34.0"), 17, fmt::format("incline_deg: {}", incline));
    const Plan plan = plan_of(text);
    const cv::Mat_<float> got = plan.render(0);
    const double cos = std::cos(incline * M_PI / 180);
    const auto expected =
        static_cast<double>(reflectance(scatter, absorb, along_z ? thickness / cos : thickness));
    const cv::Mat on_face = got > 0.9F * static_cast<float>(expected);
    EXPECT_GT(cv::countNonZero(on_face), 2000);
    for (int v = 80; v < 100; v += 5)
      for (int u = 60; u < 180; u += 7) EXPECT_NEAR(got(v, u) / expected, 1, 2e-6) << u << ' ' << v;
  }
}

}  // namespace
}  // namespace alltact
