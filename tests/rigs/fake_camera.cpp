#include "tests/rigs/fake_camera.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <linux/version.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

namespace alltact::test {
namespace {

// The same code runs inside other programs, behind their own open, close, mmap and poll: so it asks
// the kernel itself for these.
int raw_close(int descriptor) { return static_cast<int>(syscall(SYS_close, descriptor)); }
void* raw_map(std::size_t length, int descriptor, std::int64_t offset) {
  return reinterpret_cast<void*>(  // NOLINT: the kernel's calls give numbers
      syscall(SYS_mmap, nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, offset));
}
int raw_unmap(void* address, std::size_t length) {
  return static_cast<int>(syscall(SYS_munmap, address, length));
}
int raw_poll(pollfd* descriptors, nfds_t count, int timeout_ms) {
  return static_cast<int>(syscall(SYS_poll, descriptors, count, timeout_ms));
}
void signal_one(int descriptor) {
  const std::uint64_t one = 1;
  syscall(SYS_write, descriptor, &one, sizeof one);
}
void clear_signal(int descriptor) {
  std::uint64_t count = 0;
  syscall(SYS_read, descriptor, &count, sizeof count);
}

/// False where the kernel would answer EFAULT.
bool is_readable(const void* memory, std::size_t bytes) {
  std::vector<std::uint8_t> copy(bytes);
  const iovec to{copy.data(), bytes}, from{const_cast<void*>(memory), bytes};
  return process_vm_readv(getpid(), &to, 1, &from, 1, 0) >= 0 || errno != EFAULT;
}

int failed(int error_number) {
  errno = error_number;
  return -1;
}

constexpr std::uint32_t kPage = 4096;
constexpr std::uint32_t kSource = 0;  // in Handle::subscribed, beside controls; none has this id

}  // namespace

FakeCamera::FakeCamera(FakeOptions options) : options_(std::move(options)) {
  picture_.pixelformat = options_.fourccs.front();
  picture_.width = options_.sizes.front().first;
  picture_.height = options_.sizes.front().second;
  adjust(picture_);
  seconds_ = {1, options_.rates.front()};
  if (options_.is_live) pump_ = std::thread([this] { pump(); });
}

FakeCamera::~FakeCamera() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_all();
  if (pump_.joinable()) pump_.join();
  while (!handles_.empty()) FakeCamera::close(handles_.begin()->first);
}

void FakeCamera::produce(int frames) {
  const std::lock_guard lock(mutex_);
  for (int i = 0; i < frames; ++i) deliver();
}

void FakeCamera::unplug() {
  const std::lock_guard lock(mutex_);
  is_plugged_ = false;
  stop_stream();
  for (auto& [descriptor, handle] : handles_) {
    handle.is_dead = true;
    // Closing the far end over an unread byte resets the connection: POLLERR and POLLHUP.
    const char byte = 0;
    syscall(SYS_sendto, descriptor, &byte, 1, MSG_NOSIGNAL | MSG_DONTWAIT, nullptr, 0);
    raw_close(std::exchange(handle.peer, -1));
  }
}

void FakeCamera::plug_in() {
  const std::lock_guard lock(mutex_);
  is_plugged_ = true;
  controls_.reset();
}

bool FakeCamera::is_plugged() const {
  const std::lock_guard lock(mutex_);
  return is_plugged_;
}
void FakeCamera::stall(bool is_stalled) {
  const std::lock_guard lock(mutex_);
  is_stalled_ = is_stalled;
}
void FakeCamera::fail(unsigned long request, int error_number, int times) {
  const std::lock_guard lock(mutex_);
  ioctl_failures_[request] = {error_number, times};
}
void FakeCamera::fail_open(int error_number, int times) {
  const std::lock_guard lock(mutex_);
  call_failures_[SYS_open] = {error_number, times};
}
void FakeCamera::fail_mmap(int error_number, int times) {
  const std::lock_guard lock(mutex_);
  call_failures_[SYS_mmap] = {error_number, times};
}
void FakeCamera::fail_poll(int error_number, int times) {
  const std::lock_guard lock(mutex_);
  call_failures_[SYS_poll] = {error_number, times};
}
void FakeCamera::mark_damaged(int frames) {
  const std::lock_guard lock(mutex_);
  damaged_ = frames;
}
void FakeCamera::truncate(int frames) {
  const std::lock_guard lock(mutex_);
  truncated_ = frames;
}
void FakeCamera::skip(std::uint32_t frames) {
  const std::lock_guard lock(mutex_);
  sequence_ += frames;
}
void FakeCamera::repeat(int frames) {
  const std::lock_guard lock(mutex_);
  repeated_ = frames;
}
void FakeCamera::keep_number(int frames) {
  const std::lock_guard lock(mutex_);
  kept_numbers_ = frames;
}
void FakeCamera::set_clock(std::chrono::milliseconds ahead) {
  const std::lock_guard lock(mutex_);
  ahead_ = ahead;
}
void FakeCamera::refuse_size(bool is_refusing) {
  const std::lock_guard lock(mutex_);
  is_refusing_size_ = is_refusing;
}
void FakeCamera::change_source(std::uint32_t width, std::uint32_t height) {
  const std::lock_guard lock(mutex_);
  options_.sizes = {{width, height}};
  is_other_source_ = true;
  v4l2_event event{};
  event.type = V4L2_EVENT_SOURCE_CHANGE;
  event.u.src_change.changes = V4L2_EVENT_SRC_CH_RESOLUTION;
  for (auto& [descriptor, handle] : handles_)
    if (handle.subscribed.contains(kSource)) push_event(handle, event);
}
void FakeCamera::set_from_outside(std::uint32_t id, std::int32_t value) {
  const std::lock_guard lock(mutex_);
  controls_.force(id, value);
  tell(id, nullptr);
}
void FakeCamera::drift(std::uint32_t id, std::int32_t value) {
  const std::lock_guard lock(mutex_);
  controls_.force(id, value);
}
std::int32_t FakeCamera::control(std::uint32_t id) const {
  const std::lock_guard lock(mutex_);
  return controls_.value(id);
}
std::uint64_t FakeCamera::filled() const {
  const std::lock_guard lock(mutex_);
  return filled_;
}

