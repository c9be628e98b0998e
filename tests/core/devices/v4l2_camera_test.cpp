// The frames that a camera gives, and the faults that it says by name.
#include "tests/core/devices/fake_camera_use.h"
#include "tests/core/recording/recording_frames.h"

#include <cerrno>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;

/// The next frame of a queue; a fault or silence fails the test and gives an empty frame.
FramePtr next_of(FrameQueue& queue) {
  const auto item = queue.next(5s);
  if (item.has_value() && item->ok() && **item != nullptr) return **item;
  ADD_FAILURE() << (!item ? "nothing came" : item->ok() ? "the end" : item->error().sentence());
  return std::make_shared<Frame>();
}

std::string refusal(FakeCamera& fake, const FormatCriteria& criteria = {}) {
  const auto camera = V4l2Camera::open(place_of(fake), criteria);
  return camera.ok() ? "opened" : camera.error().sentence();
}

void expect_truth(const Frame& frame, int tolerance) {
  int worst = 0;
  for (int v = 0; v < frame.grey.rows; ++v)
    for (int u = 0; u < frame.grey.cols; ++u)
      worst =
          std::max(worst, std::abs(frame.grey.at<std::uint8_t>(v, u) -
                                   FakeCamera::truth(frame.sequence, static_cast<std::uint32_t>(u),
                                                     static_cast<std::uint32_t>(v))));
  EXPECT_LE(worst, tolerance) << frame.name;
}

TEST(V4l2Camera, EveryFrameOfEveryFormatArrivesAsItWasSeen) {
  for (const char* fourcc :
       {"GREY", "YUYV", "Y16", "MJPG", "UYVY", "NV12", "Y10", "Y12", "RGB3", "BGR3"}) {
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
      EXPECT_GT(*(**frame)->time_ns, last_ns);
      EXPECT_EQ((**frame)->jpeg != nullptr, is_jpeg);
      last_ns = *(**frame)->time_ns;
      expect_truth(***frame, is_jpeg ? 4 : 0);
    }
    EXPECT_EQ(camera->settings().format.text().english(),
              fmt::format("64x48 {} at 30 frames per second", fourcc));
    EXPECT_EQ(camera->status().delivered, 100U);
    EXPECT_EQ(camera->status().lost, 0U);
  }
}

/// The packets of H.264 from ffmpeg, one a frame: frame n is a flat grey of 60 + 5 n, and every
/// eighth needs no other.
std::vector<std::vector<std::uint8_t>> predicted_packets(int frames) {
  const auto stream = output_of(
      fmt::format("ffmpeg -v quiet -nostdin -f lavfi -i \"color=c=black:s=64x48:r=30,format=gray,"
                  "geq=lum='60+5*N'\" -frames:v {} -c:v libx264 -qp 0 -g 8 -bf 0 -pix_fmt yuvj420p "
                  "-x264-params aud=1:repeat-headers=1 -f h264 - </dev/null",
                  frames));
  const std::vector<std::uint8_t> delimiter{0, 0, 0, 1, 9};
  std::vector<std::vector<std::uint8_t>> packets;
  auto begin = stream.begin();
  while (begin != stream.end()) {
    const auto end = std::search(begin + 1, stream.end(), delimiter.begin(), delimiter.end());
    packets.emplace_back(begin, end);
    begin = end;
  }
  return packets;
}

