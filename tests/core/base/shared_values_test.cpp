#include "core/base/cache.h"

#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using Value = std::shared_ptr<const int>;
const Error kStopped{en::say("stopped"), "", ""};

auto maker(std::atomic<int>& made, int value) {
  return [&made, value]() -> Result<Value> {
    ++made;
    return std::make_shared<const int>(value);
  };
}

TEST(SharedValues, OneValueForAllWhoHoldIt) {
  SharedValues<int> values;
  std::atomic<int> made = 0;
  auto first = values.get("a", Job(), kStopped, maker(made, 1));
  auto second = values.get("a", Job(), kStopped, maker(made, 2));
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->get(), second->get());
  EXPECT_EQ(**values.get("b", Job(), kStopped, maker(made, 3)), 3);
  EXPECT_EQ(made, 2);
  first->reset();
  second->reset();
  EXPECT_EQ(**values.get("a", Job(), kStopped, maker(made, 4)), 4) << "nobody held it any longer";
}

TEST(SharedValues, ManyThreadsMakeItOnce) {
  SharedValues<int> values;
  std::atomic<int> made = 0;
  std::vector<Value> got(8);
  std::vector<std::thread> threads;
  for (Value& mine : got)
    threads.emplace_back([&] {
      mine = values
                 .get("a", Job(), kStopped,
                      [&]() -> Result<Value> {
                        std::this_thread::sleep_for(std::chrono::milliseconds(30));
                        ++made;
                        return std::make_shared<const int>(5);
                      })
                 .value();
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(made, 1);
  for (const Value& mine : got) EXPECT_EQ(mine.get(), got[0].get());
}

TEST(SharedValues, WhoWaitedForOneThatFailedMakesIt) {
  SharedValues<int> values;
  std::atomic<bool> has_begun = false;
  std::atomic<int> made = 0;
  std::thread failing([&] {
    EXPECT_FALSE(values.get("a", Job(), kStopped, [&]() -> Result<Value> {
      has_begun = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      return kStopped;
    }));
  });
  while (!has_begun) std::this_thread::yield();
  const auto mine = values.get("a", Job(), kStopped, maker(made, 6));
  failing.join();
  ASSERT_TRUE(mine);
  EXPECT_EQ(**mine, 6);
}

TEST(SharedValues, WhoIsAskedToStopDoesNotWait) {
  SharedValues<int> values;
  std::atomic<bool> has_begun = false, may_end = false;
  std::atomic<int> made = 0;
  std::thread slow([&] {
    EXPECT_TRUE(values.get("a", Job(), kStopped, [&]() -> Result<Value> {
      has_begun = true;
      while (!may_end) std::this_thread::yield();
      return std::make_shared<const int>(7);
    }));
  });
  while (!has_begun) std::this_thread::yield();
  Job job;
  job.request_stop();
  const auto mine = values.get("a", job, kStopped, maker(made, 8));
  EXPECT_FALSE(mine);
  EXPECT_EQ(made, 0);
  may_end = true;
  slow.join();
}

}  // namespace
}  // namespace alltact::test
