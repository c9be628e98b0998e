#include "core/base/guarded.h"

#include <system_error>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

TEST(Guarded, PassesOnWhatReturns) {
  EXPECT_TRUE(guarded([] {}).ok());
  EXPECT_TRUE(guarded([] { return Status(); }).ok());
  EXPECT_EQ(guarded([] { return Result<int>(7); }).value(), 7);
  const auto refused = guarded([]() -> Result<int> {
    return Error{en::say("no"), std::string("file"), ""};
  });
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().sentence(), "file: no.");
}

TEST(Guarded, WhateverIsThrownIsASentence) {
  const auto sentence = [](auto thrown) {
    const Status status = guarded([&] { throw thrown; });
    return status ? std::string("nothing") : status.error().sentence();
  };
  const std::string memory = "there is not enough memory. Try: close other programs.";
  EXPECT_EQ(sentence(std::bad_alloc()), memory);
  EXPECT_EQ(sentence(cv::Exception(cv::Error::StsNoMem, "", "", "", 0)), memory);
  EXPECT_EQ(
      sentence(std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again))),
      memory);
  EXPECT_EQ(sentence(std::runtime_error("a\nb")),
            "unexpected: a b. Try: reporting this as a defect.");
  EXPECT_EQ(sentence(7), "unexpected: exception. Try: reporting this as a defect.");
  const std::string opencv = sentence(cv::Exception(cv::Error::StsAssert, "size", "f", "x.cpp", 3));
  EXPECT_NE(opencv.find("size"), std::string::npos) << opencv;
  EXPECT_EQ(opencv.find('\n'), std::string::npos) << opencv;
}

}  // namespace
}  // namespace alltact
