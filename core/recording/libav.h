// libav's C objects with owners, and its errors as sentences. For this folder's own .cpp files.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <memory>
#include <string_view>

#include <opencv2/core.hpp>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
}

namespace alltact {

struct AvDeleter {
  void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
  void operator()(AVCodecParameters* parameters) const { avcodec_parameters_free(&parameters); }
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
template <class T>
using AvPtr = std::unique_ptr<T, AvDeleter>;

/// libav's own messages would stand beside our sentences and say less. Before its first use.
void quiet_libav();

/// Room of its own for a picture that goes to an encoder, which reads a little beyond the last
/// pixel: made with the first, and not what an encoder still holds. Below 0: libav's error.
[[nodiscard]] int make_room(AVFrame& picture, AVPixelFormat format, cv::Size size);

/// What an input is read with.
struct AvInputDeleter {
  void operator()(AVFormatContext* context) const { avformat_close_input(&context); }
};
using AvInput = std::unique_ptr<AVFormatContext, AvInputDeleter>;

/// An open file whose packets can be asked for, with its one video stream the only one that gives
/// any. Errors: not there, no video. `where` of the errors is the file.
struct VideoInput {
  AvInput context;
  int stream = -1;

  [[nodiscard]] AVStream* video() const {
    return context->streams[static_cast<std::size_t>(stream)];
  }
  [[nodiscard]] bool is_matroska() const {
    return std::string_view(context->iformat->name).starts_with("matroska");
  }
  /// The next packet of the video; false at the end or where the file breaks off.
  [[nodiscard]] bool read(AVPacket& packet) const;
};
[[nodiscard]] Result<VideoInput> open_video_input(const std::filesystem::path& file);

/// `number`: what a libav function returned, below 0. Errors of the system (disk full, ...) come
/// out as system_error() tells them.
[[nodiscard]] Error av_error(const Message& doing, const std::filesystem::path& file, int number);

/// A decoded picture as grey, CV_8UC1, in memory of its own. Grey pictures come out as they are;
/// of colour in luma and chroma the luma is taken, stretched to 0 to 255 where it was stored as 16
/// to 235 (ITU-R BT.601); red, green and blue weigh 0.299, 0.587 and 0.114. More than 8 bits are
/// cut to the upper 8. Error: a kind of picture that has no brightness (palettes, hardware).
[[nodiscard]] Result<cv::Mat> grey_of(const AVFrame& picture);

}  // namespace alltact
