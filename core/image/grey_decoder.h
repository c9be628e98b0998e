// Decodes a camera's bytes to an 8-bit grey image in one pass.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <memory>
#include <span>

#include <opencv2/core.hpp>

namespace alltact {

/// Pixel formats of cameras; the values are V4L2's four-character codes.
enum class PixelFormat : std::uint32_t {
  kGrey = 0x59455247,   ///< GREY: 8 bit
  kYuyv = 0x56595559,   ///< YUYV: 4:2:2, brightness in the even bytes
  kY16 = 0x20363159,    ///< Y16: 16 bit, low byte first; the image is the high byte
  kMjpeg = 0x47504A4D,  ///< MJPG: one JPEG per frame
};

/// Returns "MJPG" and the like, for any code.
[[nodiscard]] std::string fourcc_text(std::uint32_t code);
/// True for the four formats above.
[[nodiscard]] bool can_decode(std::uint32_t code);

/// Not for two threads at once.
class GreyDecoder {
 public:
  GreyDecoder();
  ~GreyDecoder();
  GreyDecoder(GreyDecoder&&) noexcept;
  GreyDecoder& operator=(GreyDecoder&&) noexcept;

  /// width_px, height_px: negotiated with the camera; stride_bytes: from row to row, unused for
  /// kMjpeg. The image owns its bytes. JPEGs are decoded to grey only, also coloured ones. Errors:
  /// fewer bytes than the image needs; a JPEG that is truncated, damaged, or of another size. Bytes
  /// behind the end of a complete JPEG are no fault: many cameras send some.
  [[nodiscard]] Result<cv::Mat> operator()(PixelFormat format, int width_px, int height_px,
                                           std::size_t stride_bytes,
                                           std::span<const std::uint8_t> bytes);

 private:
  struct Jpeg;
  [[nodiscard]] Result<cv::Mat> decode_jpeg(int width_px, int height_px,
                                            std::span<const std::uint8_t> bytes);
  [[nodiscard]] Result<cv::Mat> complete_jpeg(int width_px, int height_px,
                                              std::span<const std::uint8_t> bytes);
  std::unique_ptr<Jpeg> jpeg_;
};

}  // namespace alltact
