// Live use for a while: several readers, a recorder that falls behind, faults. ALLTACT_SOAK_SECONDS
// makes it longer.
#include "core/sources/v4l2/v4l2_camera.h"
#include "tests/rigs/fake_camera.h"

#include <cstdlib>
#include <fstream>
#include <random>

#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

namespace alltact {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

/// Resident memory of this process.
double resident_mb() {
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

std::chrono::seconds duration() {
  const char* text = std::getenv("ALLTACT_SOAK_SECONDS");
  return std::chrono::seconds(text == nullptr ? 6 : std::atoi(text));
}

TEST(LiveUse, MemoryStaysFlat) {
  test::FakeOptions options;
  options.sizes = {{640, 480}};
  options.rates = {60};
  test::FakeCamera fake(options);
  auto camera = V4l2Camera::open({&fake,
                                  "soak",
                                  [&]() -> Result<std::string> {
                                    if (fake.is_plugged()) return std::string("/dev/video0");
                                    return Error{"the camera is not there", "soak", ""};
                                  }},
                                 {});
  ASSERT_TRUE(camera.ok());
  ASSERT_TRUE((*camera)->lock().ok());
  std::atomic<bool> is_over{false};
  std::atomic<std::uint64_t> seen{0};
  const auto look = [&](std::chrono::milliseconds work) {
    LatestFrameReader reader = (*camera)->frames().reader();
    while (!is_over) {
      if (reader.next(500ms) != nullptr) ++seen;
      std::this_thread::sleep_for(work);
    }
  };
  std::vector<std::thread> readers;
  readers.emplace_back(look, 0ms);
  readers.emplace_back(look, 170ms);
  const auto recorder = (*camera)->frames().subscribe(10);  // ten frames at most, mostly full
  std::mt19937 random(20240611);
  const auto use_for = [&](std::chrono::milliseconds time) {
    const auto end = Clock::now() + time;
    for (int step = 0; Clock::now() < end; ++step) {
      std::this_thread::sleep_for(25ms);
      static_cast<void>(recorder->next(0ms));
      if (step % 40 == 0) fake.truncate(1);
      if (step % 40 == 10)
        fake.set_from_outside(V4L2_CID_GAIN, 20 + static_cast<int>(random() % 50));
      if (step % 120 == 60) fake.unplug();
      if (step % 120 == 70) fake.plug_in();
    }
    fake.plug_in();
  };
  use_for(4s);
  const double before_mb = resident_mb();
  use_for(duration());
  const double growth_mb = resident_mb() - before_mb;
  is_over = true;
  for (std::thread& reader : readers) reader.join();
  const CameraStatus status = (*camera)->status();
  RecordProperty("growth_mb", std::to_string(growth_mb));
  // Sanitizers keep what was freed.
  if (!kIsSanitized) {
    EXPECT_LT(growth_mb, 5.0);
  }
  EXPECT_GT(seen, 100U);
  EXPECT_GT(recorder->dropped(), 0U) << "and it says so";
  EXPECT_GT(status.counts.damaged, 0U);
  EXPECT_GT(status.counts.unplugged, 0U);
  EXPECT_LE(status.remarks.size(), 20U);
}

}  // namespace
}  // namespace alltact
