// A recording whose disk is full or read-only, or whose folder is removed or moved.
#include "core/recording/journal.h"
#include "core/recording/video_file.h"
#include "tests/core/recording/recorder_use.h"
#include "tests/support/small_disk.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

/// Records until the recorder ends by itself; how long its end took.
std::chrono::duration<double> record_until_it_ends(Recorder& recorder, cv::Size size) {
  std::uint32_t number = 0;
  while (recorder.add_waiting(camera_frame(number, false, size))) ++number;
  const auto begin = std::chrono::steady_clock::now();
  const Status status = recorder.finish("done");
  EXPECT_FALSE(status.ok());
  return std::chrono::steady_clock::now() - begin;
}

TEST(Recorder, EndsWholeBeforeTheDiskIsFull) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder / "disk", 8000);
  if (!disk.mounted()) GTEST_SKIP() << disk.problem();
  RecorderSettings settings = settings_for(VideoCodec::kMagicYuv);
  settings.reserve_mb = 3;
  const fs::path file = folder / "disk/v.mkv";
  auto recorder = started(file, settings);
  EXPECT_LT(record_until_it_ends(*recorder, {320, 240}).count(), 1);
  ASSERT_TRUE(recorder->problem());
  EXPECT_THAT(recorder->problem()->sentence(), HasSubstr("the disk is nearly full: 2 MB are left"));
  EXPECT_GT(fs::space(folder / "disk").available, 2'500'000U);
  const Result<bool> mended = repair_recording(file, Job());
  ASSERT_TRUE(mended.ok());
  EXPECT_FALSE(*mended) << "it is whole";
  EXPECT_EQ(exact_frames(file, false, {320, 240}), recorder->counts().recorded);
  EXPECT_GT(recorder->counts().recorded, 50U);
}

TEST(Recorder, AFullDiskLeavesEverythingBeforeItReadable) {
  for (const bool is_jpeg : {false, true}) {
    const TemporaryFolder folder;
    const SmallDisk disk(folder / "disk", 3000);
    if (!disk.mounted()) GTEST_SKIP() << disk.problem();
    const fs::path file = folder / "disk/v.mkv";
    auto recorder =
        started(file, settings_for(is_jpeg ? VideoCodec::kMjpeg : VideoCodec::kMagicYuv));
    const cv::Size size(320, 240);
    std::uint32_t number = 0;
    while (recorder->add_waiting(camera_frame(number, is_jpeg, size))) ++number;
    const Status status = recorder->finish("done");
    ASSERT_FALSE(status.ok());
    EXPECT_THAT(status.error().sentence(), HasSubstr("the disk is full"));
    const std::uint64_t recorded = recorder->counts().recorded;
    EXPECT_GT(recorded, 20U);
    EXPECT_EQ(exact_frames(file, is_jpeg, size), recorded);
    EXPECT_EQ(bytes_by_ffmpeg(file, is_jpeg),
              expected_bytes(static_cast<std::uint32_t>(recorded), is_jpeg, size));
  }
}

TEST(Recorder, AReadOnlyDiskIsTold) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder / "disk", 1000);
  if (!disk.mounted()) GTEST_SKIP() << disk.problem();
  ASSERT_TRUE(disk.forbid_writing());
  const auto recorder =
      Recorder::start(folder / "disk/v.mkv", settings_for(VideoCodec::kAuto), 30, "test");
  ASSERT_FALSE(recorder.ok());
  EXPECT_THAT(recorder.error().sentence(), HasSubstr("the disk is read-only"));
}

TEST(Recorder, PutsBackARecordingThatWasRemovedMeanwhile) {
  const TemporaryFolder folder;
  const fs::path file = folder / "day/v.mkv";
  fs::create_directory(folder / "day");
  auto recorder = started(file, settings_for(VideoCodec::kMagicYuv));
  std::uint32_t number = 0;
  for (; number < 20; ++number) ASSERT_TRUE(recorder->add_waiting(camera_frame(number, false)));
  while (recorder->counts().recorded < 20) std::this_thread::yield();
  fs::remove_all(folder / "day");
  EXPECT_LT(record_until_it_ends(*recorder, {64, 48}).count(), 1);
  EXPECT_THAT(recorder->problem()->sentence(), HasSubstr("was removed while it was being made"));
  EXPECT_EQ(exact_frames(file, false), 20U);
  EXPECT_EQ(read_journal(journal_of(file)).value().size(), 20U);
}

