#include "core/recording/recorder.h"

#include "core/base/descriptor.h"
#include "core/base/guarded.h"
#include "core/base/result.h"
#include "core/base/worker.h"
#include "core/recording/durable_file.h"
#include "core/recording/journal.h"

#include <cassert>
#include <cerrno>
#include <condition_variable>
#include <deque>
#include <mutex>

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMegabyte = 1000000;
constexpr auto kSyncInterval = std::chrono::seconds(1);

std::uint64_t bytes_of(const Frame& frame) {
  return frame.grey.total() * frame.grey.elemSize() + (frame.jpeg ? frame.jpeg->size() : 0);
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

std::string frames(std::uint64_t count) {
  return count == 1 ? "1 frame" : fmt::format("{} frames", count);
}

/// Space that users may still write on the disk of an open file.
std::uint64_t free_bytes_at(int descriptor) {
  struct statvfs status {};
  if (::fstatvfs(descriptor, &status) != 0) return 0;
  return std::uint64_t{status.f_bavail} * status.f_frsize;
}

Error nearly_full(const fs::path& file, std::uint64_t free_bytes, int reserve_mb) {
  return {en::say("the disk is nearly full: {} MB are left, {} MB must stay free",
                  free_bytes / kMegabyte, reserve_mb),
          file.string(), en::say("free some space, or record to another disk")};
}

/// Creates the file, which must be new: recordings are never overwritten.
Result<Descriptor> make_new(const fs::path& file) {
  Descriptor made(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (made.is_open()) return made;
  if (errno == EEXIST)
    return Error{en::say("the file exists already"), file.string(),
                 en::say("another name, or remove the old one")};
  std::error_code failed;
  if (errno == ENOENT && !fs::exists(folder_of(file), failed))
    return Error{en::say("could not start the recording: its folder does not exist"), file.string(),
                 en::say("create the folder first, or check the path for typing errors")};
  return system_error(en::say("could not start the recording"), file, errno);
}

}  // namespace

const std::vector<Setting<RecorderSettings>>& recorder_settings() {
  using S = RecorderSettings;
  static const std::vector<Setting<S>> settings{
      choice_setting<S, VideoCodec>(
          "codec",
          en::say("how images are stored, always without loss: auto stores the camera's own "
                  "packets (mjpeg) where available, else magicyuv; ffv1 is about a tenth smaller "
                  "and four times slower to read"),
          &S::codec,
          {{"auto", VideoCodec::kAuto},
           {"magicyuv", VideoCodec::kMagicYuv},
           {"ffv1", VideoCodec::kFfv1},
           {"mjpeg", VideoCodec::kMjpeg}}),
      number_setting<S>("queue-mb",
                        en::say("memory for frames that wait for the disk, in megabytes"),
                        &S::queue_mb, 1, 64000),
      number_setting<S>(
          "reserve-mb",
          en::say("space that is left free on the disk, in megabytes; the recording ends before"),
          &S::reserve_mb, 0, 1000000),
  };
  return settings;
}

namespace {

struct Waiting {
  FramePtr frame;
  std::uint64_t dropped_before;  // since the previous one in the queue
};

}  // namespace

struct Recorder::State {
  const fs::path file;
  const RecorderSettings settings;
  const double frames_per_s;
  JournalWriter journal;  // used by the thread while it runs

  // Of the thread only.
  std::optional<VideoWriter> video;
  std::optional<std::uint64_t> last_sequence;

  mutable std::mutex mutex;  // of all below
  std::condition_variable changed;
  std::deque<Waiting> queue;
  std::uint64_t dropped_since = 0;  // since the last frame in the queue
  std::uint64_t queue_bytes = 0;
  RecorderCounts counts;
  std::optional<Error> problem;
  bool is_ending = false;

  std::optional<SteadySync> sync;
  Worker worker;

  State(fs::path file_, const RecorderSettings& settings_, double fps, JournalWriter journal_)
      : file(std::move(file_)),
        settings(settings_),
        frames_per_s(fps),
        journal(std::move(journal_)) {}

  /// With `mutex` held. A frame always fits into an empty queue.
  [[nodiscard]] bool has_room(const Frame& frame) const {
    return queue.empty() || queue_bytes + bytes_of(frame) <=
                                static_cast<std::uint64_t>(settings.queue_mb) * kMegabyte;
  }
  void push(FramePtr frame) {
    queue_bytes += bytes_of(*frame);
    queue.push_back({std::move(frame), std::exchange(dropped_since, 0)});
    changed.notify_all();
  }

  void run();
  std::optional<Waiting> take();
  Status record(const Waiting& waiting);
  Status remark_losses(const Waiting& waiting);
  [[nodiscard]] Status check_disk();
  Status close(std::string_view why, const Job& job);
  Status save_removed(const Error& removed, const Job& job);
};

/// The oldest waiting frame; empty when there will be no more.
std::optional<Waiting> Recorder::State::take() {
  std::unique_lock lock(mutex);
  changed.wait(lock, [&] { return !queue.empty() || is_ending; });
  if (queue.empty()) return std::nullopt;
  Waiting waiting = std::move(queue.front());
  queue.pop_front();
  queue_bytes -= bytes_of(*waiting.frame);
  changed.notify_all();
  return waiting;
}

/// The thread: records frames until the queue ends, or one cannot be recorded.
void Recorder::State::run() {
  while (const auto waiting = take()) {
    const std::uint64_t recorded_before = counts.recorded;  // written by this thread only
    const Status status = guarded([&] {
      const Status has_space = check_disk();
      return has_space ? record(*waiting) : has_space;
    });
    if (!status) {
      const std::lock_guard lock(mutex);
      problem = status.error();
      // This frame may be in the video with only its line missing in the journal.
      const std::uint64_t lost = queue.size() + (counts.recorded == recorded_before ? 1 : 0);
      dropped_since += lost;
      counts.dropped += lost;
      queue.clear();
      queue_bytes = 0;
      changed.notify_all();
      return;
    }
  }
}

Status Recorder::State::record(const Waiting& waiting) {
  const Frame& frame = *waiting.frame;
  if (!video) {
    auto made = VideoWriter::create(file, frame, settings.codec, frames_per_s);
    if (!made) return made.error();
    video = std::move(*made);
  }
  if (Status status = remark_losses(waiting); !status) return status;
  if (Status status = video->add(frame); !status) return status;
  {
    const std::lock_guard lock(mutex);
    ++counts.recorded;
    counts.bytes = video->bytes();
    counts.codec = video->codec();
  }
  return journal.add(frame);
}

/// A gap in the sequence: frames dropped at a full queue, and for the rest, frames missing from the
/// source.
Status Recorder::State::remark_losses(const Waiting& waiting) {
  const std::uint64_t sequence = waiting.frame->sequence, dropped = waiting.dropped_before;
  const std::uint64_t before = last_sequence.value_or(sequence);
  const std::uint64_t gap = sequence > before + 1 ? sequence - before - 1 : 0;
  const std::uint64_t missing = gap > dropped ? gap - dropped : 0;
  last_sequence = sequence;
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex);
    counts.missing += missing;
    number = counts.recorded;
  }
  if (dropped > 0) {
    const Status status = journal.remark(fmt::format(
        "{} before frame {} lost here: the disk was too slow", frames(dropped), number));
    if (!status) return status;
  }
  if (missing == 0) return {};
  return journal.remark(
      fmt::format("{} before frame {} never came from the source", frames(missing), number));
}

