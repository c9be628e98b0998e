// A recording under way.
#include "core/recording/video_file.h"
#include "tests/core/recording/recorder_use.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"

#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

TEST(Recorder, RecordsEveryFrameWithItsTimeAndSequence) {
  for (const VideoCodec codec : {VideoCodec::kMagicYuv, VideoCodec::kFfv1, VideoCodec::kMjpeg}) {
    const TemporaryFolder folder;
    const bool is_jpeg = codec == VideoCodec::kMjpeg;
    auto recorder = started(folder / "v.mkv", settings_for(codec));
    for (std::uint32_t i = 0; i < 60; ++i)
      ASSERT_TRUE(recorder->add_waiting(camera_frame(i, is_jpeg)));
    ASSERT_TRUE(recorder->finish("the test is over").ok());
    const RecorderCounts counts = recorder->counts();
    EXPECT_EQ(counts.recorded, 60U);
    EXPECT_EQ(counts.dropped + counts.missing + counts.waiting, 0U);
    EXPECT_EQ(counts.codec, codec);
    EXPECT_GT(counts.free_bytes, 0U);
    EXPECT_EQ(exact_frames(folder / "v.mkv", is_jpeg), 60U);
    auto video = VideoFile::open(folder / "v.mkv");
    EXPECT_EQ((*video->frame(17))->time_ns, camera_frame(17, false)->time_ns);
    EXPECT_THAT(text_of(folder / "v.frames.csv"), HasSubstr("# source: test camera\n"));
    EXPECT_THAT(text_of(folder / "v.frames.csv"), HasSubstr("# ended: the test is over\n"));
  }
}

TEST(Recorder, SaysWhatItDropped) {
  const TemporaryFolder folder;
  const cv::Size size(640, 480);
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kFfv1, 1));
  std::vector<FramePtr> frames;
  for (std::uint32_t i = 0; i < 30; ++i) frames.push_back(camera_frame(i, false, size));
  std::uint64_t refused = 0;
  for (const FramePtr& frame : frames) refused += recorder->add(frame) ? 0 : 1;
  ASSERT_TRUE(recorder->add_waiting(camera_frame(30, false, size)));
  ASSERT_TRUE(recorder->finish("done").ok());
  const RecorderCounts counts = recorder->counts();
  EXPECT_GT(refused, 0U);  // 30 pictures of 0.3 MB at once, into 1 MB
  EXPECT_EQ(counts.dropped, refused);
  EXPECT_EQ(counts.recorded + counts.dropped, 31U);
  EXPECT_EQ(counts.missing, 0U);
  auto video = VideoFile::open(folder / "v.mkv");
  ASSERT_EQ(video->frame_count(), counts.recorded);
  for (std::size_t i = 0; i < video->frame_count(); ++i) {
    const FramePtr frame = *video->frame(i);
    const auto number = static_cast<std::uint32_t>(frame->sequence);
    EXPECT_EQ(cv::norm(frame->grey, camera_frame(number, false, size)->grey, cv::NORM_INF), 0);
  }
  EXPECT_EQ((*video->frame(video->frame_count() - 1))->sequence, 30U);
  EXPECT_THAT(text_of(folder / "v.frames.csv"), HasSubstr("lost here: the disk was too slow"));
}

TEST(Recorder, SaysWhatNeverCame) {
  const TemporaryFolder folder;
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kMagicYuv));
  for (const std::uint32_t number : {4U, 5U, 9U, 10U, 12U})
    ASSERT_TRUE(recorder->add_waiting(camera_frame(number, false)));
  ASSERT_TRUE(recorder->finish("done").ok());
  EXPECT_EQ(recorder->counts().missing, 4U);
  EXPECT_EQ(recorder->counts().dropped, 0U);
  const std::string journal = text_of(folder / "v.frames.csv");
  EXPECT_THAT(journal, HasSubstr("# 3 frames before frame 2 never came from the source\n2,"));
  EXPECT_THAT(journal, HasSubstr("# 1 frame before frame 4 never came from the source\n4,"));
}

TEST(Recorder, ThreadsMayAddAndLookAtTheSameTime) {
  const TemporaryFolder folder;
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kMagicYuv, 1));
  std::atomic<bool> is_over{false};
  std::uint64_t seen = 0;
  std::thread looker([&] {
    while (!is_over)
      seen = std::max(seen, recorder->counts().recorded + recorder->counts().waiting);
  });
  std::vector<std::thread> givers;
  for (std::uint32_t part = 0; part < 3; ++part)
    givers.emplace_back([&, part] {
      for (std::uint32_t i = 0; i < 40; ++i) {
        const auto frame = std::make_shared<Frame>(*camera_frame(40 * part + i, false));
        frame->time_ns = 5'000'000'123;  // whichever comes first, time does not run backwards
        EXPECT_TRUE(recorder->add_waiting(frame));
      }
    });
  for (std::thread& giver : givers) giver.join();
  is_over = true;
  looker.join();
  ASSERT_TRUE(recorder->finish("done").ok());
  EXPECT_EQ(recorder->counts().recorded, 120U);
  EXPECT_LE(seen, 121U);
  EXPECT_EQ(VideoFile::open(folder / "v.mkv")->frame_count(), 120U);
}

