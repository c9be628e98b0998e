// A USB camera made of memory: real descriptors, real mapped buffers, and every fault on request.
#pragma once

#include "core/devices/v4l2_device.h"
#include "tests/rigs/fake_controls.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace alltact::test {

struct FakeOptions {
  std::string node = "/dev/video0";
  std::vector<std::uint32_t> fourccs = {V4L2_PIX_FMT_MJPEG};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sizes = {{320, 240}};
  std::vector<std::uint32_t> rates = {30};
  /// Frames come by themselves at the agreed rate; else only by produce().
  bool is_live = true;
  bool is_metadata = false;
  bool is_multi_planar = false;
  bool tells_source = false;  ///< V4L2_EVENT_SOURCE_CHANGE, as converters do and USB cameras do not
  std::uint32_t jpeg_quality = 85;
  /// MJPG and H264: sent in turn instead of the made pictures; H264 needs them.
  std::vector<std::vector<std::uint8_t>> packets = {};
};

/// Whether a frame is a packet of its own size.
inline bool is_compressed(std::uint32_t fourcc) {
  return fourcc == V4L2_PIX_FMT_MJPEG || fourcc == V4L2_PIX_FMT_H264;
}

/// Any thread may call. What a program sees follows the kernel's documentation of V4L2; several
/// handles may be open at once, one of them streams.
class FakeCamera : public V4l2Calls {
 public:
  explicit FakeCamera(FakeOptions options);
  ~FakeCamera() override;

  /// Brightness of frame `sequence` before packing, 8 bit.
  static std::uint8_t truth(std::uint64_t sequence, std::uint32_t u, std::uint32_t v) {
    return static_cast<std::uint8_t>(40 + (u / 4 + v / 2 + 5 * sequence) % 128);
  }

  void produce(int frames = 1);
  void unplug();
  void plug_in();
  [[nodiscard]] bool is_plugged() const;
  void stall(bool is_stalled);
  /// The next `times` such ioctls fail.
  void fail(unsigned long request, int error_number, int times = 1);
  void fail_open(int error_number, int times = 1);
  void fail_mmap(int error_number, int times = 1);
  void fail_poll(int error_number, int times = 1);
  void mark_damaged(int frames);                    ///< V4L2_BUF_FLAG_ERROR
  void truncate(int frames);                        ///< half of the bytes
  void skip(std::uint32_t frames);                  ///< in the sequence numbers
  void repeat(int frames);                          ///< the picture before once more, as a new one
  void keep_number(int frames);                     ///< other pictures under one number
  void set_clock(std::chrono::milliseconds ahead);  ///< of CLOCK_MONOTONIC; its times are told
  void refuse_size(bool is_refusing);               ///< S_FMT answers with 160x120
  /// Another signal comes in: what streams gets nothing more until it begins anew.
  void change_source(std::uint32_t width, std::uint32_t height);
  void set_from_outside(std::uint32_t id, std::int32_t value);
  void drift(std::uint32_t id, std::int32_t value);  ///< as by itself, without an event
  [[nodiscard]] std::int32_t control(std::uint32_t id) const;
  [[nodiscard]] std::uint64_t filled() const;         ///< frames handed to programs
  [[nodiscard]] std::size_t buffers_to_fill() const;  ///< without one the next frame is lost
  [[nodiscard]] bool is_streaming() const;
  [[nodiscard]] int open_handles() const;
  [[nodiscard]] bool owns(int descriptor) const;

  int open(const char* node, int flags) override;
  int close(int descriptor) override;
  int ioctl(int descriptor, unsigned long request, void* argument) override;
  void* mmap(std::size_t length, int descriptor, std::int64_t offset) override;
  int munmap(void* address, std::size_t length) override;
  int poll(pollfd* descriptors, nfds_t count, int timeout_ms) override;

 private:
  struct Handle {
    int descriptor = -1, peer = -1;
    int event_signal = -1;  // an eventfd, readable while events wait
    bool is_blocking = false;
    bool is_dead = false;  // its camera was unplugged
    std::uint32_t priority = V4L2_PRIORITY_DEFAULT;
    std::set<std::uint32_t> subscribed;
    std::deque<v4l2_event> events;
    std::uint32_t event_number = 0;
  };
  struct Buffer {
    v4l2_buffer state;
    bool is_queued = false;
    bool is_done = false;
  };
  struct Failure {
    int error_number, times;
  };

  int dispatch(Handle& handle, unsigned long request, void* argument);
  int enumerate(unsigned long request, void* argument);
  int format(unsigned long request, void* argument, const Handle& handle);
  int rate(unsigned long request, void* argument);
  int input(unsigned long request, void* argument);
  int controls(Handle& handle, unsigned long request, void* argument);
  int subscribe(Handle& handle, unsigned long request, const v4l2_event_subscription& wish);
  int next_event(Handle& handle, v4l2_event& event);
  int request_buffers(Handle& handle, v4l2_requestbuffers& request);
  int query_buffer(const Handle& handle, v4l2_buffer& buffer) const;
  int queue_buffer(Handle& handle, v4l2_buffer& buffer);
  int take_buffer(Handle& handle, v4l2_buffer& buffer);
  int stream(Handle& handle, bool is_on, int type);
  void stop_stream();
  void free_buffers();
  void deliver();
  std::uint32_t fill(std::span<std::uint8_t> memory);
  void tell(std::uint32_t control_id, const Handle* cause);
  void push_event(Handle& handle, v4l2_event event);
  void adjust(v4l2_pix_format& image) const;
  void pump();
  int injected(std::map<unsigned long, Failure>& failures, unsigned long key);

  FakeOptions options_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<int, Handle> handles_;
  FakeControls controls_;
  v4l2_pix_format picture_{};
  v4l2_fract seconds_{1, 30};
  bool is_plugged_ = true, is_streaming_ = false, is_stalled_ = false, is_refusing_size_ = false;
  bool is_other_source_ = false;  // than the stream began with
  Handle* owner_ = nullptr;       // of the buffers
  int memory_ = -1;               // a memfd
  std::span<std::uint8_t> mapped_;
  std::vector<Buffer> buffers_;
  std::deque<std::uint32_t> queued_, done_;
  std::uint32_t sequence_ = 0;
  std::uint64_t filled_ = 0;
  int damaged_ = 0, truncated_ = 0, repeated_ = 0, kept_numbers_ = 0;
  std::uint32_t shown_ = 0;  // the number that the picture is made from
  std::chrono::milliseconds ahead_{0};
  std::map<unsigned long, Failure> ioctl_failures_, call_failures_;
  std::map<std::pair<std::uint32_t, std::uint64_t>, std::vector<std::uint8_t>> jpegs_;
  bool is_ending_ = false;
  std::thread pump_;
};

}  // namespace alltact::test
