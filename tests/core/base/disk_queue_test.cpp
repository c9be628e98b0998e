// Writes beside whoever asks for them: all done, in order, and what failed is told.
#include "core/base/slow_disk.h"

#include <atomic>
#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(DiskQueue, DoesEverythingInOrderBeforeItGoes) {
  std::vector<int> done;
  {
    DiskQueue queue;
    for (int i = 0; i < 50; ++i)
      queue.add([&done, i]() -> Status {
        done.push_back(i);
        return {};
      });
  }
  ASSERT_EQ(done.size(), 50U);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(DiskQueue, TellsWhatFailedUntilOneSucceeds) {
  DiskQueue queue;
  queue.wait();  // for nothing
  EXPECT_FALSE(queue.problem());
  queue.add([]() -> Status { return Error{en::say("the disk is full"), "", ""}; });
  queue.wait();
  ASSERT_TRUE(queue.problem());
  EXPECT_EQ(queue.problem()->what.english(), "the disk is full");
  queue.add([] { return Status(); });
  queue.wait();
  EXPECT_FALSE(queue.problem());
}

}  // namespace
}  // namespace alltact
