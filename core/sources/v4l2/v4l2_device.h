// An open camera node: ioctls with named errors, capability, formats.
#pragma once

#include "core/io/grey_decoder.h"
#include "core/result.h"
#include "core/sources/v4l2/v4l2_calls.h"

#include <cstdint>
#include <string>
#include <vector>

namespace alltact {

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

/// The offered format that meets the wish. Of several: the largest with at least 25 frames a second
/// (or the requested rate), then the fastest, then the one with least loss. Error: none does, with
/// the offered formats.
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

}  // namespace alltact
