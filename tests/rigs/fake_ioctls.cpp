// What the fake camera answers: formats, rates, input, controls.
#include "tests/rigs/fake_camera.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <linux/version.h>

namespace alltact::test {
namespace {

template <std::size_t N>
void write_text(std::uint8_t (&field)[N], const std::string& text) {
  std::memset(field, 0, N);
  std::memcpy(field, text.data(), std::min(text.size(), N - 1));
}

/// Of the first plane.
std::uint32_t bytes_per_pixel(std::uint32_t fourcc) {
  if (fourcc == V4L2_PIX_FMT_GREY || fourcc == V4L2_PIX_FMT_NV12) return 1;
  return fourcc == V4L2_PIX_FMT_RGB24 || fourcc == V4L2_PIX_FMT_BGR24 ? 3 : 2;
}

/// What a handle of lower priority may not do.
bool is_a_change(unsigned long request) {
  switch (request) {
    case VIDIOC_S_FMT:
    case VIDIOC_S_PARM:
    case VIDIOC_S_INPUT:
    case VIDIOC_S_CTRL:
    case VIDIOC_S_EXT_CTRLS:
    case VIDIOC_S_PRIORITY:
    case VIDIOC_REQBUFS:
    case VIDIOC_STREAMON:
    case VIDIOC_STREAMOFF:
      return true;
    default:
      return false;
  }
}

const char* description(std::uint32_t fourcc) {
  switch (fourcc) {
    case V4L2_PIX_FMT_MJPEG:
      return "Motion-JPEG";
    case V4L2_PIX_FMT_YUYV:
      return "YUYV 4:2:2";
    case V4L2_PIX_FMT_GREY:
      return "8-bit Greyscale";
    case V4L2_PIX_FMT_Y16:
      return "16-bit Greyscale";
    default:
      return "Other";
  }
}

}  // namespace

int FakeCamera::dispatch(Handle& handle, unsigned long request, void* argument) {
  std::uint32_t highest = V4L2_PRIORITY_UNSET;
  for (const auto& [descriptor, other] : handles_) highest = std::max(highest, other.priority);
  if (is_a_change(request) && handle.priority < highest) return EBUSY;
  switch (request) {
    case VIDIOC_QUERYCAP:
    case VIDIOC_ENUM_FMT:
    case VIDIOC_ENUM_FRAMESIZES:
    case VIDIOC_ENUM_FRAMEINTERVALS:
      return enumerate(request, argument);
    case VIDIOC_G_FMT:
    case VIDIOC_S_FMT:
    case VIDIOC_TRY_FMT:
      return format(request, argument, handle);
    case VIDIOC_G_PARM:
    case VIDIOC_S_PARM:
      return rate(request, argument);
    case VIDIOC_ENUMINPUT:
    case VIDIOC_G_INPUT:
    case VIDIOC_S_INPUT:
      return input(request, argument);
    case VIDIOC_G_PRIORITY:
      *static_cast<std::uint32_t*>(argument) = highest;
      return 0;
    case VIDIOC_S_PRIORITY:
      handle.priority = *static_cast<std::uint32_t*>(argument);
      return 0;
    case VIDIOC_DQEVENT:
      return next_event(handle, *static_cast<v4l2_event*>(argument));
    case VIDIOC_SUBSCRIBE_EVENT:
    case VIDIOC_UNSUBSCRIBE_EVENT:
      return subscribe(handle, request, *static_cast<v4l2_event_subscription*>(argument));
    case VIDIOC_REQBUFS:
      return request_buffers(handle, *static_cast<v4l2_requestbuffers*>(argument));
    case VIDIOC_QUERYBUF:
      return query_buffer(handle, *static_cast<v4l2_buffer*>(argument));
    case VIDIOC_QBUF:
      return queue_buffer(handle, *static_cast<v4l2_buffer*>(argument));
    case VIDIOC_DQBUF:
      return take_buffer(handle, *static_cast<v4l2_buffer*>(argument));
    case VIDIOC_STREAMON:
    case VIDIOC_STREAMOFF:
      return stream(handle, request == VIDIOC_STREAMON, *static_cast<int*>(argument));
    default:
      return controls(handle, request, argument);
  }
}

int FakeCamera::controls(Handle& handle, unsigned long request, void* argument) {
  auto& all = *static_cast<v4l2_ext_controls*>(argument);
  std::vector<std::uint32_t> changed;
  int error = ENOTTY;
  switch (request) {
    case VIDIOC_QUERY_EXT_CTRL:
      return controls_.query(*static_cast<v4l2_query_ext_ctrl*>(argument));
    case VIDIOC_QUERYCTRL:
      return controls_.query(*static_cast<v4l2_queryctrl*>(argument));
    case VIDIOC_QUERYMENU:
      return controls_.query(*static_cast<v4l2_querymenu*>(argument));
    case VIDIOC_G_EXT_CTRLS:
      return controls_.get(all);
    case VIDIOC_TRY_EXT_CTRLS:
    case VIDIOC_S_EXT_CTRLS:
      error = controls_.set(all, request == VIDIOC_TRY_EXT_CTRLS, changed);
      break;
    case VIDIOC_G_CTRL:
    case VIDIOC_S_CTRL: {
      auto& old = *static_cast<v4l2_control*>(argument);
      v4l2_ext_control one{};
      one.id = old.id;
      one.value = old.value;
      v4l2_ext_controls wrapped{};
      wrapped.count = 1;
      wrapped.controls = &one;
      error = request == VIDIOC_G_CTRL ? controls_.get(wrapped)
                                       : controls_.set(wrapped, false, changed);
      if (error == 0) old.value = one.value;
      break;
    }
    default:
      return ENOTTY;
  }
  for (const std::uint32_t id : changed) tell(id, &handle);
  return error;
}

int FakeCamera::enumerate(unsigned long request, void* argument) {
  if (request == VIDIOC_QUERYCAP) {
    auto& answer = *static_cast<v4l2_capability*>(argument);
    std::memset(&answer, 0, sizeof answer);
    write_text(answer.driver, "fake");
    write_text(answer.card, "Fake Camera");
    write_text(answer.bus_info, "usb-0000:00:14.0-2");
    answer.version = LINUX_VERSION_CODE;
    const std::uint32_t capture =
        options_.is_multi_planar ? V4L2_CAP_VIDEO_CAPTURE_MPLANE : V4L2_CAP_VIDEO_CAPTURE;
    answer.device_caps = V4L2_CAP_STREAMING | V4L2_CAP_EXT_PIX_FORMAT |
                         (options_.is_metadata ? V4L2_CAP_META_CAPTURE : capture);
    // As a UVC camera: what all its nodes can do together.
    answer.capabilities = answer.device_caps | V4L2_CAP_DEVICE_CAPS | capture;
    if (options_.is_metadata) answer.capabilities |= V4L2_CAP_META_CAPTURE;
    return 0;
  }
  if (request == VIDIOC_ENUM_FMT) {
    auto& answer = *static_cast<v4l2_fmtdesc*>(argument);
    if (answer.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || options_.is_multi_planar ||
        answer.index >= options_.fourccs.size())
      return EINVAL;
    const std::uint32_t index = answer.index;
    std::memset(&answer, 0, sizeof answer);
    answer.index = index;
    answer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    answer.pixelformat = options_.fourccs[index];
    const bool is_jpeg = answer.pixelformat == V4L2_PIX_FMT_MJPEG;
    if (is_jpeg) answer.flags = V4L2_FMT_FLAG_COMPRESSED;
    write_text(answer.description, description(answer.pixelformat));
    return 0;
  }
  const auto knows = [&](std::uint32_t fourcc) {
    return std::find(options_.fourccs.begin(), options_.fourccs.end(), fourcc) !=
           options_.fourccs.end();
  };
  if (request == VIDIOC_ENUM_FRAMESIZES) {
    auto& answer = *static_cast<v4l2_frmsizeenum*>(argument);
    if (!knows(answer.pixel_format) || answer.index >= options_.sizes.size()) return EINVAL;
    answer.type = V4L2_FRMSIZE_TYPE_DISCRETE;
    std::tie(answer.discrete.width, answer.discrete.height) = options_.sizes[answer.index];
    std::memset(answer.reserved, 0, sizeof answer.reserved);
    return 0;
  }
  auto& answer = *static_cast<v4l2_frmivalenum*>(argument);
  const auto size = std::find(options_.sizes.begin(), options_.sizes.end(),
                              std::pair(answer.width, answer.height));
  if (!knows(answer.pixel_format) || size == options_.sizes.end() ||
      answer.index >= options_.rates.size())
    return EINVAL;
  answer.type = V4L2_FRMIVAL_TYPE_DISCRETE;
  answer.discrete = {1, options_.rates[answer.index]};
  std::memset(answer.reserved, 0, sizeof answer.reserved);
  return 0;
}

/// The nearest that the camera has.
void FakeCamera::adjust(v4l2_pix_format& image) const {
  const auto wish = std::pair(image.width, image.height);
  const auto& fourccs = options_.fourccs;
  if (std::find(fourccs.begin(), fourccs.end(), image.pixelformat) == fourccs.end())
    image.pixelformat = fourccs.front();
  const auto distance = [&](const std::pair<std::uint32_t, std::uint32_t>& size) {
    return std::abs(std::int64_t{size.first} - std::int64_t{wish.first}) +
           std::abs(std::int64_t{size.second} - std::int64_t{wish.second});
  };
  const auto nearest =
      std::min_element(options_.sizes.begin(), options_.sizes.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  std::tie(image.width, image.height) = *nearest;
  if (is_refusing_size_) image.width = 160, image.height = 120;
  const bool is_jpeg = image.pixelformat == V4L2_PIX_FMT_MJPEG;
  const std::uint32_t pixel_bytes = bytes_per_pixel(image.pixelformat);
  image.field = V4L2_FIELD_NONE;
  image.bytesperline = is_compressed(image.pixelformat) ? 0 : image.width * pixel_bytes;
  image.sizeimage = image.width * image.height * std::max(2U, pixel_bytes);
  image.colorspace = is_jpeg ? V4L2_COLORSPACE_JPEG : V4L2_COLORSPACE_SRGB;
  image.priv = V4L2_PIX_FMT_PRIV_MAGIC;
  image.flags = 0;
  image.ycbcr_enc = V4L2_YCBCR_ENC_DEFAULT;
  image.quantization = V4L2_QUANTIZATION_DEFAULT;
  image.xfer_func = V4L2_XFER_FUNC_DEFAULT;
}

int FakeCamera::format(unsigned long request, void* argument, const Handle& handle) {
  auto& answer = *static_cast<v4l2_format*>(argument);
  if (answer.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || options_.is_metadata ||
      options_.is_multi_planar)
    return EINVAL;
  if (request == VIDIOC_G_FMT) {
    std::memset(&answer.fmt, 0, sizeof answer.fmt);
    answer.fmt.pix = picture_;
    return 0;
  }
  adjust(answer.fmt.pix);
  if (request == VIDIOC_TRY_FMT) return 0;
  if (owner_ != nullptr && (owner_ != &handle || !buffers_.empty())) return EBUSY;
  picture_ = answer.fmt.pix;
  return 0;
}

int FakeCamera::rate(unsigned long request, void* argument) {
  auto& answer = *static_cast<v4l2_streamparm*>(argument);
  if (answer.type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return EINVAL;
  if (request == VIDIOC_S_PARM) {
    const v4l2_fract wish = answer.parm.capture.timeperframe;
    const double per_second =
        wish.numerator == 0 ? 0 : static_cast<double>(wish.denominator) / wish.numerator;
    const auto nearest = std::min_element(
        options_.rates.begin(), options_.rates.end(), [&](std::uint32_t a, std::uint32_t b) {
          return std::abs(a - per_second) < std::abs(b - per_second);
        });
    seconds_ = {1, per_second > 0 ? *nearest : options_.rates.front()};
  }
  std::memset(&answer.parm, 0, sizeof answer.parm);
  answer.parm.capture.capability = V4L2_CAP_TIMEPERFRAME;
  answer.parm.capture.timeperframe = seconds_;
  return 0;
}

int FakeCamera::input(unsigned long request, void* argument) {
  if (request == VIDIOC_G_INPUT) return *static_cast<int*>(argument) = 0;
  if (request == VIDIOC_S_INPUT) return *static_cast<int*>(argument) == 0 ? 0 : EINVAL;
  auto& answer = *static_cast<v4l2_input*>(argument);
  if (answer.index != 0) return EINVAL;
  std::memset(&answer, 0, sizeof answer);
  write_text(answer.name, "Camera 1");
  answer.type = V4L2_INPUT_TYPE_CAMERA;
  return 0;
}

}  // namespace alltact::test
