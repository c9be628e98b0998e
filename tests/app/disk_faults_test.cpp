// A disk that is full, read-only or broken from any of its operations on, few open files and little
// memory: what was saved remains, and a sentence says why nothing new was.
#include "core/finger/finger_store.h"
#include "tests/support/finger_on_disk.h"
#include "tests/support/recorded_disk.h"
#include "tests/support/slow_run.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using Files = DiskModel::Files;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

/// Without the line that says when a reference was made: every run has another.
Files undated_files_in(const fs::path& folder) {
  Files files = files_in(folder);
  std::string& text = files["finger.yaml"];
  const std::size_t begin = text.find("  reference_date:");
  if (begin != std::string::npos) text.erase(begin, text.find('\n', begin) - begin + 1);
  return files;
}

class DiskFaults : public FingerOnDisk {
 protected:
  void SetUp() override {
    FingerOnDisk::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    fs::copy(finger(), kept_, fs::copy_options::recursive);
  }
  void put_back() const {
    fs::remove_all(finger());
    fs::copy(kept_, finger(), fs::copy_options::recursive);
  }
  [[nodiscard]] ProgramRun run(const std::string& settings, const std::string& arguments) const {
    return run_shell(fmt::format("ALLTACT_DISK='{}' {} LD_PRELOAD={} {} {}", finger(), settings,
                                 ALLTACT_FAULTY_DISK, ALLTACT_DISK_CHILD, arguments));
  }

  /// Every operation of a change is the first that fails, one after the other, until none does.
  void fail_each(const std::string& arguments, int error_number, const std::string& words) {
    const Files before = undated_files_in(finger());
    ASSERT_EQ(run("", arguments).status, 0);
    const Files after = undated_files_in(finger());
    int refused = 0;
    for (int first = 1;; first += is_slow_run() ? 1 : first) {
      put_back();
      const ProgramRun failed =
          run(fmt::format("ALLTACT_DISK_FAIL={}:{}", first, error_number), arguments);
      const auto opened = open_finger(finger());
      ASSERT_TRUE(opened) << first << opened.error().sentence();
      const Files found = undated_files_in(finger());
      if (failed.status == 0) {
        EXPECT_EQ(found, after);
        break;
      }
      ++refused;
      EXPECT_EQ(failed.status, 1) << first << failed.errors;
      EXPECT_THAT(failed.errors, HasSubstr(words)) << first;
      EXPECT_TRUE(found == before || found == after) << arguments << ", from " << first << " on";
      ASSERT_LT(first, 1000);
    }
    EXPECT_GT(refused, 2);
    put_back();
  }

  fs::path kept_ = flat_.file("kept");
};

TEST_F(DiskFaults, AFullDiskAtEveryWrite) {
  fail_each("rename " + finger() + " other", ENOSPC, "the disk is full");
  fail_each("notes " + finger() + " 3.5", ENOSPC, "the disk is full");
  fail_each("check " + finger(), ENOSPC, "the disk is full");
  fail_each("picture " + finger() + " " + flat_.presses[3].string(), ENOSPC, "the disk is full");
}

TEST_F(DiskFaults, ADiskThatBecomesReadOnlyOrBreaksAtEveryWrite) {
  const std::string image = "picture " + finger() + " " + flat_.presses[3].string();
  fail_each(image, EROFS, "read-only");
  fail_each(image, EIO, finger());
  fail_each("rename " + finger() + " other", EIO, finger());
  fail_each("rename " + finger() + " other", EMFILE, "too many");
}

TEST_F(DiskFaults, AFullDiskWhileAFingerIsCalibrated) {
  std::string presses;
  for (const auto& press : flat_.presses) presses += " " + press.string();
  fail_each("calibrate " + finger() + presses, ENOSPC, "the disk is full");
}

TEST_F(DiskFaults, TheClockOfTheComputerWasSetBack) {
  ASSERT_EQ(run("", fmt::format("calibrate {} {} {}", finger(), flat_.presses[0].string(),
                                flat_.presses[1].string()))
                .status,
            0);
  const auto check = [&](const std::string& settings) {
    return run_shell(fmt::format("{} LD_PRELOAD={} {} check {} --presses {} {} {}", settings,
                                 ALLTACT_FAULTY_DISK, ALLTACT_PROGRAM, finger(),
                                 flat_.presses[0].string(), flat_.presses[1].string(),
                                 flat_.presses[2].string()));
  };
  const std::string history = finger() + "/checks.csv";
  const ProgramRun first = check("");
  ASSERT_TRUE(fs::exists(history)) << first.errors << first.output;
  const std::string one = text_of(history);
  const ProgramRun second = check("ALLTACT_CLOCK=-400000000");
  EXPECT_EQ(second.status, first.status) << second.errors;
  EXPECT_THAT(first.errors, Not(HasSubstr("set the clock")));
  EXPECT_THAT(second.errors, HasSubstr("and this computer's clock shows 201"));
  EXPECT_THAT(second.errors, HasSubstr("set the clock"));
  const std::string both = text_of(history);
  EXPECT_TRUE(both.starts_with(one)) << "what was there remains";
  EXPECT_GT(both.size(), one.size());
  EXPECT_THAT(both.substr(one.size()), HasSubstr("201")) << "and it says when by this clock";
}

