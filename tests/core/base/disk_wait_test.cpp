#include "core/base/atomic_file.h"
#include "core/base/slow_disk.h"

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Paths = std::vector<std::filesystem::path>;

/// What a watch reports while it lives.
class Reports {
 public:
  explicit Reports(std::chrono::milliseconds timeout)
      : watch_(timeout, [this](const std::filesystem::path& file) {
          const std::lock_guard lock(mutex_);
          if (files_.empty()) first_ = Clock::now();
          files_.push_back(file);
        }) {}
  [[nodiscard]] Paths files() const {
    const std::lock_guard lock(mutex_);
    return files_;
  }
  [[nodiscard]] Clock::time_point first() const {
    const std::lock_guard lock(mutex_);
    return first_;
  }
  [[nodiscard]] Paths slow() const { return watch_.slow(); }

 private:
  mutable std::mutex mutex_;
  Paths files_;
  Clock::time_point first_;
  DiskWatch watch_;
};

void spin_until(Clock::time_point end) {
  while (Clock::now() < end) std::atomic_signal_fence(std::memory_order_seq_cst);
}

TEST(DiskWait, IsReportedOnceWhereItIsLong) {
  Paths files;
  {
    const Reports reports(100ms);
    for (int i = 0; i < 100; ++i) const DiskWait is_short("/disk/short");
    const DiskWait is_long("/net/long");
    const DiskWait is_part_of_it("/net");
    std::this_thread::sleep_for(400ms);
    EXPECT_EQ(reports.slow(), Paths{"/net/long"});
    files = reports.files();
    EXPECT_EQ(files, Paths{"/net/long"});
  }
  const DiskWait unwatched("/net/other");
  EXPECT_EQ(files.size(), 1U);
}

TEST(DiskWait, IsReportedOnceForADiskThatHoldsUpManyFiles) {
  const Reports reports(100ms);
  std::vector<std::thread> threads;
  for (int i = 0; i < 5; ++i)
    threads.emplace_back([i] {
      for (int again = 0; again < 2; ++again) {
        const DiskWait waiting("/net/file_" + std::to_string(i));
        std::this_thread::sleep_for(250ms);
      }
    });
  std::this_thread::sleep_for(200ms);
  EXPECT_EQ(reports.slow().size(), 5U);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(reports.files().size(), 1U);
  EXPECT_TRUE(reports.slow().empty());
}

/// Sixteen threads a processor, each of which works within its wait, as one that encodes a video.
TEST(DiskWait, IsNotReportedWhereItWaitsForABusyProcessor) {
  const Reports reports(100ms);
  const auto end = Clock::now() + 1500ms;
  std::atomic<std::size_t> slow{0};
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < 16 * std::max(1U, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back([end] {
      const DiskWait waiting("/disk/file");
      spin_until(end);
    });
  while (Clock::now() < end) {
    slow += reports.slow().size();
    std::this_thread::sleep_for(10ms);
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(slow, 0U);
  EXPECT_TRUE(reports.files().empty()) << reports.files().front();
}

/// The same load does not hide a disk that stalls.
TEST(DiskWait, IsReportedOnABusyProcessorToo) {
  constexpr auto kTimeout = 900ms;
  const Reports reports(kTimeout);
  std::atomic<bool> is_ending{false};
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < 2 * std::max(1U, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back([&is_ending] {
      const DiskWait waiting("/disk/file");
      while (!is_ending) spin_until(Clock::now() + 1ms);
    });
  const auto begin = Clock::now();
  {
    const DiskWait waiting("/net/file");
    std::this_thread::sleep_for(2 * kTimeout);
  }
  is_ending = true;
  for (std::thread& thread : threads) thread.join();
  ASSERT_EQ(reports.files(), Paths{"/net/file"});
  EXPECT_LT(reports.first() - begin, 5 * kTimeout / 3) << "3 s of timeout: within 5 s";
}

TEST(DiskWait, NamesTheFileThatAPersonKnows) {
  const Reports reports(50ms);
  const DiskWait waiting("/fingers/one/.change-17/.reference.4711-0.tmp.mkv");
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(reports.files(), Paths{"/fingers/one/reference.mkv"});
  EXPECT_EQ(final_path("/fingers/one/.change.list"), "/fingers/one");
  EXPECT_EQ(final_path("a/.hidden.tmp.txt"), "a/.hidden.tmp.txt");
  EXPECT_EQ(final_path("a/..tar.12-3.tmp"), "a/.tar");
}

}  // namespace
}  // namespace alltact
