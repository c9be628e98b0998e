// The simulated finger as a camera, and sources at their pace.
#include "core/open/open_source.h"
#include "core/recording/journal.h"
#include "core/recording/video_file.h"
#include "core/sources/source.h"
#include "tests/core/recording/recording_frames.h"
#include "tests/core/simulation/scene_text.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

const std::string kCamera =
    "  - use: leds\n    lamps: [{at_mm: [0.0, 0.0, 0.0], power: 270000.0}]\n"
    "  - {use: layer, scatter_per_mm: 0.6, along: normal}\n"
    "  - {use: read, sd: 2}\n  - {use: quantisation}\n";

struct SceneFile {
  explicit SceneFile(const std::string& more, const std::string& head = "frames: 40\n") {
    text = scene_text(kCamera + more);
    text.replace(text.find("frames: 3\n"), 10, head);
    std::ofstream(file) << text;
  }
  [[nodiscard]] std::unique_ptr<Source> open(const SourceOptions& options = {}) const {
    auto source = open_source({file}, options);
    EXPECT_TRUE(source.ok()) << source.error().sentence();
    return std::move(*source);
  }
  TemporaryFolder folder;
  fs::path file = folder / "scene.yaml";
  std::string text;
};

std::vector<FramePtr> all_of(Source& source) {
  std::vector<FramePtr> frames;
  while (true) {
    const auto frame = source.next();
    EXPECT_TRUE(frame.ok());
    if (!frame.ok() || !*frame) return frames;
    frames.push_back(*frame);
  }
}

TEST(SimulatedSource, GivesTheScenesFramesExactly) {
  const SceneFile scene("", "frames: 5\nframes_per_s: 50\n");
  SourceOptions options;
  options.seed = 9;
  auto source = scene.open(options);
  EXPECT_EQ(source->count(), 5U);
  EXPECT_TRUE(source->is_continuous());
  EXPECT_FALSE(source->is_live());
  EXPECT_EQ(source->frames_per_s(), 50);
  const Plan plan = plan_of(scene.text, 9);
  const auto frames = all_of(*source);
  ASSERT_EQ(frames.size(), 5U);
  for (int i = 0; i < 5; ++i) {
    const Frame& frame = *frames[static_cast<std::size_t>(i)];
    EXPECT_EQ(cv::norm(frame.grey, plan.render(i), cv::NORM_INF), 0);
    EXPECT_EQ(frame.sequence, static_cast<std::uint64_t>(i));
    EXPECT_EQ(frame.time_ns, 20'000'000 * (i + 1));
    EXPECT_EQ(frame.jpeg, nullptr);
  }
}

TEST(SimulatedSource, AJpegCameraGivesItsPackets) {
  const SceneFile scene("  - {use: mjpeg, quality: 80}\n", "frames: 3\n");
  const auto frames = all_of(*scene.open());
  ASSERT_EQ(frames.size(), 3U);
  for (const FramePtr& frame : frames) {
    ASSERT_NE(frame->jpeg, nullptr);
    EXPECT_EQ(cv::norm(cv::imdecode(*frame->jpeg, cv::IMREAD_GRAYSCALE), frame->grey, cv::NORM_INF),
              0);
  }
}

TEST(SimulatedSource, DroppedFramesLeaveAGapAndTheOthersAsTheyWere) {
  const SceneFile whole(""), gappy("  - {use: drop, share: 0.2, run: 2}\n");
  const auto all = all_of(*whole.open());
  auto source = gappy.open();
  const auto frames = all_of(*source);
  ASSERT_EQ(all.size(), 40U);
  EXPECT_EQ(gappy.open()->count(), frames.size());
  EXPECT_GT(frames.size(), 10U);
  EXPECT_LT(frames.size(), 37U);  // 0.36 of 40 get lost in the mean
  for (const FramePtr& frame : frames) {
    const FramePtr& same = all[frame->sequence];
    EXPECT_EQ(cv::norm(frame->grey, same->grey, cv::NORM_INF), 0) << "draws of its own only";
    EXPECT_EQ(frame->time_ns, same->time_ns);
  }
  // Losses come in runs of at least two.
  int alone = 0;
  for (std::size_t i = 1; i < frames.size(); ++i)
    alone += frames[i]->sequence == frames[i - 1]->sequence + 2 ? 1 : 0;
  EXPECT_EQ(alone, 0);
}

TEST(SimulatedSource, TheShareOfDroppedAndLateFramesIsWhatTheSceneSays) {
  const SceneFile scene(
      "  - {use: drop, share: 0.1}\n  - {use: late, share: 0.3, by_ms: {from: 5, to: 15}}\n");
  const Plan plan = plan_of(scene.text);
  int dropped = 0, late = 0;
  double sum_ms = 0;
  constexpr int kFrames = 20000;
  for (int i = 0; i < kFrames; ++i) {
    const Arrival arrival = plan.arrival(i);
    dropped += arrival.is_dropped ? 1 : 0;
    late += arrival.late_ms > 0 ? 1 : 0;
    sum_ms += arrival.late_ms;
    ASSERT_TRUE(arrival.late_ms == 0 || (arrival.late_ms >= 5 && arrival.late_ms <= 15));
  }
  EXPECT_NEAR(dropped, 0.1 * kFrames, 5 * std::sqrt(0.09 * kFrames));
  EXPECT_NEAR(late, 0.3 * kFrames, 5 * std::sqrt(0.21 * kFrames));
  EXPECT_NEAR(sum_ms / late, 10, 0.25);
}