/// Checks the free space, and that the files still exist.
Status Recorder::State::check_disk() {
  const std::uint64_t free_bytes = free_bytes_at(journal.descriptor());
  {
    const std::lock_guard lock(mutex);
    counts.free_bytes = free_bytes;
  }
  if (free_bytes < static_cast<std::uint64_t>(settings.reserve_mb) * kMegabyte)
    return nearly_full(file, free_bytes, settings.reserve_mb);
  if (is_removed(journal.descriptor()) || (video && is_removed(video->descriptor())))
    return Error{en::say("the recording was removed while it was being made"), file.string(), ""};
  return {};
}

/// After the thread has ended.
Status Recorder::State::close(std::string_view why, const Job& job) {
  sync.reset();
  Status first = problem ? Status(*problem) : Status();
  const auto note = [&](Status status) {
    if (first && !status) first = std::move(status);
  };
  if (dropped_since > 0)
    note(journal.remark(fmt::format("{} at the end lost here", frames(dropped_since))));
  note(journal.remark(fmt::format("ended: {}", problem ? problem->sentence() : std::string(why))));
  if (video) {
    note(video->finish());
    const std::lock_guard lock(mutex);
    counts.bytes = video->bytes();
  } else if (first) {
    first = Error{en::say("no frame arrived, so nothing was recorded"), file.string(),
                  en::say("check the source")};
  }
  note(journal.finish());
  if (!video) {
    std::error_code ignored;
    fs::remove(file, ignored);
    fs::remove(journal_of(file), ignored);
  } else if (is_removed(video->descriptor())) {
    first = save_removed(
        first ? Error{en::say("the recording was removed at its end"), file.string(), ""}
              : first.error(),
        job);
  }
  return first;
}

