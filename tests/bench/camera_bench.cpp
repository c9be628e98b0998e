// From the camera to whoever looks: 1920x1080 MJPG at 30 frames a second from the fake camera.
#include "core/sources/v4l2/v4l2_camera.h"
#include "tests/rigs/fake_camera.h"

#include <algorithm>
#include <cstring>

#include <benchmark/benchmark.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

using test::FakeCamera;
using test::FakeOptions;

/// A lit face with noise: 30 to 180 grey levels, as a finger's, colour sampled at half the columns.
std::vector<std::uint8_t> packet(int number) {
  cv::Mat grey(1080, 1920, CV_8UC1), noise(1080, 1920, CV_8UC1);
  for (int v = 0; v < grey.rows; ++v)
    for (int u = 0; u < grey.cols; ++u)
      grey.at<std::uint8_t>(v, u) =
          static_cast<std::uint8_t>(30 + 150 * (1920 - u) / 1920 * (540 - std::abs(v - 540)) / 540);
  for (int i = 0; i < 24; ++i)
    cv::circle(grey, {80 * i + 8 * number, i % 2 == 0 ? 200 : 880}, 9, cv::Scalar(220), -1);
  cv::RNG random(static_cast<std::uint64_t>(number) + 1);
  random.fill(noise, cv::RNG::NORMAL, 10, 1.2);
  grey += noise;
  cv::Mat colour;
  cv::cvtColor(grey, colour, cv::COLOR_GRAY2BGR);
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", colour, bytes, {cv::IMWRITE_JPEG_QUALITY, 85});
  return bytes;
}

FakeOptions full_size(int packets) {
  FakeOptions options;
  options.sizes = {{1920, 1080}};
  for (int i = 0; i < packets; ++i) options.packets.push_back(packet(i));
  return options;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(),
                   values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// The time from the camera's own time stamp until a waiting reader has the picture.
void BM_FrameToReader(benchmark::State& state) {
  FakeCamera fake(full_size(8));
  auto camera = V4l2Camera::open({&fake, "bench", [] { return std::string("/dev/video0"); }}, {});
  if (!camera) return state.SkipWithError(camera.error().sentence().c_str());
  LatestFrameReader reader = (*camera)->frames().reader();
  std::vector<double> ages_ms;
  for (auto _ : state) {
    const FramePtr frame = reader.next(std::chrono::seconds(1));
    if (frame == nullptr) return state.SkipWithError("no frame came");
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    const double age_ms =
        std::chrono::duration<double, std::milli>(now - std::chrono::nanoseconds(frame->time_ns))
            .count();
    ages_ms.push_back(age_ms);
    state.SetIterationTime(age_ms / 1000);
  }
  state.counters["median_ms"] = median(ages_ms);
  state.counters["missed"] = static_cast<double>(reader.missed());
}

/// Of which this is the decoder...
void BM_DecodeJpeg(benchmark::State& state) {
  const auto bytes = packet(0);
  GreyDecoder decoder;
  for (auto _ : state) benchmark::DoNotOptimize(decoder(PixelFormat::kMjpeg, 1920, 1080, 0, bytes));
  state.counters["packet_bytes"] = static_cast<double>(bytes.size());
}

/// ...beside what OpenCV does with the same bytes.
void BM_DecodeJpegOpenCv(benchmark::State& state) {
  const auto bytes = packet(0);
  for (auto _ : state) benchmark::DoNotOptimize(cv::imdecode(bytes, cv::IMREAD_GRAYSCALE));
}

BENCHMARK(BM_FrameToReader)->UseManualTime()->Iterations(60)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DecodeJpeg)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DecodeJpegOpenCv)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alltact
