// Every test starts from the same random state, whatever ran before it, and keeps nothing in the
// user's cache.
#pragma once

#include "core/base/worker.h"
#include "tests/support/own_cache.h"

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/core/utility.hpp>
#include <sched.h>

namespace alltact::test {

class Reseed : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override {
    std::srand(20240611U);
    cv::theRNG().state = 20240611U;
  }
};

/// OpenCV's threads (TBB) hand memory over in ways that ThreadSanitizer cannot see. TBB takes as
/// many as there are cores for it when it is first asked: one, here.
inline void keep_opencv_to_one_thread() {
#if defined(__SANITIZE_THREAD__)
  cpu_set_t all, one;
  sched_getaffinity(0, sizeof all, &all);
  CPU_ZERO(&one);
  CPU_SET(sched_getcpu(), &one);
  sched_setaffinity(0, sizeof one, &one);
  cv::parallel_for_({0, 2}, [](const cv::Range&) {});
  sched_setaffinity(0, sizeof all, &all);
#endif
}

inline int run_all_tests(int argc, char** argv) {
  keep_opencv_to_one_thread();
  // Properties draw the same cases in every run; RC_PARAMS from outside still wins.
  setenv("RC_PARAMS", "seed=20240611", 0);
  const OwnCache cache;
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new Reseed);
  const int status = RUN_ALL_TESTS();
  if (finish_workers(std::chrono::seconds(20))) return status;
  std::fputs("A thread that a test left does not end.\n", stderr);
  std::_Exit(1);
}

}  // namespace alltact::test
