// Work beside the window: what takes the place of what, and what is told of it.
#include "widgets/background_work.h"

#include "widgets/controls/devices.h"

#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <memory>
#include <semaphore>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

/// Pieces of work that last until they are let go, and what became of each.
class Desk {
 public:
  /// In the order in which they began.
  std::vector<std::string> begun() {
    const std::lock_guard lock(shared_->mutex);
    return shared_->begun;
  }
  /// Whose outcome was told, in this order.
  [[nodiscard]] const std::vector<std::string>& taken() const { return taken_; }
  [[nodiscard]] bool was_asked_to_stop() const { return shared_->was_asked_to_stop; }
  void let_go() { shared_->gate.release(); }

  BackgroundWork::Work piece(const std::string& name) {
    return [this, name, shared = shared_](const Job& job) {
      {
        const std::lock_guard lock(shared->mutex);
        shared->begun.push_back(name);
      }
      shared->gate.acquire();
      if (job.stop_requested()) shared->was_asked_to_stop = true;
      return std::function<void()>([this, name] { taken_.push_back(name); });
    };
  }

 private:
  struct Shared {
    std::mutex mutex;
    std::vector<std::string> begun;
    std::counting_semaphore<> gate{0};
    std::atomic<bool> was_asked_to_stop = false;
  };
  std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
  std::vector<std::string> taken_;
};

using Names = std::vector<std::string>;

class WorkBesideTheWindow : public testing::Test {
 protected:
  /// Until nothing is going on any more.
  void let_all_end() {
    desk_.let_go();
    desk_.let_go();
    desk_.let_go();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !work_.is_running(); }));
  }
  Desk desk_;
  BackgroundWork work_;
  QSignalSpy finished_{&work_, &BackgroundWork::finished};
};

TEST_F(WorkBesideTheWindow, StartedTwiceGoesOnWithTheFirst) {
  work_.start(desk_.piece("first"));
  work_.start(desk_.piece("second"));
  ASSERT_NO_FATAL_FAILURE(let_all_end());
  EXPECT_EQ(desk_.begun(), Names({"first"}));
  EXPECT_EQ(desk_.taken(), Names({"first"}));
  EXPECT_FALSE(desk_.was_asked_to_stop());
  EXPECT_EQ(finished_.count(), 1);
}

TEST_F(WorkBesideTheWindow, StartedAgainRunsAtOnceWhereNothingDoes) {
  work_.restart(desk_.piece("only"));
  ASSERT_NO_FATAL_FAILURE(let_all_end());
  EXPECT_EQ(desk_.taken(), Names({"only"}));
  EXPECT_FALSE(desk_.was_asked_to_stop());
  EXPECT_EQ(finished_.count(), 1);
}

TEST_F(WorkBesideTheWindow, WhatWasStartedAgainLastCountsAndNothingBeforeIt) {
  work_.start(desk_.piece("first"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return desk_.begun() == Names({"first"}); }));
  work_.restart(desk_.piece("second"));
  work_.restart(desk_.piece("third"));
  QTest::qWait(150);
  EXPECT_EQ(desk_.begun(), Names({"first"})) << "two at a time";
  desk_.let_go();
  ASSERT_TRUE(QTest::qWaitFor([&] { return desk_.begun() == Names({"first", "third"}); }));
  EXPECT_TRUE(work_.is_running());
  EXPECT_TRUE(desk_.was_asked_to_stop());
  EXPECT_EQ(finished_.count(), 0);
  ASSERT_NO_FATAL_FAILURE(let_all_end());
  EXPECT_EQ(desk_.begun(), Names({"first", "third"}));
  EXPECT_EQ(desk_.taken(), Names({"third"}));
  EXPECT_EQ(finished_.count(), 1);
}

