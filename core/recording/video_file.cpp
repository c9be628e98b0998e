#include "core/recording/video_file.h"

#include "core/base/atomic_file.h"
#include "core/base/descriptor.h"
#include "core/base/result.h"
#include "core/image/grey_decoder.h"
#include "core/recording/journal.h"
#include "core/recording/libav.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cerrno>
#include <numeric>
#include <span>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

extern "C" {
#include <libavutil/crc.h>
}

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// A packet: time in the stream's time steps, file position (its identity), key flag, and check
/// sum.
using Entry = MatroskaIndex::Block;

Error unreadable(const Message& what, const fs::path& file) {
  return {what, file.string(),
          en::say("play it in a video player; if that fails too, record it again")};
}

std::int64_t time_of(const AVPacket& packet, std::int64_t otherwise) {
  if (packet.pts != AV_NOPTS_VALUE) return packet.pts;
  return packet.dts != AV_NOPTS_VALUE ? packet.dts : otherwise;
}

/// All packets of the video, by reading through the complete file.
std::vector<Entry> entries_by_reading(const VideoInput& input) {
  std::vector<Entry> entries;
  const AvPtr<AVPacket> packet(av_packet_alloc());
  while (input.read(*packet))
    entries.push_back({time_of(*packet, static_cast<std::int64_t>(entries.size())), packet->pos, 0,
                       (packet->flags & AV_PKT_FLAG_KEY) != 0, 0, 0, 0});
  return entries;
}

/// The same from the file's structure; libav receives the key frames for seeking.
std::vector<Entry> entries_by_structure(const VideoInput& input, const MatroskaIndex& index) {
  for (const auto& block : index.blocks)
    if (block.is_key)
      av_add_index_entry(input.video(), block.cluster_at, block.time, 0, 0, AVINDEX_KEYFRAME);
  return index.blocks;
}

Result<AvPtr<AVCodecContext>> open_decoder(const AVStream& video, const fs::path& file) {
  const AVCodec* found = avcodec_find_decoder(video.codecpar->codec_id);
  if (found == nullptr)
    return unreadable(en::say("the video cannot be opened: no decoder for {}",
                              std::string(avcodec_get_name(video.codecpar->codec_id))),
                      file);
  AvPtr<AVCodecContext> context(avcodec_alloc_context3(found));
  avcodec_parameters_to_context(context.get(), video.codecpar);
  context->thread_type = FF_THREAD_SLICE;  // frame threads would delay frames
  context->thread_count = 2;
  context->err_recognition = AV_EF_CRCCHECK | AV_EF_EXPLODE;  // a damaged frame is an error
  if (avcodec_open2(context.get(), found, nullptr) < 0)
    return unreadable(en::say("the video cannot be opened"), file);
  return context;
}

}  // namespace

struct VideoFile::State {
  fs::path file;
  VideoInput input;
  GreyDecoder jpeg_decoder;
  AvPtr<AVCodecContext> decoder;   // none for JPEG, which GreyDecoder decodes as for a camera
  std::vector<Entry> entries;      // in the file's order
  std::vector<std::size_t> shown;  // the entry of each frame
  std::vector<JournalEntry> journal;

  Descriptor check;  // the open file, for check sums; not open for videos of other programs

  AvPtr<AVPacket> packet{av_packet_alloc()};
  AvPtr<AVFrame> av_frame{av_frame_alloc()};
  std::size_t next_read = 0;     // the entry that libav would return next
  std::size_t next_decoded = 0;  // the entry that the decoder expects
  std::size_t next_shown = 0;    // frames before it have left the decoder
  bool is_draining = false;

  [[nodiscard]] bool read(std::size_t entry);
  [[nodiscard]] bool feed();
  void restart(std::size_t entry);
  [[nodiscard]] std::size_t key_before(std::size_t entry) const;
  [[nodiscard]] Result<cv::Mat> decoded(std::size_t number);
  [[nodiscard]] Status add_jpeg(std::size_t number, Frame& frame);
  void set_times(std::size_t number, Frame& frame) const;
  [[nodiscard]] Error frame_error(std::size_t number) const {
    return unreadable(en::say("frame {} of the video cannot be read", number), file);
  }
};

