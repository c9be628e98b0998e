// The command line needs no window: what it loads, and when.
#include "tests/support/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The libraries that a use of the program loads, as the loader tells them.
std::string loaded_by(const std::string& arguments) {
  const ProgramRun run =
      run_shell(std::string("LD_DEBUG=files '") + ALLTACT_PROGRAM + "' " + arguments + " 2>&1");
  return run.output;
}

TEST(ProgramParts, ItselfNeedsNothingThatDrawsOrMeasures) {
  const ProgramRun run = run_shell(std::string("ldd '") + ALLTACT_PROGRAM + "'");
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("libc.so"));
  for (const char* library : {"libQt6", "libX11", "libxcb", "libGL", "libEGL", "libOpenGL",
                              "libvtk", "libopencv", "libav"})
    EXPECT_THAT(run.output, Not(HasSubstr(library)));
}

TEST(ProgramParts, HelpAndVersionLoadNothingMore) {
  for (const char* asked : {"--help", "-h", "--version"})
    EXPECT_THAT(loaded_by(asked), AllOf(HasSubstr("libc.so"), Not(HasSubstr("liballtact"))))
        << asked;
}

TEST(ProgramParts, WorkLoadsNoWindow) {
  const TemporaryFolder folder;
  const std::string loaded = loaded_by("check '" + (folder / "no_finger").string() + "'");
  EXPECT_THAT(loaded, HasSubstr("liballtact-commands.so"));
  for (const char* library : {"libQt6", "libvtk", "liballtact-figures.so"})
    EXPECT_THAT(loaded, Not(HasSubstr(library)));
}

TEST(ProgramParts, HelpIsTheSameWithAllThatItTellsOf) {
  // Something else on the line, and the part that holds the commands answers.
  const ProgramRun at_once = run_alltact({"--help"}), loaded = run_alltact({"--help", "--nothing"});
  EXPECT_EQ(at_once.status, 0);
  EXPECT_EQ(loaded.status, 0);
  EXPECT_EQ(at_once.output, loaded.output);
}

TEST(ProgramParts, APartThatIsMissingIsNamed) {
  const TemporaryFolder folder;
  std::filesystem::copy(ALLTACT_PROGRAM, folder / "alltact");
  const ProgramRun run = run_shell("'" + (folder / "alltact").string() + "' demo");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("liballtact-commands.so"));
}

}  // namespace
}  // namespace alltact::test
