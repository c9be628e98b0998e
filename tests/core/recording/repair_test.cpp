// Recordings that were cut off: by a kill, anywhere, or on a disk without space to mend them.
#include "core/recording/journal.h"
#include "core/recording/video_file.h"
#include "tests/core/recording/recorder_use.h"
#include "tests/support/program.h"
#include "tests/support/small_disk.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

/// Runs recording_child for a while and kills it; how many frames its camera had given by then.
std::uint32_t killed_recording(const fs::path& file, const char* codec,
                               std::chrono::milliseconds after) {
  const fs::path counter = file.parent_path() / "counter";
  std::ofstream(counter, std::ios::binary).write("\0\0\0\0", 4);
  const int descriptor = ::open(counter.c_str(), O_RDONLY | O_CLOEXEC);
  void* shared = ::mmap(nullptr, 4, PROT_READ, MAP_SHARED, descriptor, 0);
  ::close(descriptor);
  EXPECT_NE(shared, MAP_FAILED);
  const auto* given = static_cast<const std::atomic<std::uint32_t>*>(shared);
  std::string words[] = {ALLTACT_RECORDING_CHILD, file.string(), codec, "100", counter.string()};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(),
                       words[3].data(), words[4].data(), nullptr};
  pid_t child = 0;
  EXPECT_EQ(posix_spawn(&child, arguments[0], nullptr, nullptr, arguments, environ), 0);
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (given->load() == 0 && std::chrono::steady_clock::now() < patience)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::this_thread::sleep_for(after);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
  const std::uint32_t count = given->load();
  ::munmap(shared, 4);
  return count;
}

TEST(Journal, ARemarkReplacesAnIncompleteLastLine) {
  const TemporaryFolder folder;
  const fs::path file = folder / "video.journal";
  std::ofstream(file) << "# a line\n0,17,3,\n1,5";
  ASSERT_TRUE(remark_in_journal(file, "mended\nby hand").ok());
  EXPECT_EQ(text_of(file), "# a line\n0,17,3,\n# mended by hand\n");
}

TEST(Journal, ARemarkNeedsAJournal) {
  const TemporaryFolder folder;
  const Status remarked = remark_in_journal(folder / "none.journal", "mended");
  ASSERT_FALSE(remarked.ok());
  EXPECT_THAT(remarked.error().sentence(), HasSubstr("none.journal"));
  EXPECT_FALSE(fs::exists(folder / "none.journal"));
}

TEST(Recorder, KilledAtAnyMomentItLosesNoSecond) {
  const char* wanted = std::getenv("ALLTACT_KILLS");
  const int kills = wanted != nullptr ? std::atoi(wanted) : 9;
  std::mt19937 random(20240611);
  std::uint32_t worst = 0, total = 0;
  for (int i = 0; i < kills; ++i) {
    const TemporaryFolder folder;
    const fs::path file = folder / "v.mkv";
    const char* codec = std::array{"magicyuv", "mjpeg", "ffv1"}[static_cast<std::size_t>(i % 3)];
    const bool is_jpeg = i % 3 == 1;
    const std::uint32_t given =
        killed_recording(file, codec, std::chrono::milliseconds(random() % 800));
    // The file as it lies there, by a program that knows nothing of us.
    const auto bytes = bytes_by_ffmpeg(file, is_jpeg);
    const std::uint32_t frames = fs::file_size(file) == 0 ? 0 : exact_frames(file, is_jpeg);
    EXPECT_EQ(bytes, expected_bytes(frames, is_jpeg)) << "kill " << i;
    ASSERT_LE(frames, given);
    const std::uint32_t lost = given - frames;
    EXPECT_LE(lost, 100U) << "more than a second, kill " << i;
    worst = std::max(worst, lost);
    total += frames;
    if (frames == 0) continue;
    // Opening it has mended it: players can seek, and again it is exact.
    EXPECT_EQ(bytes_by_ffmpeg(file, is_jpeg), expected_bytes(frames, is_jpeg));
    const auto again = repair_recording(file, Job());
    ASSERT_TRUE(again.ok()) << again.error().sentence();
    EXPECT_FALSE(*again);
    EXPECT_GE(read_journal(journal_of(file)).value().size() + 1, frames);
  }
  fmt::print("{} kills: {} frames kept, at most {} lost at once\n", kills, total, worst);
  EXPECT_GT(total, static_cast<std::uint32_t>(10 * kills));
}