/// Fills `packet` with the packet of this entry.
bool VideoFile::State::read(std::size_t entry) {
  const std::int64_t position = entries[entry].data_bytes_at;
  if (entry != next_read)
    av_seek_frame(input.context.get(), input.stream, entries[key_before(entry)].time,
                  AVSEEK_FLAG_BACKWARD);
  next_read = entry + 1;
  while (input.read(*packet))
    if (packet->pos == position)
      return !check.is_open() || is_undamaged(check.number(), entries[entry]);
  next_read = entries.size();  // unknown position: the next read seeks
  return false;
}

std::size_t VideoFile::State::key_before(std::size_t entry) const {
  while (entry > 0 && !entries[entry].is_key) --entry;
  return entry;
}

void VideoFile::State::restart(std::size_t entry) {
  avcodec_flush_buffers(decoder.get());
  next_decoded = entry;
  is_draining = false;
}

/// Sends the next packet to the decoder. False: the decoder has everything, or refused.
bool VideoFile::State::feed() {
  if (next_decoded == entries.size()) {
    if (is_draining) return false;
    is_draining = true;
    return avcodec_send_packet(decoder.get(), nullptr) >= 0;
  }
  const std::size_t entry = next_decoded++;
  if (!read(entry)) return false;
  // Returns with the frame as its identity, also where the order changes.
  packet->pts = packet->dts = static_cast<std::int64_t>(entry);
  return avcodec_send_packet(decoder.get(), packet.get()) >= 0;
}

Result<cv::Mat> VideoFile::State::decoded(std::size_t number) {
  const std::size_t entry = shown[number];
  const std::size_t begin = key_before(entry);
  if (number < next_shown || begin > next_decoded || is_draining) restart(begin);
  next_shown = entries.size();  // an error makes the next call start again
  while (true) {
    const int status = avcodec_receive_frame(decoder.get(), av_frame.get());
    if (status == AVERROR(EAGAIN)) {
      if (!feed()) return frame_error(number);
    } else if (status < 0) {
      return frame_error(number);
    } else if (av_frame->pts == static_cast<std::int64_t>(entry)) {
      break;
    }
  }
  if (av_frame->decode_error_flags != 0 || (av_frame->flags & AV_FRAME_FLAG_CORRUPT) != 0)
    return frame_error(number);
  next_shown = number + 1;
  auto grey = grey_of(*av_frame);
  if (!grey) return Error{grey.error().what, file.string(), grey.error().advice};
  return grey;
}

Status VideoFile::State::add_jpeg(std::size_t number, Frame& frame) {
  if (!read(shown[number])) return frame_error(number);
  frame.jpeg =
      std::make_shared<const std::vector<std::uint8_t>>(packet->data, packet->data + packet->size);
  const AVCodecParameters& size = *input.video()->codecpar;
  auto grey = jpeg_decoder(PixelFormat::kMjpeg, size.width, size.height, 0, *frame.jpeg);
  if (!grey) return frame_error(number);
  frame.grey = std::move(*grey);
  return {};
}

/// Sets time, sequence and controls from the journal, or behind its end from the video. A crash can
/// leave the journal a line short.
void VideoFile::State::set_times(std::size_t number, Frame& frame) const {
  if (number < journal.size()) {
    frame.time_ns = journal[number].time_ns;
    frame.sequence = journal[number].sequence;
    frame.controls = journal[number].controls;
    return;
  }
  const AVRational step = input.video()->time_base;
  frame.time_ns = av_rescale_q(entries[shown[number]].time, step, {1, 1000000000});
  frame.sequence = number;
  if (journal.empty()) return;
  frame.time_ns += journal.front().time_ns;
  frame.sequence += journal.back().sequence - (journal.size() - 1);
}

