// What recording full HD at 30 frames a second costs, in real time: a camera that gives 1920 x 1080
// pictures when they are due, for ALLTACT_RECORDING_SECONDS (default 2). Every frame is compared
// afterwards. core_percent is the whole program's processor time, the camera's waiting included.
#include "core/recording/recorder.h"
#include "core/recording/video_file.h"
#include "tests/core/recording/recording_frames.h"

#include <chrono>
#include <filesystem>
#include <thread>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

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

/// The camera's pictures, made beforehand and given over and over.
std::vector<FramePtr> camera_pictures(bool is_jpeg) {
  std::vector<FramePtr> pictures;
  for (std::uint32_t i = 0; i < 30; ++i)
    pictures.push_back(test::camera_frame(i, is_jpeg, {1920, 1080}));
  return pictures;
}

/// The first frame that is not what the camera gave; nothing when all are.
std::optional<std::size_t> first_wrong(VideoFile& video, const std::vector<FramePtr>& pictures) {
  for (std::size_t i = 0; i < video.frame_count(); ++i) {
    const auto frame = video.frame(i);
    const Frame& truth = *pictures[i % pictures.size()];
    if (!frame.ok() || (*frame)->sequence != i) return i;
    if (truth.jpeg ? *(*frame)->jpeg != *truth.jpeg
                   : cv::norm((*frame)->grey, truth.grey, cv::NORM_INF) != 0)
      return i;
  }
  return std::nullopt;
}

void record_full_hd(benchmark::State& state, VideoCodec codec) {
  const char* wanted = std::getenv("ALLTACT_RECORDING_SECONDS");
  const double seconds = wanted != nullptr ? std::atof(wanted) : 2;
  const auto count = static_cast<std::uint32_t>(seconds * kFramesPerS);
  const auto pictures = camera_pictures(codec == VideoCodec::kMjpeg);
  const fs::path file = fs::temp_directory_path() / fmt::format("alltact-bench-{}.mkv", ::getpid());
  RecorderSettings settings;
  settings.codec = codec;
  double busy = 0, spent = 0;
  RecorderCounts counts;
  for (auto _ : state) {
    auto recorder = Recorder::start(file, settings, kFramesPerS, "bench");
    if (!recorder) return state.SkipWithError(recorder.error().sentence().c_str());
    const double before = processor_seconds();
    const auto begin = std::chrono::steady_clock::now();
    for (std::uint32_t i = 0; i < count; ++i) {
      auto frame = std::make_shared<Frame>(*pictures[i % pictures.size()]);
      frame->sequence = i;
      frame->time_ns = test::kPeriodNs * (i + 1);
      std::this_thread::sleep_until(begin + std::chrono::nanoseconds(test::kPeriodNs * i));
      (*recorder)->add(std::move(frame));
    }
    const Status status = (*recorder)->finish("done");
    busy += processor_seconds() - before;
    spent += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    counts = (*recorder)->counts();
    if (!status) return state.SkipWithError(status.error().sentence().c_str());
    state.PauseTiming();
    auto video = VideoFile::open(file);
    if (!video || video->frame_count() != count || first_wrong(*video, pictures))
      state.SkipWithError("not every frame was recorded exactly and in order");
    fs::remove(file);
    fs::remove(fs::path(file).replace_extension(".frames.csv"));
    state.ResumeTiming();
  }
  state.counters["core_percent"] = 100 * busy / spent;
  state.counters["frames"] = static_cast<double>(counts.recorded);
  state.counters["dropped"] = static_cast<double>(counts.dropped);
  state.counters["MB_per_s"] = 1e-6 * static_cast<double>(counts.bytes) / seconds;
}

BENCHMARK_CAPTURE(record_full_hd, packets, VideoCodec::kMjpeg)->Iterations(1)->UseRealTime();
BENCHMARK_CAPTURE(record_full_hd, magicyuv, VideoCodec::kMagicYuv)->Iterations(1)->UseRealTime();

}  // namespace
}  // namespace alltact
