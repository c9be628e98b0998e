#include "core/recording/depth_video.h"

#include "core/base/descriptor.h"
#include "core/image/image_file.h"
#include "core/recording/libav.h"
#include "core/recording/matroska.h"

#include <cassert>

#include <fcntl.h>
#include <unistd.h>

namespace alltact {
namespace {

constexpr int kDepthSlices = 4;              // which a reader may decode in parallel
constexpr int kSmallestSlicedDepth_px = 32;  // smaller frames cannot be cut into slices

Message compressing_depth() { return en::say("could not compress the depth"); }

Error not_depth(const std::filesystem::path& file) {
  return {en::say("the video is not marked as depth"), file.string(),
          en::say("a video from alltact reconstruct --format depth-video")};
}

Error damaged_depth(const std::filesystem::path& file) {
  return {en::say("the video of depth is damaged or cut short"), file.string(),
          en::say("reconstruct the recording again")};
}

}  // namespace

struct DepthPackets::State {
  AvPtr<AVCodecContext> context;
  AvPtr<AVFrame> frame{av_frame_alloc()};
  AvPtr<AVPacket> packet{av_packet_alloc()};

  [[nodiscard]] Status fill(const cv::Mat& steps) {
    AVFrame& to = *frame;
    const int status = allocate_frame(to, AV_PIX_FMT_GRAY16LE, steps.size());
    if (status < 0) return av_error(compressing_depth(), {}, status);
    for (int v = 0; v < steps.rows; ++v) {
      auto* row = to.data[0] + std::ptrdiff_t{v} * to.linesize[0];
      const auto* values = steps.ptr<std::uint16_t>(v);
      for (std::ptrdiff_t u = 0; u < steps.cols; ++u) {
        row[2 * u] = static_cast<std::uint8_t>(values[u]);
        row[2 * u + 1] = static_cast<std::uint8_t>(values[u] >> 8U);
      }
    }
    ++to.pts;
    return {};
  }
};

DepthPackets::DepthPackets(std::unique_ptr<State> state) : state_(std::move(state)) {}
DepthPackets::DepthPackets(DepthPackets&&) noexcept = default;
DepthPackets& DepthPackets::operator=(DepthPackets&&) noexcept = default;
DepthPackets::~DepthPackets() = default;

Result<DepthPackets> DepthPackets::create(cv::Size size) {
  quiet_libav();
  const AVCodec* found = avcodec_find_encoder(AV_CODEC_ID_FFV1);
  if (found == nullptr)
    return Error{en::say("this system's libavcodec cannot write FFV1"), "",
                 en::say("Debian's libavcodec, or depth as single images")};
  auto state = std::make_unique<State>();
  state->context.reset(avcodec_alloc_context3(found));
  AVCodecContext& context = *state->context;
  context.width = size.width;
  context.height = size.height;
  context.pix_fmt = AV_PIX_FMT_GRAY16LE;
  context.time_base = {1, 1000};
  context.flags |= AV_CODEC_FLAG_BITEXACT;
  context.gop_size = 1;      // each frame is independent
  context.thread_count = 1;  // each thread has its own encoder
  context.level = 3;
  if (std::min(size.width, size.height) >= kSmallestSlicedDepth_px) context.slices = kDepthSlices;
  av_opt_set_int(context.priv_data, "slicecrc", 1, 0);
  if (const int status = avcodec_open2(&context, found, nullptr); status < 0)
    return av_error(compressing_depth(), {}, status);
  return DepthPackets(std::move(state));
}

Result<std::string> DepthPackets::packet(const cv::Mat& steps) {
  State& s = *state_;
  assert(steps.type() == CV_16UC1 && steps.size() == cv::Size(s.context->width, s.context->height));
  if (const Status filled = s.fill(steps); !filled) return filled.error();
  av_packet_unref(s.packet.get());
  int status = avcodec_send_frame(s.context.get(), s.frame.get());
  if (status >= 0) status = avcodec_receive_packet(s.context.get(), s.packet.get());
  if (status < 0) return av_error(compressing_depth(), {}, status);
  return std::string(reinterpret_cast<const char*>(s.packet->data),
                     static_cast<std::size_t>(s.packet->size));
}

struct DepthVideoWriter::State {
  MatroskaFile file;
  double period_ms;
  std::int64_t count = 0;
  AvPtr<AVPacket> packet{av_packet_alloc()};
};

DepthVideoWriter::DepthVideoWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
DepthVideoWriter::DepthVideoWriter(DepthVideoWriter&&) noexcept = default;
DepthVideoWriter& DepthVideoWriter::operator=(DepthVideoWriter&&) noexcept = default;
DepthVideoWriter::~DepthVideoWriter() = default;

Result<DepthVideoWriter> DepthVideoWriter::create(const std::filesystem::path& file, cv::Size size,
                                                  double frames_per_s) {
  const auto packets = DepthPackets::create(size);
  if (!packets) return packets.error();
  const AvPtr<AVCodecParameters> parameters(avcodec_parameters_alloc());
  avcodec_parameters_from_context(parameters.get(), packets->state_->context.get());
  auto output = MatroskaFile::create(file, *parameters, frames_per_s,
                                     {kDepthVideoTag, std::string(kDepthSentence)});
  if (!output) return output.error();
  return DepthVideoWriter(
      std::unique_ptr<State>(new State{std::move(*output), 1000 / frames_per_s}));
}

Status DepthVideoWriter::add(std::string_view bytes) {
  State& s = *state_;
  AVPacket& packet = *s.packet;
  av_packet_unref(&packet);
  if (av_new_packet(&packet, static_cast<int>(bytes.size())) < 0) throw std::bad_alloc();
  std::copy(bytes.begin(), bytes.end(), packet.data);
  packet.pts = packet.dts = std::llround(static_cast<double>(s.count++) * s.period_ms);
  packet.flags = AV_PKT_FLAG_KEY;
  return s.file.write(packet);
}

Status DepthVideoWriter::finish() { return state_->file.finish(); }

struct DepthVideo::State {
  std::filesystem::path file;
  VideoInput input;
  AvPtr<AVCodecContext> decoder;
  MatroskaIndex index;
  std::size_t next = 0;  // block
  Descriptor check;      // the open file, for check sums
  AvPtr<AVPacket> packet{av_packet_alloc()};
  AvPtr<AVFrame> frame{av_frame_alloc()};

