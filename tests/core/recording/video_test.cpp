// What goes into a video comes out of it, by our own reader and by others'.
#include "core/base/atomic_file.h"
#include "core/recording/journal.h"
#include "core/recording/matroska.h"
#include "core/recording/video_file.h"
#include "tests/core/recording/recording_frames.h"
#include "tests/support/temporary_folder.h"

#include <bit>
#include <fstream>
#include <numeric>
#include <random>

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>
#include <unistd.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::uint32_t kFrames = 40;

Status write_video(const fs::path& file, VideoCodec codec, std::uint32_t frames,
                   cv::Size size = {64, 48}, bool is_jpeg = false) {
  auto writer = VideoWriter::create(file, *camera_frame(0, is_jpeg, size), codec, 30);
  if (!writer) return writer.error();
  for (std::uint32_t i = 0; i < frames; ++i)
    if (Status status = writer->add(*camera_frame(i, is_jpeg, size)); !status) return status;
  return writer->finish();
}

std::size_t different_pixels(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return a.total();
  return static_cast<std::size_t>(cv::countNonZero(a != b));
}

class Video : public testing::TestWithParam<VideoCodec> {
 protected:
  [[nodiscard]] static bool is_jpeg() { return GetParam() == VideoCodec::kMjpeg; }
  [[nodiscard]] Status write(std::uint32_t frames = kFrames, cv::Size size = {64, 48}) const {
    return write_video(file, GetParam(), frames, size, is_jpeg());
  }
  TemporaryFolder folder;
  fs::path file = folder / "v.mkv";
};

TEST_P(Video, EveryFrameComesBackExactlyInOrder) {
  ASSERT_TRUE(write().ok());
  auto video = VideoFile::open(file);
  ASSERT_TRUE(video.ok()) << video.error().sentence();
  ASSERT_EQ(video->frame_count(), kFrames);
  EXPECT_NEAR(video->frames_per_s(), 30, 0.1);
  for (std::uint32_t i = 0; i < kFrames; ++i) {
    const auto frame = video->frame(i);
    ASSERT_TRUE(frame.ok()) << frame.error().sentence();
    const FramePtr truth = camera_frame(i, is_jpeg());
    EXPECT_EQ(different_pixels((*frame)->grey, truth->grey), 0U) << i;
    EXPECT_EQ((*frame)->name, fmt::format("frame_{:05}", i));
    EXPECT_NEAR(static_cast<double>(*(*frame)->time_ns), kPeriodNs * i, 0.5e6 + 1) << i;
    ASSERT_EQ((*frame)->jpeg != nullptr, is_jpeg());
    if (is_jpeg()) {
      EXPECT_EQ(*(*frame)->jpeg, *truth->jpeg);
    }
  }
}

TEST_P(Video, AnyFrameCanBeAskedForAtAnyTime) {
  ASSERT_TRUE(write().ok());
  auto video = VideoFile::open(file);
  ASSERT_TRUE(video.ok());
  std::mt19937 random(7);
  for (int i = 0; i < 150; ++i) {
    const auto number = static_cast<std::uint32_t>(random() % kFrames);
    const auto frame = video->frame(number);
    ASSERT_TRUE(frame.ok()) << frame.error().sentence();
    EXPECT_EQ(different_pixels((*frame)->grey, camera_frame(number, is_jpeg())->grey), 0U)
        << number;
  }
}

TEST_P(Video, SizesThatNoCodecLikesAreExact) {
  for (const cv::Size size : {cv::Size(1, 1), {17, 3}, {33, 47}, {63, 50}, {130, 2}}) {
    const Status written = write(3, size);
    ASSERT_TRUE(written.ok()) << size << written.error().sentence();
    auto video = VideoFile::open(file);
    ASSERT_TRUE(video.ok()) << size << video.error().sentence();
    ASSERT_EQ(video->frame_count(), 3U);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto frame = video->frame(i);
      ASSERT_TRUE(frame.ok()) << size << frame.error().sentence();
      EXPECT_EQ(different_pixels((*frame)->grey, camera_frame(i, is_jpeg(), size)->grey), 0U)
          << size;
    }
  }
}

