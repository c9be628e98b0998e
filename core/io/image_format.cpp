#include "core/io/image_format.h"

#include "core/io/png_check_sum.h"

namespace alltact {
namespace {

using std::string_view_literals::operator""sv;

Error truncated() {
  return {en::say("the picture is cut short"), "", en::say("copy or record it again")};
}
Error damaged_image(const Message& what) {
  return {en::at(en::say("the picture is damaged"), what), "", en::say("copy or record it again")};
}

/// Numbers at offsets of a file; reading past the end returns 0 and sets is_past_end().
class Bytes {
 public:
  Bytes(std::string_view content, bool is_big_endian)
      : content_(content), is_big_endian_(is_big_endian) {}

  [[nodiscard]] std::uint32_t number(std::size_t at, int size) {
    if (at > content_.size() || content_.size() - at < static_cast<std::size_t>(size)) {
      is_past_end_ = true;
      return 0;
    }
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) {
      const int index = is_big_endian_ ? i : size - 1 - i;
      value = value << 8U | static_cast<unsigned char>(content_[at + index]);
    }
    return value;
  }
  [[nodiscard]] std::uint32_t u8(std::size_t at) { return number(at, 1); }
  [[nodiscard]] std::uint32_t u16(std::size_t at) { return number(at, 2); }
  [[nodiscard]] std::uint32_t u32(std::size_t at) { return number(at, 4); }
  [[nodiscard]] std::size_t size() const { return content_.size(); }
  [[nodiscard]] bool is_past_end() const { return is_past_end_; }

 private:
  std::string_view content_;
  bool is_big_endian_;
  bool is_past_end_ = false;
};

Result<ImageHeader> png_header(std::string_view content) {
  Bytes bytes(content, true);
  ImageHeader header{ImageFormat::kPng};
  if (content.size() < 33) return truncated();
  if (content.substr(12, 4) != "IHDR")
    return damaged_image(en::say("it does not begin with its header"));
  header.width_px = bytes.u32(16);
  header.height_px = bytes.u32(20);
  header.bits = static_cast<int>(bytes.u8(24));
  const std::uint32_t colour_type = bytes.u8(25);
  header.channels = (colour_type & 2U) != 0 ? 3 : 1;
  header.has_transparency = (colour_type & 4U) != 0;
  for (std::size_t at = 8;;) {  // length, name, data, check sum
    const std::size_t length = bytes.u32(at);
    if (bytes.is_past_end() || content.size() - at < 12 || content.size() - at - 12 < length)
      return truncated();
    const std::string_view name = content.substr(at + 4, 4);
    // Before the decoder, which prints its own messages on the terminal.
    if (bytes.u32(at + 8 + length) != png_check_sum(content.substr(at + 4, 4 + length)))
      return damaged_image(en::say("a check sum is wrong"));
    if (name == "tRNS") header.has_transparency = true;
    if (name == "IEND") return header;
    at += 12 + length;
  }
}

/// Offset of the marker behind the entropy-coded data that begins at `at`.
std::size_t end_of_scan(std::string_view content, std::size_t at) {
  while (at + 1 < content.size()) {
    at = content.find('\xFF', at);
    if (at == std::string_view::npos || at + 1 >= content.size()) return content.size();
    const auto code = static_cast<unsigned char>(content[at + 1]);
    const bool is_data = code == 0 || (code >= 0xD0 && code <= 0xD7);  // stuffing, restart
    if (!is_data && code != 0xFF) return at;
    at += code == 0xFF ? 1 : 2;
  }
  return content.size();
}

Result<ImageHeader> jpeg_header(std::string_view content) {
  Bytes bytes(content, true);
  ImageHeader header{ImageFormat::kJpeg};
  for (std::size_t at = 2;;) {
    const std::uint32_t start = bytes.u8(at), code = bytes.u8(at + 1);
    if (bytes.is_past_end()) return truncated();
    if (start != 0xFF) return damaged_image(en::say("its parts do not join"));
    if (code == 0xFF) {  // fill byte
      ++at;
      continue;
    }
    if (code == 0xD9) {  // end of image
      if (header.width_px == 0) return damaged_image(en::say("it has no header"));
      return header;
    }
    const std::size_t length = bytes.u16(at + 2);
    if (bytes.is_past_end() || at + 2 + length > content.size()) return truncated();
    if (length < 2) return damaged_image(en::say("its parts do not join"));
    const bool is_frame =
        code >= 0xC0 && code <= 0xCF && code != 0xC4 && code != 0xC8 && code != 0xCC;
    if (is_frame) {
      header.bits = static_cast<int>(bytes.u8(at + 4));
      header.height_px = bytes.u16(at + 5);
      header.width_px = bytes.u16(at + 7);
      header.channels = static_cast<int>(bytes.u8(at + 9));
    }
    at += 2 + length;
    if (code == 0xDA) at = end_of_scan(content, at);
  }
}

Result<ImageHeader> bmp_header(std::string_view content) {
  Bytes bytes(content, false);
  ImageHeader header{ImageFormat::kBmp};
  const std::size_t data = bytes.u32(10), declared_size = bytes.u32(2);
  const auto height = static_cast<std::int32_t>(bytes.u32(22));
  const int bits_per_pixel = static_cast<int>(bytes.u16(28));
  const std::uint32_t compression = bytes.u32(30);
  if (bytes.is_past_end()) return truncated();
  if (bytes.u32(14) < 40) return damaged_image(en::say("its header is of a kind no longer in use"));
  header.width_px = static_cast<std::int32_t>(bytes.u32(18));
  header.height_px = std::abs(static_cast<std::int64_t>(height));
  header.bits = 8;
  header.channels = bits_per_pixel > 8 ? 3 : 1;
  header.has_transparency = bits_per_pixel == 32;
  if (header.width_px < 0) return damaged_image(en::say("its width is negative"));
  const std::size_t row =
      (static_cast<std::size_t>(header.width_px) * bits_per_pixel + 31) / 32 * 4;
  const std::size_t needed =
      compression == 0 ? data + row * static_cast<std::size_t>(header.height_px) : declared_size;
  if (content.size() < needed) return truncated();
  return header;
}

/// Portable grey maps and pixmaps, binary.
Result<ImageHeader> pgm_header(std::string_view content) {
  ImageHeader header{ImageFormat::kPgm};
  header.channels = content[1] == '6' ? 3 : 1;
  std::size_t at = 2;
  std::array<std::int64_t, 3> numbers{};  // width, height, value of white
  for (std::int64_t& number : numbers) {
    while (at < content.size() &&
           (std::isspace(static_cast<unsigned char>(content[at])) != 0 || content[at] == '#'))
      at = content[at] == '#' ? content.find('\n', at) : at + 1;  // a comment ends with its line
    if (at >= content.size()) return truncated();
    const std::size_t begin = at;
    for (; at < content.size() && content[at] >= '0' && content[at] <= '9'; ++at)
      number = std::min<std::int64_t>(10 * number + (content[at] - '0'), 1 << 30);
    if (at == begin) return damaged_image(en::say("its header holds something that is no number"));
  }
  header.width_px = numbers[0];
  header.height_px = numbers[1];
  header.bits = numbers[2] > 255 ? 16 : 8;
  if (numbers[2] < 255) return damaged_image(en::say("its white is not 255"));
  const auto sample = header.channels * (header.bits / 8);
  const std::int64_t left =
      static_cast<std::int64_t>(content.size()) - static_cast<std::int64_t>(at) - 1;
  if (header.width_px > 0 && header.height_px > left / header.width_px / sample) return truncated();
  return header;
}

/// One entry of a TIFF's directory: its tag, and its first value.
struct TiffEntry {
  std::uint32_t tag, value;
};

/// Reads the last byte of the entry's values, so that a missing one is detected.
TiffEntry tiff_entry(Bytes& bytes, std::size_t at) {
  static constexpr std::array<std::size_t, 13> kSizes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8};
  constexpr std::uint32_t kShort = 3;
  const std::uint32_t type = bytes.u16(at + 2);
  const std::size_t size = bytes.u32(at + 4) * (type < kSizes.size() ? kSizes[type] : 0);
  const std::size_t position = size <= 4 ? at + 8 : bytes.u32(at + 8);
  if (size > 0) static_cast<void>(bytes.u8(position + size - 1));
  return {bytes.u16(at), type == kShort ? bytes.u16(position) : bytes.u32(position)};
}

