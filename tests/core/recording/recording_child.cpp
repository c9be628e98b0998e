// A program that records until it is killed: recording_child FILE CODEC FRAMES_PER_S COUNTER, where
// the file COUNTER holds a number that always says how many frames the camera has given.
#include "core/recording/recorder.h"
#include "tests/core/recording/recording_frames.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>

int main(int argc, char** argv) {
  using namespace alltact;
  if (argc != 5) return 2;
  RecorderSettings settings;
  for (const auto& setting : recorder_settings())
    if (setting.name == "codec" && !setting.set(settings, argv[2]).ok()) return 2;
  const double frames_per_s = std::stod(argv[3]);
  const int descriptor = ::open(argv[4], O_RDWR | O_CLOEXEC);
  void* shared =
      ::mmap(nullptr, sizeof(std::uint32_t), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  if (shared == MAP_FAILED) return 2;
  auto* given = static_cast<std::atomic<std::uint32_t>*>(shared);
  auto recorder = Recorder::start(argv[1], settings, frames_per_s, "test camera");
  if (!recorder) {
    fmt::print(stderr, "{}\n", recorder.error().sentence());
    return 1;
  }
  auto due = std::chrono::steady_clock::now();
  for (std::uint32_t number = 0;; ++number) {
    const FramePtr frame = test::camera_frame(number, settings.codec == VideoCodec::kMjpeg);
    std::this_thread::sleep_until(due);
    due += std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 / frames_per_s));
    given->store(number + 1);
    if (!(*recorder)->add(frame)) return 1;
  }
}