VideoFile::VideoFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
VideoFile::VideoFile(VideoFile&&) noexcept = default;
VideoFile& VideoFile::operator=(VideoFile&&) noexcept = default;
VideoFile::~VideoFile() = default;

Result<VideoFile> VideoFile::open(const fs::path& file, const Job& job) {
  // A failed repair is no error: the video is still read.
  [[maybe_unused]] const auto repaired = repair_recording(file, job);
  auto input = open_video_input(file);
  if (!input) return input.error();
  auto state = std::make_unique<State>();
  state->file = file;
  const auto index = index_matroska(file);
  // A crash leaves an incomplete frame at the end, but damage has complete ones behind it.
  const bool has_structure = index && (index->is_walkable || !index->has_length);
  if (has_structure && input->context->nb_streams == 1) {
    state->entries = entries_by_structure(*input, *index);
  } else {
    state->entries = entries_by_reading(*input);
    input = open_video_input(file);
    if (!input) return input.error();
  }
  state->input = std::move(*input);
  if (is_own_recording(*state->input.context))
    state->check = Descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  const auto& entries = state->entries;
  if (entries.empty()) return unreadable(en::say("the video holds no frame"), file);
  state->shown.resize(entries.size());
  std::iota(state->shown.begin(), state->shown.end(), 0U);
  std::stable_sort(state->shown.begin(), state->shown.end(),
                   [&](std::size_t a, std::size_t b) { return entries[a].time < entries[b].time; });
  if (state->input.video()->codecpar->codec_id != AV_CODEC_ID_MJPEG) {
    auto decoder = open_decoder(*state->input.video(), file);
    if (!decoder) return decoder.error();
    state->decoder = std::move(*decoder);
  }
  auto journal = read_journal(journal_of(file));
  if (!journal) return journal.error();
  state->journal = std::move(*journal);
  return VideoFile(std::move(state));
}

std::size_t VideoFile::frame_count() const { return state_->shown.size(); }

std::int64_t VideoFile::time_ns(std::size_t number) const {
  Frame frame;
  state_->set_times(number, frame);
  return frame.time_ns;
}

double VideoFile::frames_per_s() const {
  const AVStream& video = *state_->input.video();
  for (const AVRational rate : {video.avg_frame_rate, video.r_frame_rate})
    if (rate.num > 0 && rate.den > 0) return av_q2d(rate);
  return 30.0;
}

Result<FramePtr> VideoFile::frame(std::size_t number) {
  State& s = *state_;
  assert(number < s.shown.size());
  auto frame = std::make_shared<Frame>();
  frame->name = fmt::format("frame_{:05}", number);
  frame->origin = s.file.string();
  if (s.decoder) {
    auto grey = s.decoded(number);
    if (!grey) return grey.error();
    frame->grey = std::move(*grey);
  } else if (Status status = s.add_jpeg(number, *frame); !status) {
    return status.error();
  }
  s.set_times(number, *frame);
  return FramePtr(std::move(frame));
}

