#include "core/recording/matroska.h"

#include "core/base/descriptor.h"
#include "core/base/slow_disk.h"
#include "core/recording/durable_file.h"
#include "core/recording/libav.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <optional>
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
