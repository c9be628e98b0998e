// Frames whose every byte a test can name again, and what other programs read of a file.
#pragma once

#include "core/image/frame.h"
#include "core/numerics/philox.h"

#include <cstdio>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact::test {

/// A smooth picture with noise over it, as a camera gives; a pure function of its number.
inline cv::Mat camera_picture(std::uint32_t number, cv::Size size = {64, 48}) {
  cv::Mat image(size, CV_8UC1);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; u += 4) {
      const auto bits = philox({static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(v), 0, 0},
                               {number, fnv1a("camera_picture")});
      for (int i = 0; i < 4 && u + i < size.width; ++i)
        image.at<std::uint8_t>(v, u + i) =
            static_cast<std::uint8_t>((u + i + 2 * v + 5 * static_cast<int>(number)) / 2 % 200 +
                                      static_cast<int>(bits[static_cast<std::size_t>(i)] % 16));
    }
  }
  return image;
}

inline std::vector<std::uint8_t> jpeg_of(const cv::Mat& image, int quality = 90) {
  std::vector<std::uint8_t> packet;
  cv::imencode(".jpg", image, packet, {cv::IMWRITE_JPEG_QUALITY, quality});
  return packet;
}

/// A JPEG with two zeros before each restart mark, as some cameras send.
inline std::vector<std::uint8_t> with_stray_zeros(const std::vector<std::uint8_t>& jpeg) {
  std::vector<std::uint8_t> stray;
  for (std::size_t i = 0; i < jpeg.size(); ++i) {
    const bool is_mark =
        jpeg[i] == 0xFF && i + 1 < jpeg.size() && jpeg[i + 1] >= 0xD0 && jpeg[i + 1] <= 0xD7;
    if (is_mark) stray.insert(stray.end(), 2, 0);
    stray.push_back(jpeg[i]);
  }
  return stray;
}

constexpr std::int64_t kPeriodNs = 33'333'333;

/// With or without the packet that it came in.
inline FramePtr camera_frame(std::uint32_t number, bool is_jpeg, cv::Size size = {64, 48}) {
  auto frame = std::make_shared<Frame>();
  frame->grey = camera_picture(number, size);
  if (is_jpeg) {
    frame->jpeg = std::make_shared<const std::vector<std::uint8_t>>(jpeg_of(frame->grey));
    frame->grey = cv::imdecode(*frame->jpeg, cv::IMREAD_GRAYSCALE);
  }
  frame->name = "frame";
  frame->origin = "test camera";
  frame->sequence = number;
  frame->time_ns = 5'000'000'123 + kPeriodNs * number;
  return frame;
}

/// Everything that a shell command writes to its standard output.
inline std::vector<std::uint8_t> output_of(const std::string& command) {
  std::vector<std::uint8_t> output;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return output;
  std::vector<std::uint8_t> room(1 << 16);
  while (const std::size_t got = fread(room.data(), 1, room.size(), pipe))
    output.insert(output.end(), room.begin(), room.begin() + static_cast<std::ptrdiff_t>(got));
  pclose(pipe);
  return output;
}

/// The bytes that ffmpeg reads from a video: the packets one after the other, or the grey levels.
inline std::vector<std::uint8_t> bytes_by_ffmpeg(const std::string& file, bool is_jpeg) {
  return output_of("ffmpeg -v quiet -nostdin -i '" + file + "' " +
                   (is_jpeg ? "-c copy -f mjpeg" : "-pix_fmt gray -f rawvideo -vsync passthrough") +
                   " - </dev/null");
}

/// The same of the first `count` frames.
inline std::vector<std::uint8_t> expected_bytes(std::uint32_t count, bool is_jpeg,
                                                cv::Size size = {64, 48}) {
  std::vector<std::uint8_t> bytes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const FramePtr frame = camera_frame(i, is_jpeg, size);
    if (is_jpeg)
      bytes.insert(bytes.end(), frame->jpeg->begin(), frame->jpeg->end());
    else
      bytes.insert(bytes.end(), frame->grey.datastart, frame->grey.dataend);
  }
  return bytes;
}

}  // namespace alltact::test
