// What the fake camera streams: buffers, and the pictures that fill them.
#include "tests/rigs/fake_camera.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <turbojpeg.h>
#include <unistd.h>

namespace alltact::test {
namespace {

constexpr std::uint32_t kPage = 4096;
constexpr std::uint32_t kBufferMemory = V4L2_MEMORY_MMAP;

void* raw_map(std::size_t length, int descriptor) {
  return reinterpret_cast<void*>(  // NOLINT: the kernel's calls give numbers
      syscall(SYS_mmap, nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0));
}

std::vector<std::uint8_t> jpeg_of(const std::vector<std::uint8_t>& rgb, std::uint32_t width,
                                  std::uint32_t height, std::uint32_t quality) {
  tjhandle handle = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;  // NOLINT: TurboJPEG's type
  tjCompress2(handle, rgb.data(), static_cast<int>(width), 0, static_cast<int>(height), TJPF_RGB,
              &bytes, &size, TJSAMP_422, static_cast<int>(quality), 0);
  std::vector<std::uint8_t> jpeg(bytes, bytes + size);
  tjFree(bytes);
  tjDestroy(handle);
  return jpeg;
}

}  // namespace

int FakeCamera::request_buffers(Handle& handle, v4l2_requestbuffers& request) {
  if (request.type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return EINVAL;
  request.capabilities = V4L2_BUF_CAP_SUPPORTS_MMAP | V4L2_BUF_CAP_SUPPORTS_ORPHANED_BUFS;
  request.flags = 0;
  if (request.memory != kBufferMemory) return EINVAL;
  if (owner_ != nullptr && owner_ != &handle) return EBUSY;
  if (request.count == 0) stop_stream();
  if (is_streaming_) return EBUSY;
  free_buffers();
  if (request.count == 0) return 0;
  request.count = std::clamp(request.count, 2U, 32U);
  const std::uint32_t stride = (picture_.sizeimage + kPage - 1) / kPage * kPage;
  memory_ = memfd_create("fake_camera", MFD_CLOEXEC);
  const std::size_t size = std::size_t{stride} * request.count;
  if (ftruncate(memory_, static_cast<off_t>(size)) != 0) return ENOMEM;
  mapped_ = {static_cast<std::uint8_t*>(raw_map(size, memory_)), size};
  for (std::uint32_t i = 0; i < request.count; ++i) {
    Buffer buffer{};
    buffer.state.index = i;
    buffer.state.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.state.memory = kBufferMemory;
    buffer.state.length = picture_.sizeimage;
    buffer.state.m.offset = i * stride;
    buffer.state.flags = V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
    buffers_.push_back(buffer);
  }
  owner_ = &handle;
  return 0;
}

void FakeCamera::free_buffers() {
  if (!mapped_.empty()) syscall(SYS_munmap, mapped_.data(), mapped_.size());
  if (memory_ >= 0) syscall(SYS_close, memory_);
  mapped_ = {};
  memory_ = -1;
  buffers_.clear();
  queued_.clear();
  done_.clear();
  owner_ = nullptr;
}

int FakeCamera::query_buffer(const Handle&, v4l2_buffer& buffer) const {
  if (buffer.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || buffer.index >= buffers_.size()) return EINVAL;
  const Buffer& kept = buffers_[buffer.index];
  buffer = kept.state;
  if (kept.is_queued) buffer.flags |= V4L2_BUF_FLAG_QUEUED;
  if (kept.is_done) buffer.flags |= V4L2_BUF_FLAG_DONE;
  return 0;
}

int FakeCamera::queue_buffer(Handle& handle, v4l2_buffer& buffer) {
  if (buffer.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || buffer.memory != kBufferMemory ||
      buffer.index >= buffers_.size() || (buffer.flags & V4L2_BUF_FLAG_REQUEST_FD) != 0)
    return EINVAL;
  if (owner_ != &handle) return EBUSY;
  Buffer& kept = buffers_[buffer.index];
  if (kept.is_queued || kept.is_done) return EINVAL;
  kept.is_queued = true;
  kept.state.flags &= ~static_cast<std::uint32_t>(V4L2_BUF_FLAG_ERROR);
  kept.state.bytesused = 0;
  queued_.push_back(buffer.index);
  return query_buffer(handle, buffer);
}

int FakeCamera::take_buffer(Handle& handle, v4l2_buffer& buffer) {
  if (buffer.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || buffer.memory != kBufferMemory) return EINVAL;
  if (owner_ != nullptr && owner_ != &handle) return EBUSY;
  if (!is_streaming_) return EINVAL;
  if (done_.empty()) return EAGAIN;
  char byte = 0;
  syscall(SYS_recvfrom, handle.descriptor, &byte, 1, MSG_DONTWAIT, nullptr, nullptr);
  Buffer& kept = buffers_[done_.front()];
  done_.pop_front();
  kept.is_done = false;
  buffer = kept.state;
  return 0;
}

int FakeCamera::stream(Handle& handle, bool is_on, int type) {
  if (type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return EINVAL;
  if (owner_ != nullptr && owner_ != &handle) return EBUSY;
  if (!is_on) {
    stop_stream();
    return 0;
  }
  if (buffers_.empty()) return EINVAL;
  if (!is_streaming_) sequence_ = 0;
  is_streaming_ = true;
  is_other_source_ = false;
  return 0;
}

void FakeCamera::stop_stream() {
  is_streaming_ = false;
  queued_.clear();
  done_.clear();
  for (Buffer& buffer : buffers_) buffer.is_queued = buffer.is_done = false;
  char byte = 0;
  while (owner_ != nullptr &&
         syscall(SYS_recvfrom, owner_->descriptor, &byte, 1, MSG_DONTWAIT, nullptr, nullptr) > 0) {
  }
}

void FakeCamera::deliver() {
  if (!is_streaming_ || is_stalled_ || !is_plugged_ || is_other_source_) return;
  const bool is_kept = kept_numbers_ > 0, is_repeated = repeated_ > 0;
  if (is_kept) --kept_numbers_, --sequence_, ++shown_;
  if (is_repeated) --repeated_;
  const std::uint32_t sequence = sequence_++;
  if (!is_kept && !is_repeated) shown_ = sequence;
  if (queued_.empty()) return;  // nobody gave a buffer in time: this frame is lost
  const std::uint32_t index = queued_.front();
  queued_.pop_front();
  Buffer& buffer = buffers_[index];
  buffer.is_queued = false;
  buffer.is_done = true;
  const auto now = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now().time_since_epoch() + ahead_);
  buffer.state.timestamp = {now.count() / 1'000'000, now.count() % 1'000'000};
  buffer.state.sequence = sequence;
  buffer.state.field = V4L2_FIELD_NONE;
  buffer.state.bytesused = fill(mapped_.subspan(buffer.state.m.offset, buffer.state.length));
  if (truncated_ > 0) --truncated_, buffer.state.bytesused /= 2;
  if (damaged_ > 0) --damaged_, buffer.state.flags |= V4L2_BUF_FLAG_ERROR;
  done_.push_back(index);
  ++filled_;
  const char byte = 0;
  syscall(SYS_sendto, owner_->peer, &byte, 1, MSG_NOSIGNAL | MSG_DONTWAIT, nullptr, 0);
}

namespace {

/// Writes a pixel of this brightness; returns its bytes.
std::size_t pack(std::uint32_t fourcc, std::uint8_t grey, std::uint8_t* to) {
  const auto pair = [&](int first, int second) {
    to[0] = static_cast<std::uint8_t>(first);
    to[1] = static_cast<std::uint8_t>(second);
    return std::size_t{2};
  };
  switch (fourcc) {
    case V4L2_PIX_FMT_Y10:  // the lowest bits must not show
      return pair((grey << 2 | 3) & 0xFF, grey >> 6);
    case V4L2_PIX_FMT_Y12:
      return pair((grey << 4 | 9) & 0xFF, grey >> 4);
    case V4L2_PIX_FMT_Y16:
      return pair(0x5A, grey);
    case V4L2_PIX_FMT_YUYV:
      return pair(grey, 0x80);
    case V4L2_PIX_FMT_UYVY:
      return pair(0x80, grey);
    case V4L2_PIX_FMT_RGB24:
    case V4L2_PIX_FMT_BGR24:
      std::fill_n(to, 3, grey);
      return 3;
    default:  // GREY, NV12
      *to = grey;
      return 1;
  }
}

}  // namespace

std::uint32_t FakeCamera::fill(std::span<std::uint8_t> memory) {
  const std::uint64_t sequence = shown_;
  const std::uint32_t width = picture_.width, height = picture_.height;
  if (is_compressed(picture_.pixelformat)) {
    const auto& jpeg = [&]() -> const std::vector<std::uint8_t>& {
      if (!options_.packets.empty()) return options_.packets[sequence % options_.packets.size()];
      auto& made = jpegs_[{width, sequence % 128}];
      if (!made.empty()) return made;
      std::vector<std::uint8_t> rgb;
      rgb.reserve(std::size_t{3} * width * height);
      for (std::uint32_t v = 0; v < height; ++v)
        for (std::uint32_t u = 0; u < width; ++u)
          rgb.insert(rgb.end(), 3, truth(sequence % 128, u, v));
      return made = jpeg_of(rgb, width, height, options_.jpeg_quality);
    }();
    std::memcpy(memory.data(), jpeg.data(), jpeg.size());
    return static_cast<std::uint32_t>(jpeg.size());
  }
  std::size_t at = 0;
  for (std::uint32_t v = 0; v < height; ++v)
    for (std::uint32_t u = 0; u < width; ++u)
      at += pack(picture_.pixelformat, truth(sequence, u, v), &memory[at]);
  if (picture_.pixelformat == V4L2_PIX_FMT_NV12) {
    std::fill_n(&memory[at], at / 2, std::uint8_t{0x80});
    at += at / 2;
  }
  return static_cast<std::uint32_t>(at);
}

}  // namespace alltact::test
