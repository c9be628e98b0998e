#include "core/sources/source.h"

#include <atomic>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace std::chrono_literals;

FramePtr frame(std::uint64_t sequence) {
  auto frame = std::make_shared<Frame>();
  frame->sequence = sequence;
  return frame;
}

TEST(FrameHub, ALateReaderSeesTheLatestFrameOnceAndKnowsWhatItMissed) {
  FrameHub hub;
  LatestFrameReader reader = hub.reader();
  EXPECT_EQ(reader.next(0ms), nullptr);
  for (std::uint64_t i = 0; i < 5; ++i) hub.publish(frame(i));
  const FramePtr seen = reader.next(0ms);
  ASSERT_NE(seen, nullptr);
  EXPECT_EQ(seen->sequence, 4U);
  EXPECT_EQ(seen, hub.latest()) << "shared, not copied";
  EXPECT_EQ(reader.missed(), 4U);
  EXPECT_EQ(reader.next(0ms), nullptr) << "not twice";
}

TEST(FrameHub, AQueueGivesEveryFrameInOrderAndCountsWhatFoundItFull) {
  FrameHub hub;
  hub.publish(frame(0));
  const auto queue = hub.subscribe(3);
  for (std::uint64_t i = 1; i <= 5; ++i) hub.publish(frame(i));
  for (std::uint64_t i = 1; i <= 3; ++i) EXPECT_EQ((**queue->next(0ms))->sequence, i);
  EXPECT_FALSE(queue->next(0ms).has_value());
  EXPECT_EQ(queue->dropped(), 2U);
  hub.publish(frame(6));
  EXPECT_EQ((**queue->next(0ms))->sequence, 6U);
}

TEST(FrameHub, FaultsStandWhereTheyHappenedAndDoNotPileUp) {
  FrameHub hub;
  const auto queue = hub.subscribe(1);
  hub.publish(frame(0));
  for (int i = 0; i < 1000; ++i) {
    hub.fault({en::say("first"), "", ""});
    hub.publish(frame(1));  // finds the queue full
    hub.fault({en::say("last"), "", ""});
  }
  EXPECT_EQ((**queue->next(0ms))->sequence, 0U);
  const auto fault = queue->next(0ms);
  ASSERT_TRUE(fault.has_value());
  ASSERT_FALSE(fault->ok());
  EXPECT_EQ(fault->error().what.english(), "last");
  EXPECT_FALSE(queue->next(0ms).has_value());
}

TEST(FrameHub, TheEndWakesEverybodyAfterWhatIsLeft) {
  auto hub = std::make_unique<FrameHub>();
  const auto queue = hub->subscribe(3);
  LatestFrameReader reader = hub->reader();
  hub->publish(frame(7));
  EXPECT_EQ(reader.next(0ms)->sequence, 7U);
  FramePtr woken = frame(1);
  std::thread waiting([&] { woken = reader.next(1h); });
  hub.reset();
  waiting.join();
  EXPECT_EQ(woken, nullptr);
  EXPECT_EQ((**queue->next(1h))->sequence, 7U);
  EXPECT_EQ(**queue->next(1h), nullptr);
}

TEST(FrameHub, AReaderIsWokenWithoutAFrameAndLosesNone) {
  FrameHub hub;
  LatestFrameReader reader = hub.reader();
  FramePtr woken = frame(1);
  std::thread waiting([&] { woken = reader.next(1h); });
  reader.wake();
  waiting.join();
  EXPECT_EQ(woken, nullptr);
  EXPECT_EQ(reader.next(0ms), nullptr) << "woken once";
  hub.publish(frame(5));
  reader.wake();
  ASSERT_NE(woken = reader.next(1h), nullptr);
  EXPECT_EQ(woken->sequence, 5U);
  EXPECT_EQ(reader.missed(), 0U);
}

TEST(FrameHub, ManyReadersAtOnceLoseNothingUncounted) {
  constexpr std::uint64_t kFrames = 3000;
  FrameHub hub;
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  const auto queue = hub.subscribe(kFrames);
  for (int i = 0; i < 3; ++i)
    threads.emplace_back([&wrong, reader = hub.reader()]() mutable {
      std::uint64_t seen = 0, last = 0;
      while (last + 1 < kFrames) {
        const FramePtr now = reader.next(10s);
        if (now == nullptr || (seen > 0 && now->sequence <= last)) return void(++wrong);
        last = now->sequence;
        ++seen;
      }
      if (seen + reader.missed() != kFrames) ++wrong;
    });
  threads.emplace_back([&] {
    for (std::uint64_t i = 0; i < kFrames; ++i)
      if ((**queue->next(10s))->sequence != i) ++wrong;
  });
  for (std::uint64_t i = 0; i < kFrames; ++i) hub.publish(frame(i));
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(queue->dropped(), 0U);
}

}  // namespace
}  // namespace alltact
