// Owners for libav's C objects, and its errors as messages. Only for .cpp files of this folder.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
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

/// Silences libav's own messages, which say less than the program's. Call before its first use.
void quiet_libav();

/// Allocates a frame's buffer, or makes it writable where an encoder still holds it. It is padded,
/// because encoders read beyond the last pixel. Below 0: libav's error.
[[nodiscard]] int allocate_frame(AVFrame& frame, AVPixelFormat format, cv::Size size);

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

/// Converts a decoded frame to grey, CV_8UC1, in its own memory. Grey is unchanged. Of luma and
/// chroma the luma is taken, stretched to 0 to 255 where it was stored as 16 to 235 (ITU-R BT.601).
/// Red, green and blue have weights 0.299, 0.587 and 0.114. More than 8 bits are cut to the upper
/// 8. Error: a format without brightness (palettes, hardware).
[[nodiscard]] Result<cv::Mat> grey_of(const AVFrame& frame);

// A Matroska file with one video stream, each packet on the disk before the next is written. Only
// for .cpp files of this folder.

/// A tag of a file.
struct MatroskaTag {
  std::string name, text;
};
/// The tag that marks recordings of this program (is_own_recording).
[[nodiscard]] MatroskaTag recording_tag();

/// A file being written. Packets that write() took stay readable after any crash: each is a cluster
/// of its own and is in the file when write() returns. The open file is locked (flock), so that
/// nobody repairs it as an interrupted one. Not for several threads at once.
class MatroskaFile {
 public:
  /// `parameters` of the stream; packets have time stamps in milliseconds. Overwrites the file.
  [[nodiscard]] static Result<MatroskaFile> create(const std::filesystem::path& file,
                                                   const AVCodecParameters& parameters,
                                                   double frames_per_s,
                                                   const MatroskaTag& tag = recording_tag());
  MatroskaFile(MatroskaFile&&) noexcept;
  MatroskaFile& operator=(MatroskaFile&&) noexcept;
  ~MatroskaFile();

  /// After an error the file is truncated to its last complete packet and takes no more.
  [[nodiscard]] Status write(AVPacket& packet);
  /// Writes the index and the length, without which the file is readable but slow to seek in, then
  /// waits until everything is on the disk. Error: they could not be written; the packets stay
  /// readable.
  [[nodiscard]] Status finish();

  [[nodiscard]] std::uint64_t bytes() const;
  [[nodiscard]] int descriptor() const;

 private:
  struct State;
  explicit MatroskaFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// True for a recording of this program.
[[nodiscard]] bool is_own_recording(const AVFormatContext& input);

}  // namespace alltact
