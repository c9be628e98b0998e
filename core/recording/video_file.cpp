#include "core/recording/video_file.h"

#include "core/base/atomic_file.h"
#include "core/base/descriptor.h"
#include "core/base/result.h"
#include "core/image/grey_decoder.h"
#include "core/recording/journal.h"
#include "core/recording/libav.h"
#include "core/recording/matroska.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <numeric>
#include <optional>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

extern "C" {
#include <libavutil/display.h>
}

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr double kTypicalRate = 30;  // frames per second

/// A packet of the video. Times are in the stream's steps, or AV_NOPTS_VALUE.
struct Entry {
  std::int64_t shown_at, decoded_at;
  std::int64_t data_bytes_at;  // in the file: its identity, with the time of decoding
  bool is_key, is_shown;       // packets that are not shown are needed to decode others
  MatroskaIndex::Block block;  // for its check sum; only of own recordings
};

Error unreadable(const Message& what, const fs::path& file) {
  return {what, file.string(),
          en::say("play it in a video player; if that fails too, record it again")};
}

/// All packets of the video, by reading through the complete file.
std::vector<Entry> entries_by_reading(const VideoInput& input) {
  std::vector<Entry> entries;
  const AvPtr<AVPacket> packet(av_packet_alloc());
  // libav calls every packet behind a key frame on the same Ogg page a key frame.
  const bool are_keys_unknown = std::string_view(input.context->iformat->name) == "ogg";
  while (input.read(*packet)) {
    const bool is_key = (packet->flags & AV_PKT_FLAG_KEY) != 0;
    entries.push_back({packet->pts,
                       packet->dts,
                       packet->pos,
                       is_key && (!are_keys_unknown || entries.empty()),
                       (packet->flags & AV_PKT_FLAG_DISCARD) == 0,
                       {}});
  }
  return entries;
}

/// The same from the file's structure; libav receives the key frames for seeking.
std::vector<Entry> entries_by_structure(const VideoInput& input, const MatroskaIndex& index) {
  std::vector<Entry> entries;
  for (const auto& block : index.blocks) {
    entries.push_back({block.time, AV_NOPTS_VALUE, block.data_bytes_at, block.is_key, true, block});
    if (block.is_key)
      av_add_index_entry(input.video(), block.cluster_at, block.time, 0, 0, AVINDEX_KEYFRAME);
  }
  return entries;
}

/// Whether the file gives each frame the time at which it is shown.
bool are_all_timed(const std::vector<Entry>& entries) {
  std::vector<std::int64_t> times;
  for (const Entry& entry : entries) times.push_back(entry.shown_at);
  std::sort(times.begin(), times.end());
  return times.front() != AV_NOPTS_VALUE &&
         std::adjacent_find(times.begin(), times.end()) == times.end();
}

Result<AvPtr<AVCodecContext>> open_decoder(const AVCodecParameters& parameters, bool is_own,
                                           const fs::path& file) {
  const AVCodec* found = avcodec_find_decoder(parameters.codec_id);
  if (found == nullptr)
    return unreadable(en::say("the video cannot be opened: no decoder for {}",
                              std::string(avcodec_get_name(parameters.codec_id))),
                      file);
  AvPtr<AVCodecContext> context(avcodec_alloc_context3(found));
  avcodec_parameters_to_context(context.get(), &parameters);
  context->thread_type = FF_THREAD_SLICE;  // frame threads would delay frames
  context->thread_count = 2;
  if (is_own) context->err_recognition = AV_EF_CRCCHECK | AV_EF_EXPLODE;  // damage is an error
  if (avcodec_open2(context.get(), found, nullptr) < 0)
    return unreadable(en::say("the video cannot be opened"), file);
  return context;
}

/// Separates frames that some encoders of MPEG-4 pack together; null for other codecs.
AvPtr<AVBSFContext> open_unpacker(const AVStream& video) {
  AVBSFContext* made = nullptr;
  const AVBitStreamFilter* filter = av_bsf_get_by_name("mpeg4_unpack_bframes");
  if (video.codecpar->codec_id != AV_CODEC_ID_MPEG4 || filter == nullptr ||
      av_bsf_alloc(filter, &made) < 0)
    return nullptr;
  AvPtr<AVBSFContext> unpacker(made);
  avcodec_parameters_copy(unpacker->par_in, video.codecpar);
  unpacker->time_base_in = video.time_base;
  return av_bsf_init(unpacker.get()) < 0 ? nullptr : std::move(unpacker);
}

