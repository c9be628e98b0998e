// A camera that recovers by itself. It captures in a thread of its own, reports every fault, and
// resumes after re-plugging with the same settings. It reports a change of its input signal (a
// converter's). It then continues with the old format or, where that is gone, another one that
// meets the wish.
#pragma once

#include "core/base/result.h"
#include "core/base/worker.h"
#include "core/devices/camera_controls.h"
#include "core/devices/v4l2_device.h"
#include "core/image/frame.h"
#include "core/sources/source.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace alltact {

// Checks the times and the repetition of a camera's frames.

/// Frames of one camera, in the order of arrival. Not for several threads at once.
class FrameCheck {
 public:
  struct CaptureTime {
    std::int64_t time_ns = 0;        ///< after that of the frame before, and not ahead of arrival
    std::int64_t correction_ns = 0;  ///< correction of the camera's own time; 0 where that is valid
  };

  /// Returns the time of capture. `camera_ns` is the camera's own time, on the clock of
  /// `arrived_ns`. The arrival replaces it where it is not after the frame before, or more than 0.1
  /// s ahead.
  [[nodiscard]] CaptureTime time_of(std::int64_t camera_ns, std::int64_t arrived_ns);

  /// True for an exact repetition of the frame before, which noise makes impossible for a camera.
  /// Numbers and times are no evidence: some drivers never change them. A uniform frame is no
  /// repetition either, because a lens cap gives it again and again.
  [[nodiscard]] bool is_repeat(const FramePtr& frame);

 private:
  FramePtr last_;
  std::int64_t last_time_ns_ = 0;
};

class HotPlug;

/// Settings to restore after re-plugging, which a finger's provenance stores.
struct CameraSettings {
  std::string identity;  ///< by-id name, by-path name, or node: see CameraIdentity::stable_name()
  CameraFormat format;
  std::vector<ControlValue> controls;
};

/// Access to a camera: the system calls to use (real or simulated), and a search for its node.
struct CameraAccess {
  V4l2Calls* calls = nullptr;
  std::string identity;
  /// The current node of the camera. Error: it is not there.
  std::function<Result<std::string>()> find_node;
  std::string serial = {};  ///< added to every frame, where the camera has one
};

enum class CameraState {
  kStreaming = 1,
  kStalled,  ///< connected, but no frames come; the stream is restarted repeatedly
  kGone,     ///< unplugged; waits for it to come back
};

struct CameraStatus {
  CameraState state = CameraState::kStreaming;
  std::optional<Error> trouble;  ///< why no frames come now
  std::uint64_t delivered = 0;   ///< frames published
  std::uint64_t lost = 0;        ///< gaps in the driver's numbers
  std::uint64_t damaged = 0;     ///< truncated or marked as damaged: not published
  std::uint64_t repeated = 0;    ///< among the delivered: equal to the frame before
  std::uint64_t mistimed = 0;    ///< among the delivered: with an impossible time
  std::uint64_t restarts = 0;    ///< of the stream after a stall or a fault
  std::uint64_t unplugged = 0;
  std::uint64_t restored = 0;    ///< locked controls that had changed and were set again
  std::uint64_t remarked = 0;    ///< number of remarks since it was opened
  std::vector<Message> remarks;  ///< the latest twenty: changed controls, recoveries, repeated
                                 ///< frames, a wrong clock
};

class V4l2Camera {
 public:
  /// Opens the camera, sets the format, restores `controls`, starts. Error: the first failure; a
  /// control that cannot be restored is a remark only.
  static Result<std::unique_ptr<V4l2Camera>> open(const CameraAccess& access,
                                                  const FormatCriteria& criteria,
                                                  const std::vector<ControlValue>& controls = {});
  ~V4l2Camera();  ///< stops
  V4l2Camera(const V4l2Camera&) = delete;
  V4l2Camera& operator=(const V4l2Camera&) = delete;

  // All of these but stop() may be called from any thread.

  /// The latest frame for viewers, every frame for subscribers.
  [[nodiscard]] const FrameHub& frames() const { return hub_; }
  [[nodiscard]] CameraStatus status() const;
  /// The current settings, without controls that an automatic mode sets.
  [[nodiscard]] CameraSettings settings() const;
  /// Error: unplugged.
  [[nodiscard]] Result<std::vector<CameraControl>> controls() const;
  /// Sets a control; it is restored after re-plugging and held by the lock. Error: refused, or
  /// unplugged.
  [[nodiscard]] Status set_control(const ControlValue& control);

