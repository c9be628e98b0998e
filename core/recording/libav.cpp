#include "core/recording/libav.h"

#include "core/io/disk_wait.h"
#include "core/io/system_error.h"

#include <cerrno>
#include <mutex>

extern "C" {
#include <libavutil/log.h>
#include <libavutil/pixdesc.h>
}

namespace alltact {
namespace {

Error no_video(const Message& what, const std::filesystem::path& file) {
  return {what,
          file.string(),
          en::say("play it in a video player; if that fails too, record it again")};
}

/// One component of every pixel of a row, 16 bits each.
void read_component(
    const AVFrame& frame, const AVPixFmtDescriptor& format, int row, int component, int* out) {
  std::array<const std::uint8_t*, 4> data{};
  std::array<int, 4> strides{};
  for (std::size_t plane = 0; plane < 4; ++plane) {
    data[plane] = frame.data[plane];
    strides[plane] = frame.linesize[plane];
  }
  av_read_image_line2(
      out, data.data(), strides.data(), &format, 0, row, component, frame.width, 0, sizeof(int));
}

/// True where the first component is a plane of bytes.
bool has_byte_plane(const AVPixFmtDescriptor& format) {
  const AVComponentDescriptor& first = format.comp[0];
  return first.depth == 8 && first.step == 1 && first.shift == 0 && first.offset == 0 &&
         (format.flags & (AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_BITSTREAM)) == 0;
}

bool is_stored_narrow(const AVFrame& frame, const AVPixFmtDescriptor& format) {
  if (format.nb_components < 3 || (format.flags & AV_PIX_FMT_FLAG_RGB) != 0) return false;
  if (frame.color_range == AVCOL_RANGE_JPEG) return false;
  return !std::string_view(format.name).starts_with("yuvj");
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

Error av_error(const Message& doing, const std::filesystem::path& file, int number) {
  const int system = AVUNERROR(number);
  if (system > 0 && system < 200) return system_error(doing, file, system);
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(number, text.data(), text.size());
  return {en::at(doing, Message::typed(text.data())), file.string(), en::say("once more")};
}

bool VideoInput::read(AVPacket& packet) const {
  const DiskWait waiting(context->url);
  while (true) {
    av_packet_unref(&packet);
    if (av_read_frame(context.get(), &packet) < 0) return false;
    if (packet.stream_index == stream) return true;
  }
}

Result<VideoInput> open_video_input(const std::filesystem::path& file) {
  quiet_libav();
  const Message cannot = en::say("the video cannot be opened");
  const DiskWait waiting(file);
  AVFormatContext* raw = nullptr;
  if (avformat_open_input(&raw, file.c_str(), nullptr, nullptr) < 0) return no_video(cannot, file);
  VideoInput input{AvInput(raw), -1};
  // Matroska's header is complete; other formats need a search of the stream.
  if (!input.is_matroska() && avformat_find_stream_info(raw, nullptr) < 0)
    return no_video(cannot, file);
  input.stream = av_find_best_stream(raw, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
  if (input.stream < 0) return no_video(cannot, file);
  for (unsigned i = 0; i < raw->nb_streams; ++i)
    if (static_cast<int>(i) != input.stream) raw->streams[i]->discard = AVDISCARD_ALL;
  return input;
}

Result<cv::Mat> grey_of(const AVFrame& frame) {
  const AVPixFmtDescriptor* format = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
  if (format == nullptr ||
      (format->flags & (AV_PIX_FMT_FLAG_PAL | AV_PIX_FMT_FLAG_HWACCEL | AV_PIX_FMT_FLAG_FLOAT)))
    return Error{
        en::say("its kind of picture has no brightness"), "", en::say("a grey or colour video")};
  cv::Mat grey(frame.height, frame.width, CV_8UC1);
  if (has_byte_plane(*format)) {
    for (int v = 0; v < grey.rows; ++v)
      std::copy_n(frame.data[0] + std::ptrdiff_t{v} * frame.linesize[0],
                  grey.cols,
                  grey.ptr<std::uint8_t>(v));
  } else {
    const bool is_rgb = (format->flags & AV_PIX_FMT_FLAG_RGB) != 0;
    const auto width = static_cast<std::size_t>(grey.cols);
    std::vector<int> first(width), second(width), third(width);
    const int depth = format->comp[0].depth;
    const double to_8_bits = depth >= 8 ? 1.0 / (1 << (depth - 8)) : 255.0 / ((1 << depth) - 1);
    for (int v = 0; v < grey.rows; ++v) {
      read_component(frame, *format, v, 0, first.data());
      if (is_rgb) {
        read_component(frame, *format, v, 1, second.data());
        read_component(frame, *format, v, 2, third.data());
      }
      for (std::size_t u = 0; u < width; ++u) {
        const double level =
            is_rgb
                ? std::round((0.299 * first[u] + 0.587 * second[u] + 0.114 * third[u]) * to_8_bits)
                : std::floor(first[u] * to_8_bits);
        grey.at<std::uint8_t>(v, static_cast<int>(u)) = cv::saturate_cast<std::uint8_t>(level);
      }
    }
  }
  if (is_stored_narrow(frame, *format)) stretch(grey);
  return grey;
}

}  // namespace alltact
