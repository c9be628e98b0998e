#include "core/recording/video_writer.h"

#include "core/recording/matroska_file.h"

namespace alltact {
namespace {

constexpr int kSlices = 4;
constexpr int kSmallestSliced = 32;  // px; smaller frames cannot be cut into slices

Message encoding() {
  return en::say("could not encode the picture");
}

/// Encodes grey frames to packets, one each, without delay.
class Encoder {
 public:
  static Result<Encoder> create(VideoCodec codec, cv::Size size, double frames_per_s) {
    const bool is_ffv1 = codec == VideoCodec::kFfv1;
    const AVCodec* found = avcodec_find_encoder(is_ffv1 ? AV_CODEC_ID_FFV1 : AV_CODEC_ID_MAGICYUV);
    if (found == nullptr)
      return Error{
          en::say("this system's libavcodec cannot write {}", std::string(to_string(codec))),
          "",
          en::say("another codec, or Debian's libavcodec")};
    Encoder encoder;
    encoder.context_.reset(avcodec_alloc_context3(found));
    AVCodecContext& context = *encoder.context_;
    context.width = size.width;
    context.height = size.height;
    context.pix_fmt = AV_PIX_FMT_GRAY8;
    context.time_base = {1, 1000};
    context.framerate = av_d2q(frames_per_s, 100000);
    context.gop_size = 1;      // each frame is independent
    context.thread_count = 1;  // MagicYUV's threads would delay frames
    if (is_ffv1 && std::min(size.width, size.height) >= kSmallestSliced) {
      context.level = 3;
      context.slices = kSlices;
      context.thread_type = FF_THREAD_SLICE;
      context.thread_count = 2;
      av_opt_set_int(context.priv_data, "slicecrc", 1, 0);
    } else if (!is_ffv1) {
      av_opt_set(context.priv_data, "pred", "median", 0);
    }
    if (const int status = avcodec_open2(&context, found, nullptr); status < 0)
      return av_error(encoding(), {}, status);
    return encoder;
  }

  /// Error: the encoder's own, without `where`.
  Status encode(const cv::Mat& grey, AVPacket& packet) {
    if (Status status = fill(grey); !status) return status;
    av_packet_unref(&packet);
    int status = avcodec_send_frame(context_.get(), av_frame_.get());
    if (status >= 0) status = avcodec_receive_packet(context_.get(), &packet);
    if (status < 0) return av_error(encoding(), {}, status);
    return {};
  }

  [[nodiscard]] AvPtr<AVCodecParameters> parameters() const {
    AvPtr<AVCodecParameters> parameters(avcodec_parameters_alloc());
    avcodec_parameters_from_context(parameters.get(), context_.get());
    return parameters;
  }

 private:
  Status fill(const cv::Mat& grey) {
    AVFrame& av_frame = *av_frame_;
    const int status = allocate_frame(av_frame, AV_PIX_FMT_GRAY8, grey.size());
    if (status < 0) return av_error(encoding(), {}, status);
    for (int v = 0; v < grey.rows; ++v)
      std::copy_n(grey.ptr<std::uint8_t>(v),
                  grey.cols,
                  av_frame.data[0] + std::ptrdiff_t{v} * av_frame.linesize[0]);
    ++av_frame.pts;
    return {};
  }

