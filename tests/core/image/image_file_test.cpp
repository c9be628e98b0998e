#include "core/image/image_file.h"

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

#include <cstring>
#include <fstream>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;

cv::Mat noise(int type, double high, int width = 61, int height = 37) {
  cv::Mat image(height, width, type);
  cv::randu(image, cv::Scalar::all(0), cv::Scalar::all(high));
  return image;
}

std::string encoded(const std::string& ending, const cv::Mat& image,
                    const std::vector<int>& options = {}) {
  std::vector<unsigned char> bytes;
  EXPECT_TRUE(cv::imencode(ending, image, bytes, options));
  return {bytes.begin(), bytes.end()};
}

bool is_same(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return false;
  for (int row = 0; row < a.rows; ++row)
    if (std::memcmp(a.ptr(row), b.ptr(row), a.cols * a.elemSize()) != 0) return false;
  return true;
}

/// Check sum of a chunk's type and data (PNG, third edition, annex D).
std::uint32_t png_check_sum(std::string_view type_and_data) {
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char c : type_and_data) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1U ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0);
  }
  return ~sum;
}

class Picture : public testing::Test {
 protected:
  Result<cv::Mat> read(const std::string& content) {
    write(folder_ / "p", content);
    return read_grey_image(folder_ / "p");
  }
  /// Without the fsync of the real thing, which would take most of the tests' time.
  static void write(const fs::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
  }
  std::string refusal(const std::string& content) {
    const auto image = read(content);
    if (image.ok()) return "accepted";
    EXPECT_EQ(image.error().where.english(), (folder_ / "p").string());
    return image.error().what.english();
  }
  TemporaryFolder folder_;
};

TEST_F(Picture, LosslessFormatsComeBackExactly) {
  const cv::Mat grey = noise(CV_8UC1, 256);
  for (const char* ending : {".png", ".bmp", ".pgm", ".tiff"}) {
    const auto image = read(encoded(ending, grey));
    ASSERT_TRUE(image.ok()) << ending;
    EXPECT_TRUE(is_same(*image, grey)) << ending;
  }
  // Grey kept in three channels is the same grey.
  cv::Mat three;
  cv::cvtColor(grey, three, cv::COLOR_GRAY2BGR);
  for (const char* ending : {".png", ".bmp", ".ppm", ".tiff"})
    EXPECT_TRUE(is_same(*read(encoded(ending, three)), grey)) << ending;
  const auto jpeg = read(encoded(".jpg", cv::Mat(37, 61, CV_8UC1, cv::Scalar(90))));
  ASSERT_TRUE(jpeg.ok());
  EXPECT_LE(cv::norm(*jpeg, cv::Mat(37, 61, CV_8UC1, cv::Scalar(90)), cv::NORM_INF), 1);
}

TEST_F(Picture, EveryTruncationIsRefused) {
  cv::Mat grey = noise(CV_8UC1, 256, 40, 30);
  cv::GaussianBlur(grey, grey, {0, 0}, 2);
  for (const auto& [ending, options] : {std::pair<std::string, std::vector<int>>{".png", {}},
                                        {".jpg", {}},
                                        {".jpg", {cv::IMWRITE_JPEG_PROGRESSIVE, 1}},
                                        {".jpg", {cv::IMWRITE_JPEG_RST_INTERVAL, 2}},
                                        {".bmp", {}},
                                        {".pgm", {}},
                                        {".tiff", {cv::IMWRITE_TIFF_COMPRESSION, 1}},
                                        {".tiff", {cv::IMWRITE_TIFF_COMPRESSION, 5}}}) {
    const std::string whole = encoded(ending, grey, options);
    ASSERT_EQ(refusal(whole), "accepted") << ending;
    for (std::size_t size = 0; size < whole.size(); ++size) {
      ASSERT_NE(refusal(whole.substr(0, size)), "accepted") << ending << ' ' << size;
    }
  }
}

