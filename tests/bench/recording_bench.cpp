// What recording costs in real time: a camera that gives 1920x1080 MJPG at 30 frames a second for
// ALLTACT_RECORDING_SECONDS (default 2), read as any source and recorded. Every frame is compared
// afterwards. core_percent is the whole program's processor time: the camera's pictures, decoding
// and recording.
#include "core/devices/v4l2_camera.h"
#include "core/recording/recorder.h"
#include "core/recording/video_file.h"
#include "tests/bench/full_hd_camera.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>

#include <benchmark/benchmark.h>
#include <sys/resource.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr double kFramesPerS = 30;

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// What came out of recording so many frames.
struct Recorded {
  std::vector<double> ages_ms;  // of frames, when they were read
  double busy_s = 0, spent_s = 0;
  RecorderCounts counts;
  std::uint64_t lost = 0;  // on the way to the recorder
};

Result<Recorded> record(const fs::path& file, VideoCodec codec, test::FakeCamera& fake,
                        std::size_t count) {
  auto camera = V4l2Camera::open(
      {&fake, "bench", []() -> Result<std::string> { return std::string("/dev/video0"); }}, {});
  if (!camera) return camera.error();
  CameraSource source(std::move(*camera));
  RecorderSettings settings;
  settings.codec = codec;
  auto recorder = Recorder::start(file, settings, source.frames_per_s(), "bench");
  if (!recorder) return recorder.error();
  Recorded recorded;
  const double busy = processor_seconds();
  const auto begin = std::chrono::steady_clock::now();
  while (recorded.ages_ms.size() < count) {
    auto frame = source.next();
    if (!frame) return frame.error();
    recorded.ages_ms.push_back(test::age_ms(**frame));
    (*recorder)->add(std::move(*frame));
  }
  const Status finished = (*recorder)->finish("done");
  recorded.busy_s = processor_seconds() - busy;
  recorded.spent_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  recorded.counts = (*recorder)->counts();
  recorded.lost = source.dropped() + source.camera().status().lost;
  if (!finished) return finished.error();
  return recorded;
}

/// Every frame that the camera gave, one after the other, byte for byte.
bool is_exact(const fs::path& file, const std::vector<std::vector<std::uint8_t>>& packets,
              std::size_t count, bool is_jpeg) {
  auto video = VideoFile::open(file);
  if (!video || video->frame_count() != count) return false;
  std::vector<cv::Mat> images;
  for (const auto& packet : packets) images.push_back(cv::imdecode(packet, cv::IMREAD_GRAYSCALE));
  std::uint64_t first = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto frame = video->frame(i);
    if (!frame.ok()) return false;
    const std::uint64_t sequence = (*frame)->sequence;
    if (i == 0) first = sequence;
    const std::size_t which = sequence % packets.size();
    if (sequence != first + i || (is_jpeg && *(*frame)->jpeg != packets[which]) ||
        cv::norm((*frame)->grey, images[which], cv::NORM_INF) != 0)
      return false;
  }
  return true;
}

void record_full_hd(benchmark::State& state, VideoCodec codec) {
  const char* wanted = std::getenv("ALLTACT_RECORDING_SECONDS");
  const double seconds = wanted != nullptr ? std::atof(wanted) : 2;
  const auto count = static_cast<std::size_t>(seconds * kFramesPerS);
  const test::FakeOptions options = test::full_hd_camera(30);
  test::FakeCamera fake(options);
  for ([[maybe_unused]] const auto _ : state) {
    const test::TemporaryFolder folder;
    const fs::path video = folder / "bench.mkv";
    const auto recorded = record(video, codec, fake, count);
    if (!recorded) return state.SkipWithError(recorded.error().sentence().c_str());
    state.PauseTiming();
    if (recorded->lost > 0 || recorded->counts.dropped > 0 || recorded->counts.missing > 0 ||
        !is_exact(video, options.packets, count, codec == VideoCodec::kMjpeg))
      return state.SkipWithError("not every frame was recorded exactly and in order");
    state.counters["core_percent"] = 100 * recorded->busy_s / recorded->spent_s;
    state.counters["frames"] = static_cast<double>(recorded->counts.recorded);
    state.counters["MB_per_s"] = 1e-6 * static_cast<double>(recorded->counts.bytes) / seconds;
    state.counters["age_median_ms"] = test::quantile(recorded->ages_ms, 0.5);
    state.counters["age_p95_ms"] = test::quantile(recorded->ages_ms, 0.95);
    state.ResumeTiming();
  }
}

BENCHMARK_CAPTURE(record_full_hd, packets, VideoCodec::kMjpeg)->Iterations(1)->UseRealTime();
BENCHMARK_CAPTURE(record_full_hd, magicyuv, VideoCodec::kMagicYuv)->Iterations(1)->UseRealTime();

}  // namespace
}  // namespace alltact
