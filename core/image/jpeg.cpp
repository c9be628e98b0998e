#include "core/image/jpeg.h"

#include <csetjmp>
#include <cstdio>

#include <jerror.h>
#include <jpeglib.h>

namespace alltact {

// libjpeg leaves a function by longjmp where it gives up: functions that call it hold no objects
// with destructors.
struct JpegDecoder::State {
  jpeg_decompress_struct info{};
  jpeg_error_mgr errors{};
  std::jmp_buf given_up;
  int faults = 0;
  int stray_bytes = 0;  // before restart marks

  State() {
    info.err = jpeg_std_error(&errors);
    errors.error_exit = [](j_common_ptr common) { std::longjmp(of(common).given_up, 1); };
    errors.emit_message = [](j_common_ptr common, int level) {
      if (level < 0) of(common).note();
    };
    errors.output_message = [](j_common_ptr) {};
    info.client_data = this;
    jpeg_create_decompress(&info);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { jpeg_destroy_decompress(&info); }

  static State& of(j_common_ptr common) { return *static_cast<State*>(common->client_data); }

  /// A warning of libjpeg.
  void note() {
    constexpr int kEnd = JPEG_EOI, kFirstRestart = JPEG_RST0, kLastRestart = JPEG_RST0 + 7;
    const int bytes = errors.msg_parm.i[0], mark = errors.msg_parm.i[1];
    const bool is_extra = errors.msg_code == JWRN_EXTRANEOUS_DATA;
    if (is_extra && mark == kEnd) return;  // the image is complete
    if (is_extra && mark >= kFirstRestart && mark <= kLastRestart)
      stray_bytes += bytes;  // of one mark or several
    else
      ++faults;
  }

  [[nodiscard]] bool read_header(const std::uint8_t* bytes, std::size_t size) {
    if (setjmp(given_up) != 0) return false;
    jpeg_abort_decompress(&info);
    faults = 0;
    stray_bytes = 0;
    jpeg_mem_src(&info, bytes, size);
    return jpeg_read_header(&info, TRUE) == JPEG_HEADER_OK;
  }
  [[nodiscard]] bool read_rows(std::uint8_t* rows, std::size_t step, Channels channels) {
    if (setjmp(given_up) != 0) return false;
    info.out_color_space = channels == Channels::kGrey ? JCS_GRAYSCALE : JCS_EXT_BGR;
    jpeg_start_decompress(&info);
    while (info.output_scanline < info.output_height) {
      JSAMPROW row = rows + step * info.output_scanline;
      jpeg_read_scanlines(&info, &row, 1);
    }
    jpeg_finish_decompress(&info);
    return true;
  }
};

JpegDecoder::JpegDecoder() : state_(std::make_unique<State>()) {}
JpegDecoder::~JpegDecoder() = default;
JpegDecoder::JpegDecoder(JpegDecoder&&) noexcept = default;
JpegDecoder& JpegDecoder::operator=(JpegDecoder&&) noexcept = default;

namespace {

/// Zeros before restart marks that belong to no byte 255.
int zeros_before_marks(std::span<const std::uint8_t> bytes) {
  int zeros = 0;
  for (std::size_t i = 1; i + 1 < bytes.size(); ++i) {
    if (bytes[i] != 0xFF || bytes[i + 1] < 0xD0 || bytes[i + 1] > 0xD7) continue;
    std::size_t first = i;
    while (first > 0 && bytes[first - 1] == 0) --first;
    const bool is_escape = first > 0 && first < i && bytes[first - 1] == 0xFF;
    zeros += static_cast<int>(i - first) - (is_escape ? 1 : 0);
  }
  return zeros;
}

Error damaged(Message what) {
  return {std::move(what), "", en::say("another copy, or recording it again")};
}

}  // namespace

Result<cv::Mat> JpegDecoder::operator()(std::span<const std::uint8_t> bytes, Channels channels) {
  constexpr int kMaxSidePx = 16384;
  State& state = *state_;
  if (bytes.size() < 4 || !state.read_header(bytes.data(), bytes.size()))
    return damaged(en::say("this is no JPEG"));
  const auto width = static_cast<int>(state.info.image_width),
             height = static_cast<int>(state.info.image_height);
  if (width > kMaxSidePx || height > kMaxSidePx)
    return damaged(en::say("its header gives {} x {} px", width, height));
  cv::Mat image(height, width, channels == Channels::kGrey ? CV_8UC1 : CV_8UC3);
  if (!state.read_rows(image.data, image.step, channels) || state.faults > 0)
    return damaged(en::say("the JPEG is truncated or damaged"));
  if (state.stray_bytes > 0) {
    // What remains of a damaged part may be as short, but hardly ever zeros alone.
    if (state.stray_bytes > zeros_before_marks(bytes))
      return damaged(en::say("the JPEG is truncated or damaged"));
    ++stray_;
  }
  return image;
}

}  // namespace alltact