std::size_t FakeCamera::buffers_to_fill() const {
  const std::lock_guard lock(mutex_);
  return queued_.size();
}
bool FakeCamera::is_streaming() const {
  const std::lock_guard lock(mutex_);
  return is_streaming_;
}
int FakeCamera::open_handles() const {
  const std::lock_guard lock(mutex_);
  return static_cast<int>(handles_.size());
}
bool FakeCamera::owns(int descriptor) const {
  const std::lock_guard lock(mutex_);
  return handles_.contains(descriptor);
}

int FakeCamera::injected(std::map<unsigned long, Failure>& failures, unsigned long key) {
  const auto found = failures.find(key);
  if (found == failures.end()) return 0;
  const int error_number = found->second.error_number;
  if (--found->second.times == 0) failures.erase(found);
  return error_number;
}

int FakeCamera::open(const char* node, int flags) {
  const std::lock_guard lock(mutex_);
  if (!is_plugged_ || options_.node != node) return failed(ENOENT);
  if (const int error = injected(call_failures_, SYS_open); error != 0) return failed(error);
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends) != 0) return -1;
  Handle& handle = handles_[ends[0]];
  handle.descriptor = ends[0];
  handle.peer = ends[1];
  handle.event_signal = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  handle.is_blocking = (flags & O_NONBLOCK) == 0;
  return ends[0];
}

int FakeCamera::close(int descriptor) {
  const std::lock_guard lock(mutex_);
  const auto found = handles_.find(descriptor);
  if (found == handles_.end()) return raw_close(descriptor);
  if (owner_ == &found->second) {
    stop_stream();
    free_buffers();
  }
  raw_close(found->second.event_signal);
  if (found->second.peer >= 0) raw_close(found->second.peer);
  raw_close(descriptor);
  handles_.erase(found);
  return 0;
}

int FakeCamera::ioctl(int descriptor, unsigned long request, void* argument) {
  request &= 0xFFFFFFFFUL;  // some programs pass it sign-extended
  std::unique_lock lock(mutex_);
  if (_IOC_SIZE(request) > 0 && !is_readable(argument, _IOC_SIZE(request)))
    return failed(request == VIDIOC_QUERYCAP ? EFAULT : ENOTTY);
  while (true) {
    const auto found = handles_.find(descriptor);
    if (found == handles_.end()) return failed(EBADF);
    Handle& handle = found->second;
    if (handle.is_dead) return failed(ENODEV);
    int error = injected(ioctl_failures_, request);
    if (error == 0) error = dispatch(handle, request, argument);
    const bool is_waiting = error == EAGAIN && handle.is_blocking && is_streaming_;
    if (!is_waiting) return error == 0 ? 0 : failed(error);
    lock.unlock();
    pollfd wait{descriptor, POLLIN, 0};
    raw_poll(&wait, 1, 1000);
    lock.lock();
  }
}

void* FakeCamera::mmap(std::size_t length, int descriptor, std::int64_t offset) {
  const std::lock_guard lock(mutex_);
  int error = injected(call_failures_, SYS_mmap);
  const auto found = handles_.find(descriptor);
  if (found == handles_.end() || memory_ < 0) error = EINVAL;
  for (const Buffer& buffer : buffers_)
    if (buffer.state.m.offset == offset && length > buffer.state.length + kPage) error = EINVAL;
  if (error != 0) {
    errno = error;
    return MAP_FAILED;
  }
  for (Buffer& buffer : buffers_)
    if (buffer.state.m.offset == offset) buffer.state.flags |= V4L2_BUF_FLAG_MAPPED;
  return raw_map(length, memory_, offset);
}

