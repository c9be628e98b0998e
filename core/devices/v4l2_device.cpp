#include "core/devices/v4l2_device.h"

#include "core/base/result.h"

#include <cerrno>
#include <chrono>
#include <cstring>

#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace alltact {
namespace {

FailureWords words_for(int error_number) {
  switch (error_number) {
    case EACCES:
    case EPERM:
      return {
          en::say("access is not allowed"),
          en::say("sudo usermod -aG video $USER, then log in again; or install "
                  "packaging/70-alltact.rules in /etc/udev/rules.d and plug the camera in again")};
    case EBUSY:
      return {en::say("another program is using it"),
              en::say("close that program (fuser -v /dev/video* names it)")};
    case ENODEV:
    case ENXIO:
    case ENOENT:
      return {en::say("it is not connected"),
              en::say("plug the camera in; 'alltact devices' lists what is found")};
    case ENOSPC:
      return {en::say("the USB port has no bandwidth left"),
              en::say("another USB port, MJPG instead of YUYV, or smaller images")};
    case EIO:
    case EPROTO:
    case EPIPE:
    case ETIMEDOUT:
      return {en::say("the USB connection is disturbed"),
              en::say("a shorter cable or another port")};
    case EINVAL:
    case ENOTTY:
      return {en::say("the camera refuses"),
              en::say("another format or value; 'alltact devices --details' lists them")};
    case EMFILE:
    case ENFILE:
      return {en::say("too many files are open"), en::say("close other programs")};
    case ENOMEM:
      return {en::say("there is not enough memory"), en::say("close other programs")};
    default:
      return {{}, en::say("unplug the camera and plug it in again")};
  }
}

template <std::size_t N>
std::string text_of(const std::uint8_t (&field)[N]) {
  return {reinterpret_cast<const char*>(field), strnlen(reinterpret_cast<const char*>(field), N)};
}

template <class Request>
Request cleared() {
  Request request;
  std::memset(&request, 0, sizeof request);
  return request;
}

constexpr std::uint32_t kMaxEntries = 1000;  // of any list: a driver without end is a fault

void add_rates(const V4l2Device& device, CameraFormat format, std::vector<CameraFormat>& formats) {
  const std::size_t before = formats.size();
  const auto add = [&](const v4l2_fract& seconds) {
    format.seconds_numerator = seconds.numerator;
    format.seconds_denominator = seconds.denominator;
    formats.push_back(format);
  };
  for (std::uint32_t i = 0; i < kMaxEntries; ++i) {
    auto rate = cleared<v4l2_frmivalenum>();
    rate.index = i;
    rate.pixel_format = format.fourcc;
    rate.width = static_cast<std::uint32_t>(format.width_px);
    rate.height = static_cast<std::uint32_t>(format.height_px);
    if (device.ioctl(VIDIOC_ENUM_FRAMEINTERVALS, &rate) != 0) break;
    if (rate.type == V4L2_FRMIVAL_TYPE_DISCRETE) {
      add(rate.discrete);
      continue;
    }
    add(rate.stepwise.min);
    add(rate.stepwise.max);
    break;
  }
  if (formats.size() == before) formats.push_back(format);
}

void add_size(const V4l2Device& device, std::uint32_t fourcc, std::uint32_t width,
              std::uint32_t height, std::vector<CameraFormat>& formats) {
  if (width == 0 || height == 0 || width > 32768 || height > 32768) return;
  add_rates(device, {fourcc, static_cast<int>(width), static_cast<int>(height), 0, 0}, formats);
}

void add_stepwise(const V4l2Device& device, std::uint32_t fourcc,
                  const v4l2_frmsize_stepwise& range, std::vector<CameraFormat>& formats) {
  const auto fits = [](std::uint32_t value, std::uint32_t low, std::uint32_t high,
                       std::uint32_t step) {
    return value >= low && value <= high && (value - low) % std::max(step, 1U) == 0;
  };
  add_size(device, fourcc, range.min_width, range.min_height, formats);
  for (const auto& [width, height] : {std::pair{640U, 480U}, {1280U, 720U}, {1920U, 1080U}})
    if (fits(width, range.min_width, range.max_width, range.step_width) &&
        fits(height, range.min_height, range.max_height, range.step_height))
      add_size(device, fourcc, width, height, formats);
  add_size(device, fourcc, range.max_width, range.max_height, formats);
}

void add_sizes(const V4l2Device& device, std::uint32_t fourcc, std::vector<CameraFormat>& formats) {
  for (std::uint32_t i = 0; i < kMaxEntries; ++i) {
    auto size = cleared<v4l2_frmsizeenum>();
    size.index = i;
    size.pixel_format = fourcc;
    if (device.ioctl(VIDIOC_ENUM_FRAMESIZES, &size) != 0) return;
    if (size.type != V4L2_FRMSIZE_TYPE_DISCRETE)
      return add_stepwise(device, fourcc, size.stepwise, formats);
    add_size(device, fourcc, size.discrete.width, size.discrete.height, formats);
  }
}

bool meets(const CameraFormat& format, const FormatCriteria& criteria) {
  return can_decode(format.fourcc) &&
         (criteria.fourcc.empty() || fourcc_text(format.fourcc) == criteria.fourcc) &&
         (criteria.width_px == 0 || format.width_px == criteria.width_px) &&
         (criteria.height_px == 0 || format.height_px == criteria.height_px) &&
         (criteria.frames_per_second <= 0 ||
          std::abs(format.frames_per_second() - criteria.frames_per_second) < 0.05);
}

/// Ranks formats: grey, then colours, then compression.
int rank_of(std::uint32_t fourcc) {
  switch (static_cast<PixelFormat>(fourcc)) {
    case PixelFormat::kGrey:
      return 3;
    case PixelFormat::kY10:
    case PixelFormat::kY12:
    case PixelFormat::kY14:
    case PixelFormat::kY16:
      return 2;
    case PixelFormat::kMjpeg:
    case PixelFormat::kJpeg:
    case PixelFormat::kH264:
      return 0;
    default:
      return 1;
  }
}

/// Compression of differences to frames before hides small changes of brightness.
bool is_predicted(const CameraFormat& format) {
  return static_cast<PixelFormat>(format.fourcc) == PixelFormat::kH264;
}

Message listed(const std::vector<CameraFormat>& offered) {
  constexpr std::size_t kMaxListed = 12;
  std::vector<Message> formats;
  for (const CameraFormat& format : offered)
    if (formats.size() < kMaxListed) formats.push_back(format.text());
  const Message list = en::list(formats);
  if (offered.size() > kMaxListed) return en::say("{} and more", list);
  return list.empty() ? en::say("nothing") : list;
}

}  // namespace

