// Header of an image file, checked before decoding.
#pragma once

#include "core/result.h"

#include <cstdint>
#include <string_view>

namespace alltact {

enum class ImageFormat { kPng = 1, kJpeg, kBmp, kPgm, kTiff };

struct ImageHeader {
  ImageFormat format = ImageFormat::kPng;
  std::int64_t width_px = 0, height_px = 0;
  int bits = 0;      ///< per channel
  int channels = 0;  ///< without the alpha channel
  bool is_float = false;
  bool has_transparency = false;
};

/// Reads the header and walks to the end of the image, because decoders silently fill up a
/// truncated file. Errors (without `where`): unknown format, an invalid header, a file that ends
/// too early.
[[nodiscard]] Result<ImageHeader> image_header(std::string_view content);

}  // namespace alltact
