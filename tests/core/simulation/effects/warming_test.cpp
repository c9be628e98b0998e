#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Warming, LosesPowerExponentially) {
  Parameters random(11);
  for (int i = 0; i < 5; ++i) {
    const double loss = random.between(0.01, 0.9), after_s = random.between(0.1, 100);
    const std::string effect =
        fmt::format("  - {{use: warming, loss: {}, after_s: {}}}\n", loss, after_s);
    for (const int frame : {0, 3, 100, 5000}) {
      const double t = frame / 30.0;
      EXPECT_NEAR(share_in(effect, frame, 30), 1 - loss * (1 - std::exp(-t / after_s)), 1e-6);
    }
  }
}

}  // namespace
}  // namespace alltact
