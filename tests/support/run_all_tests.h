// Every test starts from the same random state, whatever ran before it.
#pragma once

#include <cstdlib>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace alltact::test {

class Reseed : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override {
    std::srand(20240611U);
    cv::theRNG().state = 20240611U;
  }
};

inline int run_all_tests(int argc, char** argv) {
  // Properties draw the same cases in every run; RC_PARAMS from outside still wins.
  setenv("RC_PARAMS", "seed=20240611", 0);
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new Reseed);
  return RUN_ALL_TESTS();
}

}  // namespace alltact::test