TEST_P(Video, OtherProgramsReadTheSameBytes) {
  ASSERT_TRUE(write().ok());
  EXPECT_EQ(bytes_by_ffmpeg(file, is_jpeg()), expected_bytes(kFrames, is_jpeg()));
  if (is_jpeg()) return;  // OpenCV would turn its decoder's colours to grey in its own way
  cv::VideoCapture capture(file.string(), cv::CAP_FFMPEG);
  EXPECT_EQ(capture.get(cv::CAP_PROP_FRAME_COUNT), kFrames);
  cv::Mat image, grey;
  for (std::uint32_t i = 0; i < kFrames; ++i) {
    ASSERT_TRUE(capture.read(image)) << i;
    cv::extractChannel(image, grey, 0);
    EXPECT_EQ(different_pixels(grey, camera_frame(i, false)->grey), 0U);
  }
  EXPECT_FALSE(capture.read(image));
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_P(Video, TheSameFramesMakeTheSameBytes) {
  ASSERT_TRUE(write(5).ok());
  ASSERT_TRUE(write_video(folder / "w.mkv", GetParam(), 5, {64, 48}, is_jpeg()).ok());
  EXPECT_GT(bytes_of(file).size(), 1000U);
  EXPECT_EQ(bytes_of(file), bytes_of(folder / "w.mkv"));
}

TEST_P(Video, CopiedFramesMakeTheBytesOfReadAndAddedOnes) {
  ASSERT_TRUE(write().ok());
  std::vector<char> keep(kFrames, 0);
  for (const std::size_t i : {3, 4, 5, 17, 39}) keep[i] = 1;
  ASSERT_TRUE(copy_frames(file, folder / "copied.mkv", keep, Job()).ok());
  auto video = VideoFile::open(file);
  ASSERT_TRUE(video.ok());
  auto writer = VideoWriter::create(folder / "added.mkv", **video->frame(3), GetParam(),
                                    video->frames_per_s());
  ASSERT_TRUE(writer.ok());
  for (std::size_t i = 0; i < kFrames; ++i) {
    if (keep[i] == 0) continue;
    ASSERT_TRUE(writer->add(**video->frame(i)).ok());
  }
  ASSERT_TRUE(writer->finish().ok());
  EXPECT_EQ(bytes_of(folder / "copied.mkv"), bytes_of(folder / "added.mkv"));

  keep.resize(kFrames + 1, 0);
  const Status more = copy_frames(file, folder / "more.mkv", keep, Job());
  ASSERT_FALSE(more.ok());
  EXPECT_THAT(more.error().sentence(), HasSubstr("only 40 of its 41 frames could be read"));
}

TEST_P(Video, EveryFrameIsInTheFileAsSoonAsItWasAdded) {
  auto writer = VideoWriter::create(file, *camera_frame(0, is_jpeg()), GetParam(), 30);
  ASSERT_TRUE(writer.ok());
  for (std::uint32_t i = 0; i < 5; ++i) {
    ASSERT_TRUE(writer->add(*camera_frame(i, is_jpeg())).ok());
    EXPECT_EQ(writer->bytes(), fs::file_size(file));
    fs::copy_file(file, folder / "copy.mkv", fs::copy_options::overwrite_existing);
    auto video = VideoFile::open(folder / "copy.mkv");
    ASSERT_TRUE(video.ok()) << video.error().sentence();
    ASSERT_EQ(video->frame_count(), i + 1);
    EXPECT_EQ(different_pixels((*video->frame(i))->grey, camera_frame(i, is_jpeg())->grey), 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Codecs, Video,
                         testing::Values(VideoCodec::kMagicYuv, VideoCodec::kFfv1,
                                         VideoCodec::kMjpeg),
                         [](const auto& info) -> std::string {
                           if (info.param == VideoCodec::kMjpeg) return "Mjpeg";
                           return std::string(to_string(info.param));
                         });

TEST(VideoWriter, SaysWhatItCannotRecord) {
  const TemporaryFolder folder;
  const auto refusal = [&](const Frame& first, VideoCodec codec, const fs::path& file) {
    const auto writer = VideoWriter::create(file, first, codec, 30);
    return writer.ok() ? "taken" : writer.error().sentence();
  };
  const fs::path file = folder / "v.mkv";
  EXPECT_THAT(refusal(*camera_frame(0, false), VideoCodec::kMjpeg, file), HasSubstr("no JPEG"));
  Frame floating;
  floating.grey = cv::Mat::zeros(8, 8, CV_32FC1);
  EXPECT_THAT(refusal(floating, VideoCodec::kAuto, file), HasSubstr("8-bit grey"));
  EXPECT_THAT(refusal(*camera_frame(0, false), VideoCodec::kFfv1, folder / "none/v.mkv"),
              HasSubstr("none/v.mkv: could not write the video: it does not exist"));

  auto writer = VideoWriter::create(file, *camera_frame(0, false), VideoCodec::kMagicYuv, 30);
  ASSERT_TRUE(writer.ok());
  ASSERT_TRUE(writer->add(*camera_frame(0, false)).ok());
  const Status other_size = writer->add(*camera_frame(1, false, {32, 32}));
  ASSERT_FALSE(other_size.ok());
  EXPECT_THAT(other_size.error().sentence(), HasSubstr("32 x 32, those before were 64 x 48"));
  EXPECT_TRUE(writer->add(*camera_frame(1, false)).ok());
  EXPECT_TRUE(writer->finish().ok());
  EXPECT_EQ(VideoFile::open(file)->frame_count(), 2U);
}

TEST(VideoWriter, ChoosesPacketsWhereThereAreAny) {
  const TemporaryFolder folder;
  const auto choice = [&](bool is_jpeg) {
    return VideoWriter::create(folder / "v.mkv", *camera_frame(0, is_jpeg), VideoCodec::kAuto, 30)
        ->codec();
  };
  EXPECT_EQ(choice(true), VideoCodec::kMjpeg);
  EXPECT_EQ(choice(false), VideoCodec::kMagicYuv);
}

TEST(VideoWriter, TimesThatAreNoneOrGoBackwardsStillMakeAVideo) {
  const TemporaryFolder folder;
  auto writer =
      VideoWriter::create(folder / "v.mkv", *camera_frame(0, false), VideoCodec::kMagicYuv, 50);
  ASSERT_TRUE(writer.ok());
  for (const std::int64_t time_ms : {1000, 1100, 1100, 900, 1150, 1300}) {
    auto frame = std::make_shared<Frame>(*camera_frame(0, false));
    frame->time_ns = time_ms * 1'000'000;
    ASSERT_TRUE(writer->add(*frame).ok());
  }
  ASSERT_TRUE(writer->finish().ok());
  auto video = VideoFile::open(folder / "v.mkv");
  std::vector<std::int64_t> times_ms;
  for (std::size_t i = 0; i < 6; ++i) times_ms.push_back(*(*video->frame(i))->time_ns / 1'000'000);
  EXPECT_THAT(times_ms, testing::ElementsAre(0, 100, 120, 140, 150, 300));
}

TEST(VideoFile, ReadsOtherPeoplesVideosAsGrey) {
  const TemporaryFolder folder;
  const std::string made = (folder / "v").string();
  struct Case {
    const char* options;
    const char* ending;
    double tolerance;  // grey levels in the mean; the source ramp is exact
  };
  // Groups of pictures with frames that are shown in another order than stored, narrow range, RGB,
  // 10 bits, other containers.
  const Case cases[] = {{"-c:v libx264 -qp 0 -bf 2 -g 12 -pix_fmt yuv420p", "mp4", 1.2},
                        {"-c:v libx264 -qp 0 -bf 2 -g 12 -pix_fmt yuv420p", "mkv", 1.2},
                        {"-c:v ffv1 -pix_fmt bgr0", "mkv", 1.2},
                        {"-c:v ffv1 -pix_fmt yuv420p10le", "mkv", 1.2},
                        {"-c:v ffv1 -pix_fmt gray", "avi", 1.2},
                        {"-c:v mjpeg -q:v 1 -pix_fmt yuvj420p", "avi", 1.5}};
  for (const Case& c : cases) {
    const std::string file = made + "." + c.ending;
    // Frame n is a flat grey of 20 + 4 n.
    output_of(
        "ffmpeg -v quiet -nostdin -y -f lavfi -i "
        "\"color=c=black:s=64x48:r=25:d=2,format=gray,geq=lum='20+4*N'\" " +
        std::string(c.options) + " '" + file + "' </dev/null");
    if (!fs::exists(file)) GTEST_SKIP() << "ffmpeg is not here or lacks a codec: " << c.options;
    auto video = VideoFile::open(file);
    ASSERT_TRUE(video.ok()) << c.options << video.error().sentence();
    ASSERT_EQ(video->frame_count(), 50U) << c.options;
    std::vector<std::size_t> order(50);
    std::iota(order.begin(), order.end(), 0U);
    for (const std::size_t number : {49U, 3U, 4U, 30U, 11U, 12U, 13U, 0U}) order.push_back(number);
    for (const std::size_t number : order) {
      const auto frame = video->frame(number);
      ASSERT_TRUE(frame.ok()) << c.options << frame.error().sentence();
      EXPECT_NEAR(cv::mean((*frame)->grey)[0], 20 + 4 * static_cast<double>(number), c.tolerance)
          << c.options << " frame " << number;
      EXPECT_NEAR(static_cast<double>(*(*frame)->time_ns), 40e6 * static_cast<double>(number), 1e6);
    }
    fs::remove(file);
  }
}

TEST(VideoFile, AFrameWithDamagedBytesIsAnErrorAndTheOthersAreExact) {
  const TemporaryFolder folder;
  const fs::path file = folder / "v.mkv";
  ASSERT_TRUE(write_video(file, VideoCodec::kFfv1, 9, {320, 240}).ok());
  {
    std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(static_cast<std::streamoff>(fs::file_size(file) / 2));
    stream << "damage";
  }
  auto video = VideoFile::open(file);
  ASSERT_TRUE(video.ok()) << video.error().sentence();
  int damaged = 0;
  for (std::uint32_t i = 0; i < video->frame_count(); ++i) {
    const auto frame = video->frame(i);
    if (!frame.ok()) {
      ++damaged;
      EXPECT_THAT(frame.error().sentence(), HasSubstr(fmt::format("frame {} of the video", i)));
    } else {
      EXPECT_EQ(different_pixels((*frame)->grey, camera_frame(i, false, {320, 240})->grey), 0U)
          << i;
    }
  }
  EXPECT_EQ(video->frame_count(), 9U);
  EXPECT_EQ(damaged, 1);
}

TEST(MatroskaIndex, AClusterThatSaysItIsLongerThanAnyFileIsDamaged) {
  const TemporaryFolder folder;
  const fs::path file = folder / "v.mkv";
  ASSERT_TRUE(write_video(file, VideoCodec::kFfv1, 3, {320, 240}).ok());
  std::string bytes = read_file(file).value();
  const std::size_t cluster = bytes.rfind("\x1F\x43\xB6\x75"), length_at = cluster + 4;
  const auto first = static_cast<unsigned char>(bytes.at(length_at));
  const std::size_t length_bytes = static_cast<std::size_t>(std::countl_zero(first)) + 1;
  // 2^48 bytes, of which nobody has the memory.
  bytes.replace(length_at, length_bytes, std::string("\x01\x01\0\0\0\0\0\0", 8));
  std::ofstream(file, std::ios::binary) << bytes;
  const auto index = index_matroska(file);
  ASSERT_TRUE(index.ok()) << index.error().sentence();
  ASSERT_EQ(index->blocks.size(), 3U);
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  for (const auto& block : index->blocks)
    EXPECT_EQ(is_undamaged(descriptor, block),
              block.cluster_at != static_cast<std::int64_t>(cluster));
  ::close(descriptor);
}

TEST(Journal, GivesBackWhatItWasTold) {
  const TemporaryFolder folder;
  EXPECT_EQ(journal_of("/a/b.c/rec.mkv"), "/a/b.c/rec.frames.csv");
  const fs::path file = folder / "v.frames.csv";
  {
    auto journal = JournalWriter::create(file, "camera, \"left\"");
    ASSERT_TRUE(journal.ok());
    for (std::uint32_t i = 0; i < 4; ++i) {
      Frame frame = *camera_frame(2 * i, false);
      if (i != 1)
        frame.controls = std::make_shared<const std::string>(i < 3 ? "a=1, \"b\"=2" : "a=2");
      ASSERT_TRUE(journal->add(frame).ok());
      ASSERT_TRUE(journal->remark("frames were\nlost").ok());
    }
  }
  auto entries = read_journal(file).value();
  ASSERT_EQ(entries.size(), 4U);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(entries[i].time_ns, camera_frame(2 * i, false)->time_ns);
    EXPECT_EQ(entries[i].sequence, 2 * i);
  }
  EXPECT_EQ(*entries[0].controls, "a=1, \"b\"=2");
  EXPECT_EQ(entries[1].controls, nullptr);
  EXPECT_EQ(*entries[3].controls, "a=2");

  // A crash leaves less of it; every length gives whole lines only.
  const auto size = fs::file_size(file);
  for (auto bytes = size; bytes-- > 0;) {
    fs::resize_file(file, bytes);
    const auto fewer = read_journal(file).value();
    ASSERT_LE(fewer.size(), entries.size());
    for (std::size_t i = 0; i < fewer.size(); ++i) EXPECT_EQ(fewer[i].time_ns, entries[i].time_ns);
    entries = fewer;
  }
  EXPECT_TRUE(entries.empty());
  EXPECT_TRUE(read_journal(folder / "none").value().empty());
}

TEST(Journal, OneWhoseTimeRunsBackwardsIsRefusedByItsFrame) {
  const TemporaryFolder folder;
  const fs::path file = folder / "v.mkv";
  ASSERT_TRUE(write_video(file, VideoCodec::kMagicYuv, 3).ok());
  const auto opened = [&](const std::vector<std::int64_t>& times_ns) {
    auto journal = JournalWriter::create(journal_of(file), "test");
    for (const std::int64_t time_ns : times_ns) {
      Frame frame = *camera_frame(0, false);
      frame.time_ns = time_ns;
      EXPECT_TRUE(journal->add(frame).ok());
    }
    const auto video = VideoFile::open(file);
    return video.ok() ? std::string("opened") : video.error().sentence();
  };
  EXPECT_EQ(opened({100, 100, 200}), "opened");
  const std::string refusal = opened({100, 300, 299});
  EXPECT_NE(refusal.find("v.frames.csv: frame 2 is older than frame 1"), std::string::npos)
      << refusal;
}

TEST(Journal, TimesAndSequenceOfAVideoComeFromIt) {
  const TemporaryFolder folder;
  const fs::path file = folder / "v.mkv";
  ASSERT_TRUE(write_video(file, VideoCodec::kMagicYuv, 4).ok());
  auto journal = JournalWriter::create(journal_of(file), "test");
  for (const std::uint32_t number : {7U, 8U, 10U})  // one line too few
    ASSERT_TRUE(journal->add(*camera_frame(number, false)).ok());
  auto video = VideoFile::open(file);
  ASSERT_EQ(video->frame_count(), 4U);
  EXPECT_EQ((*video->frame(2))->sequence, 10U);
  EXPECT_EQ((*video->frame(2))->time_ns, camera_frame(10, false)->time_ns);
  EXPECT_EQ((*video->frame(3))->sequence, 11U);
  EXPECT_NEAR(static_cast<double>(*(*video->frame(3))->time_ns),
              static_cast<double>(*camera_frame(10, false)->time_ns), 1e6);
}

}  // namespace
}  // namespace alltact::test