Result<ImageHeader> tiff_header(std::string_view content) {
  Bytes bytes(content, content[0] == 'M');
  ImageHeader header{ImageFormat::kTiff};
  header.bits = 1;
  header.channels = 1;
  const std::size_t directory = bytes.u32(4);
  const std::size_t entries = bytes.u16(directory);
  for (std::size_t i = 0; i < entries && !bytes.is_past_end(); ++i) {
    const TiffEntry entry = tiff_entry(bytes, directory + 2 + 12 * i);
    switch (entry.tag) {
      case 256:
        header.width_px = entry.value;
        break;
      case 257:
        header.height_px = entry.value;
        break;
      case 258:
        header.bits = static_cast<int>(entry.value);
        break;
      case 277:
        header.channels = static_cast<int>(entry.value);
        break;
      case 338:
        header.has_transparency = true;
        break;
      case 339:
        header.is_float = entry.value == 3;
        break;
      default:
        break;
    }
  }
  static_cast<void>(bytes.u32(directory + 2 + 12 * entries));  // offset of the next image
  // Completeness of the pixels is checked by the decoder, which does complain here.
  if (bytes.is_past_end() || entries == 0) return truncated();
  return header;
}

}  // namespace

Result<ImageHeader> image_header(std::string_view content) {
  if (content.empty())
    return Error{en::say("the file is empty"), "", en::say("copy or record it again")};
  if (content.starts_with("\x89PNG\r\n\x1A\n"sv)) return png_header(content);
  if (content.starts_with("\xFF\xD8\xFF"sv)) return jpeg_header(content);
  if (content.starts_with("BM")) return bmp_header(content);
  if (content.starts_with("P5") || content.starts_with("P6")) return pgm_header(content);
  if (content.starts_with("II*\0"sv) || content.starts_with("MM\0*"sv)) return tiff_header(content);
  return Error{en::say("the file is no picture of a kind that is known here"),
               "",
               en::say("PNG, JPEG, BMP, binary PGM or TIFF")};
}

}  // namespace alltact
