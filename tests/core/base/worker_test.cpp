#include "core/base/worker.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace alltact::test {
namespace {

using std::chrono::milliseconds;

/// Receives what threads report while it lives.
class Reports {
 public:
  Reports() {
    set_unexpected_receiver([this](const Error& error) { sentences_.push_back(error.sentence()); });
  }
  ~Reports() { set_unexpected_receiver(nullptr); }
  Reports(const Reports&) = delete;
  Reports& operator=(const Reports&) = delete;
  [[nodiscard]] const std::vector<std::string>& sentences() const { return sentences_; }

 private:
  std::vector<std::string> sentences_;  // one report at a time; read after join()
};

TEST(Worker, ReportsWhatItsWorkThrows) {
  const Reports reports;
  Worker([] { throw std::bad_alloc(); }).join();
  Worker([] { throw cv::Exception(1, "wrong size", "", "", 0); }).join();
  Worker([] { throw 7; }).join();
  ASSERT_EQ(reports.sentences().size(), 3U);
  EXPECT_NE(reports.sentences()[0].find("not enough memory"), std::string::npos);
  EXPECT_NE(reports.sentences()[1].find("wrong size"), std::string::npos);
  EXPECT_NE(reports.sentences()[2].find("unexpected"), std::string::npos);
}

TEST(Worker, StopsItsWorkAtItsEnd) {
  bool is_stopped = false;
  {
    const Worker worker([&](const std::stop_token& stop) {
      is_stopped = is_stopped_within(stop, std::chrono::minutes(1));
    });
    EXPECT_TRUE(worker.is_begun());
  }
  EXPECT_TRUE(is_stopped);
}

TEST(Worker, DestroysItsWorkOnItsThread) {
  struct Owned {
    std::thread::id* ended_on;
    ~Owned() { *ended_on = std::this_thread::get_id(); }
  };
  std::thread::id ended_on, ran_on;
  Worker worker([owned = std::make_unique<Owned>(&ended_on), &ran_on] {
    ran_on = std::this_thread::get_id();
  });
  worker.join();
  EXPECT_FALSE(worker.is_begun());
  EXPECT_EQ(ended_on, ran_on);
  EXPECT_NE(ended_on, std::this_thread::get_id());
}

TEST(Worker, WorkThatEndsLaterIsWaitedFor) {
  std::atomic<int> ended{0};
  for (int i = 0; i < 5; ++i)
    Worker([&] {
      std::this_thread::sleep_for(milliseconds(20));
      // What ending work leaves is waited for as well.
      Worker([&] {
        std::this_thread::sleep_for(milliseconds(20));
        ++ended;
      }).end_later();
    }).end_later();
  EXPECT_TRUE(finish_workers(std::chrono::seconds(10)));
  EXPECT_EQ(ended, 5);
  EXPECT_TRUE(finish_workers(milliseconds(0))) << "none is left";
}

TEST(Worker, WorkThatHangsDoesNotHoldTheProgram) {
  std::atomic<bool> is_driver_stuck{true};
  Worker([&] { is_driver_stuck.wait(true); }).end_later();
  EXPECT_FALSE(finish_workers(milliseconds(50)));
  EXPECT_FALSE(finish_workers(milliseconds(0))) << "it is still counted";
  is_driver_stuck = false;
  is_driver_stuck.notify_all();
  EXPECT_TRUE(finish_workers(std::chrono::seconds(10)));
}

TEST(Mailbox, HoldsTheNewestValue) {
  Mailbox<std::string> mailbox;
  EXPECT_TRUE(mailbox.is_empty());
  EXPECT_EQ(mailbox.take(), std::nullopt);
  EXPECT_EQ(mailbox.put("first"), std::nullopt);
  EXPECT_EQ(mailbox.put("second"), "first");
  EXPECT_EQ(mailbox.take(), "second");
  EXPECT_TRUE(mailbox.is_empty());
}

TEST(Mailbox, NotifiesOnceForEachFilling) {
  Mailbox<int> sums;
  const auto add = [&](int term) {
    return sums.change([&](std::optional<int>& sum) { sum = sum.value_or(0) + term; });
  };
  EXPECT_TRUE(add(1));
  EXPECT_FALSE(add(2));
  EXPECT_EQ(sums.take(), 3);
  EXPECT_TRUE(add(4));
  EXPECT_FALSE(sums.change([](std::optional<int>& sum) { sum.reset(); }));
  EXPECT_TRUE(sums.is_empty());
}

TEST(Mailbox, AWaitEndsWithAValueOrAStop) {
  Mailbox<int> mailbox;
  std::stop_source stop;
  std::vector<int> taken;
  Worker receiver([&, token = stop.get_token()] {
    while (const auto value = mailbox.wait(token)) taken.push_back(*value);
  });
  for (int i = 1; i <= 1000; ++i) mailbox.put(i);
  while (!mailbox.is_empty()) std::this_thread::yield();
  stop.request_stop();
  receiver.join();
  ASSERT_FALSE(taken.empty());
  EXPECT_EQ(taken.back(), 1000) << "the newest value is never lost";
  EXPECT_TRUE(std::is_sorted(taken.begin(), taken.end()));
}

}  // namespace
}  // namespace alltact::test
