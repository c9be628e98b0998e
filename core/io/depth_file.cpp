#include "core/io/depth_file.h"

#include "core/io/atomic_file.h"
#include "core/io/image_file.h"
#include "core/io/image_format.h"
#include "core/io/png_check_sum.h"

#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include <libdeflate.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact {
namespace {

using std::string_view_literals::operator""sv;

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
  out.resize(libdeflate_zlib_compress(
      compressor.get(), bytes.data(), bytes.size(), out.data(), out.size()));
  assert(!out.empty());
  return out;
}

void put_u32(std::string& out, std::uint32_t number) {
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    out.push_back(static_cast<char>(number >> shift & 0xFFU));
}

void put_chunk(std::string& out, std::string_view type, std::string_view data) {
  put_u32(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = out.size();
  out.append(type).append(data);
  put_u32(out, png_check_sum(std::string_view(out).substr(begin)));
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

void put_entry(std::string& out, std::uint16_t tag, std::uint16_t type, std::uint32_t value) {
  const auto put = [&](std::uint32_t number, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>(number >> (8 * i) & 0xFFU));
  };
  put(tag, 2), put(type, 2), put(1, 4), put(value, 4);
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
  put_u32(header, static_cast<std::uint32_t>(grey.cols));
  put_u32(header, static_cast<std::uint32_t>(grey.rows));
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

std::string depth_tiff(const cv::Mat& depth_mm) {
  assert(!depth_mm.empty() && depth_mm.type() == CV_32FC1);
  constexpr std::uint16_t kShort = 3, kLong = 4;
  std::string tiff("II*\0\0\0\0\0"sv);
  const std::string data = deflated(tiff_rows(depth_mm));
  tiff += data;
  if (tiff.size() % 2 != 0) tiff.push_back('\0');
  for (std::size_t i = 0; i < 4; ++i)  // offset of the directory, which follows the data
    tiff[4 + i] = static_cast<char>(tiff.size() >> (8 * i) & 0xFFU);
  tiff.append("\x0C\0"sv);
  const auto height = static_cast<std::uint32_t>(depth_mm.rows);
  put_entry(tiff, 256, kLong, static_cast<std::uint32_t>(depth_mm.cols));
  put_entry(tiff, 257, kLong, height);
  put_entry(tiff, 258, kShort, 32);  // bits per sample
  put_entry(tiff, 259, kShort, 8);   // deflate
  put_entry(tiff, 262, kShort, 1);   // black is zero
  put_entry(tiff, 273, kLong, 8);    // offset of the one strip
  put_entry(tiff, 277, kShort, 1);   // samples per pixel
  put_entry(tiff, 278, kLong, height);
  put_entry(tiff, 279, kLong, static_cast<std::uint32_t>(data.size()));
  put_entry(tiff, 284, kShort, 1);  // planes together
  put_entry(tiff, 317, kShort, 3);  // floating-point predictor
  put_entry(tiff, 339, kShort, 3);  // floating point
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
    return Error{en::say("the picture does not say that it holds depth in 16 bits"),
                 file.string(),
                 en::say("a picture of alltact reconstruct --format depth16")};
  cv::Mat steps;
  try {
    steps = cv::imdecode(
        cv::Mat(1, static_cast<int>(content->size()), CV_8UC1, const_cast<char*>(content->data())),
        cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    // Handled like an empty result.
  }
  if (steps.empty() || steps.type() != CV_16UC1)
    return Error{en::say("the picture is damaged or cut short"),
                 file.string(),
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