namespace {

constexpr int kSlices = 4;
constexpr int kSmallestSliced = 32;  // px; smaller frames cannot be cut into slices

Message encoding() { return en::say("could not encode the image"); }

/// Encodes grey frames to packets, one each, without delay.
class Encoder {
 public:
  static Result<Encoder> create(VideoCodec codec, cv::Size size, double frames_per_s) {
    const bool is_ffv1 = codec == VideoCodec::kFfv1;
    const AVCodec* found = avcodec_find_encoder(is_ffv1 ? AV_CODEC_ID_FFV1 : AV_CODEC_ID_MAGICYUV);
    if (found == nullptr)
      return Error{
          en::say("this system's libavcodec cannot write {}", std::string(to_string(codec))), "",
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
      std::copy_n(grey.ptr<std::uint8_t>(v), grey.cols,
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
    return Error{en::say("only 8-bit grey images can be recorded"), frame.origin,
                 en::say("a grey source")};
  if (frame.grey.size() != size)
    return Error{en::say("the image is {} x {}, those before were {} x {}", frame.grey.cols,
                         frame.grey.rows, size.width, size.height),
                 frame.origin, en::say("one recording for each size")};
  if (codec == VideoCodec::kMjpeg && !frame.jpeg)
    return Error{en::say("the source delivers no JPEG packets to store unchanged"), frame.origin,
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

Result<VideoWriter> VideoWriter::create(const std::filesystem::path& file, const Frame& first,
                                        VideoCodec requested, double frames_per_s) {
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

Status VideoWriter::finish() { return state_->file.finish(); }
VideoCodec VideoWriter::codec() const { return state_->codec; }
std::uint64_t VideoWriter::bytes() const { return state_->file.bytes(); }
int VideoWriter::descriptor() const { return state_->file.descriptor(); }

namespace {

namespace fs = std::filesystem;

Status copy_packets(const fs::path& from, const fs::path& to,
                    const std::vector<MatroskaIndex::Block>& blocks, const Job& job) {
  const auto input = open_video_input(from);
  if (!input) return input.error();
  const AVStream& video = *input->video();
  const double frames_per_s = video.avg_frame_rate.num > 0 ? av_q2d(video.avg_frame_rate) : 30.0;
  auto output = MatroskaFile::create(to, *video.codecpar, frames_per_s);
  if (!output) return output.error();
  const AvPtr<AVPacket> packet(av_packet_alloc());
  std::size_t copied = 0;
  // The rest of an interrupted frame follows the last complete block.
  while (copied < blocks.size() && input->read(*packet) &&
         packet->pos == blocks[copied].data_bytes_at) {
    if (job.stop_requested())
      return Error{en::say("stopped before it was repaired"), from.string(), ""};
    if (copied % 64 == 0)
      job.report(static_cast<double>(copied) / static_cast<double>(blocks.size()),
                 en::say("repairing an interrupted recording"));
    av_packet_rescale_ts(packet.get(), video.time_base, {1, 1000});
    if (Status status = output->write(*packet); !status) return status;
    ++copied;
  }
  if (copied < blocks.size())
    return Error{en::say("only {} of its {} frames could be read", copied, blocks.size()),
                 from.string(), en::say("another copy of the recording")};
  return output->finish();
}

Status check_space(const fs::path& file) {
  std::error_code failed;
  const auto bytes = fs::file_size(file, failed);
  const auto space = fs::space(fs::absolute(file).parent_path(), failed);
  constexpr std::uintmax_t kSpareBytes = 64 << 20;  // for other writers meanwhile
  if (!failed && space.available < bytes + bytes / 64 + kSpareBytes)
    return system_error(en::say("the interrupted recording cannot be repaired"), file, ENOSPC);
  return {};
}

/// Reports lost frames: after a power cut the journal may have more frames than the video.
void remark_lost(const fs::path& file, std::size_t frames) {
  const auto journal = read_journal(journal_of(file));
  if (!journal || journal->size() <= frames) return;
  // The repair is valid without this remark.
  [[maybe_unused]] const Status ignored = remark_in_journal(
      journal_of(file),
      fmt::format("cut off and mended: the video holds {} of the {} frames that are told of here, "
                  "the last ones did not reach the disk",
                  frames, journal->size()));
}

}  // namespace

Result<bool> repair_recording(const fs::path& file, const Job& job) {
  const auto input = open_video_input(file);
  if (!input) return input.error();
  if (!input->is_matroska() || !is_own_recording(*input->context)) return false;
  // Locks the file against other recorders and repairs while it is open.
  const Descriptor lock(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!lock.is_open() || ::flock(lock.number(), LOCK_EX | LOCK_NB) != 0)
    return Error{en::say("it is being recorded or repaired right now"), file.string(),
                 en::say("wait for its end")};
  // Only under the lock: the writer may have finished the file just before.
  const auto index = index_matroska(file);
  if (!index) return index.error();
  if (index->has_length || index->blocks.empty()) return false;
  if (Status status = check_space(file); !status) return status.error();
  const Status written = write_file_atomically(file, [&](const fs::path& temporary) {
    return copy_packets(file, temporary, index->blocks, job);
  });
  if (!written) return written.error();
  remark_lost(file, index->blocks.size());
  return true;
}

namespace {

// Element numbers, as in the file with their length marker.
constexpr std::uint32_t kEbmlHead = 0x1A45DFA3, kSegment = 0x18538067, kCluster = 0x1F43B675;
constexpr std::uint32_t kTimestamp = 0xE7, kSimpleBlock = 0xA3, kBlockGroup = 0xA0, kBlock = 0xA1;
constexpr std::uint32_t kCheckSum = 0xBF;
constexpr std::uint32_t kReference = 0xFB;  // to the block from which one in a group is predicted

constexpr std::int64_t kUnknown = -1;

struct Element {
  std::uint32_t id = 0;
  std::int64_t content_at = 0;
  std::int64_t bytes = 0;  // of the content, or kUnknown
};

class File {
 public:
  explicit File(const std::filesystem::path& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    struct stat status {};
    if (is_open() && ::fstat(descriptor_.number(), &status) == 0) bytes_ = status.st_size;
  }
  [[nodiscard]] bool is_open() const { return descriptor_.is_open(); }
  [[nodiscard]] std::int64_t bytes() const { return bytes_; }
  /// Reads from `at` on, up to the size of `room`.
  [[nodiscard]] std::span<const std::uint8_t> read(std::int64_t at,
                                                   std::span<std::uint8_t> room) const {
    const ssize_t got = ::pread(descriptor_.number(), room.data(), room.size(), at);
    return room.first(got > 0 ? static_cast<std::size_t>(got) : 0);
  }

 private:
  Descriptor descriptor_;
  std::int64_t bytes_ = 0;
};

/// The element that begins at `at`; empty where there is none, or only a part of its head.
std::optional<Element> element_at(const File& file, std::int64_t at) {
  std::array<std::uint8_t, 12> room{};
  const auto head = file.read(at, room);
  if (head.empty()) return std::nullopt;
  const auto id_length = static_cast<std::size_t>(std::countl_zero(head[0])) + 1;
  if (id_length > 4 || head.size() <= id_length) return std::nullopt;
  Element element;
  for (std::size_t i = 0; i < id_length; ++i) element.id = element.id << 8U | head[i];
  const auto length = static_cast<std::size_t>(std::countl_zero(head[id_length])) + 1;
  if (length > 8 || head.size() < id_length + length) return std::nullopt;
  std::uint64_t value = head[id_length] & (0xFFU >> length);
  for (std::size_t i = 1; i < length; ++i) value = value << 8U | head[id_length + i];
  element.content_at = at + static_cast<std::int64_t>(id_length + length);
  const bool is_unknown = value == (std::uint64_t{1} << (7 * length)) - 1;
  element.bytes = is_unknown ? kUnknown : static_cast<std::int64_t>(value);
  return element;
}

std::int64_t number_in(const File& file, const Element& element) {
  std::array<std::uint8_t, 8> room{};
  const auto requested = static_cast<std::size_t>(std::clamp<std::int64_t>(element.bytes, 0, 8));
  std::int64_t value = 0;
  for (const std::uint8_t byte : file.read(element.content_at, std::span(room).first(requested)))
    value = value << 8U | byte;
  return value;
}

bool holds_others(std::uint32_t id) {
  return id == kSegment || id == kCluster || id == kBlockGroup;
}

/// Walks through a file from its first element to its last. It enters container elements instead of
/// skipping them, because after a crash their lengths are unknown.
class Walk {
 public:
  explicit Walk(const File& file) : file_(file) {}

  MatroskaIndex run() {
    std::int64_t at = 0;
    while (const auto element = element_at(file_, at)) {
      if (element->id == kSegment) index_.has_length = element->bytes != kUnknown;
      if (element->id == kCluster) {
        block_ = {};
        block_.cluster_at = at;
        cluster_end_ = element->bytes == kUnknown ? 0 : element->content_at + element->bytes;
      }
      if (holds_others(element->id)) {
        at = element->content_at;
      } else {
        if (element->bytes == kUnknown || element->bytes > file_.bytes() - element->content_at)
          break;
        take(*element);
        at = element->content_at + element->bytes;
      }
    }
    index_.is_walkable = at == file_.bytes();
    return std::move(index_);
  }

 private:
  void take(const Element& element) {
    if (element.id == kCheckSum && element.bytes == 4 && cluster_end_ > element.content_at) {
      block_.checked_from = element.content_at + 4;
      block_.checked_bytes = cluster_end_ - block_.checked_from;
      std::array<std::uint8_t, 4> sum{};
      for (const std::uint8_t byte : file_.read(element.content_at, sum))
        block_.check_sum = block_.check_sum >> 8U | std::uint32_t{byte} << 24U;
    }
    if (element.id == kTimestamp) cluster_time_ = number_in(file_, element);
    if (element.id == kReference && !index_.blocks.empty()) index_.blocks.back().is_key = false;
    if (element.id != kSimpleBlock && element.id != kBlock) return;
    // The track's number (1 to 8 bytes, in recordings of this program 1), the time after the
    // cluster's (2), flags (1).
    std::array<std::uint8_t, 11> room{};
    const auto head = file_.read(element.content_at, room);
    const auto track = head.empty() ? 9 : static_cast<std::size_t>(std::countl_zero(head[0])) + 1;
    if (track > 8 || head.size() < track + 3) return;
    const auto relative = static_cast<std::int16_t>(head[track] << 8U | head[track + 1]);
    block_.time = cluster_time_ + relative;
    block_.data_bytes_at = element.content_at;
    block_.is_key = element.id == kBlock || (head[track + 2] & 0x80U) != 0;
    index_.blocks.push_back(block_);
  }

  const File& file_;
  MatroskaIndex index_;
  MatroskaIndex::Block block_{};  // the next block, with the values of its cluster
  std::int64_t cluster_time_ = 0, cluster_end_ = 0;
};

}  // namespace

Result<MatroskaIndex> index_matroska(const std::filesystem::path& path) {
  const File file(path);
  if (!file.is_open()) return system_error(en::say("the video cannot be opened"), path, errno);
  const auto head = element_at(file, 0);
  if (!head || head->id != kEbmlHead)
    return Error{en::say("this is no Matroska file"), path.string(),
                 en::say("check that it is the right file")};
  return Walk(file).run();
}

bool is_undamaged(int descriptor, const MatroskaIndex::Block& block) {
  if (block.checked_bytes <= 0) return true;
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 ||
      block.checked_bytes > status.st_size - block.checked_from)
    return false;
  const AVCRC* table = av_crc_get_table(AV_CRC_32_IEEE_LE);
  std::uint32_t sum = 0xFFFFFFFFU;
  // In chunks: a damaged length may be nearly that of the file.
  std::array<std::uint8_t, std::size_t{1} << 16> room{};
  std::int64_t left = block.checked_bytes;
  for (std::int64_t at = block.checked_from; left > 0;) {
    const auto requested = std::min<std::int64_t>(left, std::ssize(room));
    const ssize_t got = ::pread(descriptor, room.data(), static_cast<std::size_t>(requested), at);
    if (got <= 0) return false;
    sum = av_crc(table, sum, room.data(), static_cast<std::size_t>(got));
    at += got;
    left -= got;
  }
  return (sum ^ 0xFFFFFFFFU) == block.check_sum;
}

}  // namespace alltact
