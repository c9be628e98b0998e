#include "calibration/presses/press_input.h"
#include "core/image/image_file.h"
#include "tests/support/temporary_folder.h"

#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

using testing::HasSubstr;

/// A smooth grey picture with ten bright dots, moved by some pixels, without noise.
cv::Mat scene(const cv::Size& size, double moved_px) {
  cv::Mat image(size, CV_32FC1);
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) {
      double level = 90.0 + 40.0 * u / size.width;
      for (int dot = 0; dot < 10; ++dot) {
        const double r = std::hypot(u - moved_px - (dot + 0.7) * size.width / 10.5,
                                    v - 0.2 * size.height - 0.06 * dot * size.height);
        level += 60.0 / (1.0 + std::exp(2.0 * (r - 5.0)));
      }
      image.at<float>(v, u) = static_cast<float>(level);
    }
  return image;
}

FramePtr frame_of(const cv::Mat& scene, double noise, double light, cv::RNG& random) {
  cv::Mat grain(scene.size(), CV_32FC1);
  random.fill(grain, cv::RNG::NORMAL, 0.0, noise);
  auto frame = std::make_shared<Frame>();
  const cv::Mat seen = light * scene + grain;
  seen.convertTo(frame->grey, CV_8U);
  return frame;
}

double noise_left(const cv::Mat& grey, const cv::Mat& scene) {
  cv::Mat difference;
  cv::subtract(grey, scene, difference, cv::noArray(), CV_32F);
  cv::Scalar mean, sd;
  cv::meanStdDev(difference, mean, sd);
  return sd[0];
}

TEST(HeldFrames, SixteenHoldAQuarterOfTheNoise) {
  for (const cv::Size size : {cv::Size(480, 300), cv::Size(1280, 720)})
    for (const double noise : {1.0, 2.0, 3.0}) {
      cv::RNG random(7);
      const cv::Mat still = scene(size, 0);
      HeldFrames held;
      for (int i = 0; i < 40; ++i) held.add(frame_of(still, noise, 1.0, random));
      const auto alike = held.alike();
      ASSERT_EQ(alike.size(), 16U) << noise;
      const double left = noise_left(mean_frame(alike)->grey, still);
      std::printf("[ figures  ] %d px wide, noise %.0f: %.3f left\n", size.width, noise, left);
      // Both the frames' and the mean's levels are whole numbers.
      const double expected =
          std::hypot(std::hypot(noise, std::sqrt(1.0 / 12)) / 4, std::sqrt(1.0 / 12));
      EXPECT_NEAR(left, expected, 0.03 * expected);
    }
}

TEST(HeldFrames, PartOfAPixelIsAMovementAndFlickerIsNot) {
  for (const auto& [noise, moved_px] : {std::pair(1.0, 0.34), std::pair(3.0, 0.5)}) {
    cv::RNG random(7);
    const cv::Mat before = scene({640, 400}, 0), after = scene({640, 400}, moved_px);
    HeldFrames held;
    for (int i = 0; i < 9; ++i) held.add(frame_of(before, noise, 1.0, random));
    for (int i = 0; i < 5; ++i) held.add(frame_of(after, noise, i % 2 == 0 ? 1.0 : 1.004, random));
    EXPECT_EQ(held.alike().size(), 5U) << noise;
  }
}

TEST(HeldFrames, OfOtherSizesAreNotTheSame) {
  cv::RNG random(7);
  HeldFrames held;
  EXPECT_TRUE(held.alike().empty());
  held.add(frame_of(scene({640, 400}, 0), 1.0, 1.0, random));
  held.add(frame_of(scene({320, 200}, 0), 1.0, 1.0, random));
  EXPECT_EQ(held.alike().size(), 1U);
  held.clear();
  EXPECT_TRUE(held.is_empty());
}

/// A folder of pictures: `still` alike among some that move.
void write_burst(const std::filesystem::path& folder, int still, cv::RNG& random) {
  std::filesystem::create_directory(folder);
  int number = 0;
  const auto write = [&](double moved_px) {
    const FramePtr frame = frame_of(scene({320, 200}, moved_px), 2.0, 1.0, random);
    ASSERT_TRUE(write_image(folder / fmt::format("{:03}.png", number++), frame->grey).ok());
  };
  for (int i = 0; i < 6; ++i) write(-12.0 + 2.0 * i);
  for (int i = 0; i < still; ++i) write(0);
  for (int i = 1; i < 6; ++i) write(2.0 * i);
}

TEST(BurstSource, AveragesWhatIsHeldStill) {
  const test::TemporaryFolder folder;
  cv::RNG random(9);
  write_burst(folder.path() / "press_1", 20, random);
  write_burst(folder.path() / "press.2", 9, random);
  const FramePtr single = frame_of(scene({320, 200}, 3.0), 2.0, 1.0, random);
  ASSERT_TRUE(write_image(folder.path() / "alone.png", single->grey).ok());
  BurstSource source(
      {folder.path() / "press_1", folder.path() / "press.2", folder.path() / "alone.png"});
  const auto first = source.next(), second = source.next(), third = source.next();
  ASSERT_TRUE(first.ok() && second.ok() && third.ok());
  EXPECT_EQ((*first)->name, "press_1");
  EXPECT_EQ((*third)->name, "alone");
  EXPECT_LT(noise_left((*first)->grey, scene({320, 200}, 0)), 0.6);
  EXPECT_LT(noise_left((*second)->grey, scene({320, 200}, 0)), 0.8);
  EXPECT_EQ(cv::norm((*third)->grey, single->grey), 0.0);
  EXPECT_EQ(*source.next(), nullptr);
  EXPECT_THAT(source.remarks().front().english(),
              HasSubstr("press_1: the mean of 20 still frames, of 31"));
}

TEST(BurstSource, AFingerThatNeverHoldsStillIsRefused) {
  const test::TemporaryFolder folder;
  cv::RNG random(9);
  write_burst(folder.path() / "press_1", 0, random);
  BurstSource source({folder.path() / "press_1"});
  const auto frame = source.next();
  ASSERT_FALSE(frame.ok());
  EXPECT_THAT(frame.error().sentence(), HasSubstr("the finger moves"));
  EXPECT_THAT(frame.error().sentence(), HasSubstr("press_1"));
}

/// A film of whatever.
class Film final : public Source {
 public:
  [[nodiscard]] Result<FramePtr> next() override { return FramePtr(); }
  [[nodiscard]] std::optional<std::size_t> count() const override { return 0; }
  [[nodiscard]] bool is_continuous() const override { return true; }
};

TEST(PressInput, PicturesAreEachOfAPressHoweverTheyAreNumbered) {
  PressInput input;
  for (const char* name : {"press_01", "press_02"}) {
    auto frame = std::make_shared<Frame>();
    frame->name = name;
    input.frames.push_back(std::move(frame));
  }
  const auto source = open_presses(input);
  ASSERT_TRUE(source.ok());
  EXPECT_TRUE((*source)->is_continuous()) << "by their numbers they might be a film";
  EXPECT_FALSE(is_one_video(**source));
  EXPECT_TRUE(is_one_video(Film()));
}

}  // namespace
}  // namespace alltact
