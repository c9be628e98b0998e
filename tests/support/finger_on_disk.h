// A flat finger with its untouched picture, for tests of what a disk may do to it.
#pragma once

#include "core/finger/finger.h"
#include "tests/support/flat_finger.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/sanitized.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace alltact::test {

class FingerOnDisk : public testing::Test {
 protected:
  void SetUp() override {
    if (kIsSanitized) GTEST_SKIP() << "sanitizers want to be loaded before the disk's faults";
    const std::filesystem::path folder = finger();
    std::filesystem::create_directory(folder);
    Finger made = flat_sensor_finger(true);
    made.reference = ReferenceFiles{"", "", "reference.png"};
    ASSERT_TRUE(made.save(folder));
    std::filesystem::copy(flat_.file("ref.png"), folder / "reference.png");
  }
  [[nodiscard]] std::string finger() const { return flat_.finger(); }

  FlatFinger flat_;
};

}  // namespace alltact::test