Message CameraFormat::text() const {
  const std::string image_format =
      fmt::format("{}x{} {}", width_px, height_px, fourcc_text(fourcc));
  if (frames_per_second() <= 0) return Message::typed(image_format);
  const double rate = std::round(frames_per_second() * 100) / 100;
  return en::say("{} at {:g} frames per second", image_format, rate);
}

Result<CameraFormat> choose_format(const std::vector<CameraFormat>& offered,
                                   const FormatCriteria& criteria, const std::string& node) {
  const auto worth = [](const CameraFormat& format) {
    const double rate = format.frames_per_second();
    return std::tuple(!is_predicted(format), rate == 0 || rate > 24.5,
                      static_cast<std::int64_t>(format.width_px) * format.height_px, rate,
                      rank_of(format.fourcc));
  };
  const CameraFormat* best = nullptr;
  for (const CameraFormat& format : offered)
    if (meets(format, criteria) && (best == nullptr || worth(format) > worth(*best)))
      best = &format;
  if (best == nullptr)
    return Error{en::say("the camera has no such readable format; it offers {}", listed(offered)),
                 node, en::say("one of these in GREY, Y16, YUYV or MJPG")};
  return *best;
}

Error camera_error(const Message& doing, const std::string& node, int error_number) {
  return errno_error(doing, node, words_for(error_number), error_number);
}

bool is_gone_error(int error_number) {
  return error_number == ENODEV || error_number == ENXIO || error_number == ENOENT;
}

