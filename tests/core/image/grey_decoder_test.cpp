#include "core/image/grey_decoder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kWidth = 96, kHeight = 64;

cv::Mat smooth_colours() {
  cv::Mat image(kHeight, kWidth, CV_8UC3);
  cv::randu(image, 0, 256);
  cv::GaussianBlur(image, image, {0, 0}, 5);
  return image;
}

std::vector<std::uint8_t> jpeg_of(const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, 90});
  return bytes;
}

Result<cv::Mat> decode(PixelFormat format, const std::vector<std::uint8_t>& bytes,
                       std::size_t stride = 0) {
  GreyDecoder decoder;
  return decoder(format, kWidth, kHeight, stride, bytes);
}

TEST(GreyDecoder, RawFormatsGiveTheirBrightnessWithPaddedRowsToo) {
  cv::Mat truth(kHeight, kWidth, CV_8UC1);
  cv::randu(truth, 0, 256);
  struct Case {
    PixelFormat format;
    int bytes, offset;
  };
  for (const Case& c : {Case{PixelFormat::kGrey, 1, 0}, Case{PixelFormat::kYuyv, 2, 0},
                        Case{PixelFormat::kY16, 2, 1}})
    for (const std::size_t padding : {0U, 7U}) {
      const std::size_t stride = kWidth * static_cast<std::size_t>(c.bytes) + padding;
      std::vector<std::uint8_t> bytes(stride * kHeight - padding, 0xEE);
      for (int v = 0; v < kHeight; ++v)
        for (int u = 0; u < kWidth; ++u)
          bytes[stride * static_cast<std::size_t>(v) +
                static_cast<std::size_t>(c.bytes * u + c.offset)] = truth.at<std::uint8_t>(v, u);
      const auto grey = decode(c.format, bytes, stride);
      ASSERT_TRUE(grey.ok());
      EXPECT_EQ(cv::norm(*grey, truth, cv::NORM_INF), 0) << fourcc_text(std::uint32_t(c.format));
      bytes.pop_back();
      EXPECT_FALSE(decode(c.format, bytes, stride).ok()) << "one byte is missing";
    }
}

TEST(GreyDecoder, AColourJpegGivesTheGreyThatOpenCvGives) {
  const auto bytes = jpeg_of(smooth_colours());
  const auto grey = decode(PixelFormat::kMjpeg, bytes);
  ASSERT_TRUE(grey.ok());
  const cv::Mat theirs = cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
  EXPECT_EQ(cv::norm(*grey, theirs, cv::NORM_INF), 0);
}

TEST(GreyDecoder, StrayBytesBehindAWholeJpegAreNoFault) {
  const cv::Mat image = smooth_colours();
  auto bytes = jpeg_of(image);
  const cv::Mat whole = *decode(PixelFormat::kMjpeg, bytes);
  bytes.insert(bytes.end(), 100, 0);  // a padded buffer
  ASSERT_TRUE(decode(PixelFormat::kMjpeg, bytes).ok());
  bytes.resize(bytes.size() - 100);
  bytes.insert(bytes.end() - 2, 3, 0x55);  // before the end mark, as some cameras do
  const auto stray = decode(PixelFormat::kMjpeg, bytes);
  ASSERT_TRUE(stray.ok());
  EXPECT_EQ(cv::norm(*stray, whole, cv::NORM_INF), 0);
}

TEST(GreyDecoder, NoTruncatedJpegIsEverTakenForAPicture) {
  const auto bytes = jpeg_of(smooth_colours());
  // Up to its last entropy-coded byte: the end mark's own two bytes hold no picture.
  for (std::size_t size = 0; size + 3 < bytes.size(); ++size) {
    const std::vector<std::uint8_t> begin(bytes.begin(),
                                          bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(decode(PixelFormat::kMjpeg, begin).ok()) << size << " of " << bytes.size();
  }
}

TEST(GreyDecoder, ADamagedJpegDoesNotSpoilTheNext) {
  const auto bytes = jpeg_of(smooth_colours());
  GreyDecoder decoder;
  const cv::Mat whole = *decoder(PixelFormat::kMjpeg, kWidth, kHeight, 0, bytes);
  for (std::size_t size = 0; size < bytes.size(); size += 50) {
    static_cast<void>(
        decoder(PixelFormat::kMjpeg, kWidth, kHeight, 0, std::span(bytes).first(size)));
    const auto next = decoder(PixelFormat::kMjpeg, kWidth, kHeight, 0, bytes);
    ASSERT_TRUE(next.ok()) << size;
    EXPECT_EQ(cv::norm(*next, whole, cv::NORM_INF), 0);
  }
}

TEST(GreyDecoder, DamageThatTheCodeShowsIsAFault) {
  const auto bytes = jpeg_of(smooth_colours());
  auto broken = bytes;
  broken.erase(broken.end() - 200, broken.end() - 100);
  EXPECT_FALSE(decode(PixelFormat::kMjpeg, broken).ok());
  EXPECT_FALSE(decode(PixelFormat::kMjpeg, std::vector<std::uint8_t>(500, 0x11)).ok());
  cv::Mat small;
  cv::resize(smooth_colours(), small, {}, 0.5, 0.5);
  const auto other_size = decode(PixelFormat::kMjpeg, jpeg_of(small));
  ASSERT_FALSE(other_size.ok());
  EXPECT_THAT(other_size.error().what.english(), testing::HasSubstr("48x32"));
}

}  // namespace
}  // namespace alltact