TEST_F(DiskFaults, ADiskThatStallsIsToldOfAndCanBeLeft) {
  const ProgramRun run = run_shell(fmt::format(
      "export ALLTACT_DISK='{0}' ALLTACT_DISK_STALL=60000; LD_PRELOAD={1} {2} check {0} 2>{3} & "
      "for tenth in $(seq 400); do grep -q slowly {3} && break; sleep 0.1; done; "
      "kill -INT $!; sleep 0.2; kill -INT $!; wait $!; status=$?; cat {3} >&2; exit $status",
      finger(), ALLTACT_FAULTY_DISK, ALLTACT_PROGRAM, flat_.file("warned")));
  const std::string alarm = "its disk responds slowly";
  EXPECT_THAT(run.errors, HasSubstr("finger.yaml: " + alarm));
  EXPECT_EQ(run.errors.find(alarm), run.errors.rfind(alarm)) << run.errors;
  EXPECT_EQ(run.status, 128 + SIGINT);
}

TEST_F(DiskFaults, FewOpenFilesAreToldOrEnough) {
  int least = 4;  // with fewer the system cannot even begin the program (127)
  while (run_shell(fmt::format("ulimit -n {}; {} --version", least, ALLTACT_PROGRAM)).status == 127)
    ASSERT_LT(++least, 64);
  for (int files = least; files <= least + 20; files += is_slow_run() ? 1 : 4) {
    const ProgramRun run =
        run_shell(fmt::format("ulimit -n {}; {} reconstruct {} {} -o {}", files, ALLTACT_PROGRAM,
                              finger(), flat_.presses[0].string(), flat_.file("out")));
    EXPECT_THAT(run.status, AnyOf(0, 1)) << files << run.errors;
    EXPECT_THAT(run.errors, Not(HasSubstr("unexpected"))) << files;
    if (run.status == 1) {
      EXPECT_NE(run.errors, "") << files;
    }
    EXPECT_EQ(undated_files_in(finger()), undated_files_in(kept_));
  }
}

TEST_F(DiskFaults, LittleMemoryIsToldOrEnough) {
  int refused = 0;
  for (int megabytes = 60; megabytes <= 900; megabytes += is_slow_run() ? 40 : 210) {
    const ProgramRun run = run_shell(
        fmt::format("ulimit -v {}; timeout -s KILL 60 {} reconstruct {} {} -o {}", 1000 * megabytes,
                    ALLTACT_PROGRAM, finger(), flat_.presses[0].string(), flat_.file("out")));
    EXPECT_THAT(run.status, AnyOf(0, 1)) << megabytes << run.errors;
    if (run.status == 1) {
      EXPECT_THAT(run.errors, HasSubstr("Try: ")) << megabytes;
      ++refused;
    }
    EXPECT_EQ(undated_files_in(finger()), undated_files_in(kept_));
  }
  EXPECT_GT(refused, 0);
}

/// What draws the pages of the report on several threads waits for all of them; none may begin
/// here.
TEST_F(DiskFaults, LittleMemoryForPagesOfTheReportIsToldAndLosesNoCalibration) {
  if (!is_slow_run()) GTEST_SKIP() << "how much is little depends on the computer; --slow";
  std::string presses;
  for (const auto& press : flat_.presses) presses += " " + press.string();
  ASSERT_EQ(run("", "calibrate " + finger() + presses).status, 0);
  int without_pages = 0;
  for (int megabytes = 340; megabytes <= 640; megabytes += 10) {
    const ProgramRun run =
        run_shell(fmt::format("ulimit -v {}; timeout -s KILL 60 {} calibrate {} --again",
                              1000 * megabytes, ALLTACT_PROGRAM, finger()));
    EXPECT_THAT(run.status, AnyOf(0, 1)) << megabytes << run.errors;
    if (run.status == 1) {
      EXPECT_THAT(run.errors, HasSubstr("Try: ")) << megabytes;
    }
    EXPECT_TRUE(open_finger(finger())) << megabytes;
    without_pages += run.errors.find("report pages cannot be written") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(without_pages, 0);
}

}  // namespace
}  // namespace alltact::test
