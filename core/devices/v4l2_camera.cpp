#include "core/devices/v4l2_camera.h"

#include "core/base/guarded.h"
#include "core/devices/hot_plug.h"
#include "core/image/frame.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <linux/videodev2.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace alltact {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t kMaxRemarks = 20;
constexpr int kRetryInterval_ms = 100;  // between attempts to open or start
constexpr int kFirstFrame_ms = 3000;    // some cameras take seconds to begin
constexpr int kMinFrameTimeout_ms = 500;
constexpr std::uint32_t kMaxSequenceGap = 100'000;  // above: the driver restarted its count

/// Waits for one descriptor (or none, -1) and for the eventfd that ends waits.
short wait_for(V4l2Calls& calls, int descriptor, short events, int wake, int timeout_ms) {
  pollfd descriptors[2] = {{wake, POLLIN, 0}, {descriptor, events, 0}};
  const int ready = calls.poll(descriptors, descriptor < 0 ? 1 : 2, timeout_ms);
  return ready > 0 ? descriptors[1].revents : short{0};
}

}  // namespace

V4l2Camera::V4l2Camera(const CameraAccess& access, FormatCriteria criteria)
    : access_(access),
      criteria_(std::move(criteria)),
      plug_(HotPlug::watch()),
      wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      next_check_(Clock::now()),
      last_frame_(Clock::now()) {}

Result<std::unique_ptr<V4l2Camera>> V4l2Camera::open(const CameraAccess& access,
                                                     const FormatCriteria& criteria,
                                                     const std::vector<ControlValue>& controls) {
  const auto node = access.find_node();
  if (!node) return node.error();
  auto device = V4l2Device::open(*access.calls, *node);
  if (!device) return device.error();
  const auto capability = device->capability();
  if (!capability) return capability.error();
  if (!capability->is_capture || capability->is_multi_planar || !capability->can_stream)
    return Error{en::say("this device node delivers no readable images"), *node,
                 en::say("a camera that 'alltact devices' lists as usable")};
  std::unique_ptr<V4l2Camera> camera(new V4l2Camera(access, criteria));
  camera->restore_values_ = controls;
  if (const Status status = camera->start(std::move(*device)); !status) return status.error();
  camera->worker_ = Worker([camera = camera.get()] { camera->run(); });
  return camera;
}

V4l2Camera::~V4l2Camera() {
  stop();
  if (wake_ >= 0) ::close(wake_);
}

void V4l2Camera::stop() {
  stopping_ = true;
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(wake_, &one, sizeof one);
  worker_.join();
  hub_.close();
}

Result<CameraFormat> V4l2Camera::format_for(const V4l2Device& device) const {
  if (!is_format_open_) return format_;
  const auto offered = device.formats();
  if (std::find(offered.begin(), offered.end(), format_) != offered.end()) return format_;
  return choose_format(offered, criteria_, device.node());
}

Status V4l2Camera::start(V4l2Device device) {
  const auto chosen = format_for(device);
  if (!chosen) return chosen.error();
  CameraFormat format = *chosen;
  const auto stride = device.configure(format);
  if (!stride) return stride.error();
  const std::lock_guard lock(device_mutex_);
  for (const Message& problem : restore_controls(device, restore_values_)) remark(problem);
  const auto controls = list_controls(device);
  watch_changes(device, controls);
  auto opened = std::make_unique<V4l2Device>(std::move(device));
  auto stream = V4l2Stream::start(*opened);
  if (!stream) return stream.error();
  // Values to restore later: the requested ones first, then those found in the camera.
  std::vector<ControlValue> all = settings_of(controls);
  merge_controls(all, restore_values_);
  restore_values_ = std::move(all);
  stride_bytes_ = *stride;
  format_ = format;
  is_format_open_ = false;
  device_ = std::move(opened);
  stream_ = std::move(*stream);
  decoder_.restart();
  has_frame_ = false;
  is_repeat_reported_ = is_mistime_reported_ = false;
  last_frame_ = Clock::now();
  return {};
}