  /// Reads the next packet; false: there is none. Error: it differs from the written one.
  [[nodiscard]] Result<bool> read() {
    if (next == index.blocks.size()) return false;
    const MatroskaIndex::Block& block = index.blocks[next++];
    if (!input.read(*packet) || packet->pos != block.data_bytes_at ||
        !is_undamaged(check.number(), block))
      return damaged_depth(file);
    return true;
  }
};

DepthVideo::DepthVideo(std::unique_ptr<State> state) : state_(std::move(state)) {}
DepthVideo::DepthVideo(DepthVideo&&) noexcept = default;
DepthVideo& DepthVideo::operator=(DepthVideo&&) noexcept = default;
DepthVideo::~DepthVideo() = default;

Result<DepthVideo> DepthVideo::open(const std::filesystem::path& file) {
  auto input = open_video_input(file);
  if (!input) return input.error();
  const AVDictionaryEntry* tag = av_dict_get(input->context->metadata, kDepthVideoTag, nullptr, 0);
  const AVCodecParameters& stream = *input->video()->codecpar;
  if (tag == nullptr || tag->value != kDepthSentence || stream.codec_id != AV_CODEC_ID_FFV1)
    return not_depth(file);
  const AVCodec* found = avcodec_find_decoder(AV_CODEC_ID_FFV1);
  AvPtr<AVCodecContext> decoder(found == nullptr ? nullptr : avcodec_alloc_context3(found));
  if (!decoder) return damaged_depth(file);
  avcodec_parameters_to_context(decoder.get(), &stream);
  decoder->thread_count = 1;
  decoder->err_recognition = AV_EF_CRCCHECK | AV_EF_EXPLODE;  // a damaged frame is an error
  if (avcodec_open2(decoder.get(), found, nullptr) < 0) return damaged_depth(file);
  auto state = std::make_unique<State>();
  state->file = file;
  state->input = std::move(*input);
  state->decoder = std::move(decoder);
  auto index = index_matroska(file);
  state->check = Descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!index || !index->is_walkable || !state->check.is_open()) return damaged_depth(file);
  state->index = std::move(index).value();
  return DepthVideo(std::move(state));
}

cv::Size DepthVideo::size() const {
  const AVCodecParameters& stream = *state_->input.video()->codecpar;
  return {stream.width, stream.height};
}

double DepthVideo::frames_per_s() const {
  const AVRational rate = state_->input.video()->avg_frame_rate;
  return rate.num > 0 && rate.den > 0 ? av_q2d(rate) : 30.0;
}

Result<std::string> DepthVideo::next_packet() {
  const auto is_there = state_->read();
  if (!is_there) return is_there.error();
  if (!*is_there) return std::string();
  const AVPacket& packet = *state_->packet;
  return std::string(reinterpret_cast<const char*>(packet.data),
                     static_cast<std::size_t>(packet.size));
}

Result<cv::Mat> DepthVideo::next_mm() {
  State& s = *state_;
  const auto is_there = s.read();
  if (!is_there) return is_there.error();
  if (!*is_there) return cv::Mat();
  if (avcodec_send_packet(s.decoder.get(), s.packet.get()) < 0 ||
      avcodec_receive_frame(s.decoder.get(), s.frame.get()) < 0)
    return damaged_depth(s.file);
  const AVFrame& frame = *s.frame;
  if (frame.format != AV_PIX_FMT_GRAY16LE || frame.width != size().width ||
      frame.height != size().height || frame.decode_error_flags != 0)
    return damaged_depth(s.file);
  cv::Mat steps(frame.height, frame.width, CV_16UC1);
  for (int v = 0; v < steps.rows; ++v) {
    const auto* row = frame.data[0] + std::ptrdiff_t{v} * frame.linesize[0];
    auto* values = steps.ptr<std::uint16_t>(v);
    for (std::ptrdiff_t u = 0; u < steps.cols; ++u)
      values[u] = static_cast<std::uint16_t>(row[2 * u] | row[2 * u + 1] << 8);
  }
  return depth_of_steps(steps);
}

}  // namespace alltact
