#include "core/sources/v4l2/v4l2_camera.h"

#include "core/recording/recorder.h"
#include "core/recording/video_file.h"
#include "tests/rigs/fake_camera.h"
#include "tests/support/temporary_folder.h"

#include <cerrno>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using test::FakeCamera;
using test::FakeOptions;
using testing::Contains;
using testing::HasSubstr;

CameraPlace place_of(FakeCamera& fake, const std::string& node = "/dev/video0") {
  return {&fake, "usb-Fake-index0", [&fake, node]() -> Result<std::string> {
            if (fake.is_plugged()) return node;
            return Error{"the camera is not there", node, "plug it in"};
          }};
}

FakeOptions raw(bool is_live) {
  FakeOptions options;
  options.fourccs = {V4L2_PIX_FMT_GREY, V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_Y16, V4L2_PIX_FMT_MJPEG};
  options.sizes = {{64, 48}};
  options.rates = {200, 30};
  options.is_live = is_live;
  return options;
}

std::unique_ptr<V4l2Camera> opened(FakeCamera& fake, const FormatWish& wish = {}) {
  auto camera = V4l2Camera::open(place_of(fake), wish);
  EXPECT_TRUE(camera.ok()) << (camera.ok() ? "" : camera.error().sentence());
  return camera.ok() ? std::move(*camera) : nullptr;
}

/// The next frame of a queue; a fault or silence fails the test and gives an empty frame.
FramePtr next_of(FrameQueue& queue) {
  const auto item = queue.next(5s);
  if (item.has_value() && item->ok() && **item != nullptr) return **item;
  ADD_FAILURE() << (!item ? "nothing came" : item->ok() ? "the end" : item->error().sentence());
  return std::make_shared<Frame>();
}

std::string refusal(FakeCamera& fake, const FormatWish& wish = {}) {
  const auto camera = V4l2Camera::open(place_of(fake), wish);
  return camera.ok() ? "opened" : camera.error().sentence();
}

/// Waits until it holds, at most `patience`.
template <class Condition>
bool comes_true(const Condition& condition, std::chrono::milliseconds patience = 5s) {
  for (const auto end = Clock::now() + patience; Clock::now() < end;) {
    if (condition()) return true;
    std::this_thread::sleep_for(2ms);
  }
  return condition();
}

void expect_truth(const Frame& frame, int tolerance) {
  int worst = 0;
  for (int v = 0; v < frame.grey.rows; ++v)
    for (int u = 0; u < frame.grey.cols; ++u)
      worst = std::max(worst,
                       std::abs(frame.grey.at<std::uint8_t>(v, u) -
                                FakeCamera::truth(frame.sequence,
                                                  static_cast<std::uint32_t>(u),
                                                  static_cast<std::uint32_t>(v))));
  EXPECT_LE(worst, tolerance) << frame.name;
}

TEST(V4l2Camera, EveryFrameOfEveryFormatArrivesAsItWasSeen) {
  for (const char* fourcc : {"GREY", "YUYV", "Y16", "MJPG"}) {
    FakeOptions options = raw(false);
    options.jpeg_quality = 100;
    FakeCamera fake(options);
    const auto camera = opened(fake, {fourcc, 0, 0, 30});
    const auto queue = camera->frames().subscribe(100);
    const bool is_jpeg = std::string(fourcc) == "MJPG";
    std::int64_t last_ns = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
      fake.produce();
      const auto frame = queue->next(5s);
      ASSERT_TRUE(frame.has_value() && frame->ok()) << fourcc;
      EXPECT_EQ((**frame)->sequence, i);
      EXPECT_EQ((**frame)->name, fmt::format("frame_{:05}", i));
      EXPECT_EQ((**frame)->origin, "usb-Fake-index0");
      EXPECT_GT((**frame)->time_ns, last_ns);
      EXPECT_EQ((**frame)->jpeg != nullptr, is_jpeg);
      last_ns = (**frame)->time_ns;
      expect_truth(***frame, is_jpeg ? 4 : 0);
    }
    EXPECT_EQ(camera->settings().format.text(),
              fmt::format("64x48 {} at 30 frames per second", fourcc));
    EXPECT_EQ(camera->status().counts.delivered, 100U);
    EXPECT_EQ(camera->status().counts.lost, 0U);
  }
}

