// Every calculation that a plain formula gets wrong: the plain one fails, ours stays within its
// bound. What `alltact check --numerics` shows.
#include "calibration/hard_cases/hard_cases.h"

#include <cstdio>
#include <set>

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(HardCases, OursHoldWhereThePlainFormulaFails) {
  const auto cases = hard_cases();
  ASSERT_GT(cases.size(), 30U);
  std::set<std::string> names;
  for (const HardCase& one : cases) {
    std::printf("[ figures  ] %s: plain %.2g, ours %.2g, bound %.2g %s\n",
                one.what.c_str(),
                one.plain_error,
                one.our_error,
                one.bound,
                one.unit.c_str());
    EXPECT_TRUE(one.holds()) << one.what;
    EXPECT_TRUE(one.plain_fails()) << one.what;
    // What only just fails would show little.
    EXPECT_GE(one.plain_error, 2 * one.our_error) << one.what;
    EXPECT_TRUE(names.insert(one.what).second) << one.what;
  }
}

TEST(HardCases, AnErrorThatIsNoNumberDoesNotHold) {
  HardCase one{"", "", "", 1.0, std::nan(""), 1.0};
  EXPECT_FALSE(one.holds());
  one.our_error = INFINITY;
  EXPECT_FALSE(one.holds());
  one.plain_error = std::nan("");
  EXPECT_TRUE(one.plain_fails());
}

}  // namespace
}  // namespace alltact
