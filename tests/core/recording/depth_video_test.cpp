// Depth of a recording in one file, held against what ffmpeg reads there.
#include "core/recording/depth_video.h"

#include "core/base/atomic_file.h"
#include "core/image/image_file.h"
#include "tests/support/program.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

/// A noisy ramp that no two pictures share, none beyond a border, and both ends of what fits.
cv::Mat ramp(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(0, 0.01F);
  cv::Mat depth_mm(height, width, CV_32FC1);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      depth_mm.at<float>(v, u) = u < 2 ? std::numeric_limits<float>::quiet_NaN()
                                       : 0.02F * static_cast<float>(u + v) + noise(random);
  depth_mm.at<float>(height - 1, width - 1) = 1000;
  depth_mm.at<float>(height - 1, width - 2) = -1000;
  return depth_mm;
}

struct DepthVideoOfFive : testing::Test {
  TemporaryFolder folder;
  const cv::Size size{97, 54};
  std::vector<cv::Mat> images;
  std::filesystem::path file = folder / "depth.mkv";

  DepthVideoOfFive() {
    for (unsigned i = 0; i < 5; ++i) images.push_back(ramp(size.width, size.height, i));
  }
  /// Each picture by another of so many makers.
  void write(const std::filesystem::path& to, std::size_t makers, std::size_t first = 0) {
    std::vector<DepthPackets> packets;
    for (std::size_t i = 0; i < makers; ++i) packets.push_back(DepthPackets::create(size).value());
    auto writer = DepthVideoWriter::create(to, size, 25);
    ASSERT_TRUE(writer.ok()) << writer.error().sentence();
    for (std::size_t i = first; i < images.size(); ++i)
      ASSERT_TRUE(writer->add(packets[i % makers].packet(depth_steps(images[i])).value()).ok());
    ASSERT_TRUE(writer->finish().ok());
  }
};

TEST_F(DepthVideoOfFive, AnotherProgramReadsTheSameValuesAndWhatTheyMean) {
  write(file, 1);
  const std::string raw = (folder / "raw").string();
  const ProgramRun decode = run_shell("ffmpeg -v error -nostdin -y -i " + file.string() +
                                      " -pix_fmt gray16le -f rawvideo " + raw);
  if (decode.status == 127) GTEST_SKIP() << "ffmpeg is not here";
  ASSERT_EQ(decode.status, 0) << decode.errors;
  std::string expected;
  for (const cv::Mat& depth_mm : images) {
    const cv::Mat steps = depth_steps(depth_mm);
    expected.append(reinterpret_cast<const char*>(steps.data), 2 * steps.total());
  }
  EXPECT_EQ(text_of(raw), expected);
  const ProgramRun tags = run_shell("ffprobe -v error -show_format -show_streams " + file.string());
  EXPECT_THAT(tags.output, HasSubstr("TAG:ALLTACT_DEPTH=" + std::string(kDepthSentence)));
  EXPECT_THAT(tags.output, HasSubstr("avg_frame_rate=25/1"));
  EXPECT_THAT(tags.output, HasSubstr("pix_fmt=gray16le"));
}

TEST_F(DepthVideoOfFive, IsReadBackWithinHalfAMicrometre) {
  write(file, 1);
  auto video = DepthVideo::open(file);
  ASSERT_TRUE(video.ok()) << video.error().sentence();
  EXPECT_EQ(video->size(), size);
  EXPECT_NEAR(video->frames_per_s(), 25, 0.01);
  for (const cv::Mat& was : images) {
    const auto is = video->next_mm();
    ASSERT_TRUE(is.ok()) << is.error().sentence();
    ASSERT_EQ(is->size(), size);
    for (int v = 0; v < size.height - 1; ++v)
      for (int u = 0; u < size.width; ++u) {
        ASSERT_EQ(std::isnan(was.at<float>(v, u)), std::isnan(is->at<float>(v, u)));
        if (u >= 2) {
          ASSERT_NEAR(is->at<float>(v, u), was.at<float>(v, u), 0.000501F);
        }
      }
  }
  EXPECT_TRUE(video->next_mm().value().empty());
}

TEST_F(DepthVideoOfFive, IsTheSameByAnyNumberOfMakersAndJoined) {
  write(file, 1);
  write(folder / "three.mkv", 3);
  EXPECT_EQ(text_of(folder / "three.mkv"), text_of(file));
  write(folder / "last.mkv", 2, 2);
  auto writer = DepthVideoWriter::create(folder / "joined.mkv", size, 25);
  auto whole = DepthVideo::open(file), last = DepthVideo::open(folder / "last.mkv");
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(writer->add(whole->next_packet().value()).ok());
  for (auto packet = last->next_packet(); packet && !packet->empty(); packet = last->next_packet())
    ASSERT_TRUE(writer->add(*packet).ok());
  ASSERT_TRUE(writer->finish().ok());
  EXPECT_EQ(text_of(folder / "joined.mkv"), text_of(file));
}

TEST_F(DepthVideoOfFive, OtherAndDamagedFilesAreNotTakenForDepth) {
  write(file, 1);
  const std::string bytes = text_of(file);
  const auto images_in = [&](const std::string& content) {
    write_text(folder / "b.mkv", content);
    auto video = DepthVideo::open(folder / "b.mkv");
    if (!video) return -1;
    int count = 0;
    for (auto image = video->next_mm(); image && !image->empty(); image = video->next_mm()) ++count;
    return count;
  };
  EXPECT_EQ(images_in(bytes), 5);
  std::string other = bytes;
  other.replace(bytes.find("ALLTACT_DEPTH"), 7, "ANOTHER");
  EXPECT_EQ(images_in(other), -1);
  EXPECT_EQ(images_in("nothing"), -1);
  // A damaged picture is no picture: the check sums of its slices say so.
  std::string flipped = bytes;
  flipped[bytes.size() / 2] = static_cast<char>(flipped[bytes.size() / 2] ^ 0x10);
  EXPECT_LT(images_in(flipped), 5);
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 20)
    EXPECT_LT(images_in(bytes.substr(0, size)), 5) << size;
}

}  // namespace
}  // namespace alltact::test