TEST(V4l2Camera, GapsAreCountedAndNumbersStayTheCameras) {
  FakeCamera fake(raw(false));
  const auto camera = opened(fake);
  const auto queue = camera->frames().subscribe(100);
  const auto next = [&] {
    fake.produce();
    return next_of(*queue)->sequence;
  };
  EXPECT_EQ(next(), 0U);
  fake.skip(3);
  EXPECT_EQ(next(), 4U);
  EXPECT_EQ(next(), 5U);
  EXPECT_EQ(camera->status().counts.lost, 3U);
}

TEST(V4l2Camera, DamagedFramesAreCountedAndNeverShown) {
  FakeCamera fake(raw(false));
  for (const char* fourcc : {"GREY", "MJPG"}) {
    const auto camera = opened(fake, {fourcc, 0, 0, 0});
    const auto queue = camera->frames().subscribe(100);
    fake.mark_damaged(2);
    fake.produce(2);
    ASSERT_TRUE(comes_true([&] { return camera->status().counts.damaged == 2; }));
    fake.truncate(3);
    fake.produce(3);
    ASSERT_TRUE(comes_true([&] { return camera->status().counts.damaged == 5; }));
    fake.produce();
    EXPECT_EQ(next_of(*queue)->sequence, 5U);
    EXPECT_EQ(camera->status().counts.delivered, 1U);
  }
}

TEST(V4l2Camera, WhatCannotBeOpenedIsRefusedByName) {
  FakeCamera fake(raw(true));
  fake.fail_open(EACCES);
  EXPECT_THAT(refusal(fake),
              AllOf(HasSubstr("access is not allowed"), HasSubstr("70-alltact.rules")));
  fake.fail_open(EBUSY);
  EXPECT_THAT(refusal(fake), HasSubstr("another program is using it"));
  fake.fail(VIDIOC_S_FMT, EBUSY);
  EXPECT_THAT(refusal(fake), HasSubstr("another program is using it"));
  fake.fail(VIDIOC_STREAMON, ENOSPC);
  EXPECT_THAT(refusal(fake), AllOf(HasSubstr("no bandwidth left"), HasSubstr("MJPG")));
  fake.fail(VIDIOC_REQBUFS, ENOMEM);
  EXPECT_THAT(refusal(fake), HasSubstr("not enough memory"));
  fake.fail_mmap(EAGAIN);
  EXPECT_THAT(refusal(fake), HasSubstr("buffer cannot be mapped"));
  fake.fail(VIDIOC_QBUF, EIO);
  EXPECT_THAT(refusal(fake), HasSubstr("USB connection is disturbed"));
  fake.fail(VIDIOC_QUERYCAP, ENOTTY);
  EXPECT_THAT(refusal(fake), HasSubstr("does not answer as a camera"));
  fake.refuse_size(true);
  EXPECT_THAT(refusal(fake), AllOf(HasSubstr("asked for 64x48"), HasSubstr("chose 160x120")));
  fake.refuse_size(false);
  EXPECT_THAT(refusal(fake, {"MJPG", 1920, 1080, 0}),
              AllOf(HasSubstr("no such format"), HasSubstr("64x48 GREY at 200 frames")));
  EXPECT_EQ(fake.open_handles(), 0) << "nothing is left open";
  EXPECT_EQ(refusal(fake), "opened") << "after all that";
}

TEST(V4l2Camera, ANodeThatCarriesMetadataIsNoCamera) {
  FakeOptions options = raw(true);
  options.is_metadata = true;
  FakeCamera fake(options);
  EXPECT_THAT(refusal(fake), HasSubstr("gives no pictures"));
}

