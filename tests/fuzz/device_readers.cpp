// Readers of what devices say: HID reports, cameras' answers and packets, descriptions of both.
#include "core/devices/camera_controls.h"
#include "core/devices/hid_button.h"
#include "core/devices/led_dimmer.h"
#include "core/devices/open_gauge.h"
#include "core/devices/v4l2_device.h"
#include "core/image/grey_decoder.h"
#include "tests/core/recording/recording_frames.h"
#include "tests/fuzz/readers.h"
#include "tests/rigs/fake_camera.h"

#include <cerrno>
#include <cstring>

#include <linux/videodev2.h>
#include <sys/mman.h>

namespace alltact::test {
namespace {

using Report = std::vector<std::uint8_t>;

/// Bytes that are used up one after the other; zeros behind the last.
class Supply {
 public:
  explicit Supply(std::string_view bytes) : rest_(bytes) {}
  [[nodiscard]] bool is_empty() const { return rest_.empty(); }
  std::uint8_t byte() {
    std::uint8_t value = 0;
    fill(&value, 1);
    return value;
  }
  void fill(void* to, std::size_t size) {
    const std::size_t there = std::min(size, rest_.size());
    if (size > 0) std::memset(to, 0, size);
    if (there > 0) std::memcpy(to, rest_.data(), there);
    rest_.remove_prefix(there);
  }
  /// Its length stands in its first byte.
  Report report() {
    Report report(byte() % 65);
    fill(report.data(), report.size());
    return report;
  }

 private:
  std::string_view rest_;
};

std::string as_reports(const std::vector<Report>& reports) {
  std::string bytes;
  for (const Report& report : reports) {
    bytes += static_cast<char>(report.size());
    bytes.append(report.begin(), report.end());
  }
  return bytes;
}

/// A button is learnt, or not, from any reports; what was learnt comes back from its text.
Reading learn_from_reports(const std::string& bytes) {
  Supply supply(bytes);
  ButtonLearner learner;
  for (int i = 0; !supply.is_empty(); ++i) {
    if (i == 2) learner.begin();
    learner.feed(supply.report());
  }
  const auto& pattern = learner.pattern();
  if (!pattern) return {};
  const auto back = ButtonPattern::parse(pattern->text());
  if (!back || *back != *pattern) return {std::nullopt, "not as told: " + pattern->text()};
  (void)pattern->is_pressed(Report(pattern->report_bytes));
  (void)pattern->is_pressed({});
  return {};
}

/// Of a gauge with two values, one a broken number.
Reading read_gauge_reports(const std::string& bytes) {
  static const GaugeReport layout =
      *GaugeReport::parse("id=3 at=1 type=s24be scale=0.01 unit=N at=5 type=f32");
  Supply supply(bytes);
  while (!supply.is_empty()) {
    const GaugeLine line = layout.read(supply.report());
    for (int i = 0; i < line.count; ++i)
      if (!std::isfinite(line.force_N.at(static_cast<std::size_t>(i))))
        return {std::nullopt, "a force that is no number"};
  }
  return {};
}

/// Reads and answers from the supply, and takes everything.
class SuppliedPort : public HidPort {
 public:
  explicit SuppliedPort(Supply& supply) : supply_(supply) {}
  Result<Report> read(int) override { return supply_.report(); }
  Status write(std::span<const std::uint8_t>) override { return {}; }
  Status send_feature(std::span<const std::uint8_t>) override { return {}; }