/// Degrees by which a viewer is asked to turn the images; 0: none.
int requested_rotation_deg(const AVStream& video) {
  const auto* matrix = reinterpret_cast<const std::int32_t*>(
      av_stream_get_side_data(&video, AV_PKT_DATA_DISPLAYMATRIX, nullptr));
  const double degrees = matrix == nullptr ? 0.0 : av_display_rotation_get(matrix);
  return std::isfinite(degrees) ? static_cast<int>(std::lround(degrees)) : 0;
}

}  // namespace

struct VideoFile::State {
  fs::path file;
  VideoInput input;
  GreyDecoder jpeg_decoder;
  AvPtr<AVBSFContext> unpacker;        // may be null
  AvPtr<AVCodecContext> decoder;       // none for JPEG, which GreyDecoder decodes as for a camera
  std::vector<Entry> entries;          // in the file's order
  std::vector<std::size_t> shown;      // the entry of each frame
  std::vector<std::int64_t> times_ns;  // of each frame, by the file
  std::vector<JournalEntry> journal;
  GreyLevels levels;
  std::vector<Message> remarks;

  Descriptor check;  // the open file, for check sums; not open for videos of other programs

  AvPtr<AVPacket> packet{av_packet_alloc()};
  AvPtr<AVFrame> av_frame{av_frame_alloc()};
  std::size_t next_read = 0;     // the entry that libav would return next
  std::size_t next_decoded = 0;  // the entry that the decoder expects
  std::size_t next_shown = 0;    // frames before it have left the decoder
  bool is_draining = false;

  [[nodiscard]] bool is_own() const { return check.is_open(); }
  [[nodiscard]] bool find(std::size_t entry);
  [[nodiscard]] bool read(std::size_t entry);
  [[nodiscard]] bool feed();
  [[nodiscard]] bool send(AVPacket* sent);
  void restart(std::size_t entry);
  [[nodiscard]] std::size_t key_before(std::size_t entry) const;
  [[nodiscard]] Status decode(std::size_t number);
  [[nodiscard]] Status decode_from(std::size_t entry, std::size_t number);
  [[nodiscard]] Status add_jpeg(std::size_t number, Frame& frame);
  [[nodiscard]] Status find_order(const Job& job);
  [[nodiscard]] std::int64_t Entry::*time() const;
  [[nodiscard]] double rate() const;
  void order_by_time();
  [[nodiscard]] Status order_by_decoding(const Job& job);
  void find_times();
  void look();
  void set_times(std::size_t number, Frame& frame) const;
  [[nodiscard]] Error frame_error(std::size_t number) const {
    return unreadable(en::say("frame {} of the video cannot be read", number), file);
  }
};

/// Reads on up to the packet of this entry.
bool VideoFile::State::find(std::size_t entry) {
  const Entry& requested = entries[entry];
  while (input.read(*packet))
    if (packet->pos == requested.data_bytes_at &&
        (requested.decoded_at == AV_NOPTS_VALUE || packet->dts == requested.decoded_at))
      return true;
  return false;
}

/// Fills `packet` with the packet of this entry.
bool VideoFile::State::read(std::size_t entry) {
  if (entry != next_read) {
    const Entry& key = entries[key_before(entry)];
    av_seek_frame(input.context.get(), input.stream,
                  key.decoded_at != AV_NOPTS_VALUE ? key.decoded_at : key.shown_at,
                  AVSEEK_FLAG_BACKWARD);
  }
  next_read = entries.size();  // unknown position: the next read seeks
  bool is_found = find(entry);
  if (!is_found && !is_own()) {  // not every file can be sought in: from its beginning
    auto again = open_video_input(file);
    if (!again) return false;
    input = std::move(*again);
    is_found = find(entry);
  }
  if (!is_found) return false;
  next_read = entry + 1;
  return !is_own() || is_undamaged(check.number(), entries[entry].block);
}

std::size_t VideoFile::State::key_before(std::size_t entry) const {
  while (entry > 0 && !entries[entry].is_key) --entry;
  return entry;
}

void VideoFile::State::restart(std::size_t entry) {
  avcodec_flush_buffers(decoder.get());
  if (unpacker) av_bsf_flush(unpacker.get());
  next_decoded = entry;
  is_draining = false;
}

bool VideoFile::State::send(AVPacket* sent) {
  return avcodec_send_packet(decoder.get(), sent) >= 0;
}

