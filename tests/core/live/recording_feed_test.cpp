// A recording that is read while it is written gives what its file gives afterwards.
#include "core/live/recording_feed.h"

#include "core/live/source_runner.h"
#include "core/recording/video_file.h"
#include "core/sources/file_source.h"
#include "tests/support/scratch_folder.h"

#include <chrono>
#include <future>
#include <thread>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace std::chrono_literals;
using test::scratch_folder;

FramePtr made_frame(int i) {
  auto frame = std::make_shared<Frame>();
  frame->grey = cv::Mat(48, 64, CV_8UC1, cv::Scalar(i % 200 + 20));
  frame->name = "frame";
  frame->origin = "made";
  frame->sequence = static_cast<std::uint64_t>(i);
  frame->time_ns = i * std::int64_t{10'000'000};
  return frame;
}

/// Frames without end.
class EndlessSource : public Source {
 public:
  Result<FramePtr> next() override {
    std::this_thread::sleep_for(1ms);
    return made_frame(given_++);
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return std::nullopt; }
  [[nodiscard]] bool is_continuous() const override { return true; }

 private:
  int given_ = 0;
};

/// Everything that the follower gives until its end.
Result<std::vector<FramePtr>> all_of(Source& source) {
  std::vector<FramePtr> frames;
  for (;;) {
    auto frame = source.next();
    if (!frame) return frame.error();
    if (!*frame) return frames;
    frames.push_back(*frame);
  }
}

void expect_same(const std::vector<FramePtr>& frames, const std::filesystem::path& file) {
  VideoSource video(VideoFile::open(file).value(), {});
  ASSERT_EQ(frames.size(), video.count());
  for (const FramePtr& frame : frames) {
    const auto stored = video.next();
    ASSERT_TRUE(stored && *stored);
    EXPECT_EQ((*stored)->time_ns, frame->time_ns);
    EXPECT_EQ(cv::norm((*stored)->grey, frame->grey, cv::NORM_INF), 0.0);
  }
}

TEST(RecordingFeed, GivesTheFramesOfTheFile) {
  const auto file = scratch_folder("feed") / "take.mkv";
  FrameHub hub;
  SourceRunner runner(hub, [](const auto&, const SourceOptions&) {
    return Result<std::unique_ptr<Source>>(std::make_unique<EndlessSource>());
  });
  runner.open({"made"});
  const auto feed = std::make_shared<RecordingFeed>(file);
  const Job job;
  FollowedRecording followed(feed, job);
  auto reading = std::async(std::launch::async, [&] {
    EXPECT_EQ(followed.lossless_file(), file);
    EXPECT_FALSE(followed.count());
    return all_of(followed);
  });
  runner.start_recording(file, {}, feed);
  while (feed->extent().frames < 50) std::this_thread::sleep_for(1ms);
  runner.stop_recording();
  const auto frames = reading.get();
  ASSERT_TRUE(frames.ok()) << frames.error().sentence();
  EXPECT_GE(frames->size(), 50U);
  EXPECT_EQ(followed.count(), frames->size());
  expect_same(*frames, file);
}

TEST(RecordingFeed, AReaderThatIsOvertakenGoesOnFromTheFile) {
  const auto file = scratch_folder("overtaken") / "take.mkv";
  constexpr std::size_t kFrames = 100, kInQueue = 10;
  const auto feed = std::make_shared<RecordingFeed>(file, kInQueue * 48 * 64);
  auto writer = VideoWriter::create(file, *made_frame(0), VideoCodec::kMagicYuv, 100).value();
  feed->begin(100, VideoCodec::kMagicYuv);
  for (std::size_t i = 0; i < kFrames; ++i) {
    const FramePtr frame = made_frame(static_cast<int>(i));
    ASSERT_TRUE(writer.add(*frame));
    feed->add(frame);
  }
  ASSERT_TRUE(writer.finish());
  feed->end(true);
  const Job job;
  FollowedRecording followed(feed, job);
  const auto frames = all_of(followed);
  ASSERT_TRUE(frames.ok()) << frames.error().sentence();
  EXPECT_EQ(frames->front()->name, "frame");
  EXPECT_NE(frames->back()->name, "frame") << "it was read from the file";
  expect_same(*frames, file);
}

TEST(RecordingFeed, SaysThatARecordingDidNotBecomeComplete) {
  const auto feed = std::make_shared<RecordingFeed>("nowhere.mkv");
  const Job job;
  FollowedRecording followed(feed, job);
  feed->begin(30, VideoCodec::kAuto);
  feed->add(made_frame(0));
  feed->end(false);
  EXPECT_TRUE(followed.next().ok());
  EXPECT_FALSE(followed.next().ok());
  EXPECT_EQ(followed.count(), 1U) << "no reader may wait for more";
}

TEST(RecordingFeed, AStoppedReaderDoesNotWaitForARecordingThatNeverBegins) {
  const auto feed = std::make_shared<RecordingFeed>("nowhere.mkv");
  Job job;
  FollowedRecording followed(feed, job);
  auto reading = std::async(std::launch::async, [&] { return followed.next(); });
  std::this_thread::sleep_for(5ms);
  job.request_stop();
  EXPECT_FALSE(reading.get().ok());
}

TEST(RecordingFeed, EndsWithARecordingThatCouldNotBegin) {
  FrameHub hub;
  SourceRunner runner(hub, [](const auto&, const SourceOptions&) {
    return Result<std::unique_ptr<Source>>(std::make_unique<EndlessSource>());
  });
  const auto without_source = std::make_shared<RecordingFeed>("a.mkv");
  runner.start_recording("a.mkv", {}, without_source);
  EXPECT_TRUE(without_source->extent().is_ended);
  runner.open({"made"});
  const auto file = scratch_folder("no_folder") / "none" / "take.mkv";
  const auto feed = std::make_shared<RecordingFeed>(file);
  runner.start_recording(file, {}, feed);
  const auto end = std::chrono::steady_clock::now() + 10s;
  while (!feed->extent().is_ended && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(1ms);
  EXPECT_TRUE(feed->extent().is_ended);
  EXPECT_FALSE(feed->extent().is_complete);
}

}  // namespace
}  // namespace alltact
