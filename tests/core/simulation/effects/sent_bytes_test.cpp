// Quantisation and what a camera that sends JPEG makes of it.
#include "tests/core/simulation/effects/effect_scene.h"

#include <opencv2/imgcodecs.hpp>

namespace alltact {
namespace {

const std::string kNoisyLight = kFaceAndLamps + "  - {use: read, sd: 60}\n";

TEST(Quantisation, RoundsHalvesUpBetweenBlackAndWhite) {
  Parameters random(38);
  for (int i = 0; i < 30; ++i) {
    const double level =
        i < 20 ? std::floor(random.between(1, 250)) + 0.5 * (i % 2) : random.between(0.5, 254.4);
    const cv::Mat bytes =
        plan_of(flat_text(
                    fmt::format("  - {{use: leak, grey: {}}}\n  - {{use: quantisation}}\n", level)))
            .render(0);
    EXPECT_EQ(bytes.at<std::uint8_t>(3, 5), std::floor(level + 1 + 0.5)) << level;
  }
  const cv::Mat_<float> levels = rendered(flat_text(kNoisyLight));
  const cv::Mat bytes = plan_of(flat_text(kNoisyLight + "  - {use: quantisation}\n")).render(0);
  int dark = 0, bright = 0;
  for_pixels(levels.size(), 1, [&](int v, int u) {
    const double expected = std::clamp(std::floor(double{levels(v, u)} + 0.5), 0.0, 255.0);
    ASSERT_EQ(bytes.at<std::uint8_t>(v, u), expected);
    dark += levels(v, u) < 0;
    bright += levels(v, u) > 255;
  });
  EXPECT_GT(dark, 10);
  EXPECT_GT(bright, 10);
}

// The packet says the quality: the first luminance steps of the JPEG standard's table K.1 (ITU-T
// T.81), scaled as the Independent JPEG Group does.
TEST(Mjpeg, SendsPacketsOfTheQualityAndWhatTheyHold) {
  Parameters random(39);
  for (int i = 0; i < 10; ++i) {
    const int quality = static_cast<int>(random.between(2, 100));
    const Plan plan = plan_of(flat_text(
        kNoisyLight +
        fmt::format("  - {{use: quantisation}}\n  - {{use: mjpeg, quality: {}}}\n", quality)));
    const SentFrame sent = plan.send(0);
    ASSERT_TRUE(sent.jpeg);
    const auto& packet = *sent.jpeg;
    const std::array<std::uint8_t, 4> table{0xFF, 0xDB, 0x00, 0x43};
    const auto found = std::search(packet.begin(), packet.end(), table.begin(), table.end());
    ASSERT_LT(found + 69, packet.end());
    const int scale = quality < 50 ? 5000 / quality : 200 - 2 * quality;
    const int standard[]{16, 11, 12, 14, 12, 10, 16, 14};  // in zigzag order
    for (int k = 0; k < 8; ++k)
      EXPECT_EQ(*(found + 5 + k), std::clamp((standard[k] * scale + 50) / 100, 1, 255)) << quality;
    EXPECT_EQ(cv::norm(cv::imdecode(packet, cv::IMREAD_GRAYSCALE), sent.grey, cv::NORM_INF), 0);
    EXPECT_TRUE(same_bytes(plan.send(0, 3).grey, sent.grey));
  }
}

}  // namespace
}  // namespace alltact
