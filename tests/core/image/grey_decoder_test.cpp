#include "core/image/grey_decoder.h"

#include "tests/core/recording/recording_frames.h"

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
  truth.at<std::uint8_t>(0, 0) = 255;  // uses all 16 bits
  struct Case {
    PixelFormat format;
    int bytes, offset;
    bool is_planar = false;
  };
  for (const Case& c : {Case{PixelFormat::kGrey, 1, 0}, Case{PixelFormat::kYuyv, 2, 0},
                        Case{PixelFormat::kYvyu, 2, 0}, Case{PixelFormat::kUyvy, 2, 1},
                        Case{PixelFormat::kVyuy, 2, 1}, Case{PixelFormat::kY16, 2, 1},
                        Case{PixelFormat::kNv12, 1, 0, true}, Case{PixelFormat::kYu12, 1, 0, true}})
    for (const std::size_t padding : {0U, 7U}) {
      const std::size_t stride = kWidth * static_cast<std::size_t>(c.bytes) + padding;
      std::vector<std::uint8_t> bytes(stride * kHeight - (c.is_planar ? 0 : padding), 0xEE);
      for (int v = 0; v < kHeight; ++v)
        for (int u = 0; u < kWidth; ++u)
          bytes[stride * static_cast<std::size_t>(v) +
                static_cast<std::size_t>(c.bytes * u + c.offset)] = truth.at<std::uint8_t>(v, u);
      if (c.is_planar) bytes.resize(bytes.size() + stride * kHeight / 2, 0x80);
      const auto grey = decode(c.format, bytes, stride);
      ASSERT_TRUE(grey.ok());
      EXPECT_EQ(cv::norm(*grey, truth, cv::NORM_INF), 0) << fourcc_text(std::uint32_t(c.format));
      bytes.pop_back();
      EXPECT_FALSE(decode(c.format, bytes, stride).ok()) << "one byte is missing";
    }
}

TEST(GreyDecoder, ColoursGiveTheGreyThatOpenCvGives) {
  const cv::Mat image = smooth_colours();
  cv::Mat truth, four;
  cv::cvtColor(image, truth, cv::COLOR_BGR2GRAY);
  cv::cvtColor(image, four, cv::COLOR_BGR2BGRA);
  const std::vector<std::uint8_t> three(image.datastart, image.dataend),
      with_gap(four.datastart, four.dataend);
  EXPECT_EQ(cv::norm(*decode(PixelFormat::kBgr24, three), truth, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(*decode(PixelFormat::kBgrx32, with_gap), truth, cv::NORM_INF), 0);
  cv::cvtColor(image, truth, cv::COLOR_RGB2GRAY);
  EXPECT_EQ(cv::norm(*decode(PixelFormat::kRgb24, three), truth, cv::NORM_INF), 0);
}

/// Each pixel its column times `step`, 16 bits, low byte first.
std::vector<std::uint8_t> ramp(int step) {
  std::vector<std::uint8_t> bytes;
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) {
      bytes.push_back(static_cast<std::uint8_t>(u * step));
      bytes.push_back(static_cast<std::uint8_t>(u * step >> 8));
    }
  return bytes;
}

TEST(GreyDecoder, OfSixteenBitsAsManyCountAsTheBrightestPixelNeeds) {
  struct Case {
    PixelFormat format;
    int step, shift;
  };
  for (const Case& c : {Case{PixelFormat::kY16, 10, 2}, Case{PixelFormat::kY16, 42, 4},
                        Case{PixelFormat::kY16, 600, 8}, Case{PixelFormat::kY10, 10, 2},
                        Case{PixelFormat::kY12, 10, 4}, Case{PixelFormat::kY14, 10, 6}}) {
    GreyDecoder decoder;
    const auto grey = decoder(c.format, kWidth, kHeight, 0, ramp(c.step));
    ASSERT_TRUE(grey.ok());
    for (int u = 0; u < kWidth; ++u)
      EXPECT_EQ(grey->at<std::uint8_t>(3, u), u * c.step >> c.shift) << c.step << ' ' << u;
    const bool is_assumed = c.format == PixelFormat::kY16 && c.shift < 8;
    ASSERT_EQ(decoder.remarks().size(), is_assumed ? 1U : 0U);
    if (is_assumed) {
      EXPECT_THAT(decoder.remarks().front().english(),
                  testing::HasSubstr(fmt::format("only the lower {}", c.shift + 8)));
    }
  }
  // A darker image of the same camera has the same levels.
  GreyDecoder decoder;
  static_cast<void>(decoder(PixelFormat::kY16, kWidth, kHeight, 0, ramp(42)));
  EXPECT_EQ(decoder(PixelFormat::kY16, kWidth, kHeight, 0, ramp(10))->at<std::uint8_t>(3, 80),
            800 >> 4);
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

TEST(GreyDecoder, ZerosBeforeRestartMarksCostNoPixel) {
  const cv::Mat image = smooth_colours();
  std::vector<std::uint8_t> clean, stray;
  cv::imencode(".jpg", image, clean,
               {cv::IMWRITE_JPEG_QUALITY, 90, cv::IMWRITE_JPEG_RST_INTERVAL, 2});
  stray = test::with_stray_zeros(clean);
  const std::size_t marks = (stray.size() - clean.size()) / 2;
  ASSERT_GT(marks, 5U);
  GreyDecoder decoder;
  const auto grey = decoder(PixelFormat::kMjpeg, kWidth, kHeight, 0, stray);
  ASSERT_TRUE(grey.ok()) << grey.error().sentence();
  EXPECT_EQ(cv::norm(*grey, *decode(PixelFormat::kMjpeg, clean), cv::NORM_INF), 0);
  ASSERT_EQ(decoder.remarks().size(), 1U);
  EXPECT_THAT(decoder.remarks().front().english(), testing::HasSubstr("stray bytes"));
  // A changed byte between the marks is damage, as far as the code shows it.
  int seen = 0, changed = 0;
  for (std::size_t i = clean.size() / 2; i + 20 < clean.size(); i += 7) {
    auto broken = clean;
    broken[i] ^= 0x55;
    const auto other = decode(PixelFormat::kMjpeg, broken);
    ++changed;
    seen += other.ok() ? 0 : 1;
  }
  EXPECT_GT(seen, changed / 3);
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
