#include "core/image/image_file.h"

#include "core/base/atomic_file.h"
#include "core/base/letters.h"
#include "core/image/grey_range.h"
#include "core/image/jpeg.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>
#include <libdeflate.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

using std::string_view_literals::operator""sv;

enum class ImageFormat { kPng = 1, kJpeg, kBmp, kPgm, kTiff };

struct ImageHeader {
  ImageFormat format = ImageFormat::kPng;
  std::int64_t width_px = 0, height_px = 0;
  int bits = 0;      ///< per channel
  int channels = 0;  ///< without the alpha channel
  bool is_float = false;
  bool has_transparency = false;
  bool is_white_zero = false;  ///< TIFF: 0 is white
  int orientation = 0;         ///< that viewers are asked for, as in Exif; 0 and 1: as it is
};

/// Of a chunk's type and data (PNG, third edition, annex D): a CRC of polynomial 0xEDB88320.
std::uint32_t png_check_sum(std::string_view type_and_data) {
  return libdeflate_crc32(0, type_and_data.data(), type_and_data.size());
}

Error truncated() {
  return {en::say("the image is truncated"), "", en::say("copy or record it again")};
}
Error damaged_image(const Message& what) {
  return {en::at(en::say("the image is damaged"), what), "", en::say("copy or record it again")};
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
      value =
          value << 8U | static_cast<unsigned char>(content_[at + static_cast<std::size_t>(index)]);
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

constexpr std::uint32_t kOrientationTag = 274;

/// The orientation that Exif data ask for (JEITA CP-3451, 4.6.4 A); 0: none.
int exif_orientation(std::string_view exif) {
  if (exif.size() < 8) return 0;
  Bytes bytes(exif, exif[0] == 'M');
  const std::size_t directory = bytes.u32(4), entries = bytes.u16(directory);
  for (std::size_t i = 0; i < entries && !bytes.is_past_end(); ++i)
    if (const TiffEntry entry = tiff_entry(bytes, directory + 2 + 12 * i);
        entry.tag == kOrientationTag)
      return static_cast<int>(entry.value);
  return 0;
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
      case 262:
        header.is_white_zero = entry.value == 0;
        break;
      case kOrientationTag:
        header.orientation = static_cast<int>(entry.value);
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

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1A\n"sv;

/// A part of a PNG file: length, name, data, check sum.
struct PngChunk {
  std::string_view name, data, all;
};

/// Those up to the first incomplete one.
std::vector<PngChunk> png_chunks(std::string_view png) {
  constexpr std::size_t kAround = 12;  // of all but the data
  std::vector<PngChunk> chunks;
  Bytes bytes(png, true);
  for (std::size_t at = kPngSignature.size(); at + kAround <= png.size();) {
    const std::size_t length = bytes.u32(at);
    if (length > png.size() - at - kAround) break;
    chunks.push_back(
        {png.substr(at + 4, 4), png.substr(at + 8, length), png.substr(at, kAround + length)});
    at += kAround + length;
  }
  return chunks;
}

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
  for (const PngChunk& chunk : png_chunks(content)) {
    // Before the decoder, which prints its own messages on the terminal.
    const auto check_sum =
        static_cast<std::size_t>(chunk.data.data() - content.data()) + chunk.data.size();
    if (bytes.u32(check_sum) != png_check_sum(chunk.all.substr(4, 4 + chunk.data.size())))
      return damaged_image(en::say("a check sum is wrong"));
    if (chunk.name == "tRNS") header.has_transparency = true;
    if (chunk.name == "eXIf") header.orientation = exif_orientation(chunk.data);
    if (chunk.name == "IEND") return header;
  }
  return truncated();
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
    if (start != 0xFF) return damaged_image(en::say("its parts do not match"));
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
    if (length < 2) return damaged_image(en::say("its parts do not match"));
    constexpr std::uint32_t kApp1 = 0xE1;
    constexpr std::string_view kExif = "Exif\0\0"sv;
    if (const std::string_view part = content.substr(at + 4, length - 2);
        code == kApp1 && part.starts_with(kExif))
      header.orientation = exif_orientation(part.substr(kExif.size()));
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
  if (bytes.u32(14) < 40) return damaged_image(en::say("its header is of an obsolete kind"));
  header.width_px = static_cast<std::int32_t>(bytes.u32(18));
  header.height_px = std::abs(static_cast<std::int64_t>(height));
  header.bits = std::min(8, bits_per_pixel);
  header.channels = bits_per_pixel > 8 ? 3 : 1;
  header.has_transparency = bits_per_pixel == 32;
  if (header.width_px < 0) return damaged_image(en::say("its width is negative"));
  const std::size_t row =
      (static_cast<std::size_t>(header.width_px) * static_cast<std::size_t>(bits_per_pixel) + 31) /
      32 * 4;
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
    if (at == begin)
      return damaged_image(en::say("its header contains something that is no number"));
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

/// Reads the header and walks to the end of the image, because decoders silently fill up a
/// truncated file. Errors (without `where`): unknown format, an invalid header, a file that ends
/// too early.
Result<ImageHeader> image_header(std::string_view content) {
  if (content.empty())
    return Error{en::say("the file is empty"), "", en::say("copy or record it again")};
  if (content.starts_with(kPngSignature)) return png_header(content);
  if (content.starts_with("\xFF\xD8\xFF"sv)) return jpeg_header(content);
  if (content.starts_with("BM")) return bmp_header(content);
  if (content.starts_with("P5") || content.starts_with("P6")) return pgm_header(content);
  if (content.starts_with("II*\0"sv) || content.starts_with("MM\0*"sv)) return tiff_header(content);
  return Error{en::say("the file is not an image of a known kind"), "",
               en::say("PNG, JPEG, BMP, binary PGM or TIFF")};
}

constexpr std::int64_t kMaxSidePx = 16384;
constexpr double kBlack = 4;  // grey level

Error at(const std::filesystem::path& file, Error error) {
  error.where = file.string();
  return error;
}

struct Encoded {
  std::string content;
  ImageHeader header;
};

/// The file's bytes, after its header was checked for completeness and size.
Result<Encoded> read_encoded(const std::filesystem::path& file) {
  auto content = read_file(file);
  if (!content) return content.error();
  auto header = image_header(*content);
  if (!header) return at(file, header.error());
  const auto [width, height] = std::pair(header->width_px, header->height_px);
  if (width < 1 || height < 1 || width > kMaxSidePx || height > kMaxSidePx)
    return Error{en::say("the image header gives {} x {} px; a side must have 1 to {}", width,
                         height, kMaxSidePx),
                 file.string(), en::say("a smaller image, or copy it again if that size is wrong")};
  return Encoded{std::move(*content), *header};
}

/// Without the parts that pixels do not depend on, about which libpng writes to the terminal.
std::string critical_parts(std::string_view png) {
  std::string parts(kPngSignature);
  for (const PngChunk& chunk : png_chunks(png))
    if ((chunk.name[0] & 0x20) == 0 || chunk.name == "tRNS") parts += chunk.all;
  return parts;
}

/// Unchanged: the camera's pixels, also where a tag asks for a rotation. Empty where the decoder
/// gives up.
cv::Mat decode(const Encoded& encoded) {
  if (encoded.header.format == ImageFormat::kJpeg) {
    const auto channels =
        encoded.header.channels == 1 ? JpegDecoder::Channels::kGrey : JpegDecoder::Channels::kBgr;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(encoded.content.data());
    auto image = JpegDecoder()({bytes, encoded.content.size()}, channels);
    return image ? *image : cv::Mat();
  }
  std::string content = encoded.header.format == ImageFormat::kPng ? critical_parts(encoded.content)
                                                                   : encoded.content;
  cv::Mat image;
  try {
    image = cv::imdecode(cv::Mat(1, static_cast<int>(content.size()), CV_8UC1, content.data()),
                         cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
  // OpenCV turns only 8 bits round.
  if (encoded.header.is_white_zero && image.depth() == CV_16U) cv::bitwise_not(image, image);
  return image;
}

Error not_decodable(const Encoded& encoded, const std::filesystem::path& file) {
  if (encoded.header.format == ImageFormat::kTiff)
    return {en::say("the image is damaged, truncated, or of a rare kind of TIFF"), file.string(),
            en::say("copy it again, or save it as PNG")};
  return {en::say("the image is damaged or truncated"), file.string(),
          en::say("copy or record it again")};
}

std::optional<Error> unfit_for_grey(const ImageHeader& header) {
  if (header.is_float)
    return Error{en::say("the image has {} bits per channel (floating point); 8 to 16 as integers "
                         "are needed",
                         header.bits),
                 "", en::say("the camera's own images")};
  if (header.bits == 1)
    return Error{en::say("the image is black and white; 8 to 16 bits per pixel are needed"), "",
                 en::say("the camera's own images")};
  if (header.channels != 1 && header.channels != 3)
    return Error{en::say("the image has {} channels; 1 or 3 are needed", header.channels), "",
                 en::say("the image as the camera took it")};
  return std::nullopt;
}

/// Removes an opaque alpha channel. False: some of it is transparent.
bool remove_alpha(cv::Mat& image) {
  if (image.channels() != 2 && image.channels() != 4) return true;
  cv::Mat alpha;
  cv::extractChannel(image, alpha, image.channels() - 1);
  double least = 0;
  cv::minMaxLoc(alpha, &least);
  if (least < (image.depth() == CV_8U ? 255.0 : 65535.0)) return false;
  if (image.channels() == 2)
    cv::extractChannel(image, image, 0);
  else
    cv::cvtColor(image, image, cv::COLOR_BGRA2BGR);
  return true;
}

/// The upper 8 of the bits in use, which those of the images before were as well.
void reduce_to_8_bits(cv::Mat& image, ImageLook& look) {
  if (image.depth() != CV_16U) return;
  double brightest = 0;
  cv::minMaxLoc(image.reshape(1), nullptr, &brightest);
  look.bits = bits_in_use(static_cast<int>(brightest), std::max(look.bits, 10));
  // Truncated, as a camera's are.
  const double step = 1 << (look.bits - 8);
  image.convertTo(image, CV_8U, 1.0 / step, 0.5 / step - 0.5);
}

/// Mean absolute distance of the channels from grey, relative to the mean grey.
double colourfulness(const cv::Mat& bgr, const cv::Mat& grey) {
  cv::Mat three, distance;
  cv::cvtColor(grey, three, cv::COLOR_GRAY2BGR);
  cv::absdiff(bgr, three, distance);
  const cv::Scalar mean = cv::mean(distance);
  const double grey_level = cv::mean(grey)[0];
  return grey_level > 0 ? (mean[0] + mean[1] + mean[2]) / 3 / grey_level : 0;
}

Result<std::vector<unsigned char>> encode(const std::filesystem::path& file, const cv::Mat& image) {
  const std::string ending = lowered_extension(file);
  const int type = image.type();
  const bool is_png = ending == ".png" && (type == CV_8UC1 || type == CV_8UC3);
  const bool is_tiff =
      (ending == ".tif" || ending == ".tiff") && (type == CV_32FC1 || type == CV_32FC3);
  if (image.empty() || !(is_png || is_tiff)) {
    const Message kind = image.empty() ? en::say("empty") : Message::typed(cv::typeToString(type));
    return Error{en::say("cannot write this kind of image ({}) under that name", kind),
                 file.string(), en::say("'.png' for 8-bit images, '.tiff' for floating point")};
  }
  const std::vector<int> options = is_png ? std::vector<int>{cv::IMWRITE_PNG_COMPRESSION, 3}
                                          : std::vector<int>{cv::IMWRITE_TIFF_COMPRESSION, 1};
  std::vector<unsigned char> bytes;
  try {
    if (cv::imencode(ending, image, bytes, options)) return bytes;
  } catch (const cv::Exception&) {
    // Like a returned false: neither gives a reason.
  }
  return Error{en::say("could not encode the image"), file.string(), en::say("a smaller image")};
}

}  // namespace

std::vector<Message> ImageLook::remarks() const {
  std::vector<Message> remarks;
  if (bits == 16) remarks.push_back(en::say("16 bits per pixel were reduced to 8"));
  if (bits > 0 && bits < 16)
    remarks.push_back(
        en::say("of 16 bits per pixel only the lower {} are in use: these were taken "
                "as the entire range",
                bits));
  if (orientation > 1)
    remarks.push_back(
        en::say("viewers are asked to turn them (Exif orientation {}), which is not "
                "done here: the camera's orientation is a setting of the finger",
                orientation));
  return remarks;
}

Result<cv::Mat> read_grey_image(const std::filesystem::path& file, std::string* note,
                                ImageLook* look) {
  const auto encoded = read_encoded(file);
  if (!encoded) return encoded.error();
  if (auto problem = unfit_for_grey(encoded->header)) return at(file, *problem);
  cv::Mat image = decode(*encoded);
  if (image.empty()) return not_decodable(*encoded, file);
  if (!remove_alpha(image))
    return Error{en::say("the image has transparent parts; a camera image has none"), file.string(),
                 en::say("the image as the camera took it, without an alpha channel")};
  ImageLook own;
  ImageLook& of_all = look != nullptr ? *look : own;
  reduce_to_8_bits(image, of_all);
  // The decoded type counts, not the header's.
  if (image.type() != CV_8UC1 && image.type() != CV_8UC3)
    return Error{en::say("this kind of image cannot be used ({})",
                         std::string(cv::typeToString(image.type()))),
                 file.string(), en::say("8-bit grey images")};
  if (image.channels() == 3) {
    cv::Mat grey;
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
    if (const double colour = colourfulness(image, grey); colour > kMaxColour)
      return Error{en::say("the image is in colour: its channels differ from grey by {:.0f} %",
                           100 * colour),
                   file.string(), en::say("an image of the finger under white light")};
    image = grey;
  }
  double brightest = 0;
  cv::minMaxLoc(image, nullptr, &brightest);
  if (brightest <= kBlack)
    return Error{en::say("the image is all black"), file.string(),
                 en::say("switch on the light, or take off the lens cap")};
  of_all.orientation = std::max(of_all.orientation, encoded->header.orientation);
  if (note != nullptr) *note = note_of(encoded->content);
  return image;
}

Status write_image(const std::filesystem::path& file, const cv::Mat& image, std::string_view note) {
  const auto bytes = encode(file, image);
  if (!bytes) return bytes.error();
  const std::string_view content(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  if (note.empty()) return write_file_atomically(file, content);
  assert(image.depth() == CV_8U);  // a PNG
  return write_file_atomically(file, with_note(content, note));
}

Result<cv::Mat> read_float_image(const std::filesystem::path& file) {
  const auto encoded = read_encoded(file);
  if (!encoded) return encoded.error();
  const ImageHeader& header = encoded->header;
  if (header.format != ImageFormat::kTiff || !header.is_float || header.bits != 32 ||
      (header.channels != 1 && header.channels != 3))
    return Error{en::say("the image is no 32-bit floating-point TIFF with 1 or 3 channels"),
                 file.string(), en::say("a depth or points image written by this program")};
  cv::Mat image = decode(*encoded);
  if (image.empty()) return not_decodable(*encoded, file);
  if (image.type() != CV_32FC1 && image.type() != CV_32FC3) return not_decodable(*encoded, file);
  return image;
}

namespace {

constexpr std::size_t kHeaderEnd = 33;  // signature, then the chunk IHDR
// Keyword; then neither compressed, nor in a language, nor with a translated keyword.
constexpr std::string_view kBefore = "AllTact settings\0\0\0\0\0"sv;

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    bytes.push_back(static_cast<char>(number >> shift & 0xFFU));
  return bytes;
}

}  // namespace

std::string with_note(std::string_view png, std::string_view note) {
  std::string chunk = "iTXt";
  chunk.append(kBefore).append(note);
  std::string content(png.substr(0, kHeaderEnd));
  content += big_endian(static_cast<std::uint32_t>(chunk.size() - 4));
  content += chunk;
  content += big_endian(png_check_sum(chunk));
  return content.append(png.substr(kHeaderEnd));
}

std::string note_of(std::string_view png) {
  if (!png.starts_with(kPngSignature)) return {};
  for (const PngChunk& chunk : png_chunks(png))
    if (chunk.name == "iTXt" && chunk.data.starts_with(kBefore))
      return std::string(chunk.data.substr(kBefore.size()));
  return {};
}

namespace {

constexpr std::string_view kDepthKeyword = "AllTact depth";
constexpr int kQuickest = 1;  // level of compression: higher ones cannot reduce the noise in the
                              // low bits

struct CompressorDeleter {
  void operator()(libdeflate_compressor* compressor) const {
    libdeflate_free_compressor(compressor);
  }
};

/// A zlib stream of the bytes.
std::string deflated(const std::vector<std::uint8_t>& bytes) {
  thread_local const std::unique_ptr<libdeflate_compressor, CompressorDeleter> compressor(
      libdeflate_alloc_compressor(kQuickest));
  if (!compressor) throw std::bad_alloc();
  std::string out(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
  out.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), out.data(),
                                      out.size()));
  assert(!out.empty());
  return out;
}

void put_chunk(std::string& out, std::string_view type, std::string_view data) {
  out += big_endian(static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = out.size();
  out.append(type).append(data);
  out += big_endian(png_check_sum(std::string_view(out).substr(begin)));
}

/// Rows after the filter `sub`: each sample minus the one before it, byte by byte.
std::vector<std::uint8_t> png_rows(const cv::Mat& grey) {
  const std::size_t bytes = grey.elemSize(), width = static_cast<std::size_t>(grey.cols);
  const std::size_t row_bytes = bytes * width;
  std::vector<std::uint8_t> rows(static_cast<std::size_t>(grey.rows) * (1 + row_bytes));
  std::vector<std::uint8_t> row(row_bytes);
  for (int v = 0; v < grey.rows; ++v) {
    if (bytes == 1) {
      std::copy_n(grey.ptr<std::uint8_t>(v), width, row.data());
    } else {
      const auto* values = grey.ptr<std::uint16_t>(v);
      for (std::size_t u = 0; u < width; ++u) {
        row[2 * u] = static_cast<std::uint8_t>(values[u] >> 8U);
        row[2 * u + 1] = static_cast<std::uint8_t>(values[u]);
      }
    }
    std::uint8_t* out = rows.data() + static_cast<std::size_t>(v) * (1 + row_bytes);
    *out++ = 1;
    std::copy_n(row.data(), bytes, out);
    for (std::size_t i = bytes; i < row_bytes; ++i)
      out[i] = static_cast<std::uint8_t>(row[i] - row[i - bytes]);
  }
  return rows;
}

/// Floating-point predictor: each row's bytes by significance, highest first, each minus the one
/// before.
std::vector<std::uint8_t> tiff_rows(const cv::Mat& depth_mm) {
  const auto width = static_cast<std::size_t>(depth_mm.cols);
  std::vector<std::uint8_t> rows(static_cast<std::size_t>(depth_mm.rows) * 4 * width);
  std::vector<std::uint8_t> apart(4 * width);
  for (int v = 0; v < depth_mm.rows; ++v) {
    const auto* values = depth_mm.ptr<float>(v);
    for (std::size_t u = 0; u < width; ++u) {
      const auto bits = std::bit_cast<std::uint32_t>(values[u]);
      for (unsigned byte = 0; byte < 4; ++byte)
        apart[byte * width + u] = static_cast<std::uint8_t>(bits >> (24 - 8 * byte));
    }
    std::uint8_t* out = rows.data() + static_cast<std::size_t>(v) * 4 * width;
    out[0] = apart[0];
    for (std::size_t i = 1; i < apart.size(); ++i)
      out[i] = static_cast<std::uint8_t>(apart[i] - apart[i - 1]);
  }
  return rows;
}

void put_number(std::string& out, std::uint32_t number, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>(number >> (8 * i) & 0xFFU));
}

/// `value`: the number, or where `count` of them are.
void put_entry(std::string& out, std::uint16_t tag, std::uint16_t type, std::uint32_t value,
               std::uint32_t count = 1) {
  put_number(out, tag, 2), put_number(out, type, 2);
  put_number(out, count, 4), put_number(out, value, 4);
}

/// The description by which ImageJ knows the axes.
std::string axes_of(const PixelsOnPlane& plane) {
  return fmt::format("ImageJ=1.53t\nunit=mm\nxorigin={:.6f}\nyorigin={:.6f}\n",
                     -plane.first_column_mm / plane.step_mm, -plane.first_row_mm / plane.step_mm);
}

/// The content of the tEXt chunk with this keyword; empty where there is none.
std::string_view text_of_png(std::string_view png, std::string_view keyword) {
  const auto number = [&](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8U | static_cast<unsigned char>(png[at + i]);
    return value;
  };
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::size_t length = number(at);
    if (length > png.size() - at - 12) return {};
    const std::string_view data = png.substr(at + 8, length);
    if (png.substr(at + 4, 4) == "tEXt"sv && data.size() > keyword.size() &&
        data.starts_with(keyword) && data[keyword.size()] == '\0')
      return data.substr(keyword.size() + 1);
    at += 12 + length;
  }
  return {};
}

}  // namespace

