// The fake camera inside a program that knows nothing of it (LD_PRELOAD). ALLTACT_FAKE_CAMERA holds
// words: node=/dev/video0 pixels=MJPG,GREY size=640x480 (several with commas) rate=30
// unplug_after=FRAMES back_after_ms=MS
#include "tests/rigs/fake_camera.h"

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include <dlfcn.h>
#include <fcntl.h>

namespace {

using alltact::test::FakeCamera;
using alltact::test::FakeOptions;

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

struct Rig {
  FakeOptions options;
  std::uint64_t unplug_after = 0;
  int back_after_ms = 1000;

  Rig() {
    const char* text = std::getenv("ALLTACT_FAKE_CAMERA");
    std::istringstream words(text == nullptr ? "" : text);
    for (std::string word; words >> word;) {
      const std::string value = word.substr(word.find('=') + 1);
      if (word.starts_with("node=")) options.node = value;
      if (word.starts_with("rate=")) options.rates = numbers(value);
      if (word.starts_with("unplug_after=")) unplug_after = std::stoull(value);
      if (word.starts_with("back_after_ms=")) back_after_ms = std::stoi(value);
      if (word.starts_with("pixels=")) {
        options.fourccs.clear();
        for (std::string name : split(value)) {
          name.resize(4, ' ');
          options.fourccs.push_back(v4l2_fourcc(name[0], name[1], name[2], name[3]));
        }
      }
      if (word.starts_with("size=")) {
        options.sizes.clear();
        for (const std::string& size : split(value))
          options.sizes.emplace_back(std::stoul(size), std::stoul(size.substr(size.find('x') + 1)));
      }
    }
  }
  static std::vector<std::uint32_t> numbers(const std::string& value) {
    std::vector<std::uint32_t> numbers;
    for (const std::string& part : split(value))
      numbers.push_back(static_cast<std::uint32_t>(std::stoul(part)));
    return numbers;
  }
};

const Rig& rig() {
  static const Rig rig;
  return rig;
}

/// Made when it is first opened, never unmade: the program may use it until its last moment.
FakeCamera& camera() {
  static FakeCamera* camera = [] {
    auto* made = new FakeCamera(rig().options);
    if (rig().unplug_after > 0) {
      static auto* const plugging = new std::thread([made] {
        while (made->filled() < rig().unplug_after)
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        made->unplug();
        std::this_thread::sleep_for(std::chrono::milliseconds(rig().back_after_ms));
        made->plug_in();
      });
      static_cast<void>(plugging);
    }
    return made;
  }();
  return *camera;
}

std::atomic<bool> is_used{false};

bool is_ours(const char* node) { return node != nullptr && rig().options.node == node; }
bool is_ours(int descriptor) { return is_used && camera().owns(descriptor); }

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

int open_camera(const char* node, int flags) {
  is_used = true;
  return camera().open(node, flags);
}

}  // namespace

extern "C" {

#define ALLTACT_OPEN(name)                                                               \
  int name(const char* path, int flags, ...) {                                           \
    va_list rest;                                                                        \
    va_start(rest, flags);                                                               \
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0; \
    va_end(rest);                                                                        \
    if (is_ours(path)) return open_camera(path, flags);                                  \
    static const auto real = next<int (*)(const char*, int, ...)>(#name);                \
    return real(path, flags, mode);                                                      \
  }
ALLTACT_OPEN(open)
ALLTACT_OPEN(open64)

int __open_2(const char* path, int flags) {  // NOLINT: glibc's name
  return open(path, flags);
}
int __open64_2(const char* path, int flags) {  // NOLINT: glibc's name
  return open64(path, flags);
}

int close(int descriptor) {
  if (is_ours(descriptor)) return camera().close(descriptor);
  static const auto real = next<int (*)(int)>("close");
  return real(descriptor);
}

ssize_t read(int descriptor, void* memory, size_t bytes) {
  if (is_ours(descriptor)) {
    errno = EINVAL;  // this camera streams only
    return -1;
  }
  static const auto real = next<ssize_t (*)(int, void*, size_t)>("read");
  return real(descriptor, memory, bytes);
}

int ioctl(int descriptor, unsigned long request, ...) noexcept {
  va_list rest;
  va_start(rest, request);
  void* argument = va_arg(rest, void*);
  va_end(rest);
  if (is_ours(descriptor)) return camera().ioctl(descriptor, request, argument);
  static const auto real = next<int (*)(int, unsigned long, ...)>("ioctl");
  return real(descriptor, request, argument);
}

#define ALLTACT_MMAP(name)                                                                        \
  void* name(void* hint, size_t length, int protection, int flags, int descriptor,                \
             off64_t offset) noexcept {                                                           \
    if (descriptor >= 0 && is_ours(descriptor)) return camera().mmap(length, descriptor, offset); \
    static const auto real = next<void* (*)(void*, size_t, int, int, int, off64_t)>(#name);       \
    return real(hint, length, protection, flags, descriptor, offset);                             \
  }
ALLTACT_MMAP(mmap)
ALLTACT_MMAP(mmap64)

int poll(pollfd* descriptors, nfds_t count, int timeout_ms) {
  bool any = false;
  for (nfds_t i = 0; i < count; ++i) any = any || is_ours(descriptors[i].fd);
  if (any) return camera().poll(descriptors, count, timeout_ms);
  static const auto real = next<int (*)(pollfd*, nfds_t, int)>("poll");
  return real(descriptors, count, timeout_ms);
}
int __poll_chk(pollfd* descriptors, nfds_t count, int timeout_ms, size_t) {  // NOLINT: as above
  return poll(descriptors, count, timeout_ms);
}

}  // extern "C"
