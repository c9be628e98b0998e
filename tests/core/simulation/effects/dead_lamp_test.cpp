#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(DeadLamp, TakesOneLampAway) {
  const auto lamps = [](const std::string& list) {
    return "  - {use: leds, lamps: [" + list + "]}\n";
  };
  const std::string a = "{at_mm: [1, -3, -2], power: 300000}", b = "{at_mm: [9, 4, 0], power: 2e5}";
  for (const int dead : {0, 1}) {
    const cv::Mat_<float> expected = rendered(flat_text(lamps(dead == 0 ? b : a)));
    const cv::Mat_<float> got = rendered(
        flat_text(lamps(a + ", " + b) + fmt::format("  - {{use: dead-lamp, lamp: {}}}\n", dead)));
    EXPECT_EQ(cv::norm(expected, got, cv::NORM_INF), 0);
  }
}

TEST(DeadLamp, FailsAtItsTime) {
  const Plan with = plan_of(flat_text(kFaceAndLamps + "  - {use: dead-lamp, lamp: 1, from: 30}\n"));
  const Plan without = plan_of(flat_text(kFaceAndLamps));
  EXPECT_EQ(cv::norm(with.render(29), without.render(29), cv::NORM_INF), 0);
  EXPECT_GT(cv::norm(with.render(30), without.render(30), cv::NORM_INF), 1);
}

TEST(DeadLamp, MustBeThere) {
  EXPECT_THAT(refusal(flat_text(kFaceAndLamps + "  - {use: dead-lamp, lamp: 2}\n")),
              HasSubstr("there is no lamp 2"));
  EXPECT_THAT(refusal(flat_text("  - {use: dead-lamp, lamp: 0}\n")), HasSubstr("leds too"));
}

}  // namespace
}  // namespace alltact