Result<V4l2Device> V4l2Device::open(V4l2Calls& calls, const std::string& node) {
  int descriptor = -1;
  do {
    descriptor = calls.open(node.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  } while (descriptor < 0 && errno == EINTR);
  if (descriptor < 0) return camera_error(en::say("the camera cannot be opened"), node, errno);
  return V4l2Device(calls, descriptor, node);
}

V4l2Device::~V4l2Device() {
  if (descriptor_ >= 0) calls_->close(descriptor_);
}

V4l2Device::V4l2Device(V4l2Device&& other) noexcept
    : calls_(other.calls_),
      descriptor_(std::exchange(other.descriptor_, -1)),
      node_(std::move(other.node_)) {}

int V4l2Device::ioctl(unsigned long request, void* argument) const {
  while (calls_->ioctl(descriptor_, request, argument) != 0)
    if (errno != EINTR) return errno;
  return 0;
}

Result<V4l2Device::Capability> V4l2Device::capability() const {
  auto answer = cleared<v4l2_capability>();
  if (const int error = ioctl(VIDIOC_QUERYCAP, &answer); error != 0)
    return camera_error(en::say("this does not answer like a camera"), node_, error);
  const std::uint32_t can =
      (answer.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? answer.device_caps : answer.capabilities;
  Capability capability{
      text_of(answer.driver), text_of(answer.card), text_of(answer.bus_info), false, false, false};
  const bool is_single = (can & V4L2_CAP_VIDEO_CAPTURE) != 0;
  capability.is_multi_planar = !is_single && (can & V4L2_CAP_VIDEO_CAPTURE_MPLANE) != 0;
  capability.is_capture = is_single || capability.is_multi_planar;
  capability.can_stream = (can & V4L2_CAP_STREAMING) != 0;
  return capability;
}

std::vector<CameraFormat> V4l2Device::formats() const {
  std::vector<CameraFormat> formats;
  for (std::uint32_t i = 0; i < kMaxEntries; ++i) {
    auto description = cleared<v4l2_fmtdesc>();
    description.index = i;
    description.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (ioctl(VIDIOC_ENUM_FMT, &description) != 0) break;
    add_sizes(*this, description.pixelformat, formats);
  }
  if (!formats.empty()) return formats;
  auto set = cleared<v4l2_format>();
  set.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (ioctl(VIDIOC_G_FMT, &set) == 0)
    add_size(*this, set.fmt.pix.pixelformat, set.fmt.pix.width, set.fmt.pix.height, formats);
  return formats;
}

Result<std::size_t> V4l2Device::configure(CameraFormat& format) const {
  auto request = cleared<v4l2_format>();
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  v4l2_pix_format& image_format = request.fmt.pix;
  image_format.width = static_cast<std::uint32_t>(format.width_px);
  image_format.height = static_cast<std::uint32_t>(format.height_px);
  image_format.pixelformat = format.fourcc;
  image_format.field = V4L2_FIELD_NONE;
  if (const int error = ioctl(VIDIOC_S_FMT, &request); error != 0)
    return camera_error(en::say("the camera's format cannot be set to {}", format.text()), node_,
                        error);
  const CameraFormat got{image_format.pixelformat, static_cast<int>(image_format.width),
                         static_cast<int>(image_format.height), format.seconds_numerator,
                         format.seconds_denominator};
  if (got != format)
    return Error{en::say("{} was requested, but the camera chose {}", format.text(), got.text()),
                 node_, en::say("a format that 'alltact devices --details' lists for it")};
  if (format.seconds_numerator == 0) return image_format.bytesperline;

  auto rate = cleared<v4l2_streamparm>();
  rate.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  v4l2_fract& seconds = rate.parm.capture.timeperframe;
  seconds = {format.seconds_numerator, format.seconds_denominator};
  const int error = ioctl(VIDIOC_S_PARM, &rate);
  if (error != 0 && error != ENOTTY && error != EINVAL)  // some drivers know no rates
    return camera_error(en::say("the camera's rate cannot be set"), node_, error);
  if (error == 0 && seconds.numerator != 0 && seconds.denominator != 0) {
    format.seconds_numerator = seconds.numerator;
    format.seconds_denominator = seconds.denominator;
  }
  return image_format.bytesperline;
}

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

namespace {

/// One buffer is being filled, one waits, two cover a reader that is delayed by two frames.
constexpr std::uint32_t kBuffers = 4;

v4l2_buffer capture_buffer(std::uint32_t index = 0) {
  v4l2_buffer buffer;
  std::memset(&buffer, 0, sizeof buffer);
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return buffer;
}

int request_buffers(const V4l2Device& device, std::uint32_t& count) {
  v4l2_requestbuffers request;
  std::memset(&request, 0, sizeof request);
  request.count = count;
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  const int error = device.ioctl(VIDIOC_REQBUFS, &request);
  count = request.count;
  return error;
}

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

std::int64_t time_of(const v4l2_buffer& buffer) {
  const bool is_monotonic =
      (buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) == V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
  constexpr std::int64_t kMaxSeconds = std::int64_t{1} << 33;  // larger values are invalid times
  const bool is_time = buffer.timestamp.tv_sec >= 0 && buffer.timestamp.tv_sec < kMaxSeconds &&
                       buffer.timestamp.tv_usec >= 0 && buffer.timestamp.tv_usec < 1'000'000;
  if (!is_monotonic || !is_time) return now_ns();
  return std::int64_t{buffer.timestamp.tv_sec} * 1'000'000'000 +
         std::int64_t{buffer.timestamp.tv_usec} * 1000;
}

}  // namespace

Result<std::unique_ptr<V4l2Stream>> V4l2Stream::start(const V4l2Device& device) {
  std::unique_ptr<V4l2Stream> stream(new V4l2Stream(device));
  if (const Status status = stream->map_buffers(); !status) return status.error();
  for (std::uint32_t i = 0; i < stream->buffers_.size(); ++i)
    if (const int error = stream->queue(i); error != 0)
      return camera_error(en::say("the camera accepts no buffer"), device.node(), error);
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (const int error = device.ioctl(VIDIOC_STREAMON, &type); error != 0)
    return camera_error(en::say("the camera does not start"), device.node(), error);
  return stream;
}

Status V4l2Stream::map_buffers() {
  std::uint32_t count = kBuffers;
  if (const int error = request_buffers(*device_, count); error != 0)
    return camera_error(en::say("the camera provides no buffers"), device_->node(), error);
  if (count < 2)
    return camera_error(en::say("the camera provides no buffers"), device_->node(), ENOMEM);
  for (std::uint32_t i = 0; i < count; ++i) {
    v4l2_buffer buffer = capture_buffer(i);
    if (const int error = device_->ioctl(VIDIOC_QUERYBUF, &buffer); error != 0)
      return camera_error(en::say("the camera's buffer cannot be found"), device_->node(), error);
    void* address = device_->calls().mmap(buffer.length, device_->descriptor(), buffer.m.offset);
    if (address == MAP_FAILED)
      return camera_error(en::say("the camera's buffer cannot be mapped"), device_->node(), errno);
    buffers_.emplace_back(static_cast<std::uint8_t*>(address), buffer.length);
  }
  return {};
}

V4l2Stream::~V4l2Stream() {
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  static_cast<void>(device_->ioctl(VIDIOC_STREAMOFF, &type));  // fails when the camera is gone
  for (const auto& buffer : buffers_) device_->calls().munmap(buffer.data(), buffer.size());
  std::uint32_t none = 0;
  static_cast<void>(request_buffers(*device_, none));
}

int V4l2Stream::queue(std::uint32_t index) {
  v4l2_buffer buffer = capture_buffer(index);
  return device_->ioctl(VIDIOC_QBUF, &buffer);
}

V4l2Stream::Taken V4l2Stream::take() {
  v4l2_buffer buffer = capture_buffer();
  const int error = device_->ioctl(VIDIOC_DQBUF, &buffer);
  if (error == EAGAIN) return {};
  if (error != 0) return {error, std::nullopt};
  if (buffer.index >= buffers_.size()) return {EIO, std::nullopt};
  const std::span<const std::uint8_t> buffer_bytes = buffers_[buffer.index];
  Filled filled;
  filled.index = buffer.index;
  filled.bytes = buffer_bytes.first(std::min<std::size_t>(buffer.bytesused, buffer_bytes.size()));
  filled.sequence = buffer.sequence;
  filled.time_ns = time_of(buffer);
  filled.is_damaged = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0;
  return {0, filled};
}

int V4l2Stream::requeue(const Filled& filled) { return queue(filled.index); }

}  // namespace alltact