/// Sends the next packet to the decoder. False: the decoder has everything, or refused.
bool VideoFile::State::feed() {
  if (next_decoded == entries.size()) {
    if (is_draining) return false;
    is_draining = true;
    return send(nullptr);
  }
  const std::size_t entry = next_decoded++;
  if (!read(entry)) return false;
  // Returns with the frame as its identity, also where the order changes.
  packet->pts = packet->dts = static_cast<std::int64_t>(entry);
  if (unpacker) {
    if (av_bsf_send_packet(unpacker.get(), packet.get()) < 0) return false;
    const int status = av_bsf_receive_packet(unpacker.get(), packet.get());
    if (status == AVERROR(EAGAIN)) return true;  // it retains the packet for the next one
    if (status < 0) return false;
  }
  return send(packet.get());
}

/// Fills av_frame.
Status VideoFile::State::decode(std::size_t number) {
  const std::size_t begin = key_before(shown[number]);
  const bool goes_on = number >= next_shown && begin <= next_decoded && !is_draining;
  Status status = decode_from(goes_on ? next_decoded : begin, number);
  // Frames next to a key frame may depend on the one before it.
  if (!status && !is_own() && begin > 0) status = decode_from(key_before(begin - 1), number);
  return status;
}

/// `entry`: where to start; next_decoded goes on.
Status VideoFile::State::decode_from(std::size_t entry, std::size_t number) {
  if (entry != next_decoded || is_draining) restart(entry);
  next_shown = entries.size();  // an error makes the next call start again
  const auto requested = static_cast<std::int64_t>(shown[number]);
  while (true) {
    const int status = avcodec_receive_frame(decoder.get(), av_frame.get());
    if (status == AVERROR(EAGAIN)) {
      if (!feed()) return frame_error(number);
    } else if (status < 0) {
      return frame_error(number);
    } else if (av_frame->pts == requested) {
      break;
    }
  }
  if (av_frame->decode_error_flags != 0 || (av_frame->flags & AV_FRAME_FLAG_CORRUPT) != 0)
    return frame_error(number);
  next_shown = number + 1;
  return {};
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

Status VideoFile::State::find_order(const Job& job) {
  const AVCodecDescriptor* codec = avcodec_descriptor_get(input.video()->codecpar->codec_id);
  const bool is_intra = codec != nullptr && (codec->props & AV_CODEC_PROP_INTRA_ONLY) != 0;
  if (are_all_timed(entries) || is_intra) {
    order_by_time();
  } else if (Status status = order_by_decoding(job); !status) {
    return status;
  }
  if (shown.empty()) return unreadable(en::say("the video holds no frame"), file);
  find_times();
  return {};
}

/// Times at which frames are shown; where the file lacks some, those of decoding.
std::int64_t Entry::*VideoFile::State::time() const {
  const bool is_timed = std::none_of(entries.begin(), entries.end(), [](const Entry& entry) {
    return entry.is_shown && entry.shown_at == AV_NOPTS_VALUE;
  });
  return is_timed ? &Entry::shown_at : &Entry::decoded_at;
}

double VideoFile::State::rate() const {
  const AVStream& video = *input.video();
  for (const AVRational rate : {video.avg_frame_rate, video.r_frame_rate})
    if (rate.num > 0 && rate.den > 0) return av_q2d(rate);
  return kTypicalRate;
}

void VideoFile::State::order_by_time() {
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (entries[i].is_shown) shown.push_back(i);
  std::stable_sort(shown.begin(), shown.end(), [&, of = time()](std::size_t a, std::size_t b) {
    return entries[a].*of < entries[b].*of;
  });
}

/// The decoder knows the order in which frames are shown, also where the file does not.
Status VideoFile::State::order_by_decoding(const Job& job) {
  while (true) {
    if (job.stop_requested())
      return Error{en::say("stopped before the video was open"), file.string(), ""};
    const int status = avcodec_receive_frame(decoder.get(), av_frame.get());
    if (status >= 0 && av_frame->pts != AV_NOPTS_VALUE) {
      const auto entry = static_cast<std::size_t>(av_frame->pts);
      if (entry < entries.size() && entries[entry].is_shown) shown.push_back(entry);
    } else if (status == AVERROR_EOF || (!feed() && is_draining)) {
      break;
    }
    if (shown.size() % 64 == 0)
      job.report(static_cast<double>(next_decoded) / static_cast<double>(entries.size()),
                 en::say("looking for the order of the video's frames"));
  }
  restart(0);
  next_read = entries.size();
  const auto expected = static_cast<std::size_t>(
      std::count_if(entries.begin(), entries.end(), [](const Entry& e) { return e.is_shown; }));
  if (shown.size() < expected)
    remarks.push_back(en::say("{} of its {} frames cannot be decoded and are missing",
                              expected - shown.size(), expected));
  return {};
}

/// Where the decoder changed the order, frames take the times of decoding one after the other;
/// where the file has no times, or repeats most of them, those of its frame rate.
void VideoFile::State::find_times() {
  const AVStream& video = *input.video();
  std::vector<std::int64_t> steps;
  for (const auto of = time(); const std::size_t i : shown) steps.push_back(entries[i].*of);
  std::sort(steps.begin(), steps.end());
  std::vector<std::int64_t> different = steps;
  different.erase(std::unique(different.begin(), different.end()), different.end());
  const bool is_timed = steps.front() != AV_NOPTS_VALUE && 2 * different.size() > steps.size();
  // Without times a higher rate is that of the file's clock.
  const double assumed = rate() < 500 ? rate() : kTypicalRate;
  for (std::size_t i = 0; i < steps.size(); ++i)
    times_ns.push_back(is_timed ? av_rescale_q(steps[i], video.time_base, {1, 1000000000})
                                : std::llround(1e9 * static_cast<double>(i) / assumed));
  // Of streams without a container libav makes times up.
  const bool are_of_file = (input.context->iformat->flags & AVFMT_NOTIMESTAMPS) == 0;
  if (steps.size() > 1 && !(is_timed && are_of_file))
    remarks.push_back(en::say(
        "it holds no times of its frames: {:.4g} frames per second were assumed",
        1e9 * static_cast<double>(steps.size() - 1) /
            static_cast<double>(std::max<std::int64_t>(1, times_ns.back() - times_ns.front()))));
}

/// At some frames of a video by another program: those that can be decoded alone, if there are
/// enough.
void VideoFile::State::look() {
  constexpr std::size_t kLooks = 5;
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < shown.size(); ++i)
    if (entries[shown[i]].is_key) candidates.push_back(i);
  if (candidates.size() < kLooks) {
    candidates.resize(shown.size());
    std::iota(candidates.begin(), candidates.end(), 0U);
  }
  const std::size_t looks = std::min(kLooks, candidates.size());
  LevelsLook look;
  for (std::size_t k = 0; k < looks; ++k) {
    const std::size_t number =
        candidates[looks < 2 ? 0 : k * (candidates.size() - 1) / (looks - 1)];
    Frame frame;
    if (decoder != nullptr) {
      if (!decode(number)) continue;
      // A VP8 stream cannot state its range, so that its decoder invents one.
      if (decoder->codec_id == AV_CODEC_ID_VP8)
        av_frame->color_range = input.video()->codecpar->color_range;
      look.add(*av_frame);
    } else if (add_jpeg(number, frame)) {
      look.add(frame.grey);
    }
  }
  levels = look.levels();
  for (const auto& seen : {look.remarks(), jpeg_decoder.remarks()})
    remarks.insert(remarks.end(), seen.begin(), seen.end());
  if (const int degrees = requested_rotation_deg(*input.video()); degrees % 360 != 0)
    remarks.push_back(
        en::say("it asks viewers to turn it by {} degrees, which is not done here: "
                "the camera's orientation is a setting of the finger",
                degrees));
}