TEST(V4l2Camera, PassingFaultsDoNotStopTheFrames) {
  FakeCamera fake(raw(true));
  const auto camera = opened(fake);
  LatestFrameReader reader = camera->frames().reader();
  const auto goes_on = [&] { return reader.next(3s) != nullptr && reader.next(3s) != nullptr; };
  ASSERT_TRUE(goes_on());
  fake.fail(VIDIOC_DQBUF, EAGAIN, 5);
  EXPECT_TRUE(goes_on());
  fake.fail(VIDIOC_DQBUF, EINTR, 5);
  fake.fail_poll(EINTR, 5);
  EXPECT_TRUE(goes_on());
  EXPECT_EQ(camera->status().counts.restarts, 0U);
  for (const unsigned long request : {VIDIOC_DQBUF, VIDIOC_QBUF}) {
    fake.fail(request, EIO, 4);  // of QBUF: all four buffers are lost to the stream
    EXPECT_TRUE(goes_on());
  }
  fake.fail(VIDIOC_DQBUF, EIO);
  fake.fail(VIDIOC_STREAMON, EBUSY, 3);
  ASSERT_TRUE(comes_true([&] { return camera->status().counts.restarts >= 4; }));
  EXPECT_TRUE(goes_on());
  EXPECT_FALSE(camera->status().trouble.has_value());
  EXPECT_THAT(camera->status().remarks, Contains("Pictures come again."));
}

TEST(V4l2Camera, SilenceIsAFaultWithASentenceAndTheStreamIsStartedAgain) {
  FakeCamera fake(raw(true));
  const auto camera = opened(fake);
  const auto queue = camera->frames().subscribe(1000);
  ASSERT_TRUE((*queue->next(3s)).ok());
  fake.stall(true);
  const auto begin = Clock::now();
  while (true) {
    const auto item = queue->next(3s);
    ASSERT_TRUE(item.has_value());
    if (item->ok()) continue;
    EXPECT_THAT(item->error().sentence(), HasSubstr("no picture came for 0."));
    break;
  }
  EXPECT_LT(Clock::now() - begin, 1s);
  EXPECT_EQ(camera->status().state, CameraState::kStalled);
  fake.stall(false);
  EXPECT_TRUE(comes_true([&] { return camera->status().state == CameraState::kStreaming; }));
}

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
  EXPECT_EQ(camera->status().counts.unplugged, 0U);
  EXPECT_TRUE(comes_true([&] { return camera->status().state == CameraState::kStreaming; }));
}

TEST(V4l2Camera, ARecordingGoesOnWithASignalOfTheSameSizeAndEndsWholeAtAnother) {
  FakeOptions options = raw(true);
  options.tells_source = true;
  FakeCamera fake(options);
  const std::shared_ptr<V4l2Camera> camera = opened(fake, {"GREY", 0, 0, 200});
  CameraSource source(camera);
  const test::TemporaryFolder folder;
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
  EXPECT_TRUE(comes_true([&] { return trouble().find("no such format") != std::string::npos; }))
      << trouble();
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
  EXPECT_EQ(camera->status().counts.unplugged, 50U);
  const auto begin = Clock::now();
  camera->stop();
  EXPECT_LT(Clock::now() - begin, 1s);
}

TEST(V4l2Camera, ASlowReaderIsNeverShownAnOldFrame) {
  FakeOptions options = raw(true);
  options.rates = {100};
  FakeCamera fake(options);
  const auto camera = opened(fake, {"GREY", 0, 0, 0});
  constexpr auto kPeriod = 10ms;
  constexpr auto kWork = 10 * kPeriod;
  LatestFrameReader reader = camera->frames().reader();
  int shown = 0, old = 0;
  for (int i = 0; i < 15; ++i) {
    const FramePtr frame = reader.next(1s);
    ASSERT_NE(frame, nullptr);
    const std::chrono::nanoseconds age =
        Clock::now().time_since_epoch() - std::chrono::nanoseconds(frame->time_ns);
    ++shown;
    if (age > kPeriod + kWork) ++old;
    std::this_thread::sleep_for(kWork);
  }
  EXPECT_EQ(old, 0);
  EXPECT_GT(reader.missed(), static_cast<std::uint64_t>(shown));
}

