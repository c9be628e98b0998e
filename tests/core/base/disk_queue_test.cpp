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
      queue.add("file", [&done, i]() -> Status {
        done.push_back(i);
        return {};
      });
  }
  ASSERT_EQ(done.size(), 50U);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(DiskQueue, TellsWhatFailedUntilTheSameFileIsWritten) {
  DiskQueue queue;
  queue.wait();  // for nothing
  EXPECT_FALSE(queue.problem());
  queue.add("a", []() -> Status { return Error{en::say("the disk is full"), "", ""}; });
  queue.wait();
  ASSERT_TRUE(queue.problem());
  EXPECT_EQ(queue.problem()->what.english(), "the disk is full");
  queue.add("b", [] { return Status(); });
  queue.wait();
  EXPECT_TRUE(queue.problem()) << "another file was written";
  queue.add("a", [] { return Status(); });
  queue.wait();
  EXPECT_FALSE(queue.problem());
}

TEST(DiskQueue, WhatATaskThrowsIsItsFailure) {
  DiskQueue queue;
  queue.add("a", []() -> Status { throw std::bad_alloc(); });
  queue.add("b", []() -> Status { throw 7; });
  std::atomic<bool> is_done{false};
  queue.add("c", [&] {
    is_done = true;
    return Status();
  });
  queue.wait();
  EXPECT_TRUE(is_done);
  ASSERT_TRUE(queue.problem());
  EXPECT_EQ(queue.problem()->what.english(), "unexpected: exception");
  queue.add("b", [] { return Status(); });
  queue.wait();
  ASSERT_TRUE(queue.problem());
  EXPECT_EQ(queue.problem()->what.english(), "there is not enough memory");
  queue.clear_problem();
  EXPECT_FALSE(queue.problem());
}

}  // namespace
}  // namespace alltact
