// Inputs of libav, and its errors as messages. Only for .cpp files of this folder.
#pragma once

#include "core/base/result.h"
#include "core/image/av_frame.h"

#include <filesystem>
#include <memory>
#include <string_view>

extern "C" {
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
}

namespace alltact {

/// An open input of libav.
struct AvInputDeleter {
  void operator()(AVFormatContext* context) const { avformat_close_input(&context); }
};
using AvInput = std::unique_ptr<AVFormatContext, AvInputDeleter>;

/// An open file that gives the packets of its one video stream only. Errors: not there, no video.
/// `where` of the errors is the file.
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

/// `number`: a libav function's return value, below 0. Errors of the system (disk full, ...) become
/// those of system_error().
[[nodiscard]] Error av_error(const Message& doing, const std::filesystem::path& file, int number);

}  // namespace alltact