TEST_F(WorkBesideTheWindow, StoppedDoesNotRunWhatWaits) {
  work_.start(desk_.piece("first"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return desk_.begun() == Names({"first"}); }));
  work_.restart(desk_.piece("second"));
  work_.stop();
  ASSERT_NO_FATAL_FAILURE(let_all_end());
  QTest::qWait(150);
  EXPECT_EQ(desk_.begun(), Names({"first"}));
  EXPECT_EQ(desk_.taken(), Names()) << "it had been replaced";
  EXPECT_TRUE(desk_.was_asked_to_stop());
  EXPECT_EQ(finished_.count(), 1);
}

TEST_F(WorkBesideTheWindow, StoppedStillTellsHowFarItCame) {
  work_.start(desk_.piece("only"));
  work_.stop();
  ASSERT_NO_FATAL_FAILURE(let_all_end());
  EXPECT_TRUE(desk_.was_asked_to_stop());
  EXPECT_EQ(desk_.taken(), Names({"only"}));
  EXPECT_EQ(finished_.count(), 1);
}

TEST_F(WorkBesideTheWindow, OneThatStartsTheNextIsFinishedWithIt) {
  work_.start(
      [&](const Job&) { return std::function<void()>([&] { work_.start(desk_.piece("next")); }); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return desk_.begun() == Names({"next"}); }));
  EXPECT_TRUE(work_.is_running());
  EXPECT_EQ(finished_.count(), 0);
  ASSERT_NO_FATAL_FAILURE(let_all_end());
  EXPECT_EQ(desk_.taken(), Names({"next"}));
  EXPECT_EQ(finished_.count(), 1);
}

TEST_F(WorkBesideTheWindow, WhatReturnsAfterItsWindowHasGoneIsNotCalled) {
  {
    BackgroundWork gone;
    gone.start(desk_.piece("gone"));
    gone.restart(desk_.piece("waits"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return desk_.begun() == Names({"gone"}); }));
  }
  desk_.let_go();
  ASSERT_TRUE(QTest::qWaitFor([&] { return desk_.was_asked_to_stop(); }));
  QTest::qWait(150);
  EXPECT_EQ(desk_.begun(), Names({"gone"}));
  EXPECT_EQ(desk_.taken(), Names());
}

template <class Thrown>
BackgroundWork::Work throws(Thrown thrown) {
  return [thrown](const Job&) -> std::function<void()> { throw thrown; };
}

TEST_F(WorkBesideTheWindow, WhatIsThrownIsReportedAndTheNextWorkRuns) {
  QStringList reported;
  QObject::connect(
      &UnexpectedErrors::instance(), &UnexpectedErrors::reported, &work_,
      [&](const Error& error) { reported << QString::fromStdString(error.sentence()); });
  for (const auto& work :
       {throws(std::bad_alloc()), throws(cv::Exception(1, "size", "", "", 0)), throws(7)}) {
    work_.start(work);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !work_.is_running(); }));
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return reported.size() == 3; }));
  EXPECT_TRUE(reported[0].contains("not enough memory"));
  EXPECT_TRUE(reported[1].contains("size"));
  EXPECT_TRUE(reported[2].contains("unexpected"));
  EXPECT_EQ(finished_.count(), 3);
  work_.start(desk_.piece("next"));
  ASSERT_NO_FATAL_FAILURE(let_all_end());
  EXPECT_EQ(desk_.taken(), Names({"next"}));
}

TEST(CameraFinder, GoesOnWhereListingThrows) {
  QStringList reported;
  // The finder does not wait for its last listing when it is destroyed.
  const auto calls = std::make_shared<std::atomic<int>>(0);
  CameraFinder finder([calls]() -> std::vector<FoundCamera> {
    ++*calls;
    throw 7;
  });
  QObject::connect(
      &UnexpectedErrors::instance(), &UnexpectedErrors::reported, &finder,
      [&](const Error& error) { reported << QString::fromStdString(error.sentence()); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !reported.isEmpty(); }));
  EXPECT_TRUE(reported[0].contains("unexpected"));
  EXPECT_GE(*calls, 1);
}

}  // namespace
}  // namespace alltact::test