TEST(SimulatedSource, FaultsThatCannotBeAreRefused) {
  for (const char* effect :
       {"{use: drop, share: 0}", "{use: drop, share: 1}", "{use: drop, share: 0.1, run: 0}",
        "{use: late, share: 0, by_ms: 3}", "{use: late, share: 0.1}"}) {
    const SceneFile scene("  - " + std::string(effect) + "\n");
    EXPECT_FALSE(open_source({scene.file}).ok()) << effect;
  }
  const SceneFile no_bytes("");
  std::ofstream(no_bytes.file) << scene_text("");
  const auto source = open_source({no_bytes.file});
  ASSERT_FALSE(source.ok());
  EXPECT_THAT(source.error().sentence(), HasSubstr("add the effect quantisation"));
}

TEST(SimulatedSource, AtTheCamerasPaceItNeverEndsAndIsNeverEarly) {
  const SceneFile scene("  - {use: late, share: 0.5, by_ms: 30}\n",
                        "frames: 2\nframes_per_s: 100\n");
  SourceOptions options;
  options.pace = Pace::kRecorded;
  auto source = scene.open(options);
  EXPECT_EQ(source->count(), std::nullopt);
  EXPECT_TRUE(source->is_live());
  const Plan plan = plan_of(scene.text, 1);
  const auto begin = Clock::now();
  // The first frame may itself be late; the count begins with it.
  const double first_ms = plan.arrival(0).late_ms;
  for (int i = 0; i < 12; ++i) {
    const auto frame = source->next();
    ASSERT_TRUE(frame.ok() && *frame);
    EXPECT_EQ((*frame)->sequence, static_cast<std::uint64_t>(i));
    const std::chrono::duration<double, std::milli> passed = Clock::now() - begin;
    EXPECT_GE(passed.count(), 10 * i + plan.arrival(i).late_ms - first_ms - 0.1);
  }
}

TEST(VideoSource, ComesAtItsRecordedPaceUntilItIsStopped) {
  const TemporaryFolder folder;
  const fs::path file = folder / "v.mkv";
  auto writer = VideoWriter::create(file, *camera_frame(0, false), VideoCodec::kMagicYuv, 30);
  ASSERT_TRUE(writer.ok());
  for (const std::int64_t time_ms : {1000, 1020, 1100, 3'600'000}) {
    Frame frame = *camera_frame(0, false);
    frame.time_ns = time_ms * 1'000'000;
    ASSERT_TRUE(writer->add(frame).ok());
  }
  ASSERT_TRUE(writer->finish().ok());
  Job job;
  SourceOptions options;
  options.pace = Pace::kRecorded;
  options.job = &job;
  auto source = open_source({file}, options);
  ASSERT_TRUE(source.ok());
  EXPECT_EQ((*source)->count(), 4U);
  const auto begin = Clock::now();
  for (int i = 0; i < 3; ++i) ASSERT_NE(*(*source)->next(), nullptr);
  EXPECT_GE(Clock::now() - begin, std::chrono::milliseconds(100));
  // The last one is due in an hour.
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    job.request_stop();
  });
  EXPECT_EQ(*(*source)->next(), nullptr);
  stopper.join();
  EXPECT_LT(Clock::now() - begin, std::chrono::minutes(1));
}

/// Gives its frames when the test lets it.
class SteppedSource : public Source {
 public:
  explicit SteppedSource(std::atomic<int>& allowed) : allowed_(allowed) {}
  Result<FramePtr> next() override {
    while (allowed_ <= given_) std::this_thread::yield();
    const int number = given_++;
    if (number == 5) return Error{en::say("the fifth is broken"), "", ""};
    if (number == 8) return FramePtr();
    return camera_frame(static_cast<std::uint32_t>(number), false);
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return 8; }
  [[nodiscard]] bool is_continuous() const override { return true; }
  [[nodiscard]] int given() const { return given_; }

 private:
  std::atomic<int>& allowed_;
  std::atomic<int> given_{0};
};

TEST(NewestSource, GivesTheNewestFrameAndCountsTheOthers) {
  std::atomic<int> allowed{1};
  auto stepped = std::make_unique<SteppedSource>(allowed);
  const SteppedSource* steps = stepped.get();
  NewestSource newest(std::move(stepped));
  EXPECT_EQ((*newest.next())->sequence, 0U);
  EXPECT_EQ(newest.skipped(), 0U);
  allowed = 5;
  while (steps->given() < 5 || newest.skipped() < 3) std::this_thread::yield();
  EXPECT_EQ((*newest.next())->sequence, 4U);
  EXPECT_EQ(newest.skipped(), 3U);
  allowed = 6;
  const auto broken = newest.next();
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.error().what.english(), "the fifth is broken");
  allowed = 8;
  while (newest.skipped() < 4) std::this_thread::yield();
  EXPECT_EQ((*newest.next())->sequence, 7U);
  allowed = 9;
  EXPECT_EQ(*newest.next(), nullptr);
  EXPECT_EQ(*newest.next(), nullptr);
}

/// As a folder of pictures gives them: no times, at once.
class UntimedSource : public Source {
 public:
  Result<FramePtr> next() override {
    if (given_ == 4) return FramePtr();
    auto frame = std::make_shared<Frame>();
    frame->sequence = given_++;
    return FramePtr(std::move(frame));
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return 4; }
  [[nodiscard]] bool is_continuous() const override { return false; }
  [[nodiscard]] double frames_per_s() const override { return 50; }

 private:
  std::uint64_t given_ = 0;
};

TEST(NewestSource, PicturesComeNoFasterThanACamerasWould) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  NewestSource newest(std::make_unique<UntimedSource>());
  std::uint64_t last = 0;
  while (const FramePtr frame = *newest.next()) last = frame->sequence;
  EXPECT_EQ(last, 3U);
  EXPECT_GE(Clock::now() - begin, std::chrono::milliseconds(80));
}

}  // namespace
}  // namespace alltact::test