/// A recording of many megabytes whose folder is removed; ready to be finished.
std::unique_ptr<Recorder> long_and_removed(const TemporaryFolder& folder, std::uint32_t count) {
  fs::create_directory(folder / "day");
  auto recorder = started(folder / "day/v.mkv", settings_for(VideoCodec::kMagicYuv));
  const FramePtr image = camera_frame(0, false, {1280, 960});
  for (std::uint32_t i = 0; i < count; ++i) {
    auto frame = std::make_shared<Frame>(*image);
    frame->sequence = i;
    *frame->time_ns += kPeriodNs * i;
    EXPECT_TRUE(recorder->add_waiting(std::move(frame)));
  }
  while (recorder->counts().recorded < count) std::this_thread::yield();
  fs::remove_all(folder / "day");
  return recorder;
}

TEST(Recorder, PuttingALongRecordingBackIsReported) {
  const TemporaryFolder folder;
  auto recorder = long_and_removed(folder, 60);
  std::vector<double> told;
  const Job job([&](double fraction, const Message& what) {
    told.push_back(fraction);
    EXPECT_THAT(what.english(), HasSubstr("restoring the removed recording"));
  });
  EXPECT_THAT(recorder->finish("done", job).error().sentence(), HasSubstr("was restored"));
  ASSERT_GT(recorder->counts().bytes, 40'000'000U);
  if (told.empty()) GTEST_SKIP() << "this disk shares instead of copying";
  EXPECT_GE(told.size(), 3U);
  EXPECT_EQ(told.back(), 1.0);
  EXPECT_EQ(VideoFile::open(folder / "day/v.mkv")->frame_count(), 60U);
}

TEST(Recorder, PuttingBackCanBeStoppedAndKeepsWhatIsThere) {
  const TemporaryFolder folder;
  auto recorder = long_and_removed(folder, 60);
  Job* running = nullptr;
  std::chrono::steady_clock::time_point stopped;
  Job job([&](double, const Message& what) {
    if (what.english().find("recording: 0 of") != std::string::npos) return;  // the journal
    stopped = std::chrono::steady_clock::now();
    running->request_stop();
  });
  running = &job;
  const Status status = recorder->finish("done", job);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - stopped;
  ASSERT_FALSE(status.ok());
  if (!job.stop_requested()) GTEST_SKIP() << "this disk shares instead of copying";
  EXPECT_THAT(status.error().sentence(), HasSubstr("stopped when 16 of"));
  EXPECT_LT(took.count(), 1);
  auto video = VideoFile::open(folder / "day/v.mkv");
  ASSERT_TRUE(video.ok()) << video.error().sentence();
  EXPECT_GT(video->frame_count(), 5U);
  EXPECT_LT(video->frame_count(), 60U);
}

TEST(Recorder, AJobThatWasStoppedBeforeStillPutsTheRecordingBack) {
  const TemporaryFolder folder;
  auto recorder = long_and_removed(folder, 3);
  Job job;
  job.request_stop();  // Ctrl-C is how recordings end
  EXPECT_THAT(recorder->finish("stopped by hand", job).error().sentence(),
              HasSubstr("was restored"));
  EXPECT_EQ(VideoFile::open(folder / "day/v.mkv")->frame_count(), 3U);
}

TEST(Recorder, GoesOnInAFolderThatIsMoved) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "day");
  auto recorder = started(folder / "day/v.mkv", settings_for(VideoCodec::kMagicYuv));
  for (std::uint32_t i = 0; i < 10; ++i) ASSERT_TRUE(recorder->add_waiting(camera_frame(i, false)));
  while (recorder->counts().recorded < 10) std::this_thread::yield();
  fs::rename(folder / "day", folder / "night");
  for (std::uint32_t i = 10; i < 20; ++i)
    ASSERT_TRUE(recorder->add_waiting(camera_frame(i, false)));
  ASSERT_TRUE(recorder->finish("done").ok());
  EXPECT_EQ(exact_frames(folder / "night/v.mkv", false), 20U);
}

}  // namespace
}  // namespace alltact::test
