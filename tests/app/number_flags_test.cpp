// Numbers behind every flag: the value that a person means, or a refusal; never another value.
// Flags are found in what the program says of itself, so that a new one is tested too.
#include "calibration/joint/calibration_settings.h"
#include "calibration/lens/calibrate_lens.h"
#include "core/finger/finger.h"
#include "core/recording/recorder.h"
#include "core/sensing/pipeline_settings.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/program.h"

#include <regex>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

struct Flag {
  std::string command, name;
  bool is_number = false;
};

std::vector<std::string> all_matches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> all;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
    all.push_back((*at)[1]);
  return all;
}

/// All that take a value.
std::vector<Flag> all_flags() {
  std::vector<Flag> flags;
  const std::string help = run_alltact({"--help"}).output;
  const std::string commands = help.substr(help.find("Subcommands"));
  for (const std::string& command : all_matches(commands, std::regex("\n  ([a-z]+) "))) {
    const std::string page = run_alltact({command, "--help"}).output;
    const std::regex with_value(
        "\n  (?:-[a-z],)?(--[a-z0-9-]+ (?!Excludes:|Needs:)[A-Za-z\\[][^\n]*)");
    for (const std::string& line : all_matches(page, with_value)) {
      const bool is_number = line.find("NUMBER") != std::string::npos;
      if (!is_number && line.find('{') != std::string::npos) continue;  // one of several words
      Flag flag{command, line.substr(0, line.find(' '))};
      flag.is_number = is_number;
      flags.push_back(flag);
    }
  }
  return flags;
}

/// A flag that no command has keeps those that could begin from working for minutes.
std::string errors_of(const Flag& flag, const std::string& value) {
  const ProgramRun run = run_alltact({flag.command, flag.name + "=" + value, "--no-such-flag"});
  EXPECT_EQ(run.status, 2) << flag.command << ' ' << flag.name << ' ' << value;
  return run.errors;
}

TEST(NumberFlags, NoneIsReadByTheLibraryOfFlags) {
  int flags = 0;
  for (const Flag& flag : all_flags()) {
    ++flags;
    const ProgramRun run = run_alltact({flag.command, flag.name + "=zzz", "--no-such-flag"});
    EXPECT_THAT(run.errors, Not(HasSubstr("Could not convert")))
        << flag.command << ' ' << flag.name << " takes a number: transform(typed_number(...))";
  }
  EXPECT_GT(flags, 80);
}

TEST(NumberFlags, TakeBothDecimalMarksAndRefuseThousands) {
  int numbers = 0;
  for (const Flag& flag : all_flags()) {
    if (!flag.is_number) continue;
    ++numbers;
    SCOPED_TRACE(flag.command + ' ' + flag.name);
    EXPECT_THAT(errors_of(flag, "1,234"), HasSubstr("'1,234' can mean 1.234 or 1234"));
    EXPECT_THAT(errors_of(flag, "1.234,5"), HasSubstr("write 1234.5"));
    EXPECT_THAT(errors_of(flag, "1'000"), HasSubstr("write 1000"));
    for (const char* none : {"nan", "inf", "0x1f", "", "four"})
      EXPECT_THAT(errors_of(flag, none), AnyOf(HasSubstr("not a number"), HasSubstr("missing")));
    // What it reads is told where it is out of range; else only other flags are missing.
    const std::string comma = errors_of(flag, "4,5"), point = errors_of(flag, "4.5");
    const bool is_whole = comma.find("is not a whole number") != std::string::npos;
    EXPECT_EQ(is_whole, point.find("is not a whole number") != std::string::npos);
    if (!is_whole) {
      EXPECT_EQ(comma, point);
      EXPECT_THAT(errors_of(flag, "-9e12"), HasSubstr("not -9e12"));
      EXPECT_THAT(errors_of(flag, "−9000000000000,5"), HasSubstr("not -9000000000000.5"));
    } else {
      EXPECT_EQ(errors_of(flag, "４"), errors_of(flag, "4"));
      EXPECT_THAT(errors_of(flag, "-4"), HasSubstr("not -4"));
    }
  }
  EXPECT_GE(numbers, 30);
}

template <class S>
void expect_typed(const std::string& command, const std::vector<Setting<S>>& settings) {
  for (const Setting<S>& setting : settings) {
    if (!setting.range.numbers) continue;
    const Flag flag{command, "--" + setting.name};
    EXPECT_THAT(errors_of(flag, "1,234"), HasSubstr("'1,234' can mean 1.234 or 1234"))
        << setting.name;
    EXPECT_THAT(errors_of(flag, "nan"), HasSubstr("'nan' is not a number")) << setting.name;
  }
}

TEST(NumberFlags, OfSettingsToo) {
  expect_typed("reconstruct", pipeline_settings());
  expect_typed("calibrate", calibration_settings());
  expect_typed("lens", lens_settings());
  expect_typed("record", recorder_settings());
}

TEST(NumberFlags, ReachTheFingerAsTheyWereMeant) {
  for (const auto& [text, meant] : {std::pair{"1,6", 1.6}, {"1.6", 1.6}, {"1,6 mm", 1.6}}) {
    const TemporaryFolder folder;
    write_flat_camera(folder / "camera.yaml");
    const ProgramRun run =
        run_alltact({"new", (folder / "finger").string(), "--camera",
                     (folder / "camera.yaml").string(), "--kind", "flat", "--layer-mm", text});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(Finger::load(folder / "finger")->face.layer_mm, meant) << text;
    EXPECT_EQ(run.errors, "");
  }
}

TEST(NumberFlags, WarnOfWhatIsNotPlausible) {
  const TemporaryFolder folder;
  write_flat_camera(folder / "camera.yaml");
  const ProgramRun run =
      run_alltact({"new", (folder / "finger").string(), "--camera",
                   (folder / "camera.yaml").string(), "--kind", "flat", "--layer-mm", "16"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.errors,
              HasSubstr("16 mm is more than typical for the thickness of a layer (0.3 to 5 mm)"));
}

}  // namespace
}  // namespace alltact::test
