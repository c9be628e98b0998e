// The six system calls that drive a camera: the kernel's own, or a simulation in tests.
#pragma once

#include <cstddef>
#include <cstdint>

#include <poll.h>

namespace alltact {

/// Each call returns the value of its namesake and sets errno likewise. Any thread may call.
class V4l2Calls {
 public:
  virtual ~V4l2Calls() = default;
  virtual int open(const char* node, int flags) = 0;
  virtual int close(int descriptor) = 0;
  virtual int ioctl(int descriptor, unsigned long request, void* argument) = 0;
  /// Shared, readable and writable; MAP_FAILED on error.
  virtual void* mmap(std::size_t length, int descriptor, std::int64_t offset) = 0;
  virtual int munmap(void* address, std::size_t length) = 0;
  virtual int poll(pollfd* descriptors, nfds_t count, int timeout_ms) = 0;
};

/// The kernel.
[[nodiscard]] V4l2Calls& kernel_calls();

}  // namespace alltact