void V4l2Camera::run() {
  while (!stopping_) {
    const Status ran = guarded([this] {
      if (device_ == nullptr) {
        wait_for_plug();
        if (!stopping_) reconnect();
      } else if (stream_ == nullptr) {
        wait_for(*access_.calls, -1, 0, wake_, kRetryInterval_ms);
        if (!stopping_) restart(*status().trouble);
      } else {
        capture();
      }
    });
    if (ran) continue;
    trouble(CameraState::kStalled, ran.error());
    wait_for(*access_.calls, -1, 0, wake_, kRetryInterval_ms);
  }
}

int V4l2Camera::frame_timeout_ms() const {
  if (!has_frame_) return kFirstFrame_ms;
  const double rate = format_.frames_per_second();
  return std::max(kMinFrameTimeout_ms, rate > 0 ? static_cast<int>(5000.0 / rate) : 0);
}

void V4l2Camera::capture() {
  const bool is_locked = !locked().empty();
  const int wait_ms = is_locked ? static_cast<int>(kCheckInterval.count()) : frame_timeout_ms();
  const short ready =
      wait_for(*access_.calls, device_->descriptor(), POLLIN | POLLPRI, wake_, wait_ms);
  if (stopping_) return;
  if ((ready & POLLPRI) != 0) follow_changes();
  if (stream_ == nullptr) return;
  if ((ready & (POLLIN | POLLERR | POLLHUP | POLLNVAL)) != 0) {
    const bool taken = take_frame();
    if (stream_ == nullptr) return;
    // An error state without a buffer behind it would end every later wait at once.
    if (!taken && (ready & (POLLERR | POLLHUP | POLLNVAL)) != 0)
      return restart(
          camera_error(en::say("the camera stopped sending images"), device_->node(), EIO));
  }
  if (is_locked && Clock::now() >= next_check_) check_next_held();
  const auto silence = std::chrono::duration_cast<milliseconds>(Clock::now() - last_frame_).count();
  if (silence >= frame_timeout_ms())
    restart({en::say("no image arrived for {:.1f} seconds", static_cast<double>(silence) / 1e3),
             access_.identity,
             en::say("check the cable and the USB port; the stream is being restarted")});
}

bool V4l2Camera::take_frame() {
  const V4l2Stream::Taken taken = stream_->take();
  if (is_gone_error(taken.error_number)) {
    drop_device(unplugged());
    return false;
  }
  if (taken.error_number != 0) {
    restart(
        camera_error(en::say("an image cannot be captured"), device_->node(), taken.error_number));
    return false;
  }
  if (!taken.filled) return false;
  last_frame_ = Clock::now();
  publish(*taken.filled);
  return true;
}

std::uint64_t V4l2Camera::number_of(std::uint32_t driver_sequence) {
  std::uint32_t step = driver_sequence - last_driver_sequence_;
  if (!has_frame_ || step == 0 || step > kMaxSequenceGap) step = 1;
  has_frame_ = true;
  last_driver_sequence_ = driver_sequence;
  if (step > 1) {
    const std::lock_guard lock(status_mutex_);
    status_.lost += step - 1;
  }
  const std::uint64_t number = next_number_ + step - 1;
  next_number_ = number + 1;
  return number;
}

/// Corrects the time of a frame: times that align forces and recordings never run backwards.
std::int64_t V4l2Camera::time_of(const V4l2Stream::Filled& filled) {
  const auto arrived_ns =
      std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch()).count();
  const FrameCheck::CaptureTime taken_at = check_.time_of(filled.time_ns, arrived_ns);
  if (taken_at.correction_ns == 0) return taken_at.time_ns;
  {
    const std::lock_guard lock(status_mutex_);
    ++status_.mistimed;
  }
  if (!std::exchange(is_mistime_reported_, true))
    remark(
        en::say("The camera's clock was changed by {:+.1f} s: until it is correct again, the time "
                "of arrival of images is used",
                -1e-9 * static_cast<double>(taken_at.correction_ns)));
  return taken_at.time_ns;
}