int FakeCamera::munmap(void* address, std::size_t length) { return raw_unmap(address, length); }

int FakeCamera::poll(pollfd* descriptors, nfds_t count, int timeout_ms) {
  std::vector<pollfd> all(descriptors, descriptors + count);
  std::vector<nfds_t> signal_of;  // which descriptor the signals behind `count` belong to
  bool is_idle = false;
  {
    const std::lock_guard lock(mutex_);
    if (const int error = injected(call_failures_, SYS_poll); error != 0) return failed(error);
    for (nfds_t i = 0; i < count; ++i) {
      const auto found = handles_.find(descriptors[i].fd);
      if (found == handles_.end()) continue;
      all[i].events = static_cast<short>(all[i].events & ~POLLPRI);
      if ((descriptors[i].events & POLLPRI) != 0) {
        all.push_back({found->second.event_signal, POLLIN, 0});
        signal_of.push_back(i);
      }
      // The kernel does not wait for pictures that nobody asked to be taken.
      const bool is_streamer = is_streaming_ && owner_ == &found->second;
      if ((descriptors[i].events & POLLIN) != 0 && !is_streamer) is_idle = true;
    }
  }
  int ready = raw_poll(all.data(), all.size(), is_idle ? 0 : timeout_ms);
  if (ready < 0) return ready;
  ready = 0;
  for (nfds_t i = 0; i < count; ++i) {
    descriptors[i].revents = all[i].revents;
    for (std::size_t s = 0; s < signal_of.size(); ++s)
      if (signal_of[s] == i && (all[count + s].revents & POLLIN) != 0)
        descriptors[i].revents |= POLLPRI;
    if (is_idle && (descriptors[i].events & POLLIN) != 0 && owns(descriptors[i].fd))
      descriptors[i].revents |= POLLERR;
    if (descriptors[i].revents != 0) ++ready;
  }
  return ready;
}

void FakeCamera::tell(std::uint32_t control_id, const Handle* cause) {
  for (auto& [descriptor, handle] : handles_)
    if (&handle != cause && handle.subscribed.contains(control_id))
      push_event(handle, controls_.event(control_id, V4L2_EVENT_CTRL_CH_VALUE));
}

void FakeCamera::push_event(Handle& handle, v4l2_event event) {
  // As the kernel: one event a control, the latest, which tells all that changed since.
  for (auto old = handle.events.begin(); old != handle.events.end(); ++old) {
    if (old->type != event.type || old->id != event.id) continue;
    event.u.ctrl.changes |= old->u.ctrl.changes;
    handle.events.erase(old);
    break;
  }
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  event.timestamp = now;
  event.sequence = handle.event_number++;
  handle.events.push_back(event);
  signal_one(handle.event_signal);
}

int FakeCamera::next_event(Handle& handle, v4l2_event& event) {
  if (handle.events.empty()) return ENOENT;
  event = handle.events.front();
  handle.events.pop_front();
  event.pending = static_cast<std::uint32_t>(handle.events.size());
  if (handle.events.empty()) clear_signal(handle.event_signal);
  return 0;
}

int FakeCamera::subscribe(Handle& handle, unsigned long request,
                          const v4l2_event_subscription& wish) {
  const bool is_on = request == VIDIOC_SUBSCRIBE_EVENT;
  if (wish.type == V4L2_EVENT_ALL && !is_on) {
    handle.subscribed.clear();
    handle.events.clear();
    clear_signal(handle.event_signal);
    return 0;
  }
  const bool is_source =
      options_.tells_source && wish.type == V4L2_EVENT_SOURCE_CHANGE && wish.id == kSource;
  if (!is_source && (wish.type != V4L2_EVENT_CTRL || !controls_.has(wish.id))) return EINVAL;
  if (!is_on) {
    handle.subscribed.erase(wish.id);
    std::erase_if(handle.events, [&](const v4l2_event& event) { return event.id == wish.id; });
    if (handle.events.empty()) clear_signal(handle.event_signal);
    return 0;
  }
  handle.subscribed.insert(wish.id);
  if (!is_source && (wish.flags & V4L2_EVENT_SUB_FL_SEND_INITIAL) != 0)
    push_event(handle,
               controls_.event(wish.id, V4L2_EVENT_CTRL_CH_VALUE | V4L2_EVENT_CTRL_CH_FLAGS));
  return 0;
}

void FakeCamera::pump() {
  std::unique_lock lock(mutex_);
  auto due = std::chrono::steady_clock::now();
  while (!is_ending_) {
    const auto period =
        std::chrono::nanoseconds(1'000'000'000ULL * seconds_.numerator / seconds_.denominator);
    due = std::max(due + period, std::chrono::steady_clock::now());
    changed_.wait_until(lock, due, [&] { return is_ending_; });
    if (!is_ending_) deliver();
  }
}

}  // namespace alltact::test