  AvPtr<AVCodecContext> context_;
  AvPtr<AVFrame> av_frame_{av_frame_alloc()};
};

VideoCodec resolved(VideoCodec requested, const Frame& first) {
  if (requested != VideoCodec::kAuto) return requested;
  return first.jpeg ? VideoCodec::kMjpeg : VideoCodec::kMagicYuv;
}

AvPtr<AVCodecParameters> mjpeg_parameters(cv::Size size) {
  AvPtr<AVCodecParameters> parameters(avcodec_parameters_alloc());
  parameters->codec_type = AVMEDIA_TYPE_VIDEO;
  parameters->codec_id = AV_CODEC_ID_MJPEG;
  parameters->width = size.width;
  parameters->height = size.height;
  return parameters;
}

Status check(const Frame& frame, cv::Size size, VideoCodec codec) {
  if (frame.grey.type() != CV_8UC1 || frame.grey.empty())
    return Error{en::say("only 8-bit grey pictures can be recorded"),
                 frame.origin,
                 en::say("a grey source")};
  if (frame.grey.size() != size)
    return Error{en::say("the picture is {} x {}, those before were {} x {}",
                         frame.grey.cols,
                         frame.grey.rows,
                         size.width,
                         size.height),
                 frame.origin,
                 en::say("one recording for each size")};
  if (codec == VideoCodec::kMjpeg && !frame.jpeg)
    return Error{en::say("the source gives no JPEG packets that could be stored untouched"),
                 frame.origin,
                 en::say("the codec magicyuv or ffv1")};
  return {};
}

}  // namespace

std::string_view to_string(VideoCodec codec) {
  switch (codec) {
    case VideoCodec::kMagicYuv:
      return "MagicYUV";
    case VideoCodec::kFfv1:
      return "FFV1";
    case VideoCodec::kMjpeg:
      return "the camera's own JPEG packets";
    case VideoCodec::kAuto:
      break;
  }
  return "automatic";
}

struct VideoWriter::State {
  VideoCodec codec;
  cv::Size size;
  double period_ms;
  std::optional<Encoder> encoder;  // none for JPEG packets
  MatroskaFile file;
  AvPtr<AVPacket> packet{av_packet_alloc()};
  bool has_first = false;
  std::int64_t first_ns = 0, last_ns = 0;
  double last_ms = 0;

  [[nodiscard]] double time_ms(const Frame& frame) {
    if (!has_first) {
      has_first = true;
      first_ns = last_ns = frame.time_ns;
      return last_ms = 0;
    }
    const double captured_ms = static_cast<double>(frame.time_ns - first_ns) * 1e-6;
    const bool is_later = frame.time_ns > last_ns && captured_ms >= last_ms + 1;
    last_ns = std::max(last_ns, frame.time_ns);
    return last_ms = is_later ? captured_ms : last_ms + std::max(period_ms, 1.0);
  }
};

VideoWriter::VideoWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

Result<VideoWriter> VideoWriter::create(const std::filesystem::path& file,
                                        const Frame& first,
                                        VideoCodec requested,
                                        double frames_per_s) {
  quiet_libav();
  const cv::Size size = first.grey.size();
  if (Status status = check(first, size, requested); !status) return status.error();
  const VideoCodec codec = resolved(requested, first);
  std::optional<Encoder> encoder;
  auto parameters = mjpeg_parameters(size);
  if (codec != VideoCodec::kMjpeg) {
    auto made = Encoder::create(codec, size, frames_per_s);
    if (!made) return made.error();
    encoder = std::move(*made);
    parameters = encoder->parameters();
  }
  auto output = MatroskaFile::create(file, *parameters, frames_per_s);
  if (!output) return output.error();
  return VideoWriter(std::unique_ptr<State>(
      new State{codec, size, 1000 / frames_per_s, std::move(encoder), std::move(*output)}));
}

Status VideoWriter::add(const Frame& frame) {
  State& s = *state_;
  if (Status status = check(frame, s.size, s.codec); !status) return status;
  AVPacket& packet = *s.packet;
  if (s.encoder) {
    if (Status status = s.encoder->encode(frame.grey, packet); !status) return status;
  } else {
    av_packet_unref(&packet);
    // The muxer only reads it.
    packet.data = const_cast<std::uint8_t*>(frame.jpeg->data());
    packet.size = static_cast<int>(frame.jpeg->size());
  }
  packet.pts = packet.dts = std::llround(s.time_ms(frame));
  packet.duration = 0;
  packet.flags = AV_PKT_FLAG_KEY;
  return s.file.write(packet);
}

Status VideoWriter::finish() {
  return state_->file.finish();
}
VideoCodec VideoWriter::codec() const {
  return state_->codec;
}
std::uint64_t VideoWriter::bytes() const {
  return state_->file.bytes();
}
int VideoWriter::descriptor() const {
  return state_->file.descriptor();
}

}  // namespace alltact