  /// Switches automatic exposure, gain, white balance and focus off and holds their values. A
  /// change from outside is detected (by event, or within about a second per ten controls),
  /// reverted and remarked. Error: unplugged.
  [[nodiscard]] Status lock();
  void unlock();
  /// The held values; empty when not locked.
  [[nodiscard]] std::vector<ControlValue> locked() const;

  /// Ends the stream, within the processing time of one frame; readers get no more frames.
  void stop();

 private:
  V4l2Camera(const CameraAccess& access, FormatCriteria criteria);

  [[nodiscard]] Result<CameraFormat> format_for(const V4l2Device& device) const;
  [[nodiscard]] Status start(V4l2Device device);
  void run();
  void capture();
  void wait_for_plug();
  void reconnect();
  void restart(const Error& why);
  void drop_device(const Error& why);
  [[nodiscard]] bool take_frame();
  void publish(const V4l2Stream::Filled& filled);
  [[nodiscard]] std::int64_t time_of(const V4l2Stream::Filled& filled);
  void check_repeat(const FramePtr& frame);
  [[nodiscard]] std::shared_ptr<const std::string> controls_now();
  [[nodiscard]] std::uint64_t number_of(std::uint32_t driver_sequence);
  void follow_changes();
  void renegotiate();
  void check_next_held();
  void on_change(const ControlValue& change);
  void trouble(CameraState state, const Error& error);
  /// `what`: a sentence without its full stop.
  void remark(const Message& what);
  [[nodiscard]] int frame_timeout_ms() const;
  [[nodiscard]] Error unplugged() const;

  // One held control at a time, because each costs USB time.
  static constexpr std::chrono::milliseconds kCheckInterval{100};

  CameraAccess access_;
  FormatCriteria criteria_;
  CameraFormat format_;
  bool is_format_open_ = true;  // chosen at the start of the stream, from the formats available
                                // then
  std::size_t stride_bytes_ = 0;
  GreyDecoder decoder_;
  FrameHub hub_;
  std::unique_ptr<HotPlug> plug_;  // null where the system has no udev: then it polls
  int wake_ = -1;                  // an eventfd that ends every wait

  // The capturing thread changes device_, others use it: both under this lock.
  mutable std::mutex device_mutex_;
  std::unique_ptr<V4l2Device> device_;
  std::vector<ControlValue> restore_values_;  // to restore
  std::vector<ControlValue> held_;            // locked

  // Of the capturing thread only.
  std::unique_ptr<V4l2Stream> stream_;
  FrameCheck check_;
  bool is_repeat_reported_ = false, is_mistime_reported_ = false;  // since the device was opened
  std::shared_ptr<const std::string> frame_controls_;              // of the last frame
  bool has_frame_ = false;                                         // since the stream was started
  std::size_t decoder_remarks_ = 0;                                // of the decoder's, passed on
  std::uint32_t last_driver_sequence_ = 0;
  std::uint64_t next_number_ = 0;
  std::size_t next_held_ = 0;
  std::chrono::steady_clock::time_point next_check_, last_frame_;

  mutable std::mutex status_mutex_;
  CameraStatus status_;
  std::deque<Message> remarks_;

  std::atomic<bool> stopping_{false};
  Worker worker_;
};

/// A camera as a Source: every frame in order.
class CameraSource : public Source {
 public:
  /// Buffers at most `capacity` frames for a slow reader.
  explicit CameraSource(std::shared_ptr<V4l2Camera> camera, std::size_t capacity = 30);

  /// Waits for the next frame, at most a second. Errors: the camera was unplugged, or sends no
  /// frames; call again, frames resume when it is back. nullptr once it was stopped.
  [[nodiscard]] Result<FramePtr> next() override;
  [[nodiscard]] std::optional<std::size_t> count() const override { return std::nullopt; }
  [[nodiscard]] bool is_continuous() const override { return true; }
  [[nodiscard]] bool is_live() const override { return true; }
  [[nodiscard]] double frames_per_s() const override;
  /// Frames that were lost because next() was called too rarely.
  [[nodiscard]] std::uint64_t dropped() const { return queue_->dropped(); }
  [[nodiscard]] V4l2Camera& camera() const { return *camera_; }
  /// For users that may outlive this source.
  [[nodiscard]] std::shared_ptr<V4l2Camera> shared_camera() const { return camera_; }

 private:
  std::shared_ptr<V4l2Camera> camera_;
  std::unique_ptr<FrameQueue> queue_;
};

}  // namespace alltact
