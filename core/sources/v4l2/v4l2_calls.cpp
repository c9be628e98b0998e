#include "core/sources/v4l2/v4l2_calls.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace alltact {
namespace {

class KernelCalls : public V4l2Calls {
 public:
  int open(const char* node, int flags) override { return ::open(node, flags); }
  int close(int descriptor) override { return ::close(descriptor); }
  int ioctl(int descriptor, unsigned long request, void* argument) override {
    return ::ioctl(descriptor, request, argument);
  }
  void* mmap(std::size_t length, int descriptor, std::int64_t offset) override {
    return ::mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, offset);
  }
  int munmap(void* address, std::size_t length) override { return ::munmap(address, length); }
  int poll(pollfd* descriptors, nfds_t count, int timeout_ms) override {
    return ::poll(descriptors, count, timeout_ms);
  }
};

}  // namespace

V4l2Calls& kernel_calls() {
  static KernelCalls calls;
  return calls;
}

}  // namespace alltact
