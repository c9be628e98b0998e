#include "core/image/grey_decoder.h"

#include "core/image/av_frame.h"
#include "core/image/grey_range.h"
#include "core/image/jpeg.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <opencv2/imgproc.hpp>

namespace alltact {

std::string fourcc_text(std::uint32_t code) {
  std::string text;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto letter = static_cast<char>((code >> shift) & 0x7FU);
    text += letter >= ' ' && letter <= '~' ? letter : '?';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

namespace {

/// Where an uncompressed format has its brightness.
struct Layout {
  PixelFormat format;
  int pixel_bytes;         // in the first plane
  int at;                  // of the brightness in a pixel; -1: colours
  int bits;                // of it
  bool is_planar = false;  // half as many bytes of colour behind the brightness
};
constexpr std::array kLayouts{
    Layout{PixelFormat::kGrey, 1, 0, 8},       Layout{PixelFormat::kY10, 2, 0, 10},
    Layout{PixelFormat::kY12, 2, 0, 12},       Layout{PixelFormat::kY14, 2, 0, 14},
    Layout{PixelFormat::kY16, 2, 0, 16},       Layout{PixelFormat::kYuyv, 2, 0, 8},
    Layout{PixelFormat::kYvyu, 2, 0, 8},       Layout{PixelFormat::kUyvy, 2, 1, 8},
    Layout{PixelFormat::kVyuy, 2, 1, 8},       Layout{PixelFormat::kNv12, 1, 0, 8, true},
    Layout{PixelFormat::kNv21, 1, 0, 8, true}, Layout{PixelFormat::kYu12, 1, 0, 8, true},
    Layout{PixelFormat::kYv12, 1, 0, 8, true}, Layout{PixelFormat::kRgb24, 3, -1, 8},
    Layout{PixelFormat::kBgr24, 3, -1, 8},     Layout{PixelFormat::kBgrx32, 4, -1, 8}};

const Layout* layout_of(PixelFormat format) {
  const auto* found = std::find_if(kLayouts.begin(), kLayouts.end(),
                                   [&](const Layout& one) { return one.format == format; });
  return found == kLayouts.end() ? nullptr : found;
}

/// The byte at kAt of each pair.
template <int kAt>
void take_alternate_bytes(const std::uint8_t* from, std::uint8_t* to, int count) {
  for (int i = 0; i < count; ++i) to[i] = from[2 * i + kAt];
}

/// The upper 8 of the bits in use.
void take_upper_bits(const std::uint8_t* from, std::uint8_t* to, int count, int bits) {
  for (int i = 0; i < count; ++i) {
    const int value = from[2 * i] | from[2 * i + 1] << 8;
    to[i] = static_cast<std::uint8_t>(std::min(value >> (bits - 8), 255));
  }
}

void take_grey_of_colours(PixelFormat format, const std::uint8_t* from, cv::Mat to) {
  const int type = format == PixelFormat::kBgrx32 ? CV_8UC4 : CV_8UC3;
  const cv::Mat colours(1, to.cols, type, const_cast<std::uint8_t*>(from));
  const int conversion = format == PixelFormat::kRgb24   ? cv::COLOR_RGB2GRAY
                         : format == PixelFormat::kBgr24 ? cv::COLOR_BGR2GRAY
                                                         : cv::COLOR_BGRA2GRAY;
  cv::cvtColor(colours, to, conversion);
}

Error damaged_packet(Message what) {
  return {
      std::move(what), "",
      en::say(
          "a shorter USB cable or another port; if it persists, another format or a lower rate")};
}

Error other_size(int width, int height, int width_px, int height_px) {
  return damaged_packet(
      en::say("a {}x{} frame arrived instead of {}x{}", width, height, width_px, height_px));
}

}  // namespace

bool is_jpeg(PixelFormat format) {
  return format == PixelFormat::kMjpeg || format == PixelFormat::kJpeg;
}

bool can_decode(std::uint32_t code) {
  const auto format = static_cast<PixelFormat>(code);
  return layout_of(format) != nullptr || is_jpeg(format) || format == PixelFormat::kH264;
}

struct GreyDecoder::Compressed {
  JpegDecoder jpeg;
  // Of predicted frames; made for the first.
  AvPtr<AVCodecContext> h264 = nullptr;
  AvPtr<AVFrame> av_frame{av_frame_alloc()};
  AvPtr<AVPacket> packet{av_packet_alloc()};
  std::optional<GreyLevels> levels;  // after the first image
};

GreyDecoder::GreyDecoder() : compressed_(std::make_unique<Compressed>()) {}
GreyDecoder::~GreyDecoder() = default;
GreyDecoder::GreyDecoder(GreyDecoder&&) noexcept = default;
GreyDecoder& GreyDecoder::operator=(GreyDecoder&&) noexcept = default;

/// Cameras name Y16 what holds 10 to 16 bits (the kernel's documentation allows it): as many are
/// taken to be in use as the brightest pixel so far needs.
int GreyDecoder::bits_of(PixelFormat format, int width_px, int height_px, std::size_t stride_bytes,
                         std::span<const std::uint8_t> bytes) {
  const int named = layout_of(format)->bits;
  if (format != PixelFormat::kY16 || y16_bits_ == named) return named;
  int brightest = 0;
  for (int v = 0; v < height_px; ++v) {
    const std::uint8_t* row = bytes.data() + stride_bytes * static_cast<std::size_t>(v);
    for (int u = 0; u < width_px; ++u)
      brightest = std::max(brightest, row[2 * u] | row[2 * u + 1] << 8);
  }
  const int bits = bits_in_use(brightest, 10);
  if (bits > y16_bits_) {
    y16_bits_ = bits;
    if (bits < named)
      remarks_.push_back(
          en::say("of the 16 bits per pixel only the lower {} are in use: these are "
                  "taken as the entire range",
                  bits));
  }
  return y16_bits_;
}

Result<cv::Mat> GreyDecoder::operator()(PixelFormat format, int width_px, int height_px,
                                        std::size_t stride_bytes,
                                        std::span<const std::uint8_t> bytes) {
  if (is_jpeg(format)) return decode_jpeg(width_px, height_px, bytes);
  if (format == PixelFormat::kH264) return decode_h264(width_px, height_px, bytes);
  const Layout& layout = *layout_of(format);
  const auto row_bytes = static_cast<std::size_t>(width_px * layout.pixel_bytes);
  const std::size_t stride = std::max(stride_bytes, row_bytes);
  const auto rows = static_cast<std::size_t>(height_px);
  std::size_t needed = stride * (rows - 1) + row_bytes;
  if (layout.is_planar) needed = stride * rows + stride * (rows / 2);
  if (bytes.size() < needed)
    return damaged_packet(en::say("a frame arrived with {} of {} bytes", bytes.size(), needed));
  const int bits =
      layout.bits > 8 ? bits_of(format, width_px, height_px, stride, bytes) : layout.bits;
  cv::Mat grey(height_px, width_px, CV_8UC1);
  for (int v = 0; v < height_px; ++v) {
    const std::uint8_t* from = bytes.data() + stride * static_cast<std::size_t>(v);
    std::uint8_t* to = grey.ptr(v);
    if (layout.at < 0)
      take_grey_of_colours(format, from, grey.row(v));
    else if (layout.bits > 8)
      take_upper_bits(from, to, width_px, bits);
    else if (layout.pixel_bytes == 1)
      std::memcpy(to, from, row_bytes);
    else if (layout.at == 0)
      take_alternate_bytes<0>(from, to, width_px);
    else
      take_alternate_bytes<1>(from, to, width_px);
  }
  return grey;
}

void GreyDecoder::restart() {
  if (compressed_->h264) avcodec_flush_buffers(compressed_->h264.get());
}

Result<cv::Mat> GreyDecoder::decode_jpeg(int width_px, int height_px,
                                         std::span<const std::uint8_t> bytes) {
  JpegDecoder& decoder = compressed_->jpeg;
  const bool was_clean = decoder.stray() == 0;
  auto image = decoder(bytes, JpegDecoder::Channels::kGrey);
  if (!image) return damaged_packet(image.error().what);
  if (image->cols != width_px || image->rows != height_px)
    return other_size(image->cols, image->rows, width_px, height_px);
  if (was_clean && decoder.stray() > 0)
    remarks_.push_back(en::say("its JPEGs contain stray bytes, which cost no pixel"));
  return image;
}

Result<cv::Mat> GreyDecoder::decode_h264(int width_px, int height_px,
                                         std::span<const std::uint8_t> bytes) {
  Compressed& state = *compressed_;
  if (!state.h264) {
    quiet_libav();
    const AVCodec* codec = avcodec_find_decoder(AV_CODEC_ID_H264);
    if (codec == nullptr)
      return Error{en::say("this system's libavcodec cannot read H.264"), "",
                   en::say("another format of the camera")};
    state.h264.reset(avcodec_alloc_context3(codec));
    state.h264->flags |= AV_CODEC_FLAG_LOW_DELAY;
    state.h264->thread_count = 1;  // threads would delay frames
    if (avcodec_open2(state.h264.get(), codec, nullptr) < 0) {
      state.h264.reset();
      return damaged_packet(en::say("H.264 cannot be decoded"));
    }
  }
  AVPacket& packet = *state.packet;
  const auto size = static_cast<int>(bytes.size());
  if (av_new_packet(&packet, size) < 0) return damaged_packet(en::say("H.264 cannot be decoded"));
  std::memcpy(packet.data, bytes.data(), bytes.size());
  const bool is_sent = avcodec_send_packet(state.h264.get(), &packet) >= 0;
  av_packet_unref(&packet);
  const int status = avcodec_receive_frame(state.h264.get(), state.av_frame.get());
  const AVFrame& shown = *state.av_frame;
  const bool is_waiting = status == AVERROR(EAGAIN);
  if (is_waiting && (is_sent || !state.levels))
    return cv::Mat();  // for a frame that needs no other
  if (!is_sent || status < 0 || shown.decode_error_flags != 0 ||
      (shown.flags & AV_FRAME_FLAG_CORRUPT) != 0) {
    if (!state.levels) return cv::Mat();
    return damaged_packet(en::say("a frame of H.264 is damaged"));
  }
  if (shown.width != width_px || shown.height != height_px)
    return other_size(shown.width, shown.height, width_px, height_px);
  if (!state.levels) {
    LevelsLook look;
    look.add(shown);
    state.levels = look.levels();
    for (const Message& remark : look.remarks()) remarks_.push_back(remark);
  }
  return grey_of(shown, *state.levels);
}

}  // namespace alltact