/// The journal first: it is short, and lists the frames if the rest is stopped.
Status Recorder::State::save_removed(const Error& removed, const Job& job) {
  Status saved;
  if (is_removed(journal.descriptor()))
    saved = restore_file(journal.descriptor(), journal_of(file), job);
  if (saved) saved = restore_file(video->descriptor(), file, job);
  if (!saved)
    return Error{en::say("{}, and it could not be restored ({})", removed.what, saved.error().what),
                 removed.where, en::say("record again, and leave the folder alone meanwhile")};
  return Error{en::clauses({removed.what, en::say("what was recorded until then was restored")}),
               removed.where, en::say("leave the folder alone while it records")};
}

Recorder::Recorder(std::unique_ptr<State> state) : state_(std::move(state)) {}

Recorder::~Recorder() {
  if (state_->worker.is_begun()) [[maybe_unused]]
    const Status ignored = finish("given up");
}

Result<std::unique_ptr<Recorder>> Recorder::start(const fs::path& file,
                                                  const RecorderSettings& settings,
                                                  double frames_per_s, std::string_view source) {
  assert(frames_per_s > 0);
  if (file.extension() != ".mkv")
    return Error{en::say("recordings are Matroska files"), file.string(),
                 en::say("a name that ends in .mkv")};
  std::uint64_t free_bytes = 0;
  if (const auto made = make_new(file); made)
    free_bytes = free_bytes_at(made->number());
  else
    return made.error();
  Status status;
  if (free_bytes < static_cast<std::uint64_t>(settings.reserve_mb) * kMegabyte)
    status = nearly_full(file, free_bytes, settings.reserve_mb);
  auto journal = status ? JournalWriter::create(journal_of(file), source)
                        : Result<JournalWriter>(status.error());
  if (!journal) {
    std::error_code ignored;
    fs::remove(file, ignored);
    return journal.error();
  }
  auto state = std::make_unique<State>(file, settings, frames_per_s, std::move(*journal));
  state->counts.free_bytes = free_bytes;
  state->sync.emplace(std::vector{file, journal_of(file)}, kSyncInterval);
  state->worker = Worker([s = state.get()] { s->run(); });
  return std::unique_ptr<Recorder>(new Recorder(std::move(state)));
}

bool Recorder::add(FramePtr frame) {
  State& s = *state_;
  const std::lock_guard lock(s.mutex);
  if (s.problem || s.is_ending) return false;
  if (!s.has_room(*frame)) {
    ++s.counts.dropped;
    ++s.dropped_since;
    return false;
  }
  s.push(std::move(frame));
  return true;
}

bool Recorder::add_waiting(FramePtr frame) {
  State& s = *state_;
  std::unique_lock lock(s.mutex);
  s.changed.wait(lock, [&] { return s.problem || s.is_ending || s.has_room(*frame); });
  if (s.problem || s.is_ending) return false;
  s.push(std::move(frame));
  return true;
}

RecorderCounts Recorder::counts() const {
  const std::lock_guard lock(state_->mutex);
  RecorderCounts counts = state_->counts;
  counts.waiting = state_->queue.size();
  return counts;
}

std::optional<Error> Recorder::problem() const {
  const std::lock_guard lock(state_->mutex);
  return state_->problem;
}

Status Recorder::finish(std::string_view why, const Job& job) {
  State& s = *state_;
  assert(s.worker.is_begun());
  {
    const std::lock_guard lock(s.mutex);
    s.is_ending = true;
    s.changed.notify_all();
  }
  s.worker.join();
  return s.close(why, job);
}

}  // namespace alltact
