#include "core/base/result.h"

#include <memory>

#include <gtest/gtest.h>

namespace alltact {
namespace {

Result<std::unique_ptr<int>> made(bool is_value) {
  if (is_value) return std::make_unique<int>(7);
  return Error{en::say("the disk is full"), std::string("file"), ""};
}

TEST(Result, HoldsAValueOrAnError) {
  EXPECT_EQ(*made(true).value(), 7);
  EXPECT_EQ(made(false).error().sentence(), "file: the disk is full.");
}

TEST(ResultDeathTest, AccessToWhatItDoesNotHoldEndsWithAMessageInEveryBuild) {
  EXPECT_DEATH(static_cast<void>(*made(false)), "file: the disk is full");
  EXPECT_DEATH(static_cast<void>(made(false)->get()), "file: the disk is full");
  EXPECT_DEATH(static_cast<void>(made(true).error()), "has none");
  EXPECT_DEATH(static_cast<void>(Status().error()), "has none");
}

}  // namespace
}  // namespace alltact