TEST_F(Picture, AnyFlippedBitOfAPngIsRefusedWithoutAWordFromTheDecoder) {
  const std::string whole = encoded(".png", noise(CV_8UC1, 256, 24, 20));
  testing::internal::CaptureStderr();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    EXPECT_NE(refusal(damaged), "accepted") << at;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(Picture, DamageNeverCrashes) {
  std::mt19937 random(9);
  const cv::Mat grey = noise(CV_8UC1, 256, 24, 20);
  for (const char* ending : {".png", ".jpg", ".bmp", ".pgm", ".tiff"}) {
    const std::string whole = encoded(ending, grey);
    for (int i = 0; i < 40; ++i) {
      std::string damaged = whole;
      for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = static_cast<char>(random());
      const auto image = read(damaged);
      if (image.ok()) {
        EXPECT_EQ(image->type(), CV_8UC1);
      }
    }
  }
}

TEST_F(Picture, SlightTintIsGreyAndStrongColourIsRefused) {
  cv::Mat grey = noise(CV_8UC1, 100) + 60, three;
  cv::cvtColor(grey, three, cv::COLOR_GRAY2BGR);
  const cv::Mat tinted = three + cv::Scalar(0, 2, 9);
  const auto image = read(encoded(".png", tinted));
  ASSERT_TRUE(image.ok());
  EXPECT_LE(cv::norm(*image, grey, cv::NORM_INF), 5);
  EXPECT_THAT(refusal(encoded(".png", three + cv::Scalar(0, 0, 70))), HasSubstr("in colour"));
  EXPECT_THAT(refusal(encoded(".png", noise(CV_8UC3, 256))), HasSubstr("in colour"));
}

TEST_F(Picture, OtherKindsOfPixelsAreRefused) {
  EXPECT_THAT(refusal(encoded(".tiff", noise(CV_32FC1, 1))), HasSubstr("floating point"));
  EXPECT_THAT(refusal(encoded(".png", noise(CV_8UC4, 256))), HasSubstr("transparent"));
  EXPECT_THAT(refusal(encoded(".tiff", noise(CV_8UC4, 256))), HasSubstr("4 channels"));
  EXPECT_THAT(refusal(encoded(".png", cv::Mat(20, 20, CV_8UC1, cv::Scalar(4)))),
              HasSubstr("all black"));
  EXPECT_EQ(refusal(encoded(".png", cv::Mat(20, 20, CV_8UC1, cv::Scalar(5)))), "accepted");
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
  EXPECT_THAT(refusal("just some words, no picture"), HasSubstr("not an image"));
  EXPECT_THAT(read_grey_image(folder_ / "none.png").error().sentence(), HasSubstr("none.png"));
  EXPECT_FALSE(read_grey_image(folder_.path()).ok());
}

TEST_F(Picture, SizesAreCheckedBeforeAnythingIsAllocated) {
  std::string png = encoded(".png", noise(CV_8UC1, 256));
  png[16] = png[20] = 0x7F;  // first bytes of width and height
  const std::uint32_t sum = png_check_sum(std::string_view(png).substr(12, 17));
  for (unsigned i = 0; i < 4; ++i) png[29 + i] = static_cast<char>(sum >> (24 - 8 * i));
  EXPECT_THAT(refusal(png), HasSubstr("a side must have"));
  EXPECT_NE(refusal("P5 100000 100000 255\nxxxxxxxxxxxxxxxxxxxxxxxxxx"), "accepted");
  EXPECT_NE(refusal("P5 0 10 255\n"), "accepted");
  std::string jpeg = encoded(".jpg", noise(CV_8UC1, 256));
  const std::size_t frame = jpeg.find("\xFF\xC0");
  ASSERT_NE(frame, std::string::npos);
  jpeg[frame + 5] = jpeg[frame + 7] = '\x7F';
  EXPECT_THAT(refusal(jpeg), HasSubstr("a side must have"));
}

TEST_F(Picture, RealPicturesOfAKindredSensorAreAccepted) {
  const fs::path data = fs::path(ALLTACT_SOURCE_DIR) / "../shared/data/dtact_sensor_1";
  if (!fs::exists(data)) GTEST_SKIP() << "no folder " << data;
  for (const auto& entry : fs::directory_iterator(data))
    if (entry.path().extension() == ".png") {
      const auto image = read_grey_image(entry.path());
      ASSERT_TRUE(image.ok()) << image.error().sentence();
      EXPECT_EQ(image->type(), CV_8UC1);
      EXPECT_GT(image->cols, 400);
    }
}

TEST_F(Picture, WritesWhatItReads) {
  const cv::Mat grey = noise(CV_8UC1, 256);
  ASSERT_TRUE(write_image(folder_ / "a.png", grey).ok());
  EXPECT_TRUE(is_same(*read_grey_image(folder_ / "a.png"), grey));
  for (int type : {CV_32FC1, CV_32FC3}) {
    cv::Mat depth = noise(type, 3);
    depth.ptr<float>(2)[5] = std::nanf("");
    ASSERT_TRUE(write_image(folder_ / "a.tiff", depth).ok());
    const std::string bytes = *read_file(folder_ / "a.tiff");
    EXPECT_TRUE(is_same(*read_float_image(folder_ / "a.tiff"), depth));
    EXPECT_TRUE(is_same(cv::imread(folder_ / "a.tiff", cv::IMREAD_UNCHANGED), depth));
    ASSERT_TRUE(write_image(folder_ / "b.tiff", depth).ok());
    EXPECT_EQ(*read_file(folder_ / "b.tiff"), bytes);  // no dates, no names
    // No compression: the values stand in the file as they are.
    EXPECT_GE(bytes.size(), depth.total() * depth.elemSize());
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 30) {
      write(folder_ / "cut.tiff", bytes.substr(0, size));
      ASSERT_FALSE(read_float_image(folder_ / "cut.tiff").ok()) << size;
    }
  }
  EXPECT_FALSE(read_float_image(folder_ / "a.png").ok());
}