void V4l2Camera::check_repeat(const FramePtr& frame) {
  if (!check_.is_repeat(frame)) return;
  {
    const std::lock_guard lock(status_mutex_);
    ++status_.repeated;
  }
  if (!std::exchange(is_repeat_reported_, true))
    remark(
        en::say("The camera sent an image twice ({}): a mean over several images is less certain "
                "than reported",
                frame->name));
}

void V4l2Camera::publish(const V4l2Stream::Filled& filled) {
  auto frame = std::make_shared<Frame>();
  frame->sequence = number_of(filled.sequence);
  frame->time_ns = time_of(filled);
  frame->name = fmt::format("frame_{:05}", frame->sequence);
  frame->origin = access_.identity;
  frame->controls = controls_now();
  const auto format = static_cast<PixelFormat>(format_.fourcc);
  const auto decode = [&](std::span<const std::uint8_t> bytes) {
    return decoder_(format, format_.width_px, format_.height_px, stride_bytes_, bytes);
  };
  bool is_good = !filled.is_damaged && !filled.bytes.empty();
  if (is_good && is_jpeg(format)) {
    // The one copy: the packet itself, so that the camera has its buffer back before decoding.
    frame->jpeg =
        std::make_shared<const std::vector<std::uint8_t>>(filled.bytes.begin(), filled.bytes.end());
  } else if (is_good) {
    auto grey = decode(filled.bytes);
    is_good = grey.ok();
    if (is_good) frame->grey = std::move(*grey);
  }
  static_cast<void>(stream_->requeue(filled));  // a failure shows at the next wait
  if (is_good && frame->jpeg != nullptr) {
    auto grey = decode(*frame->jpeg);
    is_good = grey.ok();
    if (is_good) frame->grey = std::move(*grey);
  }
  for (; decoder_remarks_ < decoder_.remarks().size(); ++decoder_remarks_)
    remark(en::at(en::say("Images of the camera"), decoder_.remarks()[decoder_remarks_]));
  if (is_good && frame->grey.empty()) return;  // a predicted one, before the first complete one
  bool is_back = false;
  {
    const std::lock_guard lock(status_mutex_);
    ++(is_good ? status_.delivered : status_.damaged);
    is_back = is_good && status_.trouble.has_value();
    if (is_back) {
      status_.state = CameraState::kStreaming;
      status_.trouble.reset();
    }
  }
  if (is_back) remark(en::say("Images arrive again"));
  if (!is_good) return;
  check_repeat(frame);
  hub_.publish(std::move(frame));
}

void V4l2Camera::restart(const Error& why) {
  auto capability = device_->capability();
  stream_.reset();
  if (!capability) return drop_device(unplugged());
  trouble(CameraState::kStalled, why);
  {
    const std::lock_guard lock(status_mutex_);
    ++status_.restarts;
  }
  auto stream = V4l2Stream::start(*device_);
  last_frame_ = Clock::now();
  if (!stream) return trouble(CameraState::kStalled, stream.error());
  stream_ = std::move(*stream);
  decoder_.restart();
  const bool had_frame = std::exchange(has_frame_, false);
  // Prevents a busy loop of streams that fail at once.
  if (!had_frame) wait_for(*access_.calls, -1, 0, wake_, kRetryInterval_ms);
}

void V4l2Camera::drop_device(const Error& why) {
  {
    const std::lock_guard lock(device_mutex_);
    stream_.reset();
    device_.reset();
  }
  {
    const std::lock_guard lock(status_mutex_);
    ++status_.unplugged;
  }
  trouble(CameraState::kGone, why);
}

void V4l2Camera::wait_for_plug() {
  const int descriptor = plug_ == nullptr ? -1 : plug_->descriptor();
  // The timeout also covers containers, which may receive no events.
  if (wait_for(*access_.calls, descriptor, POLLIN, wake_, kRetryInterval_ms) != 0)
    static_cast<void>(plug_->read());
}

