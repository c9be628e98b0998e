// Decodes a camera's bytes to an 8-bit grey image in one pass.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Pixel formats of cameras; the values are V4L2's four-character codes. Luma is taken as it is.
enum class PixelFormat : std::uint32_t {
  kGrey = 0x59455247,    ///< GREY: 8 bit
  kY10 = 0x20303159,     ///< Y10, Y12, Y14: 16 bits, low byte first, of which so many are used
  kY12 = 0x20323159,     ///<
  kY14 = 0x20343159,     ///<
  kY16 = 0x20363159,     ///< Y16: the same; many cameras use fewer, see GreyDecoder::remarks()
  kYuyv = 0x56595559,    ///< YUYV, YVYU: 4:2:2, brightness in the first bytes
  kYvyu = 0x55595659,    ///<
  kUyvy = 0x59565955,    ///< UYVY, VYUY: brightness in the second bytes
  kVyuy = 0x59555956,    ///<
  kNv12 = 0x3231564E,    ///< NV12, NV21, YU12, YV12: 4:2:0, brightness first
  kNv21 = 0x3132564E,    ///<
  kYu12 = 0x32315559,    ///<
  kYv12 = 0x32315659,    ///<
  kRgb24 = 0x33424752,   ///< RGB3: 8 bits each
  kBgr24 = 0x33524742,   ///< BGR3: in reverse order
  kBgrx32 = 0x34325258,  ///< XR24: blue, green, red and nothing
  kMjpeg = 0x47504A4D,   ///< MJPG, JPEG: one JPEG per frame
  kJpeg = 0x4745504A,    ///<
  kH264 = 0x34363248,    ///< H264: predicted from frames before
};

/// Returns "MJPG" and the like, for any code.
[[nodiscard]] std::string fourcc_text(std::uint32_t code);
/// True for the formats above.
[[nodiscard]] bool can_decode(std::uint32_t code);
/// True where a frame is one complete JPEG.
[[nodiscard]] bool is_jpeg(PixelFormat format);

/// Of one camera. Not for two threads at once.
class GreyDecoder {
 public:
  GreyDecoder();
  ~GreyDecoder();
  GreyDecoder(GreyDecoder&&) noexcept;
  GreyDecoder& operator=(GreyDecoder&&) noexcept;

  /// width_px, height_px: negotiated with the camera; stride_bytes: from row to row, unused for
  /// compressed formats. The image owns its bytes; it is empty where a predicted one cannot be
  /// shown yet. JPEGs are decoded to grey only, also coloured ones (jpeg.h). Errors: fewer bytes
  /// than the image needs; a compressed one that is truncated, damaged, or of another size.
  [[nodiscard]] Result<cv::Mat> operator()(PixelFormat format, int width_px, int height_px,
                                           std::size_t stride_bytes,
                                           std::span<const std::uint8_t> bytes);

  /// The camera's stream begins anew: what comes next is not predicted from what came before.
  void restart();

  /// What was assumed about the images so far, a sentence without full stop each.
  [[nodiscard]] const std::vector<Message>& remarks() const { return remarks_; }

 private:
  struct Compressed;
  [[nodiscard]] Result<cv::Mat> decode_jpeg(int width_px, int height_px,
                                            std::span<const std::uint8_t> bytes);
  [[nodiscard]] Result<cv::Mat> decode_h264(int width_px, int height_px,
                                            std::span<const std::uint8_t> bytes);
  [[nodiscard]] int bits_of(PixelFormat format, int width_px, int height_px,
                            std::size_t stride_bytes, std::span<const std::uint8_t> bytes);

  std::unique_ptr<Compressed> compressed_;
  int y16_bits_ = 0;  // in use so far
  std::vector<Message> remarks_;
};

}  // namespace alltact
