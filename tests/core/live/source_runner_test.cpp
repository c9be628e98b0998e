// Sources that run beside whoever looks: opened, read, recorded and ended without waiting.
#include "core/live/source_runner.h"

#include "core/recording/video_file.h"
#include "tests/support/temporary_folder.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace std::chrono_literals;

/// Gives `frames` frames, numbered but for every tenth, which is lost; then ends, or waits.
class MadeSource : public Source {
 public:
  MadeSource(int frames, bool is_ending) : frames_(frames), is_ending_(is_ending) {}
  Result<FramePtr> next() override {
    if (given_ == frames_ && is_ending_) return FramePtr();
    std::this_thread::sleep_for(1ms);
    if (given_ == frames_) return Error{en::say("nothing comes"), "", ""};
    auto frame = std::make_shared<Frame>();
    frame->grey = cv::Mat(48, 64, CV_8UC1, cv::Scalar(given_ % 200 + 20));
    frame->name = "frame";
    frame->origin = "made";
    if (given_ % 9 == 8) ++number_;
    frame->sequence = number_++;
    frame->time_ns = monotonic_ns();
    ++given_;
    return FramePtr(frame);
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return std::nullopt; }
  [[nodiscard]] bool is_continuous() const override { return true; }

 private:
  int frames_, given_ = 0;
  std::uint64_t number_ = 0;
  bool is_ending_;
};

SourceOpener gives(int frames, bool is_ending) {
  return [=](const auto&, const SourceOptions&) -> Result<std::unique_ptr<Source>> {
    return std::unique_ptr<Source>(std::make_unique<MadeSource>(frames, is_ending));
  };
}

template <class Condition>
bool comes_true(const Condition& condition) {
  for (const auto end = std::chrono::steady_clock::now() + 10s;
       std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(1ms))
    if (condition()) return true;
  return condition();
}