TEST(V4l2Camera, TheSameSettingsAreBackAfterPluggingIn) {
  FakeCamera fake(raw(true));
  const auto camera = opened(fake, {"YUYV", 64, 48, 30});
  ASSERT_TRUE(
      camera->set_control({V4L2_CID_AUTO_WHITE_BALANCE, "White Balance, Automatic", 0}).ok());
  ASSERT_TRUE(
      camera->set_control({V4L2_CID_WHITE_BALANCE_TEMPERATURE, "White Balance Temperature", 3300})
          .ok());
  ASSERT_TRUE(camera->set_control({V4L2_CID_GAIN, "Gain", 42}).ok());
  const CameraSettings before = camera->settings();
  fake.unplug();
  ASSERT_TRUE(comes_true([&] { return camera->status().state == CameraState::kGone; }));
  EXPECT_EQ(camera->settings().controls, before.controls) << "known without the camera too";
  EXPECT_THAT(camera->set_control({V4L2_CID_GAIN, "Gain", 1}).error().what, HasSubstr("unplugged"));
  fake.plug_in();
  EXPECT_EQ(fake.control(V4L2_CID_GAIN), 10);
  ASSERT_TRUE(comes_true([&] { return camera->status().state == CameraState::kStreaming; }));
  EXPECT_EQ(fake.control(V4L2_CID_GAIN), 42);
  EXPECT_EQ(fake.control(V4L2_CID_WHITE_BALANCE_TEMPERATURE), 3300);
  const CameraSettings after = camera->settings();
  EXPECT_EQ(after.controls, before.controls);
  EXPECT_EQ(after.format, before.format);
  EXPECT_EQ(after.identity, before.identity);
}

TEST(V4l2Camera, StoredSettingsArePutBackAtTheStart) {
  FakeCamera fake(raw(true));
  std::vector<ControlValue> stored;
  {
    const auto camera = opened(fake);
    ASSERT_TRUE(camera->lock().ok());
    ASSERT_TRUE(camera->set_control({V4L2_CID_EXPOSURE_ABSOLUTE, "Exposure", 77}).ok());
    stored = camera->settings().controls;
  }
  fake.unplug();
  fake.plug_in();
  const auto camera = V4l2Camera::open(place_of(fake), {}, stored);
  ASSERT_TRUE(camera.ok());
  EXPECT_EQ(fake.control(V4L2_CID_EXPOSURE_ABSOLUTE), 77);
  EXPECT_EQ((*camera)->settings().controls, stored);
}

