// Dates and times of day: the second that is meant, or a refusal.
#include "core/base/time_stamp.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

// Seconds as date -u +%s prints them.
TEST(TimeStamp, IsTheSecondThatIsMeant) {
  struct Example {
    const char* text;
    double seconds;
  };
  for (const Example& example : {Example{"2026-03-01T12:00:00Z", 1772366400},
                                 {"2026-03-01 12:00:00", 1772366400},
                                 {"2026-03-01 12:00:00.123", 1772366400.123},
                                 {"2026-03-01T12:00:00,5", 1772366400.5},
                                 {"2026-03-01T13:00:00+01:00", 1772366400},
                                 {"2026-03-01T17:30:00 +0530", 1772366400},
                                 {"2026-03-01T07:00:00-05", 1772366400},
                                 {"2026/3/1 12:00", 1772366400},
                                 {"01.03.2026 12:00:00", 1772366400},
                                 {"13/03/2026 12:00:00", 1773403200},
                                 {"03/13/2026 12:00:00", 1773403200},
                                 {"01-Mar-2026 12:00:00", 1772366400},
                                 {"1.3.2026", 1772323200},
                                 {"12:00:01.5", 43201.5},
                                 {"12:00:01 PM", 43201},
                                 {"12:00:01 am", 1},
                                 {"1:02:03 PM", 46923},
                                 {"01:23.4", 83.4},
                                 {"100:00:00", 360000}}) {
    const auto stamp = parse_time_stamp(example.text);
    ASSERT_TRUE(stamp) << example.text << ": " << stamp.error().sentence();
    EXPECT_EQ(stamp->seconds(), example.seconds) << example.text;
    EXPECT_FALSE(stamp->is_date_ambiguous) << example.text;
    EXPECT_TRUE(resembles_time_stamp(example.text)) << example.text;
  }
  EXPECT_TRUE(parse_time_stamp("03/01/2026 12:00:00")->is_date_ambiguous);
  EXPECT_FALSE(parse_time_stamp("01/01/2026 12:00:00")->is_date_ambiguous);
}

TEST(TimeStamp, WhatDoesNotExistIsRefused) {
  for (const char* text : {"",
                           "12",
                           "2026-02-30",
                           "2026-13-01 12:00:00",
                           "31.04.2026",
                           "12:30",
                           "12:60:00",
                           "12:00:60",
                           "2026-03-01 24:00:00",
                           "13:00:00 PM",
                           "0:00:00 AM",
                           "12:00:00.",
                           "12:00:00+15:00",
                           "2026-03-01 noon",
                           "1/2",
                           "12:00:00 x",
                           "2026-03-01T12:00:00+1",
                           "a:b:c",
                           "-1:00:00",
                           "01.03.26 12:00:00"})
    EXPECT_FALSE(parse_time_stamp(text)) << text;
  for (const char* number : {"1.5", "-3", "1e-5", "+2.5e+3", "", "x:y"})
    EXPECT_FALSE(resembles_time_stamp(number)) << number;
}

}  // namespace
}  // namespace alltact