TEST(SourceRunner, PublishesEveryFrameAndSaysThatItEnded) {
  FrameHub hub;
  SourceRunner runner(hub, gives(40, true));
  EXPECT_EQ(runner.status().state, SourceState::kClosed);
  const auto queue = hub.subscribe(100);
  runner.open({"made"});
  ASSERT_TRUE(comes_true([&] { return runner.status().state == SourceState::kEnded; }));
  const SourceStatus status = runner.status();
  EXPECT_EQ(status.delivered, 40U);
  EXPECT_EQ(status.missing, 4U);
  EXPECT_TRUE(status.is_continuous);
  EXPECT_FALSE(status.problem);
  for (int i = 0; i < 40; ++i) {
    const auto frame = queue->next(1s);
    ASSERT_TRUE(frame && frame->ok()) << i;
    const auto age_ms = runner.age_ms(***frame, monotonic_ns());
    ASSERT_TRUE(age_ms);
    EXPECT_TRUE(*age_ms >= 0 && *age_ms < 10'000) << *age_ms;
  }
}

/// Frames taken 30 times a second, of which it gives one every `period`.
class TimedSource : public Source {
 public:
  explicit TimedSource(std::chrono::milliseconds period) : period_(period) {}
  Result<FramePtr> next() override {
    std::this_thread::sleep_for(period_);
    auto frame = std::make_shared<Frame>();
    frame->grey = cv::Mat(48, 64, CV_8UC1, cv::Scalar(100));
    frame->origin = "timed";
    frame->sequence = number_++;
    frame->time_ns = static_cast<std::int64_t>(frame->sequence) * 1'000'000'000 / 30;
    return FramePtr(frame);
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return std::nullopt; }
  [[nodiscard]] bool is_continuous() const override { return true; }

 private:
  std::chrono::milliseconds period_;
  std::uint64_t number_ = 0;
};

TEST(SourceRunner, ReportsTheRateOfTheFramesTimesWhileItCatchesUp) {
  for (const auto period : {1ms, 100ms}) {
    FrameHub hub;
    SourceRunner runner(hub, [=](const auto&, const SourceOptions&) {
      return Result<std::unique_ptr<Source>>(std::make_unique<TimedSource>(period));
    });
    runner.open({"timed"});
    ASSERT_TRUE(comes_true([&] { return runner.status().frames_per_s > 0; }));
    const SourceStatus status = runner.status();
    EXPECT_EQ(status.is_catching_up, period == 1ms);
    if (period == 1ms)
      EXPECT_NEAR(status.frames_per_s, 30, 1e-3);
    else
      EXPECT_LE(status.frames_per_s, 10.1) << "it falls behind";
  }
}

TEST(SourceRunner, SaysWhyASourceCannotBeOpenedAndGoesOnWithAnother) {
  FrameHub hub;
  std::atomic<bool> is_there{false};
  SourceRunner runner(
      hub,
      [&](const auto& inputs, const SourceOptions& options) -> Result<std::unique_ptr<Source>> {
        if (is_there) return gives(1000, true)(inputs, options);
        return Error{en::say("no such camera"), "", ""};
      });
  runner.open({"camera"});
  ASSERT_TRUE(comes_true([&] { return runner.status().state == SourceState::kFailed; }));
  EXPECT_EQ(runner.status().problem->what.english(), "no such camera");
  is_there = true;
  runner.open({"camera"});
  ASSERT_TRUE(comes_true([&] { return runner.status().delivered > 3; }));
  EXPECT_FALSE(runner.status().problem);
  runner.close();
  ASSERT_TRUE(comes_true([&] { return runner.status().state == SourceState::kClosed; }));
  const FramePtr last = hub.latest();
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(hub.latest(), last) << "nothing is published any more";
}

TEST(SourceRunner, TellsAFaultWhileNoFrameComes) {
  FrameHub hub;
  SourceRunner runner(hub, gives(5, false));
  runner.open({"made"});
  ASSERT_TRUE(comes_true([&] { return runner.status().problem.has_value(); }));
  EXPECT_EQ(runner.status().state, SourceState::kRunning);
  EXPECT_EQ(runner.status().delivered, 5U);
}

/// Throws `thrown` from every third call, else gives frames.
template <class Thrown>
class ThrowingSource : public MadeSource {
 public:
  explicit ThrowingSource(Thrown thrown) : MadeSource(1'000'000, true), thrown_(thrown) {}
  Result<FramePtr> next() override {
    if (++calls_ % 3 == 0) throw thrown_;
    return MadeSource::next();
  }

 private:
  Thrown thrown_;
  int calls_ = 0;
};

template <class Thrown>
void expect_to_survive(Thrown thrown, const std::string& sentence) {
  FrameHub hub;
  SourceRunner source_throws(
      hub, [&](const auto&, const SourceOptions&) -> Result<std::unique_ptr<Source>> {
        return std::unique_ptr<Source>(std::make_unique<ThrowingSource<Thrown>>(thrown));
      });
  source_throws.open({"made"});
  EXPECT_TRUE(comes_true([&] {
    const auto problem = source_throws.status().problem;
    return problem && problem->sentence() == sentence;
  })) << sentence;
  EXPECT_TRUE(comes_true([&] { return source_throws.status().delivered > 10; })) << "it goes on";

  SourceRunner opener_throws(
      hub,
      [&](const auto&, const SourceOptions&) -> Result<std::unique_ptr<Source>> { throw thrown; });
  opener_throws.open({"made"});
  ASSERT_TRUE(comes_true([&] { return opener_throws.status().state == SourceState::kFailed; }));
  EXPECT_EQ(opener_throws.status().problem->sentence(), sentence);
}

TEST(SourceRunner, WhatASourceThrowsIsAProblemOfTheSource) {
  expect_to_survive(std::bad_alloc(), "there is not enough memory. Try: close other programs.");
  expect_to_survive(cv::Exception(cv::Error::StsNoMem, "", "", "", 0),
                    "there is not enough memory. Try: close other programs.");
  expect_to_survive(7, "unexpected: exception. Try: reporting this as a defect.");
}

TEST(SourceRunner, AStopRightAfterAStartIsNotLost) {
  const test::TemporaryFolder folder;
  FrameHub hub;
  SourceRunner runner(hub, gives(1'000'000, true));
  runner.open({"made"});
  ASSERT_TRUE(comes_true([&] { return runner.status().delivered > 2; }));
  constexpr int kOrders = 1000;
  for (int order = 0; order < kOrders; ++order) {
    const auto file = folder / ("r" + std::to_string(order) + ".mkv");
    runner.start_recording(file, {});
    std::this_thread::sleep_for(std::chrono::microseconds(10 * order));
    runner.stop_recording();
    ASSERT_TRUE(comes_true([&] { return runner.recording().state == RecordingState::kDone; }))
        << "stopped after " << 10 * order << " us";
    ASSERT_EQ(runner.recording().file, file);
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
  }
}

TEST(SourceRunner, RecordsWhatComesUntilItIsStopped) {
  const test::TemporaryFolder folder;
  FrameHub hub;
  SourceRunner runner(hub, gives(1'000'000, true));
  runner.start_recording(folder / "early.mkv", {});
  EXPECT_EQ(runner.recording().state, RecordingState::kNone) << "no source runs";
  runner.open({"made"});
  runner.start_recording(folder / "made.mkv", {});
  EXPECT_EQ(runner.recording().state, RecordingState::kRunning);
  runner.start_recording(folder / "second.mkv", {});  // one is enough
  ASSERT_TRUE(comes_true([&] { return runner.recording().counts.recorded >= 20; }));
  runner.stop_recording();
  ASSERT_TRUE(comes_true([&] { return runner.recording().state == RecordingState::kDone; }));
  const RecordingStatus recording = runner.recording();
  EXPECT_FALSE(recording.problem) << recording.problem->sentence();
  EXPECT_EQ(recording.file, folder / "made.mkv");
  EXPECT_GT(recording.seconds, 0);
  EXPECT_EQ(runner.status().state, SourceState::kRunning) << "the source goes on";
  auto video = VideoFile::open(recording.file, Job());
  ASSERT_TRUE(video.ok()) << video.error().sentence();
  EXPECT_EQ(video.value().frame_count(), recording.counts.recorded);
  EXPECT_FALSE(std::filesystem::exists(folder / "second.mkv"));
}

TEST(SourceRunner, SaysWhyARecordingCannotBegin) {
  const test::TemporaryFolder folder;
  FrameHub hub;
  SourceRunner runner(hub, gives(1'000'000, true));
  runner.open({"made"});
  runner.start_recording(folder / "nowhere" / "made.mkv", {});
  ASSERT_TRUE(comes_true([&] { return runner.recording().state == RecordingState::kDone; }));
  EXPECT_TRUE(runner.recording().problem);
}

}  // namespace
}  // namespace alltact