 private:
  Supply& supply_;
};

Reading drive_dimmer(const std::string& bytes) {
  Supply supply(bytes);
  auto dimmer =
      LedDimmer::create(std::make_unique<SuppliedPort>(supply), "04d8:00dd", "mcp2221a gp2");
  if (!dimmer) return {dimmer.error()};
  const Status set = dimmer->set(0.5);
  return set ? Reading() : Reading{set.error()};
}

Reading read_descriptions(const std::string& bytes) {
  if (const auto button = LearntButton::parse(bytes);
      button && LearntButton::parse(button->text())->pattern != button->pattern)
    return {std::nullopt, "another button comes back"};
  if (const auto report = DimmerReport::parse(bytes);
      report && *DimmerReport::parse(report->text()) != *report)
    return {std::nullopt, "another dimmer comes back"};
  const bool is_taken = LearntButton::parse(bytes).ok() || DimmerReport::parse(bytes).ok() ||
                        GaugeDirections::parse(bytes).ok() ||
                        GaugeReport::parse_table(bytes, "gauge.csv").ok();
  if (is_taken) return {};
  return reading_of(GaugeReport::parse(bytes), kNoLaw);
}

/// Format, size and row length in the first five bytes, the packet behind.
Reading decode_packet(const std::string& bytes) {
  static constexpr std::array kFormats{
      PixelFormat::kGrey,  PixelFormat::kYuyv,  PixelFormat::kY16,
      PixelFormat::kMjpeg, PixelFormat::kUyvy,  PixelFormat::kNv12,
      PixelFormat::kY10,   PixelFormat::kRgb24, PixelFormat::kH264};
  Supply supply(bytes);
  const PixelFormat format = kFormats.at(supply.byte() % kFormats.size());
  const int width = 1 + supply.byte() % 64, height = 1 + supply.byte() % 48;
  const std::size_t stride = supply.byte() + 256U * (supply.byte() % 2);
  static GreyDecoder decoder;
  const auto* packet = reinterpret_cast<const std::uint8_t*>(bytes.data());
  const std::size_t head = std::min<std::size_t>(5, bytes.size());
  return reading_of(decoder(format, width, height, stride, {packet + head, bytes.size() - head}),
                    [&](const cv::Mat& grey) {
                      // A predicted image may have to wait.
                      const bool is_waiting = format == PixelFormat::kH264 && grey.empty();
                      return is_waiting || grey.size() == cv::Size(width, height) ? ""
                                                                                  : "another size";
                    });
}

std::vector<std::string> packet_seeds() {
  const auto jpeg = jpeg_of(camera_picture(1, {64, 48}));
  std::vector<std::string> seeds{std::string("\x03\x3f\x2f\0\0", 5) +
                                 std::string(jpeg.begin(), jpeg.end())};
  for (const char format : {'\0', '\1', '\2'})
    seeds.push_back(std::string{format, '\x07', '\x05', '\0', '\0'} + std::string(16 * 6, 'x'));
  return seeds;
}

/// A camera that answers every question with whatever comes next: an error number, then the bytes
/// of the answer over those of the question.
class SuppliedCamera : public V4l2Calls {
 public:
  explicit SuppliedCamera(Supply& supply) : supply_(supply) {}
  int open(const char*, int) override { return 1000; }
  int close(int) override { return 0; }
  int ioctl(int, unsigned long request, void* argument) override {
    if (supply_.is_empty()) return errno = EINVAL, -1;
    if (const int error = supply_.byte(); error != 0 && error != EINTR) return errno = error, -1;
    if ((_IOC_DIR(request) & _IOC_READ) == 0) return 0;
    if (request == VIDIOC_G_EXT_CTRLS || request == VIDIOC_S_EXT_CTRLS) {
      auto* all = static_cast<v4l2_ext_controls*>(argument);
      supply_.fill(&all->controls->value64, sizeof all->controls->value64);
    } else if (supply_.byte() % 4 != 0) {  // else as it was asked
      supply_.fill(argument, _IOC_SIZE(request));
    }
    return 0;
  }
  void* mmap(std::size_t length, int, std::int64_t) override {
    constexpr std::size_t kMost = 1 << 16;
    if (length == 0 || length > kMost || maps_ == 40) return errno = ENOMEM, MAP_FAILED;
    ++maps_;
    return ::mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  }
  int munmap(void* address, std::size_t length) override {
    --maps_;
    return ::munmap(address, length);
  }
  int poll(pollfd*, nfds_t, int) override { return 0; }
  [[nodiscard]] int maps() const { return maps_; }

