#include "core/recording/video_file.h"

#include "core/io/grey_decoder.h"
#include "core/recording/journal.h"
#include "core/recording/libav.h"
#include "core/recording/matroska_file.h"
#include "core/recording/matroska_index.h"
#include "core/recording/repair.h"

#include <numeric>

#include <fcntl.h>
#include <unistd.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// A packet: time in the stream's time steps, file position (its identity), key flag, and check
/// sum.
using Entry = MatroskaIndex::Block;

Error unreadable(const Message& what, const fs::path& file) {
  return {what,
          file.string(),
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
    entries.push_back({time_of(*packet, static_cast<std::int64_t>(entries.size())),
                       packet->pos,
                       0,
                       (packet->flags & AV_PKT_FLAG_KEY) != 0,
                       0,
                       0,
                       0});
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

  int check = -1;  // the open file, for check sums; -1 for videos of other programs

  AvPtr<AVPacket> packet{av_packet_alloc()};
  AvPtr<AVFrame> av_frame{av_frame_alloc()};
  std::size_t next_read = 0;     // the entry that libav would return next
  std::size_t next_decoded = 0;  // the entry that the decoder expects
  std::size_t next_shown = 0;    // frames before it have left the decoder
  bool is_draining = false;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (check >= 0) ::close(check);
  }
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
    av_seek_frame(
        input.context.get(), input.stream, entries[key_before(entry)].time, AVSEEK_FLAG_BACKWARD);
  next_read = entry + 1;
  while (input.read(*packet))
    if (packet->pos == position) return check < 0 || is_undamaged(check, entries[entry]);
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
    state->check = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const auto& entries = state->entries;
  if (entries.empty()) return unreadable(en::say("the video holds no frame"), file);
  state->shown.resize(entries.size());
  std::iota(state->shown.begin(), state->shown.end(), 0U);
  std::stable_sort(state->shown.begin(), state->shown.end(), [&](std::size_t a, std::size_t b) {
    return entries[a].time < entries[b].time;
  });
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

std::size_t VideoFile::frame_count() const {
  return state_->shown.size();
}

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

}  // namespace alltact
