// A test program started again by one of its tests.
#pragma once

#include <QProcessEnvironment>

namespace alltact::test {

/// So that it runs all tests that its filter names, whatever part of them its parent was given, and
/// leaves the parent's report alone.
inline QProcessEnvironment environment_of_child_tests() {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* name : {"GTEST_OUTPUT", "GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX"})
    environment.remove(name);
  return environment;
}

}  // namespace alltact::test