TEST(Mend, ARecordingCutAnywhereKeepsEveryWholeFrame) {
  const TemporaryFolder folder;
  const fs::path whole = folder / "whole.mkv", cut = folder / "cut.mkv";
  std::vector<std::uint64_t> ends;  // of each frame in the file
  {
    auto writer = VideoWriter::create(whole, *camera_frame(0, false), VideoCodec::kMagicYuv, 30);
    ASSERT_TRUE(writer.ok());
    for (std::uint32_t i = 0; i < 4; ++i) {
      ASSERT_TRUE(writer->add(*camera_frame(i, false)).ok());
      ends.push_back(writer->bytes());
    }
  }  // never finished
  for (std::uint64_t bytes = ends.back(); bytes > 0; bytes -= std::min<std::uint64_t>(bytes, 97)) {
    fs::copy_file(whole, cut, fs::copy_options::overwrite_existing);
    fs::resize_file(cut, bytes);
    const auto kept = static_cast<std::uint32_t>(
        std::count_if(ends.begin(), ends.end(), [&](std::uint64_t end) { return end <= bytes; }));
    if (kept > 0) {
      ASSERT_EQ(exact_frames(cut, false), kept) << bytes;
      EXPECT_FALSE(*repair_recording(cut, Job()));
    } else {
      EXPECT_FALSE(VideoFile::open(cut).ok());
    }
  }
  for (const auto& entry : fs::directory_iterator(folder.path()))
    EXPECT_THAT(entry.path().filename().string(), testing::AnyOf("whole.mkv", "cut.mkv"));
}

TEST(Mend, SaysWhichFramesAPowerCutTook) {
  for (const std::uint32_t told : {3U, 4U, 6U}) {
    const TemporaryFolder folder;
    const fs::path file = folder / "cut.mkv";
    {
      auto writer = VideoWriter::create(file, *camera_frame(0, false), VideoCodec::kMagicYuv, 30);
      auto journal = JournalWriter::create(journal_of(file), "a camera");
      ASSERT_TRUE(writer.ok() && journal.ok());
      for (std::uint32_t i = 0; i < 4; ++i) ASSERT_TRUE(writer->add(*camera_frame(i, false)).ok());
      for (std::uint32_t i = 0; i < told; ++i)
        ASSERT_TRUE(journal->add(*camera_frame(i, false)).ok());
    }  // never finished
    const std::string lines = text_of(journal_of(file));
    std::ofstream(journal_of(file), std::ios::app) << "9,81";
    ASSERT_TRUE(VideoFile::open(file).ok());
    ASSERT_TRUE(VideoFile::open(file).ok());
    if (told <= 4)
      EXPECT_EQ(text_of(journal_of(file)), lines + "9,81");
    else
      EXPECT_EQ(text_of(journal_of(file)),
                lines +
                    "# cut off and mended: the video holds 4 of the 6 frames that are told of "
                    "here, the last ones did not reach the disk\n");
    EXPECT_EQ(read_journal(journal_of(file))->size(), told);
  }
}

TEST(Mend, LeavesOtherPeoplesFilesAlone) {
  const TemporaryFolder folder;
  const fs::path file = folder / "v.mkv";
  output_of(
      "ffmpeg -v quiet -nostdin -f lavfi -i testsrc=s=64x48:d=1 -c:v ffv1 -f matroska - "
      "</dev/null >'" +
      file.string() + "'");
  if (!fs::exists(file) || fs::file_size(file) == 0) GTEST_SKIP() << "ffmpeg is not here";
  const std::string before = text_of(file);
  EXPECT_EQ(VideoFile::open(file)->frame_count(), 25U);
  EXPECT_EQ(text_of(file), before);
}

TEST(Mend, WithoutSpaceForACopyTheRecordingIsReadAsItIs) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder / "disk", 2000);
  if (!disk.mounted()) GTEST_SKIP() << disk.problem();
  const fs::path file = folder / "disk/v.mkv";
  {
    auto writer = VideoWriter::create(file, *camera_frame(0, false), VideoCodec::kMagicYuv, 30);
    ASSERT_TRUE(writer.ok());
    for (std::uint32_t i = 0; i < 30; ++i) ASSERT_TRUE(writer->add(*camera_frame(i, false)).ok());
  }
  const auto mended = repair_recording(file, Job());
  ASSERT_FALSE(mended.ok());
  EXPECT_THAT(mended.error().sentence(), HasSubstr("the disk is full"));
  EXPECT_EQ(exact_frames(file, false), 30U);
  auto video = VideoFile::open(file);
  for (const std::uint32_t number : {29U, 3U, 17U, 0U})
    EXPECT_EQ(
        cv::norm((*video->frame(number))->grey, camera_frame(number, false)->grey, cv::NORM_INF),
        0);
}

}  // namespace
}  // namespace alltact::test