cv::Mat depth_steps(const cv::Mat& depth_mm) {
  assert(depth_mm.type() == CV_32FC1);
  cv::Mat steps(depth_mm.size(), CV_16UC1);
  constexpr auto kPerMm = static_cast<float>(1 / kDepthStep_mm);
  for (int v = 0; v < steps.rows; ++v) {
    const auto* from = depth_mm.ptr<float>(v);
    auto* to = steps.ptr<std::uint16_t>(v);
    for (int u = 0; u < steps.cols; ++u) {
      const float value = from[u] * kPerMm + (static_cast<float>(kDepthZero) + 0.5F);
      // Also false for NaN. Truncation after adding a half rounds.
      const float clamped = std::min(std::max(value, 1.0F), 65535.0F);
      to[u] = value == value ? static_cast<std::uint16_t>(static_cast<int>(clamped)) : 0;
    }
  }
  return steps;
}

cv::Mat depth_of_steps(const cv::Mat& steps) {
  assert(steps.type() == CV_16UC1);
  cv::Mat depth_mm(steps.size(), CV_32FC1);
  for (int v = 0; v < steps.rows; ++v)
    for (int u = 0; u < steps.cols; ++u) {
      const int value = steps.at<std::uint16_t>(v, u);
      depth_mm.at<float>(v, u) = value == 0
                                     ? std::numeric_limits<float>::quiet_NaN()
                                     : static_cast<float>(kDepthStep_mm * (value - kDepthZero));
    }
  return depth_mm;
}

