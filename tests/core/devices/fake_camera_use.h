// A camera opened on a fake one, and what tests ask of it.
#pragma once

#include "core/devices/v4l2_camera.h"
#include "tests/rigs/fake_camera.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace alltact::test {

using Clock = std::chrono::steady_clock;

inline CameraAccess place_of(FakeCamera& fake, const std::string& node = "/dev/video0") {
  return {&fake, "usb-Fake-index0", [&fake, node]() -> Result<std::string> {
            if (fake.is_plugged()) return node;
            return Error{en::say("the camera is not connected"), node, en::say("plug it in")};
          }};
}

inline FakeOptions raw(bool is_live) {
  FakeOptions options;
  options.fourccs = {V4L2_PIX_FMT_GREY,  V4L2_PIX_FMT_YUYV,  V4L2_PIX_FMT_Y16, V4L2_PIX_FMT_MJPEG,
                     V4L2_PIX_FMT_UYVY,  V4L2_PIX_FMT_NV12,  V4L2_PIX_FMT_Y10, V4L2_PIX_FMT_Y12,
                     V4L2_PIX_FMT_RGB24, V4L2_PIX_FMT_BGR24, V4L2_PIX_FMT_H264};
  options.sizes = {{64, 48}};
  options.rates = {200, 30};
  options.is_live = is_live;
  return options;
}

inline std::unique_ptr<V4l2Camera> opened(FakeCamera& fake, const FormatCriteria& criteria = {}) {
  auto camera = V4l2Camera::open(place_of(fake), criteria);
  EXPECT_TRUE(camera.ok()) << (camera.ok() ? "" : camera.error().sentence());
  return camera.ok() ? std::move(*camera) : nullptr;
}

/// Waits until it holds, at most `patience`.
template <class Condition>
bool comes_true(const Condition& condition,
                std::chrono::milliseconds patience = std::chrono::seconds(5)) {
  for (const auto end = Clock::now() + patience; Clock::now() < end;) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return condition();
}

/// In English.
inline std::vector<std::string> remarks_of(const V4l2Camera& camera) {
  std::vector<std::string> remarks;
  for (const Message& remark : camera.status().remarks) remarks.push_back(remark.english());
  return remarks;
}

}  // namespace alltact::test
