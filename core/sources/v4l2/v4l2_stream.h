// A running stream with buffers shared with the kernel.
#pragma once

#include "core/result.h"
#include "core/sources/v4l2/v4l2_device.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace alltact {

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
