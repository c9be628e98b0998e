// A camera that is unplugged, or is given another signal.
#include "core/recording/journal.h"
#include "core/recording/recorder.h"
#include "core/recording/video_file.h"
#include "tests/core/devices/fake_camera_use.h"
#include "tests/support/temporary_folder.h"

#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

TEST(V4l2Camera, ASourceGivesAnErrorOnUnplugAndGoesOnAfterwards) {
  FakeCamera fake(raw(true));
  const std::shared_ptr<V4l2Camera> camera = opened(fake);
  CameraSource source(camera);
  EXPECT_TRUE(source.is_continuous());
  ASSERT_TRUE(source.next().ok());
  fake.unplug();
  std::string sentence;
  std::uint64_t last = 0;
  for (int i = 0; i < 100 && sentence.empty(); ++i) {
    const auto frame = source.next();
    if (frame.ok()) {
      last = (*frame)->sequence;
    } else {
      sentence = frame.error().sentence();
    }
  }
  EXPECT_THAT(sentence, AllOf(HasSubstr("unplugged"), HasSubstr("plug it in again")));
  const auto begin = Clock::now();
  EXPECT_FALSE(source.next().ok()) << "still away";
  EXPECT_LT(Clock::now() - begin, 2s);
  fake.plug_in();
  FramePtr frame;
  for (int i = 0; i < 5 && frame == nullptr; ++i)
    if (auto item = source.next(); item.ok()) frame = *item;
  ASSERT_NE(frame, nullptr);
  EXPECT_GT(frame->sequence, last) << "numbers go on";
  camera->stop();
  int left = 0;
  while (left < 100) {
    const auto rest = source.next();
    ASSERT_TRUE(rest.ok());
    if (*rest == nullptr) break;
    ++left;
  }
  EXPECT_LE(left, 30);
}

TEST(V4l2Camera, ASignalThatChangesIsToldAndAgreedOnAnew) {
  FakeOptions options = raw(true);
  options.tells_source = true;
  FakeCamera fake(options);
  const std::shared_ptr<V4l2Camera> camera = opened(fake, {"GREY", 0, 0, 200});
  CameraSource source(camera);
  std::uint64_t last = (*source.next())->sequence;
  for (const cv::Size size : {cv::Size(64, 48), cv::Size(32, 16), cv::Size(64, 48)}) {
    fake.change_source(static_cast<std::uint32_t>(size.width),
                       static_cast<std::uint32_t>(size.height));
    const auto begin = Clock::now();
    std::string sentence;
    FramePtr frame;
    while (Clock::now() - begin < 5s && (sentence.empty() || frame == nullptr)) {
      const auto item = source.next();
      if (!item.ok()) {
        sentence = item.error().sentence();
      } else {
        if (!sentence.empty()) frame = *item;
        EXPECT_GT((*item)->sequence, last);
        last = (*item)->sequence;
      }
    }
    EXPECT_LT(Clock::now() - begin, 1s);
    EXPECT_THAT(sentence,
                AllOf(HasSubstr("signal changed"),
                      HasSubstr(fmt::format("sends {}x{} GREY", size.width, size.height))));
    ASSERT_NE(frame, nullptr);
    EXPECT_EQ(frame->grey.size(), size);
    EXPECT_THAT(*frame->controls, HasSubstr(fmt::format("Format={}x{}", size.width, size.height)));
  }
  EXPECT_EQ(camera->status().unplugged, 0U);
  EXPECT_TRUE(comes_true([&] { return camera->status().state == CameraState::kStreaming; }));
}

TEST(V4l2Camera, ARecordingGoesOnWithASignalOfTheSameSizeAndEndsWholeAtAnother) {
  FakeOptions options = raw(true);
  options.tells_source = true;
  FakeCamera fake(options);
  const std::shared_ptr<V4l2Camera> camera = opened(fake, {"GREY", 0, 0, 200});
  CameraSource source(camera);
  const TemporaryFolder folder;
  RecorderSettings settings;
  settings.reserve_mb = 0;
  const auto recorder = Recorder::start(folder / "v.mkv", settings, 200, "test");
  ASSERT_TRUE(recorder.ok()) << recorder.error().sentence();
  std::uint64_t given = 0;
  const auto record = [&](std::uint64_t until) {
    const auto end = Clock::now() + 5s;
    while (given < until && Clock::now() < end && !(*recorder)->problem()) {
      const auto frame = source.next();
      if (frame.ok() && (*recorder)->add_waiting(*frame)) ++given;
    }
  };
  record(20);
  fake.change_source(64, 48);
  record(40);
  EXPECT_FALSE((*recorder)->problem());
  EXPECT_EQ(given, 40U);
  fake.change_source(32, 16);
  record(1000);
  const Status status = (*recorder)->finish("done");
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().sentence(), HasSubstr("32 x 16, those before were 64 x 48"));
  EXPECT_GE((*recorder)->counts().recorded, 40U);
  auto video = VideoFile::open(folder / "v.mkv");
  ASSERT_TRUE(video.ok()) << video.error().sentence();
  EXPECT_EQ(video->frame_count(), (*recorder)->counts().recorded);
  EXPECT_EQ((*video->frame(39))->grey.size(), cv::Size(64, 48));
}