void V4l2Camera::reconnect() {
  const auto node = access_.find_node();
  if (!node) return;
  auto device = V4l2Device::open(*access_.calls, *node);
  const Status status = device.ok() ? start(std::move(*device)) : Status(device.error());
  if (!status) return trouble(CameraState::kGone, status.error());
  {
    const std::lock_guard lock(status_mutex_);
    status_.state = CameraState::kStalled;
    status_.trouble =
        Error{en::say("the camera is back and has not sent an image yet"), access_.identity, ""};
  }
  remark(en::say("The camera was plugged in again at {}", *node));
}

/// Restarts the stream with the previous format where the camera still has it.
void V4l2Camera::renegotiate() {
  const Message before = format_.text();
  std::optional<V4l2Device> device;
  {
    const std::lock_guard lock(device_mutex_);
    stream_.reset();
    device.emplace(std::move(*device_));
    device_.reset();
  }
  is_format_open_ = true;
  const Status status = start(std::move(*device));
  if (!status) return trouble(CameraState::kGone, status.error());  // is opened again and again
  trouble(
      CameraState::kStalled,
      {en::say("the camera's signal changed: it sent {}, and sends {} now", before, format_.text()),
       access_.identity, en::say("check what is plugged into it, if this was not intended")});
}

Error V4l2Camera::unplugged() const {
  return {en::say("the camera was unplugged"), access_.identity,
          en::say("plug it in again; it continues by itself with the same settings")};
}

void V4l2Camera::trouble(CameraState state, const Error& error) {
  bool is_new = false;
  {
    const std::lock_guard lock(status_mutex_);
    is_new = !status_.trouble || status_.trouble->what != error.what;
    status_.state = state;
    status_.trouble = error;
  }
  if (is_new) hub_.fault(error);
}

void V4l2Camera::remark(const Message& what) {
  const std::lock_guard lock(status_mutex_);
  ++status_.remarked;
  remarks_.push_back(en::say("{}.", what));
  if (remarks_.size() > kMaxRemarks) remarks_.pop_front();
}

CameraStatus V4l2Camera::status() const {
  const std::lock_guard lock(status_mutex_);
  CameraStatus status = status_;
  status.remarks.assign(remarks_.begin(), remarks_.end());
  return status;
}

namespace {

constexpr std::int64_t kMaxAhead_ns = 100'000'000;  // drivers with smoothed times err by less

bool has_same_bytes(const Frame& a, const Frame& b) {
  if (a.jpeg && b.jpeg) return *a.jpeg == *b.jpeg;
  if (a.grey.size() != b.grey.size()) return false;
  for (int v = 0; v < a.grey.rows; ++v)
    if (std::memcmp(a.grey.ptr(v), b.grey.ptr(v), static_cast<std::size_t>(a.grey.cols)) != 0)
      return false;
  return true;
}

bool is_uniform(const cv::Mat& grey) {
  double min = 0, max = 0;
  cv::minMaxLoc(grey, &min, &max);
  return min == max;
}

}  // namespace

FrameCheck::CaptureTime FrameCheck::time_of(std::int64_t camera_ns, std::int64_t arrived_ns) {
  CaptureTime taken_at{camera_ns, 0};
  if (camera_ns <= last_time_ns_ || camera_ns > arrived_ns + kMaxAhead_ns) {
    taken_at.correction_ns = arrived_ns - camera_ns;
    taken_at.time_ns = std::max(arrived_ns, last_time_ns_ + 1);
  }
  last_time_ns_ = taken_at.time_ns;
  return taken_at;
}

bool FrameCheck::is_repeat(const FramePtr& frame) {
  const bool is_same = last_ && has_same_bytes(*frame, *last_) && !is_uniform(frame->grey);
  last_ = frame;
  return is_same;
}

// The camera's settings: added to every frame, changed, and locked.

