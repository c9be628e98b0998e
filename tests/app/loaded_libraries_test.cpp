#include "tests/support/program.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

TEST(LoadedLibraries, HoldNoQt5) {
  const fs::path build = fs::path(ALLTACT_PROGRAM).parent_path().parent_path();
  for (const fs::path& program :
       {build / "app/liballtact-commands.so", build / "app/liballtact-figures.so",
        build / "tests/core_tests", build / "tests/app_tests", build / "app/studio/alltact-studio",
        build / "tests/widgets_tests", build / "tests/studio_tests",
        build / "tests/calibration_tests"}) {
    if (!fs::exists(program)) continue;  // a build of one part alone
    const ProgramRun libraries = run_shell("ldd '" + program.string() + "'");
    ASSERT_EQ(libraries.status, 0) << libraries.errors;
    ASSERT_THAT(libraries.output, testing::HasSubstr("libopencv_core")) << program;
    EXPECT_THAT(libraries.output, testing::Not(testing::HasSubstr("libQt5"))) << program;
    EXPECT_THAT(libraries.output, testing::Not(testing::HasSubstr("libopencv_highgui"))) << program;
  }
}

}  // namespace
}  // namespace alltact::test
