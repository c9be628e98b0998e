#include "core/io/disk_wait.h"

#include <mutex>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace std::chrono_literals;

TEST(DiskWait, IsToldOfOnceWhereItIsLong) {
  std::mutex mutex;
  std::vector<std::filesystem::path> told;
  {
    const DiskWatch watch(100ms, [&](const std::filesystem::path& file) {
      const std::lock_guard lock(mutex);
      told.push_back(file);
    });
    for (int i = 0; i < 100; ++i) const DiskWait is_short("/disk/short");
    const DiskWait is_long("/net/long");
    const DiskWait is_part_of_it("/net");
    std::this_thread::sleep_for(300ms);
    EXPECT_EQ(watch.slow(), std::vector<std::filesystem::path>{"/net/long"});
    const std::lock_guard lock(mutex);
    EXPECT_EQ(told, std::vector<std::filesystem::path>{"/net/long"});
  }
  const DiskWait unwatched("/net/other");
  EXPECT_EQ(told.size(), 1U);
}

}  // namespace
}  // namespace alltact
