#include "calibration/checks/check_history.h"

#include "tests/support/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace alltact {
namespace {

CheckEntry some_entry(int i) {
  CheckEntry entry;
  entry.time = "2026-01-31T12:00:0" + std::to_string(i) + "Z";
  entry.verdict = static_cast<CheckVerdict>(1 + i % 4);
  entry.error_mm = 0.1 / (i + 3);
  entry.drifting_above_mm = 0.02;
  entry.recalibrate_above_mm = 0.06;
  entry.light_percent = -1.25;
  entry.presses = i;
  entry.ball_radius_mm = 3.975;
  entry.calibration_date = "2026-01-30T12:00:00Z";
  entry.program_version = "0.1.0";
  if (i % 2 == 1) entry.bias_mm = -0.0125 * i;
  entry.operator_name = i % 3 == 0 ? "" : "Ann \"A.\", night, " + std::to_string(i);
  return entry;
}

TEST(CheckHistory, ComesBackAsItWasAppended) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(load_checks(folder.path(), nullptr)->empty());
  std::vector<CheckEntry> all;
  for (int i = 0; i < 5; ++i) {
    all.push_back(some_entry(i));
    ASSERT_TRUE(append_check(folder.path(), all.back()).ok());
    const auto back = load_checks(folder.path(), nullptr);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(*back, all);
  }
}

TEST(CheckHistory, ACutOffFileKeepsItsWholeLinesAndGoesOn) {
  const test::TemporaryFolder folder;
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(append_check(folder.path(), some_entry(i)).ok());
  const std::string whole = test::text_of(folder / kCheckFile);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    test::write_text(folder / kCheckFile, whole.substr(0, length));
    const auto back = load_checks(folder.path(), nullptr);
    ASSERT_TRUE(back.ok());
    for (std::size_t i = 0; i + 1 < back->size(); ++i)
      EXPECT_EQ((*back)[i], some_entry(static_cast<int>(i)));
    ASSERT_TRUE(append_check(folder.path(), some_entry(7)).ok());
    EXPECT_EQ(load_checks(folder.path(), nullptr)->back(), some_entry(7)) << length;
  }
}

TEST(CheckHistory, LinesOfEarlierVersionsStayAndTheHeadNamesAllColumns) {
  const test::TemporaryFolder folder;
  const std::string line =
      "2026-01-31T12:00:00Z,pass,0.01,0.02,0.06,-1.25,3,4,2026-01-30T12:00:00Z,0.1.0";
  test::write_text(folder / kCheckFile,
                   "time_utc,verdict,error_mm,drifting_above_mm,recalibrate_above_mm,"
                   "light_percent,presses,ball_radius_mm,calibration_date,program_version\n" +
                       line + "\n");
  ASSERT_TRUE(append_check(folder.path(), some_entry(1)).ok());
  std::vector<Message> warnings;
  const auto back = load_checks(folder.path(), &warnings);
  ASSERT_TRUE(back.ok());
  EXPECT_TRUE(warnings.empty());
  ASSERT_EQ(back->size(), 2U);
  EXPECT_FALSE(back->front().bias_mm.has_value());
  EXPECT_EQ(back->back(), some_entry(1));
  const std::string text = test::text_of(folder / kCheckFile);
  EXPECT_THAT(text, testing::HasSubstr("program_version,bias_mm,operator\n" + line + "\n"));
}

TEST(CheckHistory, TheLastCheckCountsForTheCalibrationThatItWasOf) {
  Finger finger;
  EXPECT_EQ(latest_check({}, finger), nullptr);
  std::vector<CheckEntry> history{some_entry(0), some_entry(1)};
  EXPECT_EQ(latest_check(history, finger), &history.back()) << "the finger does not tell its date";
  finger.provenance["calibration_date"] = history.back().calibration_date;
  EXPECT_EQ(latest_check(history, finger), &history.back());
  finger.provenance["calibration_date"] = "2026-02-01T12:00:00Z";
  EXPECT_EQ(latest_check(history, finger), nullptr);
  history.back().calibration_date.clear();
  EXPECT_EQ(latest_check(history, finger), &history.back()) << "an old file does not tell it";
}

RC_GTEST_PROP(CheckHistory, AnythingElseIsLeftOutAndNamed, ()) {
  const test::TemporaryFolder folder;
  const auto junk = *rc::gen::container<std::string>(rc::gen::inRange<char>(' ', 127));
  test::write_text(folder / kCheckFile, "x" + junk + "\n");
  std::vector<Message> warnings;
  const auto back = load_checks(folder.path(), &warnings);
  RC_ASSERT(back.ok() && back->empty());
  RC_ASSERT(warnings.size() == 1U);
}

TEST(SecondsOf, KnowsTheCalendar) {
  EXPECT_EQ(unix_seconds("1970-01-01T00:00:00Z"), 0.0);
  EXPECT_EQ(unix_seconds("2000-03-01T00:00:00Z"), 951868800.0);  // as date -u +%s says
  EXPECT_EQ(unix_seconds("2026-11-21T16:18:16Z"), 1795277896.0);
  for (const char* wrong : {"", "2026-02-30T00:00:00Z", "2026-01-01 00:00:00",
                            "2026-01-01T24:00:00Z", "2026-01-01T00:00:00Zx", "2026-1-01T00:00:00Z"})
    EXPECT_FALSE(unix_seconds(wrong)) << wrong;
}

}  // namespace
}  // namespace alltact
