#include "core/base/atomic_file.h"
#include "core/image/image_file.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact {
namespace {

using testing::HasSubstr;

/// A dent of a millimetre in noise, none beyond a border.
cv::Mat dent(int width, int height) {
  std::mt19937 random(7);
  std::normal_distribution<float> noise(0, 0.008F);
  cv::Mat depth_mm(height, width, CV_32FC1);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      depth_mm.at<float>(v, u) =
          v < 3 ? std::numeric_limits<float>::quiet_NaN()
                : std::exp(-0.01F * static_cast<float>((u - 20) * (u - 20) + (v - 15) * (v - 15))) +
                      noise(random);
  return depth_mm;
}

TEST(DepthFile, SixteenBitsAreWithinHalfAMicrometre) {
  const test::TemporaryFolder folder;
  const cv::Mat depth_mm = dent(61, 37);
  ASSERT_TRUE(write_file_unsynced(folder / "a.depth16.png", depth_png(depth_mm)).ok());
  const auto read = read_depth_png(folder / "a.depth16.png");
  ASSERT_TRUE(read.ok()) << read.error().sentence();
  for (int v = 0; v < depth_mm.rows; ++v)
    for (int u = 0; u < depth_mm.cols; ++u) {
      const float was = depth_mm.at<float>(v, u), is = read->at<float>(v, u);
      ASSERT_EQ(std::isnan(was), std::isnan(is));
      if (!std::isnan(was)) {
        ASSERT_NEAR(is, was, 0.000501F);
      }
    }
  // Any program reads the same values, and their meaning beside them.
  const cv::Mat steps = cv::imread(folder / "a.depth16.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(steps.type(), CV_16UC1);
  EXPECT_EQ(cv::norm(steps, depth_steps(depth_mm), cv::NORM_INF), 0);
  EXPECT_EQ(steps.at<std::uint16_t>(0, 0), 0);
  EXPECT_THAT(*read_file(folder / "a.depth16.png"), HasSubstr(std::string(kDepthSentence)));
}

TEST(DepthFile, ValuesBeyondSixteenBitsBecomeTheNearest) {
  cv::Mat depth_mm(1, 4, CV_32FC1);
  depth_mm.at<float>(0, 0) = -50;
  depth_mm.at<float>(0, 1) = 100;
  depth_mm.at<float>(0, 2) = std::numeric_limits<float>::infinity();
  depth_mm.at<float>(0, 3) = 0;
  const cv::Mat steps = depth_steps(depth_mm);
  EXPECT_EQ(steps.at<std::uint16_t>(0, 0), 1);
  EXPECT_EQ(steps.at<std::uint16_t>(0, 1), 65535);
  EXPECT_EQ(steps.at<std::uint16_t>(0, 2), 65535);
  EXPECT_EQ(steps.at<std::uint16_t>(0, 3), kDepthZero);
}

TEST(DepthFile, TheTiffIsExactAndSmallerAndNothingOfItMayBeMissing) {
  const test::TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair(61, 37), std::pair(1, 1), std::pair(960, 54)}) {
    const cv::Mat depth_mm = dent(width, height);
    const std::string bytes = depth_tiff(depth_mm);
    ASSERT_TRUE(write_file_unsynced(folder / "a.depth.tiff", bytes).ok());
    for (const cv::Mat& read : {*read_float_image(folder / "a.depth.tiff"),
                                cv::imread(folder / "a.depth.tiff", cv::IMREAD_UNCHANGED)}) {
      ASSERT_EQ(read.type(), CV_32FC1);
      ASSERT_EQ(read.size(), depth_mm.size());
      for (int v = 0; v < height; ++v)
        ASSERT_EQ(std::memcmp(read.ptr(v), depth_mm.ptr(v), 4 * static_cast<std::size_t>(width)),
                  0);
    }
    if (width == 960) {
      EXPECT_LT(bytes.size(), 0.9 * 4 * width * height);  // noise stays
    }
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 30) {
      ASSERT_TRUE(write_file_unsynced(folder / "cut.tiff", bytes.substr(0, size)).ok());
      EXPECT_FALSE(read_float_image(folder / "cut.tiff").ok()) << size;
    }
  }
}

TEST(DepthFile, OtherPicturesAreNotTakenForDepth) {
  const test::TemporaryFolder folder;
  const cv::Mat depth_mm = dent(61, 37);
  const std::string png = depth_png(depth_mm);
  const auto refused = [&](const std::string& content) {
    EXPECT_TRUE(write_file_unsynced(folder / "b.png", content).ok());
    return !read_depth_png(folder / "b.png").ok();
  };
  EXPECT_FALSE(refused(png));
  EXPECT_TRUE(refused(grey_png(depth_steps(depth_mm))));  // says nothing of what it holds
  EXPECT_TRUE(refused(grey_png(cv::Mat(9, 9, CV_8UC1, cv::Scalar(7)))));
  EXPECT_TRUE(refused(depth_tiff(depth_mm)));
  for (std::size_t size = 0; size < png.size(); size += 1 + png.size() / 40)
    EXPECT_TRUE(refused(png.substr(0, size))) << size;
  EXPECT_FALSE(read_depth_png(folder / "none.png").ok());
}

}  // namespace
}  // namespace alltact
