// From the camera to whoever looks: 1920x1080 MJPG at 30 frames a second from the fake camera.
#include "core/devices/v4l2_camera.h"
#include "tests/bench/full_hd_camera.h"

#include <benchmark/benchmark.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact {
namespace {

using test::FakeCamera;
using test::full_hd_camera;
using test::full_hd_packet;

/// The time from the camera's own time stamp until a waiting reader has the picture.
void BM_FrameToReader(benchmark::State& state) {
  FakeCamera fake(full_hd_camera(8));
  auto camera = V4l2Camera::open({&fake, "bench", [] { return std::string("/dev/video0"); }}, {});
  if (!camera) return state.SkipWithError(camera.error().sentence().c_str());
  LatestFrameReader reader = (*camera)->frames().reader();
  std::vector<double> ages_ms;
  for ([[maybe_unused]] const auto _ : state) {
    const FramePtr frame = reader.next(std::chrono::seconds(1));
    if (frame == nullptr) return state.SkipWithError("no frame arrived");
    const double age_ms = test::age_ms(*frame);
    ages_ms.push_back(age_ms);
    state.SetIterationTime(age_ms / 1000);
  }
  state.counters["median_ms"] = test::quantile(ages_ms, 0.5);
  state.counters["missed"] = static_cast<double>(reader.missed());
}

/// Of which this is the decoder...
void BM_DecodeJpeg(benchmark::State& state) {
  const auto bytes = full_hd_packet(0);
  GreyDecoder decoder;
  for ([[maybe_unused]] const auto _ : state)
    benchmark::DoNotOptimize(decoder(PixelFormat::kMjpeg, 1920, 1080, 0, bytes));
  state.counters["packet_bytes"] = static_cast<double>(bytes.size());
}

/// ...beside what OpenCV does with the same bytes.
void BM_DecodeJpegOpenCv(benchmark::State& state) {
  const auto bytes = full_hd_packet(0);
  for ([[maybe_unused]] const auto _ : state)
    benchmark::DoNotOptimize(cv::imdecode(bytes, cv::IMREAD_GRAYSCALE));
}

BENCHMARK(BM_FrameToReader)->UseManualTime()->Iterations(60)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DecodeJpeg)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DecodeJpegOpenCv)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alltact