TEST(V4l2Camera, TheLockHoldsWhatOthersChangeWhetherTheyTellOrNot) {
  FakeCamera fake(raw(true));
  const auto camera = opened(fake);
  ASSERT_TRUE(camera->lock().ok());
  EXPECT_EQ(fake.control(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_MANUAL);
  EXPECT_EQ(fake.control(V4L2_CID_AUTO_WHITE_BALANCE), 0);
  EXPECT_EQ(fake.control(V4L2_CID_FOCUS_AUTO), 0);
  fake.set_from_outside(V4L2_CID_EXPOSURE_ABSOLUTE, 999);
  EXPECT_TRUE(comes_true([&] { return fake.control(V4L2_CID_EXPOSURE_ABSOLUTE) == 250; }, 1s));
  fake.drift(V4L2_CID_GAIN, 55);
  EXPECT_TRUE(comes_true([&] { return fake.control(V4L2_CID_GAIN) == 10; }, 3s));
  EXPECT_TRUE(comes_true([&] { return camera->status().counts.put_back == 2; }));
  EXPECT_THAT(camera->status().remarks,
              Contains("'Exposure Time, Absolute' was changed from 250 to 999 by something else; "
                       "it was put back."));
  // Our own change is no such thing.
  ASSERT_TRUE(camera->set_control({V4L2_CID_GAIN, "Gain", 20}).ok());
  std::this_thread::sleep_for(1500ms);
  EXPECT_EQ(fake.control(V4L2_CID_GAIN), 20);
  EXPECT_EQ(camera->status().counts.put_back, 2U);
  camera->unlock();
  fake.set_from_outside(V4L2_CID_GAIN, 66);
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(fake.control(V4L2_CID_GAIN), 66);
}

TEST(V4l2Camera, ControlsCarryRangesMenusAndWhoHasThemInHand) {
  FakeCamera fake(raw(true));
  const auto camera = opened(fake);
  const auto controls = camera->controls();
  ASSERT_TRUE(controls.ok());
  const auto named = [&](const std::string& name) -> const CameraControl& {
    for (const CameraControl& control : *controls)
      if (control.name == name) return control;
    throw std::runtime_error(name);
  };
  EXPECT_EQ(controls->size(), 8U) << "without the two class titles";
  const CameraControl& exposure = named("Auto Exposure");
  EXPECT_EQ(exposure.type, ControlType::kMenu);
  ASSERT_EQ(exposure.menu.size(), 2U);
  EXPECT_EQ(exposure.menu[1].value, 3);
  EXPECT_EQ(exposure.menu[1].name, "Aperture Priority Mode");
  EXPECT_EQ(exposure.value, 3);
  const CameraControl& temperature = named("White Balance Temperature");
  EXPECT_EQ(temperature.low, 2800);
  EXPECT_EQ(temperature.high, 6500);
  EXPECT_EQ(temperature.step, 10);
  EXPECT_EQ(temperature.default_value, 4600);
  EXPECT_TRUE(temperature.is_inactive);
  EXPECT_FALSE(named("Gain").is_inactive);

  const auto sentence = [&](std::uint32_t id, const char* name, std::int64_t value) {
    return camera->set_control({id, name, value}).error().sentence();
  };
  EXPECT_THAT(sentence(V4L2_CID_WHITE_BALANCE_TEMPERATURE, "Temperature", 3000),
              HasSubstr("automatic mode has it in hand"));
  EXPECT_THAT(sentence(V4L2_CID_GAIN, "Gain", 1000), HasSubstr("the camera took 100 instead"));
  EXPECT_THAT(sentence(V4L2_CID_EXPOSURE_AUTO, "Auto", 9), HasSubstr("refuses this value"));
}

TEST(ChooseFormat, TakesTheLargestThatIsFastEnoughAndLosesLeast) {
  const auto format = [](PixelFormat pixels, int width, int height, std::uint32_t rate) {
    return CameraFormat{static_cast<std::uint32_t>(pixels), width, height, 1, rate};
  };
  const std::vector<CameraFormat> offered = {format(PixelFormat::kYuyv, 1920, 1080, 5),
                                             format(PixelFormat::kMjpeg, 1920, 1080, 30),
                                             format(PixelFormat::kMjpeg, 640, 480, 30),
                                             format(PixelFormat::kYuyv, 640, 480, 30),
                                             format(PixelFormat::kGrey, 640, 480, 30),
                                             {0x34363248, 3840, 2160, 1, 30}};  // H264
  const auto chosen = [&](const FormatWish& wish) {
    const auto best = choose_format(offered, wish, "node");
    return best.ok() ? best->text() : best.error().sentence();
  };
  EXPECT_EQ(chosen({}), "1920x1080 MJPG at 30 frames per second");
  EXPECT_EQ(chosen({"", 640, 480, 0}), "640x480 GREY at 30 frames per second");
  EXPECT_EQ(chosen({"YUYV", 0, 0, 0}), "640x480 YUYV at 30 frames per second");
  EXPECT_EQ(chosen({"YUYV", 1920, 1080, 0}), "1920x1080 YUYV at 5 frames per second");
  EXPECT_THAT(chosen({"H264", 0, 0, 0}), HasSubstr("no such format"));
}

}  // namespace
}  // namespace alltact
