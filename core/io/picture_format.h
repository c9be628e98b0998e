// What a picture file says of itself before anyone decodes it.
#pragma once

#include "core/result.h"

#include <cstdint>
#include <string_view>

namespace alltact {

enum class PictureFormat { kPng = 1, kJpeg, kBmp, kPgm, kTiff };

struct PictureHeader {
  PictureFormat format = PictureFormat::kPng;
  std::int64_t width_px = 0, height_px = 0;
  int bits = 0;      ///< per channel
  int channels = 0;  ///< without the transparency
  bool is_float = false;
  bool has_transparency = false;
};

/// Reads the header and walks to the end of the picture, because decoders fill up in silence what
/// a truncated file lacks. Errors (without `where`): no picture format that is known, a header
/// that makes no sense, a file that ends too early.
[[nodiscard]] Result<PictureHeader> picture_header(std::string_view content);

}  // namespace alltact