TEST(V4l2Camera, PredictedFramesBeginWithTheFirstThatNeedsNoOther) {
  auto packets = predicted_packets(24);
  if (packets.size() != 24) GTEST_SKIP() << "ffmpeg with libx264 is not here";
  packets.erase(packets.begin(), packets.begin() + 3);  // as if switched on in between
  FakeOptions options = raw(false);
  options.packets = packets;
  FakeCamera fake(options);
  const auto camera = opened(fake, {"H264", 0, 0, 0});
  const auto queue = camera->frames().subscribe(100);
  for (std::size_t i = 0; i < packets.size(); ++i) {
    ASSERT_TRUE(comes_true([&] { return fake.buffers_to_fill() > 0; }));
    fake.produce();
    if (i < 5) continue;
    const FramePtr frame = next_of(*queue);
    ASSERT_EQ(frame->sequence, i);
    EXPECT_NEAR(cv::mean(frame->grey)[0], 60 + 5 * static_cast<double>(i + 3), 1.0) << i;
  }
  EXPECT_EQ(camera->status().damaged, 0U);
  EXPECT_EQ(camera->status().delivered, packets.size() - 5);
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
  EXPECT_EQ(camera->status().lost, 3U);
}

TEST(V4l2Camera, DamagedFramesAreCountedAndNeverShown) {
  FakeCamera fake(raw(false));
  for (const char* fourcc : {"GREY", "MJPG"}) {
    const auto camera = opened(fake, {fourcc, 0, 0, 0});
    const auto queue = camera->frames().subscribe(100);
    fake.mark_damaged(2);
    fake.produce(2);
    ASSERT_TRUE(comes_true([&] { return camera->status().damaged == 2; }));
    fake.truncate(3);
    fake.produce(3);
    ASSERT_TRUE(comes_true([&] { return camera->status().damaged == 5; }));
    fake.produce();
    EXPECT_EQ(next_of(*queue)->sequence, 5U);
    EXPECT_EQ(camera->status().delivered, 1U);
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
  EXPECT_THAT(refusal(fake), HasSubstr("does not answer like a camera"));
  fake.refuse_size(true);
  EXPECT_THAT(refusal(fake),
              AllOf(HasSubstr("64x48"), HasSubstr("was requested, but the camera chose 160x120")));
  fake.refuse_size(false);
  EXPECT_THAT(refusal(fake, {"MJPG", 1920, 1080, 0}),
              AllOf(HasSubstr("no such readable format"), HasSubstr("64x48 GREY at 200 frames")));
  EXPECT_EQ(fake.open_handles(), 0) << "nothing is left open";
  EXPECT_EQ(refusal(fake), "opened") << "after all that";
}

TEST(V4l2Camera, ANodeThatCarriesMetadataIsNoCamera) {
  FakeOptions options = raw(true);
  options.is_metadata = true;
  FakeCamera fake(options);
  EXPECT_THAT(refusal(fake), HasSubstr("delivers no readable images"));
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
  EXPECT_EQ(camera->status().restarts, 0U);
  for (const unsigned long request : {VIDIOC_DQBUF, VIDIOC_QBUF}) {
    fake.fail(request, EIO, 4);  // of QBUF: all four buffers are lost to the stream
    EXPECT_TRUE(goes_on());
  }
  fake.fail(VIDIOC_DQBUF, EIO);
  fake.fail(VIDIOC_STREAMON, EBUSY, 3);
  ASSERT_TRUE(comes_true([&] { return camera->status().restarts >= 4; }));
  EXPECT_TRUE(goes_on());
  EXPECT_FALSE(camera->status().trouble.has_value());
  EXPECT_THAT(remarks_of(*camera), Contains("Images arrive again."));
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
    EXPECT_THAT(item->error().sentence(), HasSubstr("no image arrived for 0."));
    break;
  }
  EXPECT_LT(Clock::now() - begin, 1s);
  EXPECT_EQ(camera->status().state, CameraState::kStalled);
  fake.stall(false);
  EXPECT_TRUE(comes_true([&] { return camera->status().state == CameraState::kStreaming; }));
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
        Clock::now().time_since_epoch() - std::chrono::nanoseconds(*frame->time_ns);
    ++shown;
    if (age > kPeriod + kWork) ++old;
    std::this_thread::sleep_for(kWork);
  }
  EXPECT_EQ(old, 0);
  EXPECT_GT(reader.missed(), static_cast<std::uint64_t>(shown));
}

}  // namespace
}  // namespace alltact::test