TEST(Recorder, NeverWritesOverARecording) {
  const TemporaryFolder folder;
  const auto refusal = [&](const fs::path& file, const RecorderSettings& settings) {
    const auto recorder = Recorder::start(file, settings, 30, "test");
    return recorder.ok() ? "started" : recorder.error().sentence();
  };
  const RecorderSettings settings = settings_for(VideoCodec::kAuto);
  std::ofstream(folder / "old.mkv") << "precious";
  EXPECT_THAT(refusal(folder / "old.mkv", settings), HasSubstr("the file exists already"));
  EXPECT_EQ(text_of(folder / "old.mkv"), "precious");
  EXPECT_THAT(refusal(folder / "v.avi", settings), HasSubstr("ends in .mkv"));
  EXPECT_THAT(refusal(folder / "none/v.mkv", settings), HasSubstr("its folder does not exist"));
  RecorderSettings vast = settings;
  vast.reserve_mb = 1000000000;
  EXPECT_THAT(refusal(folder / "v.mkv", vast), HasSubstr("the disk is nearly full"));
  EXPECT_FALSE(fs::exists(folder / "v.mkv"));
}

TEST(Recorder, WithoutAFrameNothingIsLeft) {
  const TemporaryFolder folder;
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kAuto));
  const Status status = recorder->finish("done");
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().sentence(), HasSubstr("no frame arrived"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Recorder, AFrameThatDoesNotFitEndsItWhole) {
  const TemporaryFolder folder;
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kMagicYuv));
  for (std::uint32_t i = 0; i < 5; ++i) ASSERT_TRUE(recorder->add_waiting(camera_frame(i, false)));
  (void)recorder->add_waiting(camera_frame(5, false, {32, 32}));
  while (!recorder->problem()) std::this_thread::yield();
  EXPECT_FALSE(recorder->add(camera_frame(6, false)));
  EXPECT_FALSE(recorder->add_waiting(camera_frame(6, false)));
  const Status status = recorder->finish("done");
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().sentence(), HasSubstr("32 x 32, those before were 64 x 48"));
  EXPECT_EQ(exact_frames(folder / "v.mkv", false), 5U);
  EXPECT_THAT(text_of(folder / "v.frames.csv"), HasSubstr("# ended: test camera: the image is"));
}

TEST(Recorder, CanBeReadWhileItRecordsAndIsNotMendedThen) {
  const TemporaryFolder folder;
  const fs::path file = folder / "v.mkv";
  auto recorder = started(file, settings_for(VideoCodec::kMagicYuv));
  for (std::uint32_t i = 0; i < 10; ++i) ASSERT_TRUE(recorder->add_waiting(camera_frame(i, false)));
  while (recorder->counts().recorded < 10) std::this_thread::yield();
  const Result<bool> mended = repair_recording(file, Job());
  ASSERT_FALSE(mended.ok());
  EXPECT_THAT(mended.error().sentence(), HasSubstr("being recorded or repaired right now"));
  EXPECT_EQ(exact_frames(file, false), 10U);
  for (std::uint32_t i = 10; i < 20; ++i)
    ASSERT_TRUE(recorder->add_waiting(camera_frame(i, false)));
  ASSERT_TRUE(recorder->finish("done").ok());
  EXPECT_EQ(exact_frames(file, false), 20U);
}

/// Resident memory of this program, MB.
double memory_mb() {
  std::ifstream statm("/proc/self/statm");
  double all = 0, resident = 0;
  statm >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

TEST(Recorder, MemoryDoesNotGrowWithTheRecording) {
  if (kIsSanitized) GTEST_SKIP() << "sanitizers keep freed memory";
  // ALLTACT_SOAK_SECONDS of recorded time at 30 frames a second, as fast as it goes.
  const char* wanted = std::getenv("ALLTACT_SOAK_SECONDS");
  const std::uint32_t frames = 30 * (wanted != nullptr ? std::atoi(wanted) : 30);
  const TemporaryFolder folder;
  std::vector<FramePtr> given;  // the same pictures over and over
  for (std::uint32_t i = 0; i < 10; ++i) given.push_back(camera_frame(i, false, {320, 240}));
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kMagicYuv, 2));
  double before_mb = 0;
  for (std::uint32_t i = 0; i < frames; ++i) {
    auto frame = std::make_shared<Frame>(*given[i % given.size()]);
    frame->sequence = i;
    frame->time_ns = kPeriodNs * i;
    ASSERT_TRUE(recorder->add_waiting(frame));
    if (i == 300) before_mb = memory_mb();
  }
  const double growth_mb = memory_mb() - before_mb;
  ASSERT_TRUE(recorder->finish("done").ok());
  fmt::print("{} frames, memory grew by {:.2f} MB\n", frames, growth_mb);
  EXPECT_LT(growth_mb, 5);
  EXPECT_EQ(recorder->counts().recorded, frames);
}

}  // namespace
}  // namespace alltact::test