std::string grey_png(const cv::Mat& grey, std::string_view keyword, std::string_view text) {
  assert(!grey.empty() && (grey.type() == CV_8UC1 || grey.type() == CV_16UC1));
  std::string png("\x89PNG\r\n\x1A\n"sv), header;
  header += big_endian(static_cast<std::uint32_t>(grey.cols));
  header += big_endian(static_cast<std::uint32_t>(grey.rows));
  header.push_back(static_cast<char>(8 * grey.elemSize()));
  header.append("\0\0\0\0"sv);  // grey; deflate, the standard filters, not interlaced
  put_chunk(png, "IHDR", header);
  if (!text.empty()) put_chunk(png, "tEXt", std::string(keyword).append(1, '\0').append(text));
  put_chunk(png, "IDAT", deflated(png_rows(grey)));
  put_chunk(png, "IEND", {});
  return png;
}

std::string depth_png(const cv::Mat& depth_mm) {
  return grey_png(depth_steps(depth_mm), kDepthKeyword, kDepthSentence);
}

std::string depth_tiff(const cv::Mat& depth_mm, const std::optional<PixelsOnPlane>& plane) {
  assert(!depth_mm.empty() && depth_mm.type() == CV_32FC1);
  constexpr std::uint16_t kText = 2, kShort = 3, kLong = 4, kRational = 5;
  std::string tiff("II*\0\0\0\0\0"sv);
  const std::string data = deflated(tiff_rows(depth_mm));
  tiff += data;
  if (tiff.size() % 2 != 0) tiff.push_back('\0');
  const std::string axes = plane ? axes_of(*plane) : std::string();
  const auto axes_at = static_cast<std::uint32_t>(tiff.size());
  tiff.append(axes).append(1 + (axes.size() + 1) % 2, '\0');
  const auto resolution_at = static_cast<std::uint32_t>(tiff.size());
  constexpr std::uint32_t kPerMillion = 1'000'000;
  if (plane) {
    put_number(tiff, static_cast<std::uint32_t>(std::lround(kPerMillion / plane->step_mm)), 4);
    put_number(tiff, kPerMillion, 4);
  }
  for (std::size_t i = 0; i < 4; ++i)  // offset of the directory, which follows the data
    tiff[4 + i] = static_cast<char>(tiff.size() >> (8 * i) & 0xFFU);
  put_number(tiff, plane ? 16 : 12, 2);
  const auto height = static_cast<std::uint32_t>(depth_mm.rows);
  put_entry(tiff, 256, kLong, static_cast<std::uint32_t>(depth_mm.cols));
  put_entry(tiff, 257, kLong, height);
  put_entry(tiff, 258, kShort, 32);  // bits per sample
  put_entry(tiff, 259, kShort, 8);   // deflate
  put_entry(tiff, 262, kShort, 1);   // black is zero
  if (plane) put_entry(tiff, 270, kText, axes_at, static_cast<std::uint32_t>(axes.size()) + 1);
  put_entry(tiff, 273, kLong, 8);   // offset of the one strip
  put_entry(tiff, 277, kShort, 1);  // samples per pixel
  put_entry(tiff, 278, kLong, height);
  put_entry(tiff, 279, kLong, static_cast<std::uint32_t>(data.size()));
  if (plane)
    for (const auto side : {std::uint16_t{282}, std::uint16_t{283}})
      put_entry(tiff, side, kRational, resolution_at);
  put_entry(tiff, 284, kShort, 1);             // planes together
  if (plane) put_entry(tiff, 296, kShort, 1);  // the unit is that of the description
  put_entry(tiff, 317, kShort, 3);             // floating-point predictor
  put_entry(tiff, 339, kShort, 3);             // floating point
  return tiff.append("\0\0\0\0"sv);
}

