#include "core/base/utc_time.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr const char* kPast = "2001-09-09T01:46:40Z";
constexpr const char* kFuture = "2999-12-31T23:59:59Z";

TEST(UtcTime, NowIsAUtcDateThatHasCome) {
  const std::string now = utc_now();
  EXPECT_TRUE(is_utc(now)) << now;
  EXPECT_FALSE(is_ahead_of_clock(now));
}

TEST(UtcTime, OnlyADateBeyondTheClockIsAheadOfIt) {
  EXPECT_FALSE(is_ahead_of_clock(kPast));
  EXPECT_TRUE(is_ahead_of_clock(kFuture));
  EXPECT_FALSE(is_ahead_of_clock(""));
  EXPECT_FALSE(is_ahead_of_clock("tomorrow"));
}

TEST(UtcTime, WhatIsMadeFromSomethingIsNotOlderThanIt) {
  EXPECT_EQ(utc_not_before(kFuture), kFuture);
  EXPECT_GT(utc_not_before(kPast), kPast);
  EXPECT_LT(utc_not_before("zzz"), kFuture) << "no date";
  EXPECT_TRUE(is_utc(utc_not_before("")));
}

}  // namespace
}  // namespace alltact
