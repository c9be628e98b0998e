// An open camera node: ioctls with named errors, capability, formats.
#pragma once

#include "core/base/result.h"
#include "core/image/grey_decoder.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <poll.h>

namespace alltact {

// The six system calls that drive a camera: the kernel's own, or a simulation in tests.

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

/// One stream format that a camera offers or a caller requests.
struct CameraFormat {
  std::uint32_t fourcc = 0;  ///< a PixelFormat, or another code that can_decode() refuses
  int width_px = 0;
  int height_px = 0;
  std::uint32_t seconds_numerator = 0;    ///< frame period, as the driver writes it;
  std::uint32_t seconds_denominator = 0;  ///< both 0: the driver does not report it

  [[nodiscard]] double frames_per_second() const {
    return seconds_numerator == 0 ? 0.0
                                  : static_cast<double>(seconds_denominator) / seconds_numerator;
  }
  /// "1920x1080 MJPG at 30 frames per second".
  [[nodiscard]] Message text() const;
  bool operator==(const CameraFormat&) const = default;
};

/// Criteria for a format; empty or 0 accepts anything.
struct FormatCriteria {
  std::string fourcc;  ///< GREY, YUYV, Y16 or MJPG
  int width_px = 0;
  int height_px = 0;
  double frames_per_second = 0;
};

/// The offered format that meets the wish. Of several: one that is not predicted from frames
/// before, then the largest with at least 25 frames a second (or the requested rate), then the
/// fastest, then the one with least loss. Error: none does, with the offered formats.
[[nodiscard]] Result<CameraFormat> choose_format(const std::vector<CameraFormat>& offered,
                                                 const FormatCriteria& criteria,
                                                 const std::string& node);

/// The error for a failed call on a camera. doing: "the camera could not be opened".
[[nodiscard]] Error camera_error(const Message& doing, const std::string& node, int error_number);
/// True for the error numbers of a device that is no longer there.
[[nodiscard]] bool is_gone_error(int error_number);

/// Closes the node when destroyed. Any thread may call ioctl().
class V4l2Device {
 public:
  /// Error: cannot be opened.
  static Result<V4l2Device> open(V4l2Calls& calls, const std::string& node);
  ~V4l2Device();
  V4l2Device(V4l2Device&& other) noexcept;
  V4l2Device& operator=(V4l2Device&&) = delete;

  /// Repeats after an interrupting signal. Returns 0 or the error number.
  [[nodiscard]] int ioctl(unsigned long request, void* argument) const;
  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] const std::string& node() const { return node_; }
  [[nodiscard]] V4l2Calls& calls() const { return *calls_; }

  struct Capability {
    std::string driver, card, bus;
    /// Of this node only, not of its siblings: a camera's second node carries metadata only.
    bool is_capture = false;
    bool can_stream = false;
    bool is_multi_planar = false;
  };
  [[nodiscard]] Result<Capability> capability() const;

  /// Every format, size and rate. For ranges: both ends, and 640x480, 1280x720 and 1920x1080 within
  /// them. Without a list: the current format.
  [[nodiscard]] std::vector<CameraFormat> formats() const;

  /// Sets format and rate. Returns bytes per row. Error: refused, or the driver chose another
  /// format or size. A changed rate is no error: it is written to `format`.
  [[nodiscard]] Result<std::size_t> configure(CameraFormat& format) const;

 private:
  V4l2Device(V4l2Calls& calls, int descriptor, std::string node)
      : calls_(&calls), descriptor_(descriptor), node_(std::move(node)) {}

  V4l2Calls* calls_;
  int descriptor_;
  std::string node_;
};

// A running stream with buffers shared with the kernel.

/// Stops streaming and unmaps when destroyed. One thread. The device must outlive it.
class V4l2Stream {
 public:
  /// The device must have been configured. Error: no buffers, no bandwidth, in use, gone.
  static Result<std::unique_ptr<V4l2Stream>> start(const V4l2Device& device);
  ~V4l2Stream();
  V4l2Stream(const V4l2Stream&) = delete;
  V4l2Stream& operator=(const V4l2Stream&) = delete;

  /// A filled buffer; its bytes are valid until requeue().
  struct Filled {
    std::uint32_t index = 0;
    std::span<const std::uint8_t> bytes;
    std::uint32_t sequence = 0;
    std::int64_t time_ns = 0;  ///< monotonic; the time of take(), if the driver's clock is another
    bool is_damaged = false;   ///< the driver reports lost data
  };
  /// error 0 and no buffer: none is filled yet.
  struct Taken {
    int error_number = 0;
    std::optional<Filled> filled;
  };
  [[nodiscard]] Taken take();
  /// Returns 0 or the error number.
  [[nodiscard]] int requeue(const Filled& filled);

 private:
  explicit V4l2Stream(const V4l2Device& device) : device_(&device) {}
  [[nodiscard]] Status map_buffers();
  [[nodiscard]] int queue(std::uint32_t index);

  const V4l2Device* device_;
  std::vector<std::span<std::uint8_t>> buffers_;
};

}  // namespace alltact
