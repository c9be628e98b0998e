// A camera that keeps going: captures in a thread of its own, says every fault by name, comes back
// by itself after it was unplugged, with the same settings. When the signal that it gives on
// changes (a converter's), it says so and goes on with the format of before or, where that is gone,
// another that meets the wish.
#pragma once

#include "core/result.h"
#include "core/sources/frame_hub.h"
#include "core/sources/source.h"
#include "core/sources/v4l2/camera_controls.h"
#include "core/sources/v4l2/picture_check.h"
#include "core/sources/v4l2/v4l2_device.h"
#include "core/sources/v4l2/v4l2_stream.h"

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace alltact {

class HotPlug;

/// What has to be the same again after re-plugging, and what a finger's provenance stores.
struct CameraSettings {
  std::string identity;  ///< by-id name, by-path name, or node: see CameraIdentity::lasting()
  CameraFormat format;
  std::vector<ControlValue> controls;
};

/// Where a camera is reached: the system's or a rig's calls, and how to find its node again.
struct CameraPlace {
  V4l2Calls* calls = nullptr;
  std::string identity;
  /// The node at which the camera is now. Error: it is not there.
  std::function<Result<std::string>()> find_node;
  std::string serial = {};  ///< told with every frame, where the camera has one
};

enum class CameraState {
  kStreaming = 1,
  kStalled,  ///< there, but no pictures come; the stream is started again and again
  kGone,     ///< unplugged; waits for it to come back
};

struct CameraCounts {
  std::uint64_t delivered = 0;  ///< frames published
  std::uint64_t lost = 0;       ///< gaps in the driver's numbers
  std::uint64_t damaged = 0;    ///< came, but truncated or marked as damaged: never shown
  std::uint64_t repeated = 0;   ///< of those delivered: the picture before once more
  std::uint64_t mistimed = 0;   ///< of those delivered: told at a time that cannot be
  std::uint64_t restarts = 0;   ///< of the stream after a stall or a fault
  std::uint64_t unplugged = 0;
  std::uint64_t put_back = 0;  ///< locked controls that had changed and were set again
};

struct CameraStatus {
  CameraState state = CameraState::kStreaming;
  std::optional<Error> trouble;  ///< why no pictures come now
  CameraCounts counts;
  std::uint64_t remarked = 0;    ///< remarks since it was opened
  std::vector<Message> remarks;  ///< the latest twenty: controls that changed, what came back,
                                 ///< pictures that repeat, a clock that is wrong
};

class V4l2Camera {
 public:
  /// Opens, chooses and sets the format, puts `controls` back, starts. Error: the first thing that
  /// failed; a control that cannot be put back is a remark only.
  static Result<std::unique_ptr<V4l2Camera>> open(const CameraPlace& place,
                                                  const FormatWish& wish,
                                                  const std::vector<ControlValue>& controls = {});
  ~V4l2Camera();  ///< stops
  V4l2Camera(const V4l2Camera&) = delete;
  V4l2Camera& operator=(const V4l2Camera&) = delete;

  // All of these but stop() may be called from any thread.

  /// The latest frame for whoever looks, every frame for whoever subscribes.
  [[nodiscard]] const FrameHub& frames() const { return hub_; }
  [[nodiscard]] CameraStatus status() const;
  /// As they are now; the controls that an automatic mode has in hand are left out.
  [[nodiscard]] CameraSettings settings() const;
  /// Error: unplugged.
  [[nodiscard]] Result<std::vector<CameraControl>> controls() const;
  /// Kept from now on, also through re-plugging and by the lock. Error: refused, or unplugged.
  [[nodiscard]] Status set_control(const ControlValue& control);

  /// Switches automatic exposure, gain, white balance and focus off and holds their values: a
  /// change from outside is seen (by event, or within about a second per ten controls), put back
  /// and remarked. Error: unplugged.
  [[nodiscard]] Status lock();
  void unlock();
  /// What is held; empty when not locked.
  [[nodiscard]] std::vector<ControlValue> locked() const;

  /// Ends the stream, within the time of one frame's work; readers get no more frames.
  void stop();

 private:
  V4l2Camera(const CameraPlace& place, FormatWish wish);

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
  void look_for_repeat(const FramePtr& frame);
  [[nodiscard]] std::shared_ptr<const std::string> controls_now();
  [[nodiscard]] std::uint64_t number_of(std::uint32_t driver_sequence);
  void follow_changes();
  void agree_anew();
  void check_next_held();
  void on_change(const ControlValue& change);
  void trouble(CameraState state, const Error& error);
  /// `what`: a sentence without its full stop.
  void remark(const Message& what);
  [[nodiscard]] int patience_ms() const;
  [[nodiscard]] Error unplugged() const;

  // Of held controls, one at a time: each costs USB time.
  static constexpr std::chrono::milliseconds kBetweenChecks{100};

  CameraPlace place_;
  FormatWish wish_;
  CameraFormat format_;
  bool is_format_open_ = true;  // to be chosen when the stream starts, by what there is then
  std::size_t stride_bytes_ = 0;
  GreyDecoder decoder_;
  FrameHub hub_;
  std::unique_ptr<HotPlug> plug_;  // null where the system has no udev: then only time passes
  int wake_ = -1;                  // an eventfd that ends every wait

  // The capturing thread changes device_, others use it: both under this lock.
  mutable std::mutex device_mutex_;
  std::unique_ptr<V4l2Device> device_;
  std::vector<ControlValue> wanted_;  // to put back
  std::vector<ControlValue> held_;    // locked

  // Of the capturing thread alone.
  std::unique_ptr<V4l2Stream> stream_;
  PictureCheck check_;
  bool is_repeat_told_ = false, is_mistime_told_ = false;  // since the device was opened
  std::shared_ptr<const std::string> told_controls_;       // with the last frame
  bool has_frame_ = false;                                 // since the stream was started
  std::uint32_t last_driver_sequence_ = 0;
  std::uint64_t next_number_ = 0;
  std::size_t next_held_ = 0;
  std::chrono::steady_clock::time_point next_check_, last_frame_;

  mutable std::mutex status_mutex_;
  CameraStatus status_;
  std::deque<Message> remarks_;

  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

/// A camera as a Source: every frame in order.
class CameraSource : public Source {
 public:
  /// Keeps at most `capacity` frames for a reader that falls behind.
  explicit CameraSource(std::shared_ptr<V4l2Camera> camera, std::size_t capacity = 30);

  /// Waits for the next frame, at most a second. Errors: the camera was unplugged, or sends
  /// nothing; call again, it goes on when the camera is back. nullptr once it was stopped.
  [[nodiscard]] Result<FramePtr> next() override;
  [[nodiscard]] std::optional<std::size_t> count() const override { return std::nullopt; }
  [[nodiscard]] bool is_continuous() const override { return true; }
  [[nodiscard]] bool is_live() const override { return true; }
  [[nodiscard]] double frames_per_s() const override;
  /// Frames that were lost because next() was not called often enough.
  [[nodiscard]] std::uint64_t dropped() const { return queue_->dropped(); }
  [[nodiscard]] V4l2Camera& camera() const { return *camera_; }
  /// For whoever may use it longer than this source lives.
  [[nodiscard]] std::shared_ptr<V4l2Camera> shared_camera() const { return camera_; }

 private:
  std::shared_ptr<V4l2Camera> camera_;
  std::unique_ptr<FrameQueue> queue_;
};

}  // namespace alltact
