#include "core/recording/repair.h"

#include "core/io/atomic_file.h"
#include "core/io/system_error.h"
#include "core/recording/journal.h"
#include "core/recording/matroska_file.h"
#include "core/recording/matroska_index.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// Locks a file against other recorders and repairs while it lives.
class Lock {
 public:
  explicit Lock(const fs::path& file) : number_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
    is_held_ = number_ >= 0 && ::flock(number_, LOCK_EX | LOCK_NB) == 0;
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  ~Lock() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] bool is_held() const { return is_held_; }

 private:
  int number_;
  bool is_held_;
};

Status copy_packets(const fs::path& from,
                    const fs::path& to,
                    const std::vector<MatroskaIndex::Block>& blocks,
                    const Job& job) {
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
      return Error{en::say("stopped before it was mended"), from.string(), ""};
    if (copied % 64 == 0)
      job.report(static_cast<double>(copied) / static_cast<double>(blocks.size()),
                 en::say("mending an interrupted recording"));
    av_packet_rescale_ts(packet.get(), video.time_base, {1, 1000});
    if (Status status = output->write(*packet); !status) return status;
    ++copied;
  }
  if (copied < blocks.size())
    return Error{en::say("only {} of its {} frames could be read", copied, blocks.size()),
                 from.string(),
                 en::say("another copy of the recording")};
  return output->finish();
}

Status check_space(const fs::path& file) {
  std::error_code failed;
  const auto bytes = fs::file_size(file, failed);
  const auto space = fs::space(fs::absolute(file).parent_path(), failed);
  constexpr std::uintmax_t kSpareBytes = 64 << 20;  // for other writers meanwhile
  if (!failed && space.available < bytes + bytes / 64 + kSpareBytes)
    return system_error(en::say("the interrupted recording cannot be mended"), file, ENOSPC);
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
                  frames,
                  journal->size()));
}

}  // namespace

Result<bool> repair_recording(const fs::path& file, const Job& job) {
  const auto input = open_video_input(file);
  if (!input) return input.error();
  if (!input->is_matroska() || !is_own_recording(*input->context)) return false;
  const Lock lock(file);
  if (!lock.is_held())
    return Error{en::say("it is being recorded or mended right now"),
                 file.string(),
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

}  // namespace alltact