TEST_F(Picture, WordsTravelInsideAPng) {
  const cv::Mat grey = noise(CV_8UC1, 256);
  const auto note_in = [&](const fs::path& file) {
    std::string note = "untouched";
    EXPECT_TRUE(is_same(*read_grey_image(file, &note), grey));
    return note;
  };
  ASSERT_TRUE(write_image(folder_ / "a.png", grey).ok());
  EXPECT_EQ(note_in(folder_ / "a.png"), "");
  ASSERT_TRUE(write_image(folder_ / "a.png", grey, "Gain=3").ok());
  EXPECT_EQ(note_in(folder_ / "a.png"), "Gain=3");
  EXPECT_TRUE(is_same(cv::imread(folder_ / "a.png", cv::IMREAD_UNCHANGED), grey));
  // Length, type, data and the check sum that zlib's crc32() gives.
  const std::string bytes = *read_file(folder_ / "a.png");
  using std::string_literals::operator""s;
  EXPECT_EQ(bytes.substr(33, 39),
            "\0\0\0\x1B"
            "iTXtAllTact settings\0\0\0\0\0Gain=3\xBA\xEE\x5D\x4D"s);
  for (std::size_t size = 0; size < 72; ++size) EXPECT_EQ(note_of(bytes.substr(0, size)), "");
  EXPECT_EQ(note_of(bytes.substr(0, 72)), "Gain=3");
  EXPECT_EQ(note_of(encoded(".jpg", grey)), "");
}

TEST_F(Picture, RefusesToWriteWhatTheEndingCannotHold) {
  EXPECT_FALSE(write_image(folder_ / "a.png", noise(CV_32FC1, 1)).ok());
  EXPECT_FALSE(write_image(folder_ / "a.tiff", noise(CV_8UC1, 256)).ok());
  EXPECT_FALSE(write_image(folder_ / "a.xyz", noise(CV_8UC1, 256)).ok());
  EXPECT_FALSE(write_image(folder_ / "a.png", cv::Mat()).ok());
  EXPECT_FALSE(fs::exists(folder_ / "a.png"));
}

}  // namespace
}  // namespace alltact
