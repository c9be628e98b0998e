// Owners of libav's frames and packets, and the grey of frames in any pixel format.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"

#include <cstdint>
#include <memory>
#include <vector>

#include <opencv2/core.hpp>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavcodec/bsf.h>
}

namespace alltact {

struct AvDeleter {
  void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
  void operator()(AVCodecParameters* parameters) const { avcodec_parameters_free(&parameters); }
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
  void operator()(AVBSFContext* filter) const { av_bsf_free(&filter); }
};
template <class T>
using AvPtr = std::unique_ptr<T, AvDeleter>;

/// Silences libav's own messages, which say less than the program's. Call before its first use.
void quiet_libav();

/// Allocates a frame's buffer, or makes it writable where an encoder still holds it. It is padded,
/// because encoders read beyond the last pixel. Below 0: libav's error.
[[nodiscard]] int allocate_frame(AVFrame& frame, AVPixelFormat format, cv::Size size);

/// What a video's pixel format leaves open about its brightness.
struct GreyLevels {
  int bits = 0;            ///< of more than 8, those in use from the lowest on; 0: all
  bool is_narrow = false;  ///< luma is stored as 16 to 235 of 255 (ITU-R BT.601)
};

/// Converts a decoded frame to grey, CV_8UC1, in its own memory. Grey is unchanged. Of luma and
/// chroma the luma is taken, stretched to 0 to 255 where it is narrow. Red, green and blue have
/// weights 0.299, 0.587 and 0.114. Of more than 8 bits in use the upper 8 are taken. Error: a
/// format without brightness (palettes, hardware).
[[nodiscard]] Result<cv::Mat> grey_of(const AVFrame& frame, const GreyLevels& levels);

/// Looks at some frames of a video for what its format leaves open, and for images that can hardly
/// be measured.
class LevelsLook {
 public:
  /// Frames without brightness are ignored.
  void add(const AVFrame& frame);
  void add(const cv::Mat& grey);  ///< CV_8UC1
  [[nodiscard]] GreyLevels levels() const;
  /// A sentence for what was assumed, and for each fault: nearly black, saturated, coloured.
  [[nodiscard]] std::vector<Message> remarks() const;

 private:
  [[nodiscard]] int used_bits() const;
  [[nodiscard]] double part_from(double level) const;
  [[nodiscard]] double part_too_dark() const;

  std::vector<std::uint64_t> counts_;  // of luma, grey or green, by value
  std::uint64_t pixels_ = 0;
  double colour_ = 0, grey_ = 0;  // sums over pixels: distance of the channels from grey, and grey
  int depth_ = 0;
  bool is_luma_ = false;  // with chroma: its range is a question
  bool is_rgb_ = false;
  int named_range_ = 0;  // AVColorRange
};

}  // namespace alltact