Result<cv::Mat> read_depth_png(const std::filesystem::path& file) {
  const auto content = read_file(file);
  if (!content) return content.error();
  const auto header = image_header(*content);
  if (!header) return Error{header.error().what, file.string(), header.error().advice};
  constexpr std::int64_t kMaxSide_px = 16384;
  if (header->format != ImageFormat::kPng || header->bits != 16 || header->channels != 1 ||
      header->has_transparency || header->width_px < 1 || header->height_px < 1 ||
      header->width_px > kMaxSide_px || header->height_px > kMaxSide_px ||
      text_of_png(*content, kDepthKeyword) != kDepthSentence)
    return Error{en::say("the image is not marked as depth in 16 bits"), file.string(),
                 en::say("an image from alltact reconstruct --format depth16")};
  cv::Mat steps;
  try {
    steps = cv::imdecode(
        cv::Mat(1, static_cast<int>(content->size()), CV_8UC1, const_cast<char*>(content->data())),
        cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    // Handled like an empty result.
  }
  if (steps.empty() || steps.type() != CV_16UC1)
    return Error{en::say("the image is damaged or truncated"), file.string(),
                 en::say("copy or record it again")};
  return depth_of_steps(steps);
}

Result<cv::Mat> read_frame_depth(const std::filesystem::path& folder, const std::string& name) {
  const auto small = folder / (name + ".depth16.png"), exact = folder / (name + ".depth.tiff");
  std::error_code ignored;
  if (!std::filesystem::exists(exact, ignored) && std::filesystem::exists(small, ignored))
    return read_depth_png(small);
  return read_float_image(exact);
}

}  // namespace alltact