 private:
  Supply& supply_;
  int maps_ = 0;
};

/// What a program does with a camera from opening it to its third frame.
Reading use_camera(const V4l2Device& device) {
  if (const auto capability = device.capability(); !capability) return {capability.error()};
  const auto controls = list_controls(device);
  std::vector<Message> problems;
  (void)lock_brightness(device, problems);
  (void)restore_controls(device, settings_of(controls));
  watch_changes(device, controls);
  for (int i = 0; i < 3; ++i) (void)next_change(device);
  auto format = choose_format(device.formats(), {}, device.node());
  if (!format) return {format.error()};
  const auto stride = device.configure(*format);
  if (!stride) return {stride.error()};
  auto stream = V4l2Stream::start(device);
  if (!stream) return {stream.error()};
  GreyDecoder decoder;
  for (int i = 0; i < 3; ++i) {
    const auto taken = (*stream)->take();
    if (!taken.filled) continue;
    if (format->width_px <= 4096 && format->height_px <= 4096) {
      const auto grey = decoder(static_cast<PixelFormat>(format->fourcc), format->width_px,
                                format->height_px, *stride, taken.filled->bytes);
      if (grey && grey->empty()) return {std::nullopt, "a frame without pixels"};
    }
    (void)(*stream)->requeue(*taken.filled);
  }
  return {};
}

Reading ask_camera(const std::string& bytes) {
  Supply supply(bytes);
  SuppliedCamera camera(supply);
  Reading reading;
  {
    const auto device = V4l2Device::open(camera, "/dev/video0");
    reading = use_camera(*device);
  }
  if (camera.maps() != 0) reading.broken = "buffers that are not given back";
  return reading;
}

/// Writes down what a made-up camera answers, as SuppliedCamera reads it.
class NotedCamera : public FakeCamera {
 public:
  using FakeCamera::FakeCamera;
  int ioctl(int descriptor, unsigned long request, void* argument) override {
    if (request == VIDIOC_DQBUF) produce(1);
    const int result = FakeCamera::ioctl(descriptor, request, argument);
    const int error = errno;
    notes_ += static_cast<char>(result == 0 ? 0 : error);
    if (result != 0) return errno = error, result;
    if ((_IOC_DIR(request) & _IOC_READ) == 0) return 0;
    if (request == VIDIOC_G_EXT_CTRLS || request == VIDIOC_S_EXT_CTRLS) {
      note(&static_cast<v4l2_ext_controls*>(argument)->controls->value64, sizeof(std::int64_t));
    } else {
      notes_ += '\1';
      note(argument, _IOC_SIZE(request));
    }
    return 0;
  }
  [[nodiscard]] const std::string& notes() const { return notes_; }

 private:
  void note(const void* bytes, std::size_t size) {
    notes_.append(static_cast<const char*>(bytes), size);
  }
  std::string notes_;
};

std::vector<std::string> camera_seeds() {
  std::vector<std::string> seeds;
  for (const std::uint32_t fourcc : {V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_GREY, V4L2_PIX_FMT_YUYV}) {
    FakeOptions options;
    options.fourccs = {fourcc};
    options.sizes = {{64, 48}};
    options.is_live = false;
    NotedCamera camera(options);
    (void)use_camera(*V4l2Device::open(camera, options.node));
    seeds.push_back(camera.notes());
  }
  return seeds;
}

}  // namespace

std::vector<Reader> device_readers() {
  const auto pedal = [] {
    const Report rest{1, 0, 0, 7}, held{1, 0, 5, 7};
    return std::vector{as_reports({rest, rest, held, rest, held, rest})};
  };
  return {
      {"hid_button", pedal, learn_from_reports},
      {"hid_gauge",
       [] {
         return std::vector{as_reports({{3, 9, 0, 1, 2, 0, 0, 0x80, 0x3f}, {4, 1}})};
       },
       read_gauge_reports},
      {"hid_dimmer",
       [] {
         Report state(64), done(64);
         state[0] = 0x61, done[0] = 0x60;
         return std::vector{as_reports({state, done, done})};
       },
       drive_dimmer},
      {"hid_words",
       [] {
         return std::vector<std::string>{
             "0c45:7403/0 4 2:05=05,3:01=01", "output id=0 bytes=8 at=1 range=0..255",
             "id=3 at=1 type=s16be scale=0.01 unit=N at=3",
             "at,type,scale,zero,unit,id\n1,s16,0.01,0,N,3\n", "y/-x/0.6,0.8,0"};
       },
       read_descriptions},
      {"camera_packet", packet_seeds, decode_packet},
      {"camera_answers", camera_seeds, ask_camera},
  };
}

}  // namespace alltact::test
