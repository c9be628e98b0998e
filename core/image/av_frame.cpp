#include "core/image/av_frame.h"

#include "core/image/grey_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <string_view>

extern "C" {
#include <libavutil/log.h>
#include <libavutil/pixdesc.h>
}

namespace alltact {
namespace {

/// Luma with chroma; alone, with or without transparency, it is grey.
bool is_luma(const AVPixFmtDescriptor& format) {
  return format.nb_components >= 3 && (format.flags & AV_PIX_FMT_FLAG_RGB) == 0;
}

/// One component of every pixel of a row, 16 bits each; of chroma as many as it has.
void read_component(const AVFrame& frame, const AVPixFmtDescriptor& format, int row, int component,
                    std::vector<int>* out) {
  std::array<const std::uint8_t*, 4> data{};
  std::array<int, 4> strides{};
  for (std::size_t plane = 0; plane < 4; ++plane) {
    data[plane] = frame.data[plane];
    strides[plane] = frame.linesize[plane];
  }
  const bool is_chroma = is_luma(format) && component > 0;
  const int width = is_chroma ? AV_CEIL_RSHIFT(frame.width, format.log2_chroma_w) : frame.width;
  out->resize(static_cast<std::size_t>(width));
  av_read_image_line2(out->data(), data.data(), strides.data(), &format, 0,
                      is_chroma ? row >> format.log2_chroma_h : row, component, width, 0,
                      sizeof(int));
}

/// True where the first component is a plane of bytes.
bool has_byte_plane(const AVPixFmtDescriptor& format) {
  const AVComponentDescriptor& first = format.comp[0];
  return first.depth == 8 && first.step == 1 && first.shift == 0 && first.offset == 0 &&
         (format.flags & (AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_BITSTREAM)) == 0;
}

bool is_rgb(const AVPixFmtDescriptor& format) { return (format.flags & AV_PIX_FMT_FLAG_RGB) != 0; }

/// nullptr for a format without brightness.
const AVPixFmtDescriptor* readable_format(const AVFrame& frame) {
  const AVPixFmtDescriptor* format = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
  constexpr auto kUnreadable =
      AV_PIX_FMT_FLAG_PAL | AV_PIX_FMT_FLAG_HWACCEL | AV_PIX_FMT_FLAG_FLOAT;
  return format == nullptr || (format->flags & kUnreadable) != 0 ? nullptr : format;
}

double grey_of_colours(double red, double green, double blue) {
  return 0.299 * red + 0.587 * green + 0.114 * blue;
}

void stretch(cv::Mat& grey) {
  cv::Mat table(1, 256, CV_8UC1);
  for (int level = 0; level < 256; ++level)
    table.at<std::uint8_t>(level) = cv::saturate_cast<std::uint8_t>((level - 16) * 255.0 / 219.0);
  cv::LUT(grey, table, grey);
}

}  // namespace

int allocate_frame(AVFrame& frame, AVPixelFormat format, cv::Size size) {
  if (frame.buf[0] != nullptr) return av_frame_make_writable(&frame);
  frame.format = format;
  frame.width = size.width;
  frame.height = size.height;
  return av_frame_get_buffer(&frame, 0);
}

void quiet_libav() {
  static std::once_flag once;
  std::call_once(once, [] { av_log_set_level(AV_LOG_QUIET); });
}

Result<cv::Mat> grey_of(const AVFrame& frame, const GreyLevels& levels) {
  const AVPixFmtDescriptor* format = readable_format(frame);
  if (format == nullptr)
    return Error{en::say("its pixel format has no brightness"), "",
                 en::say("a grey or colour video")};
  cv::Mat grey(frame.height, frame.width, CV_8UC1);
  if (has_byte_plane(*format)) {
    for (int v = 0; v < grey.rows; ++v)
      std::copy_n(frame.data[0] + std::ptrdiff_t{v} * frame.linesize[0], grey.cols,
                  grey.ptr<std::uint8_t>(v));
  } else {
    std::vector<int> first, second, third;
    const int depth = levels.bits > 0 ? levels.bits : format->comp[0].depth;
    const double to_8_bits = depth >= 8 ? 1.0 / (1 << (depth - 8)) : 255.0 / ((1 << depth) - 1);
    for (int v = 0; v < grey.rows; ++v) {
      read_component(frame, *format, v, 0, &first);
      if (is_rgb(*format)) {
        read_component(frame, *format, v, 1, &second);
        read_component(frame, *format, v, 2, &third);
      }
      for (std::size_t u = 0; u < first.size(); ++u) {
        const double level =
            is_rgb(*format) ? std::round(grey_of_colours(first[u], second[u], third[u]) * to_8_bits)
                            : std::floor(first[u] * to_8_bits);
        grey.at<std::uint8_t>(v, static_cast<int>(u)) = cv::saturate_cast<std::uint8_t>(level);
      }
    }
  }
  if (levels.is_narrow) stretch(grey);
  return grey;
}

namespace {

constexpr int kRowStep = 3;  // rows of a look: neighbours show the same

}  // namespace

void LevelsLook::add(const AVFrame& frame) {
  const AVPixFmtDescriptor* format = readable_format(frame);
  if (format == nullptr) return;
  depth_ = format->comp[0].depth;
  is_luma_ = is_luma(*format);
  is_rgb_ = is_rgb(*format);
  const bool is_named_full = std::string_view(format->name).starts_with("yuvj");
  named_range_ = is_named_full ? AVCOL_RANGE_JPEG : frame.color_range;
  counts_.resize(std::size_t{1} << std::min(depth_, 16));
  std::array<std::vector<int>, 3> rows;
  const int components = is_luma_ || is_rgb(*format) ? 3 : 1;
  const double neutral = 1 << (depth_ - 1);
  for (int v = 0; v < frame.height; v += kRowStep) {
    for (int i = 0; i < components; ++i)
      read_component(frame, *format, v, i, &rows[static_cast<std::size_t>(i)]);
    const auto& [first, second, third] = rows;
    for (std::size_t u = 0; u < first.size(); ++u) {
      const int value = is_rgb(*format) ? std::max({first[u], second[u], third[u]}) : first[u];
      ++counts_[std::min(static_cast<std::size_t>(value), counts_.size() - 1)];
      grey_ += first[u];
      if (is_rgb(*format)) {
        const double grey = grey_of_colours(first[u], second[u], third[u]);
        grey_ += grey - first[u];
        colour_ +=
            (std::abs(first[u] - grey) + std::abs(second[u] - grey) + std::abs(third[u] - grey)) /
            3;
      } else if (is_luma_) {
        const std::size_t of_chroma = u >> format->log2_chroma_w;
        const double blue = second[of_chroma] - neutral, red = third[of_chroma] - neutral;
        colour_ += (std::abs(1.402 * red) + std::abs(0.344 * blue + 0.714 * red) +
                    std::abs(1.772 * blue)) /
                   3;
      }
    }
    pixels_ += first.size();
  }
}

void LevelsLook::add(const cv::Mat& grey) {
  depth_ = 8;
  named_range_ = AVCOL_RANGE_JPEG;
  counts_.resize(256);
  for (int v = 0; v < grey.rows; v += kRowStep)
    for (int u = 0; u < grey.cols; ++u) {
      ++counts_[grey.at<std::uint8_t>(v, u)];
      ++pixels_;
    }
}

/// Part of the pixels at this level and above, of 255 where all bits in use are.
double LevelsLook::part_from(double level) const {
  const int bits = used_bits();
  const auto from = static_cast<std::size_t>(std::ceil(level / 255.0 * ((1 << bits) - 1)));
  std::uint64_t above = 0;
  for (std::size_t value = from; value < counts_.size(); ++value) above += counts_[value];
  return pixels_ > 0 ? static_cast<double>(above) / static_cast<double>(pixels_) : 0.0;
}

int LevelsLook::used_bits() const {
  if (depth_ <= 8 || is_luma_) return depth_;
  std::size_t brightest = counts_.size() - 1;
  while (brightest > 0 && counts_[brightest] == 0) --brightest;
  return std::min(depth_, bits_in_use(static_cast<int>(brightest), 8));
}

/// Part of the pixels that narrow luma does not reach, but in a few next to edges that compression
/// made.
double LevelsLook::part_too_dark() const {
  constexpr double kTooDark = 9.0;
  return 1.0 - part_from(kTooDark);
}

GreyLevels LevelsLook::levels() const {
  GreyLevels levels;
  levels.bits = depth_ > 8 && used_bits() < depth_ ? used_bits() : 0;
  if (is_rgb_) return levels;
  // What a file states is overruled by many pixels only.
  constexpr double kFewPixels = 1e-3, kManyPixels = 1e-2;
  if (named_range_ == AVCOL_RANGE_MPEG)
    levels.is_narrow = part_too_dark() <= kManyPixels;
  else if (named_range_ == AVCOL_RANGE_UNSPECIFIED)
    levels.is_narrow = is_luma_ && part_too_dark() <= kFewPixels;
  return levels;
}

std::vector<Message> LevelsLook::remarks() const {
  constexpr double kDark = 40, kSaturated = 254;
  constexpr double kMuchSaturated = 1.0 / 3;
  if (pixels_ == 0) return {};
  std::vector<Message> remarks;
  const GreyLevels levels = this->levels();
  if (levels.bits > 0)
    remarks.push_back(
        en::say("of its {} bits per pixel only the lower {} are in use: these were "
                "taken as the entire range",
                depth_, levels.bits));
  if (!is_rgb_ && named_range_ == AVCOL_RANGE_MPEG && !levels.is_narrow)
    remarks.push_back(
        en::say("it states that its brightness is stored as 16 to 235, but {:.0f} % of its pixels "
                "are below 9: 0 to 255 was assumed",
                100 * part_too_dark()));
  if (is_luma_ && named_range_ == AVCOL_RANGE_UNSPECIFIED)
    remarks.push_back(
        levels.is_narrow
            ? en::say("it does not state the range of its brightness: 16 to 235 was assumed")
            : en::say("it does not state the range of its brightness: it has levels below 9, so 0 "
                      "to 255 was assumed"));
  const double stretched = levels.is_narrow ? 16 + kDark * 219 / 255 : kDark;
  if (part_from(stretched) == 0)
    remarks.push_back(en::say(
        "it is nearly black: no pixel reaches grey level {:.0f} of 255; check light and exposure",
        kDark));
  const double white = part_from(levels.is_narrow ? 235 : kSaturated);
  if (white > kMuchSaturated)
    remarks.push_back(
        en::say("{:.0f} % of it is saturated; reduce exposure or light", 100 * white));
  if (const double colour = grey_ > 0 ? colour_ / grey_ : 0; colour > kMaxColour)
    remarks.push_back(
        en::say("it is in colour: its channels differ from grey by {:.0f} %; only "
                "its brightness is used",
                100 * colour));
  return remarks;
}

}  // namespace alltact
