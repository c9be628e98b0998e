#include "core/recording/matroska_file.h"

#include "core/io/disk_wait.h"
#include "core/io/system_error.h"
#include "core/recording/restore_file.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace alltact {
namespace {

constexpr int kBufferBytes = 1 << 16;
constexpr const char* kRecordedBy = "RECORDED_BY";
constexpr const char* kRecorderName = "AllTact";

Message writing_video() {
  return en::say("could not write the video");
}

}  // namespace

MatroskaTag recording_tag() {
  return {kRecordedBy, kRecorderName};
}

bool is_own_recording(const AVFormatContext& input) {
  const AVDictionaryEntry* entry = av_dict_get(input.metadata, kRecordedBy, nullptr, 0);
  return entry != nullptr && std::string_view(entry->value) == kRecorderName;
}

// Destination of libav's bytes. Its callbacks hold this address.
struct MatroskaFile::State {
  std::filesystem::path file;
  int descriptor = -1;
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
    if (descriptor >= 0) ::close(descriptor);
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
          ::write(self.descriptor, bytes + done, static_cast<std::size_t>(count - done));
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return AVERROR(self.error_number = errno);
      done += static_cast<int>(written);
    }
    return count;
  }
  static std::int64_t seek(void* opaque, std::int64_t offset, int whence) {
    auto& self = *static_cast<State*>(opaque);
    if (whence == AVSEEK_SIZE) return AVERROR(ENOSYS);
    const off_t position = ::lseek(self.descriptor, offset, whence);
    return position < 0 ? AVERROR(errno) : position;
  }
};

Status MatroskaFile::State::open(const AVCodecParameters& parameters,
                                 double frames_per_s,
                                 const MatroskaTag& tag) {
  descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) return error(AVERROR(errno));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0)
    return Error{en::say("it is being recorded or mended right now"),
                 file.string(),
                 en::say("another name")};
  if (::ftruncate(descriptor, 0) != 0) return error(AVERROR(errno));
  io = avio_alloc_context(static_cast<std::uint8_t*>(av_malloc(kBufferBytes)),
                          kBufferBytes,
                          1,
                          this,
                          nullptr,
                          write,
                          seek);
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
  [[maybe_unused]] const int ignored = ::ftruncate(descriptor, static_cast<off_t>(complete_bytes));
  return problem;
}

Status MatroskaFile::State::finish() {
  if (!is_open) return error(AVERROR(EPIPE));
  if (Status status = flush(av_write_trailer(context)); !status) return status;
  is_open = false;
  complete_bytes = static_cast<std::uint64_t>(::lseek(descriptor, 0, SEEK_END));
  const DiskWait waiting(file);
  // A removed file is about to be copied: a wait for its bytes to reach the disk would be useless.
  if (!is_removed(descriptor) && ::fsync(descriptor) != 0) return error(AVERROR(errno));
  return {};
}

MatroskaFile::MatroskaFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
MatroskaFile::MatroskaFile(MatroskaFile&&) noexcept = default;
MatroskaFile& MatroskaFile::operator=(MatroskaFile&&) noexcept = default;
MatroskaFile::~MatroskaFile() = default;

Result<MatroskaFile> MatroskaFile::create(const std::filesystem::path& file,
                                          const AVCodecParameters& parameters,
                                          double frames_per_s,
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
  ::flock(state_->descriptor, LOCK_UN);
  return status;
}

std::uint64_t MatroskaFile::bytes() const {
  return state_->complete_bytes;
}
int MatroskaFile::descriptor() const {
  return state_->descriptor;
}

}  // namespace alltact