/// Sets time, sequence and controls from the journal, or behind its end from the video. A crash can
/// leave the journal a line short.
void VideoFile::State::set_times(std::size_t number, Frame& frame) const {
  frame.time_ns = times_ns[number];
  frame.sequence = number;
  if (number < journal.size()) {
    if (journal[number].time_ns) frame.time_ns = journal[number].time_ns;
    frame.sequence = journal[number].sequence;
    frame.controls = journal[number].controls;
    return;
  }
  if (journal.empty()) return;
  *frame.time_ns += journal.front().time_ns.value_or(0);
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
  if (state->entries.empty()) return unreadable(en::say("the video holds no frame"), file);
  const AVStream& video = *state->input.video();
  if (is_own_recording(*state->input.context))
    state->check = Descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (video.codecpar->codec_id != AV_CODEC_ID_MJPEG) {
    state->unpacker = open_unpacker(video);
    auto decoder = open_decoder(state->unpacker ? *state->unpacker->par_out : *video.codecpar,
                                state->is_own(), file);
    if (!decoder) return decoder.error();
    state->decoder = std::move(*decoder);
  }
  if (Status status = state->find_order(job); !status) return status.error();
  if (!state->is_own()) state->look();
  for (Message& remark : state->remarks)
    remark = en::say("{}.", en::at(Message::typed(file.filename().string()), remark));
  auto journal = read_journal(journal_of(file));
  if (!journal) return journal.error();
  state->journal = std::move(*journal);
  return VideoFile(std::move(state));
}

