#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

// The mean over the exposure, summed up in small steps.
template <class Power>
double mean_about(double t, double exposure, const Power& power) {
  constexpr int kSteps = 200000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += power(t + exposure * ((i + 0.5) / kSteps - 0.5));
  return sum / kSteps;
}

TEST(Flicker, OfTheMainsIsItsMeanOverTheExposure) {
  Parameters random(9);
  for (int i = 0; i < 5; ++i) {
    const double hz = random.between(50, 130), exposure_ms = random.between(0.5, 12),
                 depth = random.between(0.05, 0.9), rate = random.between(20, 60);
    const std::string effect =
        fmt::format("  - {{use: flicker, kind: mains, hz: {}, exposure_ms: {}, depth: {}}}\n", hz,
                    exposure_ms, depth);
    for (const int frame : {0, 1, 7, 40}) {
      const double expected = mean_about(frame / rate, exposure_ms / 1000, [&](double t) {
        return 1 + depth * std::cos(2 * M_PI * hz * t);
      });
      EXPECT_NEAR(share_in(effect, frame, rate), expected, 1e-6);
    }
  }
}

TEST(Flicker, OfSwitchedLampsIsTheTimeThatTheyAreOn) {
  Parameters random(10);
  for (int i = 0; i < 5; ++i) {
    const double hz = random.between(90, 900), exposure_ms = random.between(0.5, 12),
                 duty = random.between(0.1, 0.9), rate = random.between(20, 60);
    const std::string effect =
        fmt::format("  - {{use: flicker, kind: pwm, hz: {}, exposure_ms: {}, duty: {}}}\n", hz,
                    exposure_ms, duty);
    for (const int frame : {0, 1, 7, 40}) {
      const double expected = mean_about(frame / rate, exposure_ms / 1000, [&](double t) {
        const double part = t * hz - std::floor(t * hz);
        return part < duty ? 1 / duty : 0.0;
      });
      EXPECT_NEAR(share_in(effect, frame, rate), expected, 2e-4);
    }
  }
}

TEST(Flicker, LeavesRoomLightAndNeedsLamps) {
  const std::string dark =
      "  - {use: flicker, kind: mains, hz: 100, exposure_ms: 0.001, depth: 1}\n";
  const std::string room = kFaceAndLamps + "  - {use: ambient, level: 30}\n";
  const cv::Mat_<float> lit = rendered("frames_per_s: 200\n" + flat_text(room + dark), 1);
  EXPECT_NEAR(lit(90, 160), 30 * 0.9 / 1.9, 1e-3);  // half a period after the top
  EXPECT_THAT(refusal(flat_text(dark)), HasSubstr("leds too"));
}

}  // namespace
}  // namespace alltact
