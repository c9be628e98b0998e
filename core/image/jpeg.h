// Decodes JPEGs of cameras and files, and counts their damage.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <memory>
#include <span>

#include <opencv2/core.hpp>

namespace alltact {

/// Not for two threads at once.
class JpegDecoder {
 public:
  JpegDecoder();
  ~JpegDecoder();
  JpegDecoder(JpegDecoder&&) noexcept;
  JpegDecoder& operator=(JpegDecoder&&) noexcept;

  enum class Channels { kGrey = 1, kBgr = 3 };

  /// The image, CV_8UC1 or CV_8UC3, in its own memory; grey of a coloured JPEG is its luma. Stray
  /// bytes that cost no pixel are no fault: before the end of the image and behind it, and zeros
  /// before restart marks, as some cameras send. Errors, without `where`: no JPEG, a side
  /// of more than 16384 px, truncated, damaged, no such colours (CMYK).
  [[nodiscard]] Result<cv::Mat> operator()(std::span<const std::uint8_t> bytes, Channels channels);
  /// Images so far with stray bytes before restart marks.
  [[nodiscard]] std::uint64_t stray() const { return stray_; }

 private:
  struct State;
  std::unique_ptr<State> state_;
  std::uint64_t stray_ = 0;
};

}  // namespace alltact