bool contains_video(const fs::path& file) { return open_video_input(file).ok(); }

std::size_t VideoFile::frame_count() const { return state_->shown.size(); }

std::int64_t VideoFile::time_ns(std::size_t number) const {
  Frame frame;
  state_->set_times(number, frame);
  return *frame.time_ns;
}

const std::vector<Message>& VideoFile::remarks() const { return state_->remarks; }

std::optional<fs::path> VideoFile::lossless_file() const {
  const bool is_lossless = state_->is_own() && state_->decoder &&
                           state_->decoder->codec_id == AV_CODEC_ID_MAGICYUV &&
                           state_->shown.size() == state_->entries.size();
  return is_lossless ? std::optional(state_->file) : std::nullopt;
}

double VideoFile::frames_per_s() const { return state_->rate(); }

Result<FramePtr> VideoFile::frame(std::size_t number) {
  State& s = *state_;
  assert(number < s.shown.size());
  auto frame = std::make_shared<Frame>();
  frame->name = fmt::format("frame_{:05}", number);
  frame->origin = s.file.string();
  if (s.decoder) {
    if (Status status = s.decode(number); !status) return status.error();
    auto grey = grey_of(*s.av_frame, s.levels);
    if (!grey) return Error{grey.error().what, s.file.string(), grey.error().advice};
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
    context.color_range = AVCOL_RANGE_JPEG;
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
  std::optional<std::int64_t> first_ns = {}, last_ns = {};
  std::optional<double> last_ms = {};

  [[nodiscard]] double time_ms(const Frame& frame) {
    if (!first_ns) first_ns = frame.time_ns;
    if (!last_ms) {
      last_ns = first_ns;
      return *(last_ms = 0.0);
    }
    const double next_ms = *last_ms + std::max(period_ms, 1.0);
    if (!frame.time_ns) return *(last_ms = next_ms);
    const double captured_ms = static_cast<double>(*frame.time_ns - *first_ns) * 1e-6;
    const bool is_later =
        *frame.time_ns > last_ns.value_or(*frame.time_ns - 1) && captured_ms >= *last_ms + 1;
    last_ns = std::max(last_ns.value_or(*frame.time_ns), *frame.time_ns);
    return *(last_ms = is_later ? captured_ms : next_ms);
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

struct Copying {
  std::vector<char> keep;  // by packet
  Message doing, stopped;
};

Status copy_packets(const fs::path& from, const fs::path& to,
                    const std::vector<MatroskaIndex::Block>& blocks, const Copying& copying,
                    const Job& job) {
  const auto input = open_video_input(from);
  if (!input) return input.error();
  const AVStream& video = *input->video();
  const double frames_per_s =
      video.avg_frame_rate.num > 0 ? av_q2d(video.avg_frame_rate) : kTypicalRate;
  auto output = MatroskaFile::create(to, *video.codecpar, frames_per_s);
  if (!output) return output.error();
  const AvPtr<AVPacket> packet(av_packet_alloc());
  std::optional<std::int64_t> first_ms;
  const std::size_t count = copying.keep.size();
  std::size_t read = 0;
  // The rest of an interrupted frame follows the last complete block.
  while (read < std::min(count, blocks.size()) && input->read(*packet) &&
         packet->pos == blocks[read].data_bytes_at) {
    if (job.stop_requested()) return Error{copying.stopped, from.string(), ""};
    if (read % 64 == 0)
      job.report(static_cast<double>(read) / static_cast<double>(count), copying.doing);
    if (!copying.keep[read++]) continue;
    av_packet_rescale_ts(packet.get(), video.time_base, {1, 1000});
    if (!first_ms) first_ms = packet->pts;
    packet->pts = packet->dts = packet->pts - *first_ms;
    if (Status status = output->write(*packet); !status) return status;
  }
  if (read < count)
    return Error{en::say("only {} of its {} frames could be read", read, count), from.string(),
                 en::say("another copy of the recording")};
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
    return copy_packets(
        file, temporary, index->blocks,
        {std::vector<char>(index->blocks.size(), 1), en::say("repairing an interrupted recording"),
         en::say("stopped before it was repaired")},
        job);
  });
  if (!written) return written.error();
  remark_lost(file, index->blocks.size());
  return true;
}

Status copy_frames(const fs::path& from, const fs::path& to, const std::vector<char>& keep,
                   const Job& job) {
  const auto index = index_matroska(from);
  if (!index) return index.error();
  return copy_packets(from, to, index->blocks,
                      {keep, en::say("writing the accepted frames"),
                       en::say("stopped before the recording was written")},
                      job);
}

}  // namespace alltact
