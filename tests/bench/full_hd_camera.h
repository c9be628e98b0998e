// A camera that gives 1920x1080 MJPG at 30 frames a second, and the age of what comes from it.
#pragma once

#include "core/image/frame.h"
#include "tests/rigs/fake_camera.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact::test {

/// A lit face with noise: 30 to 180 grey levels, as a finger's, colour sampled at half the columns.
inline std::vector<std::uint8_t> full_hd_packet(int number) {
  cv::Mat grey(1080, 1920, CV_8UC1), noise(1080, 1920, CV_8UC1);
  for (int v = 0; v < grey.rows; ++v)
    for (int u = 0; u < grey.cols; ++u)
      grey.at<std::uint8_t>(v, u) =
          static_cast<std::uint8_t>(30 + 150 * (1920 - u) / 1920 * (540 - std::abs(v - 540)) / 540);
  for (int i = 0; i < 24; ++i)
    cv::circle(grey, {80 * i + 8 * number, i % 2 == 0 ? 200 : 880}, 9, cv::Scalar(220), -1);
  cv::RNG random(static_cast<std::uint64_t>(number) + 1);
  random.fill(noise, cv::RNG::NORMAL, 10, 1.2);
  grey += noise;
  cv::Mat colour;
  cv::cvtColor(grey, colour, cv::COLOR_GRAY2BGR);
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", colour, bytes, {cv::IMWRITE_JPEG_QUALITY, 85});
  return bytes;
}

inline FakeOptions full_hd_camera(int packets) {
  FakeOptions options;
  options.sizes = {{1920, 1080}};
  for (int i = 0; i < packets; ++i) options.packets.push_back(full_hd_packet(i));
  return options;
}

/// Since the camera's own time stamp.
inline double age_ms(const Frame& frame) {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now - std::chrono::nanoseconds(*frame.time_ns))
      .count();
}

/// share 0.5: the median.
inline double quantile(std::vector<double> values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace alltact::test