TEST(V4l2Camera, ASignalThatCannotBeReadIsToldAndWaitedFor) {
  FakeOptions options = raw(true);
  options.tells_source = true;
  FakeCamera fake(options);
  const std::shared_ptr<V4l2Camera> camera = opened(fake, {"GREY", 64, 48, 200});
  CameraSource source(camera);
  ASSERT_TRUE(source.next().ok());
  fake.change_source(32, 16);
  const auto trouble = [&] {
    const auto status = camera->status();
    return status.trouble ? status.trouble->sentence() : std::string();
  };
  EXPECT_TRUE(comes_true([&] {
    return trouble().find("no such readable format") != std::string::npos;
  })) << trouble();
  fake.change_source(64, 48);
  EXPECT_TRUE(comes_true([&] { return camera->status().state == CameraState::kStreaming; }));
}

TEST(V4l2Camera, FiftyUnplugsAtAnyMomentNeitherCrashNorHang) {
  FakeCamera fake(raw(true));
  const std::shared_ptr<V4l2Camera> camera = opened(fake, {"MJPG", 0, 0, 200});
  ASSERT_TRUE(camera->lock().ok());
  std::mt19937 random(20240611);
  std::uniform_int_distribution<int> moment_us(0, 30'000);
  const auto pause = [&] {
    std::this_thread::sleep_for(std::chrono::microseconds(moment_us(random)));
  };
  for (int i = 0; i < 50; ++i) {
    LatestFrameReader reader = camera->frames().reader();
    pause();
    fake.unplug();
    ASSERT_TRUE(comes_true([&] { return camera->status().state == CameraState::kGone; }, 1s)) << i;
    // A re-plug within the same moment may be over already; otherwise there is a sentence.
    const auto status = camera->status();
    ASSERT_TRUE(status.trouble.has_value());
    EXPECT_FALSE(status.trouble->sentence().empty());
    static_cast<void>(reader.next(0ms));
    pause();
    fake.plug_in();
    ASSERT_NE(reader.next(1s), nullptr) << i;
  }
  EXPECT_EQ(camera->status().unplugged, 50U);
  const auto begin = Clock::now();
  camera->stop();
  EXPECT_LT(Clock::now() - begin, 1s);
}

TEST(V4l2Camera, RepeatedPicturesAreCountedAndSaidOnce) {
  for (const char* fourcc : {"GREY", "MJPG"}) {
    FakeCamera fake(raw(false));
    const auto camera = opened(fake, {fourcc, 0, 0, 0});
    auto produce = [&, made = std::uint64_t{0}](int frames) mutable {
      fake.produce(frames);
      made += static_cast<std::uint64_t>(frames);
      return comes_true([&] { return camera->status().delivered == made; });
    };
    ASSERT_TRUE(produce(2));
    EXPECT_EQ(camera->status().repeated, 0U);
    fake.repeat(2);
    ASSERT_TRUE(produce(3));
    fake.repeat(1);
    ASSERT_TRUE(produce(2));
    EXPECT_EQ(camera->status().repeated, 3U) << fourcc;
    EXPECT_THAT(remarks_of(*camera),
                testing::ElementsAre(HasSubstr("sent an image twice (frame_00002)")));
  }
}

TEST(V4l2Camera, ANumberThatStaysIsNoRepeatedPicture) {
  FakeCamera fake(raw(false));
  const auto camera = opened(fake);
  const auto queue = camera->frames().subscribe(10);
  for (int i = 0; i < 3; ++i) {
    fake.produce();
    ASSERT_TRUE(queue->next(5s).has_value());
    fake.keep_number(1);
  }
  EXPECT_EQ(camera->status().repeated, 0U);
  EXPECT_TRUE(remarks_of(*camera).empty());
}

TEST(V4l2Camera, AClockThatIsSetBackDuringARecordingIsSaidAndLosesNothing) {
  const TemporaryFolder folder;
  FakeCamera fake(raw(false));
  const auto camera = opened(fake);
  const auto queue = camera->frames().subscribe(100);
  auto recorder = Recorder::start(folder / "x.mkv", {}, 30, "fake");
  ASSERT_TRUE(recorder.ok());
  std::int64_t last_ns = 0;
  // Not further back than any computer has run that has got here.
  for (const auto ahead : {0ms, -30000ms, 7200000ms, 0ms}) {
    fake.set_clock(ahead);
    for (int i = 0; i < 5; ++i) {
      fake.produce();
      const auto frame = queue->next(5s);
      ASSERT_TRUE(frame && frame->ok());
      const std::int64_t now_ns = Clock::now().time_since_epoch() / 1ns;
      EXPECT_GT(*(**frame)->time_ns, last_ns);
      EXPECT_LE(*(**frame)->time_ns, now_ns);
      EXPECT_GT(*(**frame)->time_ns, now_ns - 5'000'000'000);
      last_ns = *(**frame)->time_ns;
      EXPECT_TRUE((*recorder)->add(**frame));
    }
  }
  EXPECT_EQ(camera->status().mistimed, 10U);
  EXPECT_THAT(remarks_of(*camera),
              testing::ElementsAre(HasSubstr("The camera's clock was changed by -30.0 s")));
  ASSERT_TRUE((*recorder)->finish("done").ok());
  const auto journal = read_journal(journal_of(folder / "x.mkv"));
  ASSERT_TRUE(journal.ok()) << journal.error().sentence();
  EXPECT_EQ(journal->size(), 20U);
}

}  // namespace
}  // namespace alltact::test
