// Demands that the program does not meet yet. They are written as they must hold, and this list,
// one place, keeps them out of the default run; whoever mends one takes its line away.
// ALLTACT_AWAITED=1 runs them all the same.
#pragma once

#include "tests/support/slow_run.h"

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace alltact::test {

struct Awaited {
  const char* test;  ///< "Suite.Name"
  const char* what;  ///< what happens today
};

inline constexpr Awaited kAwaited[] = {
    {"HardShapes.OneThatIsTwistedByFiveDegrees",
     "1.5 mm off, and no outline can tell: a face that sways by 0.26 mm without a twist draws the "
     "same to 3e-6 px, and fingers sway by millimetres; markers tell (twist_model.h)"},
};

/// What is missing for the test that runs now; nullptr: it must pass.
inline const char* awaited() {
  if (std::getenv("ALLTACT_AWAITED") != nullptr) return nullptr;
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = std::string(info->test_suite_name()) + "." + info->name();
  for (const Awaited& one : kAwaited)
    if (name == one.test) return one.what;
  return nullptr;
}

}  // namespace alltact::test

#define ALLTACT_SKIP_IF_AWAITED() \
  if (const char* what = ::alltact::test::awaited()) GTEST_SKIP() << "awaited: " << what
