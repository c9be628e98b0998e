#include "core/gripper/gripper_recording.h"

#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

constexpr const char* kMotorTable = "time_ns,turns\n1000,2.0\n2000,3.0\r\n4000,-1.5\n";

TEST(MotorLog, IsStraightBetweenItsLinesAndNothingBeyond) {
  const auto log = MotorLog::parse(kMotorTable, "motor.csv");
  ASSERT_TRUE(log) << log.error().sentence();
  EXPECT_EQ(log->turns_at(1000), 2.0);
  EXPECT_NEAR(*log->turns_at(1250), 2.25, 1e-12);
  EXPECT_EQ(log->turns_at(2000), 3.0);
  EXPECT_NEAR(*log->turns_at(3000), 0.75, 1e-12);
  EXPECT_EQ(log->turns_at(4000), -1.5);
  EXPECT_FALSE(log->turns_at(999));
  EXPECT_FALSE(log->turns_at(4001));
  EXPECT_FALSE(log->turns_at(std::numeric_limits<std::int64_t>::min()));
}

TEST(MotorLog, WhatIsNoTableIsRefusedByFileAndLine) {
  const auto refusal = [](const std::string& text) {
    const auto log = MotorLog::parse(text, "motor.csv");
    return log ? std::string("accepted") : log.error().sentence();
  };
  const std::string head = "time_ns,turns\n1,2\n";
  EXPECT_THAT(refusal(""), HasSubstr("motor.csv: the table is empty"));
  EXPECT_THAT(refusal(head), HasSubstr("fewer than two"));
  EXPECT_THAT(refusal("turns\n1\n"),
              HasSubstr("motor.csv, line 1: the column 'time_ns' is missing; found: 'turns'"));
  EXPECT_THAT(refusal(head + "1,3\n"),
              HasSubstr("motor.csv, line 3, column time_ns: the time is not after"));
  for (const char* line :
       {"2", "2,", "2,nan", "2,inf", "2.5,1", "a,1", "2,1,3", "2,1e999", "99999999999999999999,1"})
    EXPECT_THAT(refusal(head + line + "\n"), HasSubstr("motor.csv, line 3")) << line;
  EXPECT_THAT(refusal("time,turns\n0.5,1\n"), HasSubstr("'0.5' is not an integer in ns"));
  EXPECT_FALSE(MotorLog::load("/nowhere/motor.csv"));
}

TEST(MotorLog, OtherUnitsStandInTheNames) {
  for (const char* text :
       {"t_s;Angle [deg]\n0,001;720\n0,003;-360\n", "t_ms\trev\n1\t2\n3\t-1\n",
        "Time (us),turns\n1000,2\n3000,-1\n", "time_ns,turns\n1000000,2\n3000000,-1\n"}) {
    const auto log = MotorLog::parse(text, "motor.csv");
    ASSERT_TRUE(log) << text << log.error().sentence();
    EXPECT_EQ(log->first_ns(), 1'000'000);
    EXPECT_EQ(log->last_ns(), 3'000'000);
    EXPECT_EQ(log->turns_at(1'000'000), 2.0) << text;
    EXPECT_NEAR(*log->turns_at(2'000'000), 0.5, 1e-12) << text;
  }
  const auto since_1970 =
      MotorLog::parse("time_ns,turns\n1772366400123456789,2\n1772366400123456790,3\n", "motor.csv");
  ASSERT_TRUE(since_1970) << since_1970.error().sentence();
  EXPECT_EQ(since_1970->first_ns(), 1772366400123456789) << "exact";
}

TEST(MotorLog, EveryTruncationAndDamageIsReadOrRefused) {
  const std::string text = kMotorTable;
  for (std::size_t size = 0; size < text.size(); ++size) {
    const auto log = MotorLog::parse(text.substr(0, size), "motor.csv");
    if (log) {
      EXPECT_TRUE(log->turns_at(1500));
    }
  }
  std::mt19937 random(3);
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = text;
    for (int k = 0; k < 2; ++k) damaged[random() % text.size()] = "0123456789,-.e\n"[random() % 15];
    const auto log = MotorLog::parse(damaged, "motor.csv");
    if (!log) continue;
    for (const std::int64_t time : {0, 1000, 1500, 4000})
      if (const auto turns = log->turns_at(time)) {
        EXPECT_TRUE(std::isfinite(*turns));
      }
  }
}

}  // namespace
}  // namespace alltact
