// Power that fails at any moment of a change leaves what was there before or what was to be there
// then, never some of both, and nothing that anybody has to clear away.
#include "calibration/reference/reference_recording.h"
#include "core/recording/journal.h"
#include "core/recording/video_file.h"
#include "tests/support/finger_on_disk.h"
#include "tests/support/marked_finger.h"
#include "tests/support/recorded_disk.h"

#include <algorithm>
#include <cstdlib>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using Lost = DiskModel::Lost;
using Files = DiskModel::Files;

/// Runs disk_child on a disk that writes down what it does.
std::vector<DiskOperation> log_of(const fs::path& disk, const std::string& arguments) {
  const TemporaryFolder folder;
  const ProgramRun run = run_shell(
      "ALLTACT_DISK='" + disk.string() + "' ALLTACT_DISK_LOG='" + (folder / "log").string() +
      "' LD_PRELOAD=" + ALLTACT_FAULTY_DISK + " " + ALLTACT_DISK_CHILD + " " + arguments);
  EXPECT_EQ(run.status, 0) << run.errors;
  return disk_log(folder / "log");
}

/// What a program finds after a power cut at any moment of a change is all old or all new.
void expect_old_or_new(const fs::path& finger, const std::string& arguments) {
  const DiskModel disk(finger);
  const auto operations = log_of(finger, arguments);
  expect_old_or_new_after_cuts(disk, operations, finger);
}

using PowerCut = FingerOnDisk;

TEST_F(PowerCut, WhileAFingerIsChanged) {
  expect_old_or_new(finger(), "rename " + finger() + " other");
  expect_old_or_new(finger(), "notes " + finger() + " 3.5");
  expect_old_or_new(finger(), "check " + finger());
  expect_old_or_new(finger(), "check " + finger());
}

TEST_F(PowerCut, WhileAnUntouchedPictureIsInstalled) {
  expect_old_or_new(finger(), "picture " + finger() + " " + flat_.presses[3].string());
}

TEST_F(PowerCut, WhileAFingerIsCalibratedAgainWithMorePresses) {
  const std::string calibrate =
      "calibrate " + finger() + " " + flat_.presses[0].string() + " " + flat_.presses[1].string();
  (void)log_of(finger(), calibrate);
  expect_old_or_new(finger(),
                    calibrate + " " + flat_.presses[2].string() + " " + flat_.presses[3].string());
}

/// A finger that bends to and fro, as pictures in a folder.
void write_bending(const fs::path& finger_folder, const fs::path& images, double width_px) {
  MarkedFinger drawn;
  drawn.width = 480, drawn.height = 270, drawn.focal = 262, drawn.dot_mm = 0.9, drawn.noise = 0.4;
  Finger finger;
  finger.name = "drawn";
  finger.camera = drawn.camera();
  finger.face = drawn.face();
  finger.markers = {drawn.per_row, Polarity::kAuto};
  if (!fs::exists(finger_folder)) {
    fs::create_directory(finger_folder);
    ASSERT_TRUE(finger.save(finger_folder));
  }
  fs::create_directory(images);
  std::mt19937 random(11);
  for (int i = 0; i < 12; ++i) {
    const double t = 2 * M_PI * i / 12;
    const Bend bend{0.35 * std::sin(t), 0.2 * std::sin(2 * t + 1), width_px * std::cos(3 * t), 0};
    cv::imwrite(images / fmt::format("frame_{:05}.png", i),
                drawn.with_noise(drawn.clean(bend), random));
  }
}

TEST_F(PowerCut, WhileARecordingIsInstalled) {
  const TemporaryFolder folder;
  const fs::path finger = folder / "drawn";
  ASSERT_NO_FATAL_FAILURE(write_bending(finger, folder / "one", 6));
  ASSERT_NO_FATAL_FAILURE(write_bending(finger, folder / "two", 4));
  const std::string install = "reference " + finger.string() + " ";
  (void)log_of(finger, install + (folder / "one").string());
  ASSERT_TRUE(fs::exists(finger / "reference.mkv"));
  expect_old_or_new(finger, install + (folder / "two").string());
}

std::size_t lines_of(const Files& files, const fs::path& scratch) {
  lay_out(files, scratch);
  const auto told = read_journal(journal_of(scratch / "v.mkv"));
  return told ? told->size() : 0;
}

/// Whoever records loses the last second, and no frame of which the frame log told before that.
TEST_F(PowerCut, WhileARecordingIsMade) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "day");
  const fs::path day = folder / "day";
  DiskModel disk(day);
  const auto operations = log_of(day, "record " + (day / "v.mkv").string() + " 20");
  std::size_t most = 0, syncs = 0, told_when_synced = 0;
  std::set<std::pair<Lost, Files>> seen;
  for (std::size_t done = 1; done <= operations.size(); ++done) {
    disk.apply(operations[done - 1]);
    const bool is_sync = operations[done - 1].what == "sync";
    syncs += is_sync ? 1 : 0;
    if (is_sync && operations[done - 1].path.ends_with("v.mkv"))
      told_when_synced = lines_of(disk.files(Lost::kNothing), folder / "then");
    for (const Lost lost : kEveryLoss) {
      const Files left = disk.files(lost);
      if (!left.contains("v.mkv") || left.at("v.mkv").empty() || !seen.emplace(lost, left).second)
        continue;
      const fs::path there = folder / std::to_string(seen.size());
      lay_out(left, there);
      auto video = VideoFile::open(there / "v.mkv");
      const auto told = read_journal(journal_of(there / "v.mkv"));
      ASSERT_TRUE(told) << told.error().sentence();
      // Lines that were written while the video was being synced may be ahead of its frames.
      const bool is_whole = lost == Lost::kNothing || lost == Lost::kBoth;
      if (is_whole && !told->empty()) {
        ASSERT_TRUE(video) << done << ": " << video.error().sentence();
        const std::size_t wanted = lost == Lost::kNothing ? told->size() - 1 : told_when_synced;
        EXPECT_GE(video->frame_count(), std::min(wanted, told->size())) << done;
      }
      if (lost == Lost::kBoth && video && done < operations.size() * 9 / 10)
        most = std::max(most, video->frame_count());
      fs::remove_all(there);
    }
  }
  EXPECT_GT(syncs, 4U);
  EXPECT_GT(most, 5U) << "it was on the disk while it was still being made";
}

}  // namespace
}  // namespace alltact::test
