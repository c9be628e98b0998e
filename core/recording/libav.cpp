#include "core/recording/libav.h"

#include "core/base/descriptor.h"
#include "core/base/result.h"
#include "core/base/slow_disk.h"
#include "core/recording/durable_file.h"

#include <cerrno>
#include <mutex>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

extern "C" {
#include <libavutil/log.h>
#include <libavutil/pixdesc.h>
}

namespace alltact {
namespace {

Error no_video(const Message& what, const std::filesystem::path& file) {
  return {what, file.string(),
          en::say("play it in a video player; if that fails too, record it again")};
}

/// One component of every pixel of a row, 16 bits each.
void read_component(const AVFrame& frame, const AVPixFmtDescriptor& format, int row, int component,
                    int* out) {
  std::array<const std::uint8_t*, 4> data{};
  std::array<int, 4> strides{};
  for (std::size_t plane = 0; plane < 4; ++plane) {
    data[plane] = frame.data[plane];
    strides[plane] = frame.linesize[plane];
  }
  av_read_image_line2(out, data.data(), strides.data(), &format, 0, row, component, frame.width, 0,
                      sizeof(int));
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
    return Error{en::say("its pixel format has no brightness"), "",
                 en::say("a grey or colour video")};
  cv::Mat grey(frame.height, frame.width, CV_8UC1);
  if (has_byte_plane(*format)) {
    for (int v = 0; v < grey.rows; ++v)
      std::copy_n(frame.data[0] + std::ptrdiff_t{v} * frame.linesize[0], grey.cols,
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

namespace {

constexpr int kBufferBytes = 1 << 16;
constexpr const char* kRecordedBy = "RECORDED_BY";
constexpr const char* kRecorderName = "AllTact";

Message writing_video() { return en::say("could not write the video"); }

}  // namespace

MatroskaTag recording_tag() { return {kRecordedBy, kRecorderName}; }

bool is_own_recording(const AVFormatContext& input) {
  const AVDictionaryEntry* entry = av_dict_get(input.metadata, kRecordedBy, nullptr, 0);
  return entry != nullptr && std::string_view(entry->value) == kRecorderName;
}

// Destination of libav's bytes. Its callbacks hold this address.
struct MatroskaFile::State {
  std::filesystem::path file;
  Descriptor descriptor;
  int error_number = 0;              // of the first failed write
  std::uint64_t complete_bytes = 0;  // up to the end of the last complete packet
  bool is_open = false;              // the header is written, the end is not
  AVIOContext* io = nullptr;
  AVFormatContext* context = nullptr;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (context != nullptr) avformat_free_context(context);
    if (io != nullptr) {
      av_freep(&io->buffer);
      avio_context_free(&io);
    }
  }

  [[nodiscard]] Error error(int number) const {
    return av_error(writing_video(), file, error_number != 0 ? AVERROR(error_number) : number);
  }
  Status open(const AVCodecParameters& parameters, double frames_per_s, const MatroskaTag& tag);
  Status truncate_file(int number);
  Status flush(int number);
  Status finish();

  static int write(void* opaque, std::uint8_t* bytes, int count) {
    auto& self = *static_cast<State*>(opaque);
    if (self.error_number != 0) return AVERROR(self.error_number);
    const DiskWait waiting(self.file);
    for (int done = 0; done < count;) {
      const ssize_t written =
          ::write(self.descriptor.number(), bytes + done, static_cast<std::size_t>(count - done));
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return AVERROR(self.error_number = errno);
      done += static_cast<int>(written);
    }
    return count;
  }
  static std::int64_t seek(void* opaque, std::int64_t offset, int whence) {
    auto& self = *static_cast<State*>(opaque);
    if (whence == AVSEEK_SIZE) return AVERROR(ENOSYS);
    const off_t position = ::lseek(self.descriptor.number(), offset, whence);
    return position < 0 ? AVERROR(errno) : position;
  }
};

Status MatroskaFile::State::open(const AVCodecParameters& parameters, double frames_per_s,
                                 const MatroskaTag& tag) {
  descriptor = Descriptor(::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
  if (!descriptor.is_open()) return error(AVERROR(errno));
  if (::flock(descriptor.number(), LOCK_EX | LOCK_NB) != 0)
    return Error{en::say("it is being recorded or repaired right now"), file.string(),
                 en::say("another name")};
  if (::ftruncate(descriptor.number(), 0) != 0) return error(AVERROR(errno));
  io = avio_alloc_context(static_cast<std::uint8_t*>(av_malloc(kBufferBytes)), kBufferBytes, 1,
                          this, nullptr, write, seek);
  int status = avformat_alloc_output_context2(&context, nullptr, "matroska", nullptr);
  if (status < 0) return error(status);
  context->pb = io;
  context->flags |= AVFMT_FLAG_BITEXACT;  // the same frames make the same bytes
  av_dict_set(&context->metadata, tag.name.c_str(), tag.text.c_str(), 0);
  AVStream* stream = avformat_new_stream(context, nullptr);
  status = avcodec_parameters_copy(stream->codecpar, &parameters);
  if (status < 0) return error(status);
  stream->time_base = {1, 1000};
  stream->avg_frame_rate = av_d2q(frames_per_s, 100000);
  status = avformat_write_header(context, nullptr);
  if (status < 0) return error(status);
  is_open = true;
  return flush(0);
}

/// Writes libav's buffered bytes to the file.
Status MatroskaFile::State::flush(int number) {
  avio_flush(io);
  if (number < 0 || io->error < 0 || error_number != 0)
    return truncate_file(number < 0 ? number : io->error);
  complete_bytes = static_cast<std::uint64_t>(avio_tell(io));
  return {};
}

Status MatroskaFile::State::truncate_file(int number) {
  is_open = false;
  const Error problem = error(number);
  // Should this fail, readers ignore the incomplete packet at the end.
  [[maybe_unused]] const int ignored =
      ::ftruncate(descriptor.number(), static_cast<off_t>(complete_bytes));
  return problem;
}

Status MatroskaFile::State::finish() {
  if (!is_open) return error(AVERROR(EPIPE));
  if (Status status = flush(av_write_trailer(context)); !status) return status;
  is_open = false;
  complete_bytes = static_cast<std::uint64_t>(::lseek(descriptor.number(), 0, SEEK_END));
  const DiskWait waiting(file);
  // A removed file is about to be copied: a wait for its bytes to reach the disk would be useless.
  if (!is_removed(descriptor.number()) && ::fsync(descriptor.number()) != 0)
    return error(AVERROR(errno));
  return {};
}

MatroskaFile::MatroskaFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
MatroskaFile::MatroskaFile(MatroskaFile&&) noexcept = default;
MatroskaFile& MatroskaFile::operator=(MatroskaFile&&) noexcept = default;
MatroskaFile::~MatroskaFile() = default;

Result<MatroskaFile> MatroskaFile::create(const std::filesystem::path& file,
                                          const AVCodecParameters& parameters, double frames_per_s,
                                          const MatroskaTag& tag) {
  auto state = std::make_unique<State>();
  state->file = file;
  if (Status status = state->open(parameters, frames_per_s, tag); !status) return status.error();
  return MatroskaFile(std::move(state));
}

Status MatroskaFile::write(AVPacket& packet) {
  State& s = *state_;
  if (!s.is_open) return s.error(AVERROR(EPIPE));
  packet.stream_index = 0;
  int status = av_write_frame(s.context, &packet);
  if (status >= 0) status = av_write_frame(s.context, nullptr);  // ends the cluster
  return s.flush(status);
}

Status MatroskaFile::finish() {
  const Status status = state_->finish();
  ::flock(state_->descriptor.number(), LOCK_UN);
  return status;
}

std::uint64_t MatroskaFile::bytes() const { return state_->complete_bytes; }
int MatroskaFile::descriptor() const { return state_->descriptor.number(); }

}  // namespace alltact