/// Known settings, without a request to the camera for each frame.
std::shared_ptr<const std::string> V4l2Camera::controls_now() {
  std::string text;
  add_setting(text, "Camera", access_.identity);
  if (!access_.serial.empty()) add_setting(text, "Serial number", access_.serial);
  add_setting(text, "Format", format_.text().english());
  {
    const std::lock_guard lock(device_mutex_);
    for (const ControlValue& control : restore_values_)
      add_setting(text, control.name, fmt::format("{}", control.value));
  }
  if (frame_controls_ == nullptr || *frame_controls_ != text)
    frame_controls_ = std::make_shared<const std::string>(std::move(text));
  return frame_controls_;
}

CameraSettings V4l2Camera::settings() const {
  const std::lock_guard lock(device_mutex_);
  return {access_.identity, format_,
          device_ == nullptr ? restore_values_ : settings_of(list_controls(*device_))};
}

Result<std::vector<CameraControl>> V4l2Camera::controls() const {
  const std::lock_guard lock(device_mutex_);
  if (device_ == nullptr) return unplugged();
  return list_controls(*device_);
}

Status V4l2Camera::set_control(const ControlValue& control) {
  const std::lock_guard lock(device_mutex_);
  if (device_ == nullptr) return unplugged();
  if (const Status status = write_control(*device_, control); !status) return status;
  merge_controls(restore_values_, {control});
  if (ControlValue* held = find_control(held_, control.id)) held->value = control.value;
  return {};
}

Status V4l2Camera::lock() {
  const std::lock_guard lock(device_mutex_);
  if (device_ == nullptr) return unplugged();
  std::vector<Message> problems;
  held_ = lock_brightness(*device_, problems);
  merge_controls(restore_values_, held_);
  for (const Message& problem : problems) remark(problem);
  return {};
}

void V4l2Camera::unlock() {
  const std::lock_guard lock(device_mutex_);
  held_.clear();
}

std::vector<ControlValue> V4l2Camera::locked() const {
  const std::lock_guard lock(device_mutex_);
  return held_;
}

void V4l2Camera::follow_changes() {
  bool is_other_source = false;
  while (const auto change = next_change(*device_)) {
    if (const auto* control = std::get_if<ControlValue>(&*change)) {
      on_change(*control);
    } else {
      is_other_source = true;
    }
  }
  if (is_other_source) renegotiate();
}

void V4l2Camera::check_next_held() {
  next_check_ = std::chrono::steady_clock::now() + kCheckInterval;
  const auto held = locked();
  if (held.empty()) return;
  const ControlValue& control = held[next_held_++ % held.size()];
  const auto now = read_control(*device_, control);
  if (now.ok()) on_change({control.id, {}, *now});  // a failed read shows as a fault of the stream
}

void V4l2Camera::on_change(const ControlValue& change) {
  const std::lock_guard lock(device_mutex_);
  ControlValue* held = find_control(held_, change.id);
  ControlValue* to_restore = find_control(restore_values_, change.id);
  if (held == nullptr) {
    if (to_restore != nullptr) to_restore->value = change.value;
    return;
  }
  if (change.value == held->value) return;
  const Status status = write_control(*device_, *held);
  if (status.ok()) {
    const std::lock_guard status_lock(status_mutex_);
    ++status_.restored;
  }
  const Message changed = en::say("'{}' was changed from {} to {} by something else", held->name,
                                  held->value, change.value);
  remark(
      en::clauses({changed, status.ok() ? en::say("it was restored") : status.error().message()}));
}

CameraSource::CameraSource(std::shared_ptr<V4l2Camera> camera, std::size_t capacity)
    : camera_(std::move(camera)), queue_(camera_->frames().subscribe(capacity)) {}

double CameraSource::frames_per_s() const {
  const double rate = camera_->settings().format.frames_per_second();
  return rate > 0 ? rate : Source::frames_per_s();
}

Result<FramePtr> CameraSource::next() {
  if (auto item = queue_->next(std::chrono::seconds(1))) return std::move(*item);
  const auto status = camera_->status();
  if (status.trouble) return *status.trouble;
  return Error{en::say("the camera has sent no image for a second"), camera_->settings().identity,
               en::say("check the cable and the USB port")};
}

}  // namespace alltact
