#include "tests/core/simulation/effects/effect_scene.h"

#include <fmt/ranges.h>

namespace alltact {
namespace {

// Any number of lamps anywhere before the face, bare and aimed.
TEST(Leds, LightByPowerCosineAndDistance) {
  Parameters random(32);
  for (int i = 0; i < 8; ++i) {
    struct Lamp {
      Eigen::Vector3d at, aim;
      double power;
      int lobe;  // 0: bare
    };
    std::vector<Lamp> lamps;
    std::vector<std::string> reported;
    const int count = static_cast<int>(random.between(1, 7));
    for (int k = 0; k < count; ++k) {
      const auto somewhere = [&](double low, double high) {
        return Eigen::Vector3d(random.between(-40, 40), random.between(-30, 30),
                               random.between(low, high));
      };
      Lamp lamp{somewhere(-20, 25), somewhere(28, 90), random.between(1e4, 1e6), 0};
      const int kind = static_cast<int>(random.between(0, 5));
      lamp.lobe = kind == 0 ? 0 : 1 << (kind - 1);
      reported.push_back(fmt::format("{{at_mm: [{}, {}, {}], power: {}", lamp.at.x(), lamp.at.y(),
                                     lamp.at.z(), lamp.power) +
                         (kind == 0
                              ? "}"
                              : fmt::format(", aim_mm: [{}, {}, {}], lobe: {}}}", lamp.aim.x(),
                                            lamp.aim.y(), lamp.aim.z(), lamp.lobe)));
      lamps.push_back(lamp);
    }
    const double room = random.between(1, 60);
    const bool lit_room = i % 2 == 0;
    const cv::Mat_<float> got = rendered(
        flat_text(fmt::format("  - {{use: leds, lamps: [{}]}}\n", fmt::join(reported, ", ")) +
                  (lit_room ? fmt::format("  - {{use: ambient, level: {}}}\n", room) : "")));
    for_pixels(got.size(), 11, [&](int v, int u) {
      const Eigen::Vector3d p = flat_point(u, v);
      double expected = lit_room ? room : 0;
      for (const Lamp& lamp : lamps) {
        const Eigen::Vector3d way = lamp.at - p;
        const double r = way.norm(), cosine = std::max(0.0, -way.z() / r);
        const double beside = std::max(0.0, -(lamp.aim - lamp.at).normalized().dot(way) / r);
        expected += lamp.power * cosine / (r * r) * std::pow(beside, lamp.lobe);
      }
      EXPECT_NEAR(got(v, u), expected, 4e-6 * expected + 1e-4) << u << ' ' << v;
    });
  }
}

}  // namespace
}  // namespace alltact
