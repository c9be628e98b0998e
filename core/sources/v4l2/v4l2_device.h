// An open camera node: ioctls with named errors, what it can do, its formats.
#pragma once

#include "core/io/grey_decoder.h"
#include "core/result.h"
#include "core/sources/v4l2/v4l2_calls.h"

#include <cstdint>
#include <string>
#include <vector>

namespace alltact {

/// One way of streaming that a camera offers or was asked for.
struct CameraFormat {
  std::uint32_t fourcc = 0;  ///< a PixelFormat, or another code that can_decode() refuses
  int width_px = 0;
  int height_px = 0;
  std::uint32_t seconds_numerator = 0;    ///< time from frame to frame, as the driver writes it;
  std::uint32_t seconds_denominator = 0;  ///< both 0: the driver does not say

  [[nodiscard]] double frames_per_second() const {
    return seconds_numerator == 0 ? 0.0
                                  : static_cast<double>(seconds_denominator) / seconds_numerator;
  }
  /// "1920x1080 MJPG at 30 frames per second".
  [[nodiscard]] Message text() const;
  bool operator==(const CameraFormat&) const = default;
};

/// What is wanted of a format; what is left empty or 0 may be anything.
struct FormatWish {
  std::string fourcc;  ///< GREY, YUYV, Y16 or MJPG
  int width_px = 0;
  int height_px = 0;
  double frames_per_second = 0;
};

/// The offered format that meets the wish; of several the largest that reaches 25 frames a second
/// (or the wished rate), then the fastest, then the one with least loss. Error: none does, with
/// what there is.
[[nodiscard]] Result<CameraFormat> choose_format(const std::vector<CameraFormat>& offered,
                                                 const FormatWish& wish,
                                                 const std::string& node);

/// What a failed call on a camera means. doing: "the camera could not be opened".
[[nodiscard]] Error camera_error(const Message& doing, const std::string& node, int error_number);
/// True for the error numbers of a device that is no longer there.
[[nodiscard]] bool means_gone(int error_number);

/// Closes the node when it goes away. Any thread may call ioctl().
class V4l2Device {
 public:
  /// Error: cannot be opened.
  static Result<V4l2Device> open(V4l2Calls& calls, const std::string& node);
  ~V4l2Device();
  V4l2Device(V4l2Device&& other) noexcept;
  V4l2Device& operator=(V4l2Device&&) = delete;

  /// Tries again when a signal interrupts. Returns 0 or the error number.
  [[nodiscard]] int ioctl(unsigned long request, void* argument) const;
  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] const std::string& node() const { return node_; }
  [[nodiscard]] V4l2Calls& calls() const { return *calls_; }

  struct Capability {
    std::string driver, card, bus;
    /// Of this node alone, not of its siblings: a camera's second node carries metadata only.
    bool is_capture = false;
    bool can_stream = false;
    bool is_multi_planar = false;
  };
  [[nodiscard]] Result<Capability> capability() const;

  /// Every format, size and rate. Where a driver gives ranges: both ends, and 640x480, 1280x720 and
  /// 1920x1080 within them. Where it lists nothing: the one that is set.
  [[nodiscard]] std::vector<CameraFormat> formats() const;

  /// Sets format and rate. Returns bytes per row. Error: refused, or the driver chose another
  /// format or size than asked. A rate that the driver changed is no error: it is written to
  /// `format`.
  [[nodiscard]] Result<std::size_t> configure(CameraFormat& format) const;

 private:
  V4l2Device(V4l2Calls& calls, int descriptor, std::string node)
      : calls_(&calls), descriptor_(descriptor), node_(std::move(node)) {}

  V4l2Calls* calls_;
  int descriptor_;
  std::string node_;
};

}  // namespace alltact
