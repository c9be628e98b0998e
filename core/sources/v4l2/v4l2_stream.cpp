#include "core/sources/v4l2/v4l2_stream.h"

#include <cerrno>
#include <chrono>
#include <cstring>

#include <linux/videodev2.h>
#include <sys/mman.h>

namespace alltact {
namespace {

/// One buffer is being filled, one waits, two cover a reader that is delayed by two frames.
constexpr std::uint32_t kBuffers = 4;

v4l2_buffer capture_buffer(std::uint32_t index = 0) {
  v4l2_buffer buffer;
  std::memset(&buffer, 0, sizeof buffer);
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return buffer;
}

int request_buffers(const V4l2Device& device, std::uint32_t& count) {
  v4l2_requestbuffers request;
  std::memset(&request, 0, sizeof request);
  request.count = count;
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  const int error = device.ioctl(VIDIOC_REQBUFS, &request);
  count = request.count;
  return error;
}

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

std::int64_t time_of(const v4l2_buffer& buffer) {
  const bool is_monotonic =
      (buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) == V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
  constexpr std::int64_t kMaxSeconds = std::int64_t{1} << 33;  // larger values are invalid times
  const bool is_time = buffer.timestamp.tv_sec >= 0 && buffer.timestamp.tv_sec < kMaxSeconds &&
                       buffer.timestamp.tv_usec >= 0 && buffer.timestamp.tv_usec < 1'000'000;
  if (!is_monotonic || !is_time) return now_ns();
  return std::int64_t{buffer.timestamp.tv_sec} * 1'000'000'000 +
         std::int64_t{buffer.timestamp.tv_usec} * 1000;
}

}  // namespace

Result<std::unique_ptr<V4l2Stream>> V4l2Stream::start(const V4l2Device& device) {
  std::unique_ptr<V4l2Stream> stream(new V4l2Stream(device));
  if (const Status status = stream->map_buffers(); !status) return status.error();
  for (std::uint32_t i = 0; i < stream->buffers_.size(); ++i)
    if (const int error = stream->queue(i); error != 0)
      return camera_error(en::say("the camera takes no buffer"), device.node(), error);
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (const int error = device.ioctl(VIDIOC_STREAMON, &type); error != 0)
    return camera_error(en::say("the camera does not start"), device.node(), error);
  return stream;
}

Status V4l2Stream::map_buffers() {
  std::uint32_t count = kBuffers;
  if (const int error = request_buffers(*device_, count); error != 0)
    return camera_error(en::say("the camera gives no buffers"), device_->node(), error);
  if (count < 2)
    return camera_error(en::say("the camera gives no buffers"), device_->node(), ENOMEM);
  for (std::uint32_t i = 0; i < count; ++i) {
    v4l2_buffer buffer = capture_buffer(i);
    if (const int error = device_->ioctl(VIDIOC_QUERYBUF, &buffer); error != 0)
      return camera_error(en::say("the camera's buffer cannot be found"), device_->node(), error);
    void* address = device_->calls().mmap(buffer.length, device_->descriptor(), buffer.m.offset);
    if (address == MAP_FAILED)
      return camera_error(en::say("the camera's buffer cannot be mapped"), device_->node(), errno);
    buffers_.emplace_back(static_cast<std::uint8_t*>(address), buffer.length);
  }
  return {};
}

V4l2Stream::~V4l2Stream() {
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  static_cast<void>(device_->ioctl(VIDIOC_STREAMOFF, &type));  // fails when the camera is gone
  for (const auto& buffer : buffers_) device_->calls().munmap(buffer.data(), buffer.size());
  std::uint32_t none = 0;
  static_cast<void>(request_buffers(*device_, none));
}

int V4l2Stream::queue(std::uint32_t index) {
  v4l2_buffer buffer = capture_buffer(index);
  return device_->ioctl(VIDIOC_QBUF, &buffer);
}

V4l2Stream::Taken V4l2Stream::take() {
  v4l2_buffer buffer = capture_buffer();
  const int error = device_->ioctl(VIDIOC_DQBUF, &buffer);
  if (error == EAGAIN) return {};
  if (error != 0) return {error, std::nullopt};
  if (buffer.index >= buffers_.size()) return {EIO, std::nullopt};
  const std::span<const std::uint8_t> buffer_bytes = buffers_[buffer.index];
  Filled filled;
  filled.index = buffer.index;
  filled.bytes = buffer_bytes.first(std::min<std::size_t>(buffer.bytesused, buffer_bytes.size()));
  filled.sequence = buffer.sequence;
  filled.time_ns = time_of(buffer);
  filled.is_damaged = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0;
  return {0, filled};
}

int V4l2Stream::requeue(const Filled& filled) {
  return queue(filled.index);
}

}  // namespace alltact
