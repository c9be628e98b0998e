// A recording under way, and what can happen to it.
#include "core/recording/recorder.h"

#include "core/recording/journal.h"
#include "core/recording/mend.h"
#include "core/recording/video_file.h"
#include "tests/core/recording/recording_frames.h"
#include "tests/support/small_disk.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

RecorderSettings settings_for(VideoCodec codec, int queue_mb = 256) {
  RecorderSettings settings;
  settings.codec = codec;
  settings.queue_mb = queue_mb;
  settings.reserve_mb = 0;
  return settings;
}

std::unique_ptr<Recorder> started(const fs::path& file, const RecorderSettings& settings) {
  auto recorder = Recorder::start(file, settings, 30, "test camera");
  EXPECT_TRUE(recorder.ok()) << recorder.error().sentence();
  return std::move(*recorder);
}

/// All frames of a recording are the camera's, from the first on without a gap; how many.
std::uint32_t exact_frames(const fs::path& file, bool is_jpeg, cv::Size size = {64, 48}) {
  auto video = VideoFile::open(file);
  EXPECT_TRUE(video.ok()) << video.error().sentence();
  if (!video.ok()) return 0;
  for (std::uint32_t i = 0; i < video->frame_count(); ++i) {
    const auto frame = video->frame(i);
    EXPECT_TRUE(frame.ok()) << frame.error().sentence();
    if (!frame.ok()) return i;
    const FramePtr truth = camera_frame(i, is_jpeg, size);
    EXPECT_EQ(cv::norm((*frame)->grey, truth->grey, cv::NORM_INF), 0) << i;
    EXPECT_EQ((*frame)->sequence, i);
  }
  return static_cast<std::uint32_t>(video->frame_count());
}

TEST(Recorder, RecordsEveryFrameWithItsTimeAndSequence) {
  for (const VideoCodec codec : {VideoCodec::kMagicYuv, VideoCodec::kFfv1, VideoCodec::kMjpeg}) {
    const TemporaryFolder folder;
    const bool is_jpeg = codec == VideoCodec::kMjpeg;
    auto recorder = started(folder / "v.mkv", settings_for(codec));
    for (std::uint32_t i = 0; i < 60; ++i)
      ASSERT_TRUE(recorder->add_waiting(camera_frame(i, is_jpeg)));
    ASSERT_TRUE(recorder->finish("the test is over").ok());
    const RecorderCounts counts = recorder->counts();
    EXPECT_EQ(counts.recorded, 60U);
    EXPECT_EQ(counts.dropped + counts.missing + counts.waiting, 0U);
    EXPECT_EQ(counts.codec, codec);
    EXPECT_GT(counts.free_bytes, 0U);
    EXPECT_EQ(exact_frames(folder / "v.mkv", is_jpeg), 60U);
    auto video = VideoFile::open(folder / "v.mkv");
    EXPECT_EQ((*video->frame(17))->time_ns, camera_frame(17, false)->time_ns);
    EXPECT_THAT(text_of(folder / "v.frames.csv"), HasSubstr("# source: test camera\n"));
    EXPECT_THAT(text_of(folder / "v.frames.csv"), HasSubstr("# ended: the test is over\n"));
  }
}

TEST(Recorder, SaysWhatItDropped) {
  const TemporaryFolder folder;
  const cv::Size size(640, 480);
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kFfv1, 1));
  std::vector<FramePtr> frames;
  for (std::uint32_t i = 0; i < 30; ++i) frames.push_back(camera_frame(i, false, size));
  std::uint64_t refused = 0;
  for (const FramePtr& frame : frames) refused += recorder->add(frame) ? 0 : 1;
  ASSERT_TRUE(recorder->add_waiting(camera_frame(30, false, size)));
  ASSERT_TRUE(recorder->finish("done").ok());
  const RecorderCounts counts = recorder->counts();
  EXPECT_GT(refused, 0U);  // 30 pictures of 0.3 MB at once, into 1 MB
  EXPECT_EQ(counts.dropped, refused);
  EXPECT_EQ(counts.recorded + counts.dropped, 31U);
  EXPECT_EQ(counts.missing, 0U);
  auto video = VideoFile::open(folder / "v.mkv");
  ASSERT_EQ(video->frame_count(), counts.recorded);
  for (std::size_t i = 0; i < video->frame_count(); ++i) {
    const FramePtr frame = *video->frame(i);
    const auto number = static_cast<std::uint32_t>(frame->sequence);
    EXPECT_EQ(cv::norm(frame->grey, camera_frame(number, false, size)->grey, cv::NORM_INF), 0);
  }
  EXPECT_EQ((*video->frame(video->frame_count() - 1))->sequence, 30U);
  EXPECT_THAT(text_of(folder / "v.frames.csv"), HasSubstr("lost here: the disk was too slow"));
}

TEST(Recorder, SaysWhatNeverCame) {
  const TemporaryFolder folder;
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kMagicYuv));
  for (const std::uint32_t number : {4U, 5U, 9U, 10U, 12U})
    ASSERT_TRUE(recorder->add_waiting(camera_frame(number, false)));
  ASSERT_TRUE(recorder->finish("done").ok());
  EXPECT_EQ(recorder->counts().missing, 4U);
  EXPECT_EQ(recorder->counts().dropped, 0U);
  const std::string journal = text_of(folder / "v.frames.csv");
  EXPECT_THAT(journal, HasSubstr("# 3 frames before frame 2 never came from the source\n2,"));
  EXPECT_THAT(journal, HasSubstr("# 1 frame before frame 4 never came from the source\n4,"));
}

TEST(Recorder, ThreadsMayAddAndLookAtTheSameTime) {
  const TemporaryFolder folder;
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kMagicYuv, 1));
  std::atomic<bool> is_over{false};
  std::uint64_t seen = 0;
  std::thread looker([&] {
    while (!is_over)
      seen = std::max(seen, recorder->counts().recorded + recorder->counts().waiting);
  });
  std::vector<std::thread> givers;
  for (std::uint32_t part = 0; part < 3; ++part)
    givers.emplace_back([&, part] {
      for (std::uint32_t i = 0; i < 40; ++i) {
        const auto frame = std::make_shared<Frame>(*camera_frame(40 * part + i, false));
        frame->time_ns = 5'000'000'123;  // whichever comes first, time does not run backwards
        EXPECT_TRUE(recorder->add_waiting(frame));
      }
    });
  for (std::thread& giver : givers) giver.join();
  is_over = true;
  looker.join();
  ASSERT_TRUE(recorder->finish("done").ok());
  EXPECT_EQ(recorder->counts().recorded, 120U);
  EXPECT_LE(seen, 121U);
  EXPECT_EQ(VideoFile::open(folder / "v.mkv")->frame_count(), 120U);
}

TEST(Recorder, NeverWritesOverARecording) {
  const TemporaryFolder folder;
  const auto refusal = [&](const fs::path& file, const RecorderSettings& settings) {
    const auto recorder = Recorder::start(file, settings, 30, "test");
    return recorder.ok() ? "started" : recorder.error().sentence();
  };
  const RecorderSettings settings = settings_for(VideoCodec::kAuto);
  std::ofstream(folder / "old.mkv") << "precious";
  EXPECT_THAT(refusal(folder / "old.mkv", settings), HasSubstr("there is a file already"));
  EXPECT_EQ(text_of(folder / "old.mkv"), "precious");
  EXPECT_THAT(refusal(folder / "v.avi", settings), HasSubstr("ends in .mkv"));
  EXPECT_THAT(refusal(folder / "none/v.mkv", settings), HasSubstr("its folder does not exist"));
  RecorderSettings vast = settings;
  vast.reserve_mb = 1000000000;
  EXPECT_THAT(refusal(folder / "v.mkv", vast), HasSubstr("the disk is nearly full"));
  EXPECT_FALSE(fs::exists(folder / "v.mkv"));
}

TEST(Recorder, WithoutAFrameNothingIsLeft) {
  const TemporaryFolder folder;
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kAuto));
  const Status status = recorder->finish("done");
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().sentence(), HasSubstr("no frame came"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Recorder, AFrameThatDoesNotFitEndsItWhole) {
  const TemporaryFolder folder;
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kMagicYuv));
  for (std::uint32_t i = 0; i < 5; ++i) ASSERT_TRUE(recorder->add_waiting(camera_frame(i, false)));
  (void)recorder->add_waiting(camera_frame(5, false, {32, 32}));
  while (!recorder->problem()) std::this_thread::yield();
  EXPECT_FALSE(recorder->add(camera_frame(6, false)));
  EXPECT_FALSE(recorder->add_waiting(camera_frame(6, false)));
  const Status status = recorder->finish("done");
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().sentence(), HasSubstr("32 x 32, those before were 64 x 48"));
  EXPECT_EQ(exact_frames(folder / "v.mkv", false), 5U);
  EXPECT_THAT(text_of(folder / "v.frames.csv"), HasSubstr("# ended: test camera: the picture is"));
}

/// Records until the recorder ends by itself; how long its end took.
std::chrono::duration<double> record_until_it_ends(Recorder& recorder, cv::Size size) {
  std::uint32_t number = 0;
  while (recorder.add_waiting(camera_frame(number, false, size))) ++number;
  const auto begin = std::chrono::steady_clock::now();
  const Status status = recorder.finish("done");
  EXPECT_FALSE(status.ok());
  return std::chrono::steady_clock::now() - begin;
}

TEST(Recorder, EndsWholeBeforeTheDiskIsFull) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder / "disk", 8000);
  if (!disk.mounted()) GTEST_SKIP() << disk.problem();
  RecorderSettings settings = settings_for(VideoCodec::kMagicYuv);
  settings.reserve_mb = 3;
  const fs::path file = folder / "disk/v.mkv";
  auto recorder = started(file, settings);
  EXPECT_LT(record_until_it_ends(*recorder, {320, 240}).count(), 1);
  ASSERT_TRUE(recorder->problem());
  EXPECT_THAT(recorder->problem()->sentence(), HasSubstr("the disk is nearly full: 2 MB are left"));
  EXPECT_GT(fs::space(folder / "disk").available, 2'500'000U);
  const Result<bool> mended = mend_recording(file, Job());
  ASSERT_TRUE(mended.ok());
  EXPECT_FALSE(*mended) << "it is whole";
  EXPECT_EQ(exact_frames(file, false, {320, 240}), recorder->counts().recorded);
  EXPECT_GT(recorder->counts().recorded, 50U);
}

TEST(Recorder, AFullDiskLeavesEverythingBeforeItReadable) {
  for (const bool is_jpeg : {false, true}) {
    const TemporaryFolder folder;
    const SmallDisk disk(folder / "disk", 3000);
    if (!disk.mounted()) GTEST_SKIP() << disk.problem();
    const fs::path file = folder / "disk/v.mkv";
    auto recorder =
        started(file, settings_for(is_jpeg ? VideoCodec::kMjpeg : VideoCodec::kMagicYuv));
    const cv::Size size(320, 240);
    std::uint32_t number = 0;
    while (recorder->add_waiting(camera_frame(number, is_jpeg, size))) ++number;
    const Status status = recorder->finish("done");
    ASSERT_FALSE(status.ok());
    EXPECT_THAT(status.error().sentence(), HasSubstr("the disk is full"));
    const std::uint64_t recorded = recorder->counts().recorded;
    EXPECT_GT(recorded, 20U);
    EXPECT_EQ(exact_frames(file, is_jpeg, size), recorded);
    EXPECT_EQ(bytes_by_ffmpeg(file, is_jpeg),
              expected_bytes(static_cast<std::uint32_t>(recorded), is_jpeg, size));
  }
}

TEST(Recorder, AReadOnlyDiskIsTold) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder / "disk", 1000);
  if (!disk.mounted()) GTEST_SKIP() << disk.problem();
  ASSERT_TRUE(disk.forbid_writing());
  const auto recorder =
      Recorder::start(folder / "disk/v.mkv", settings_for(VideoCodec::kAuto), 30, "test");
  ASSERT_FALSE(recorder.ok());
  EXPECT_THAT(recorder.error().sentence(), HasSubstr("the disk is read-only"));
}

TEST(Recorder, PutsBackARecordingThatWasRemovedMeanwhile) {
  const TemporaryFolder folder;
  const fs::path file = folder / "day/v.mkv";
  fs::create_directory(folder / "day");
  auto recorder = started(file, settings_for(VideoCodec::kMagicYuv));
  std::uint32_t number = 0;
  for (; number < 20; ++number) ASSERT_TRUE(recorder->add_waiting(camera_frame(number, false)));
  while (recorder->counts().recorded < 20) std::this_thread::yield();
  fs::remove_all(folder / "day");
  EXPECT_LT(record_until_it_ends(*recorder, {64, 48}).count(), 1);
  EXPECT_THAT(recorder->problem()->sentence(), HasSubstr("was removed while it was being made"));
  EXPECT_EQ(exact_frames(file, false), 20U);
  EXPECT_EQ(read_journal(journal_of(file)).value().size(), 20U);
}

/// A recording of many megabytes whose folder is removed; ready to be finished.
std::unique_ptr<Recorder> long_and_removed(const TemporaryFolder& folder, std::uint32_t count) {
  fs::create_directory(folder / "day");
  auto recorder = started(folder / "day/v.mkv", settings_for(VideoCodec::kMagicYuv));
  const FramePtr picture = camera_frame(0, false, {1280, 960});
  for (std::uint32_t i = 0; i < count; ++i) {
    auto frame = std::make_shared<Frame>(*picture);
    frame->sequence = i;
    frame->time_ns += kPeriodNs * i;
    EXPECT_TRUE(recorder->add_waiting(std::move(frame)));
  }
  while (recorder->counts().recorded < count) std::this_thread::yield();
  fs::remove_all(folder / "day");
  return recorder;
}

TEST(Recorder, PuttingALongRecordingBackIsReported) {
  const TemporaryFolder folder;
  auto recorder = long_and_removed(folder, 60);
  std::vector<double> told;
  const Job job([&](double fraction, std::string_view what) {
    told.push_back(fraction);
    EXPECT_THAT(std::string(what), HasSubstr("putting the removed recording back"));
  });
  EXPECT_THAT(recorder->finish("done", job).error().sentence(), HasSubstr("was put back"));
  ASSERT_GT(recorder->counts().bytes, 40'000'000U);
  if (told.empty()) GTEST_SKIP() << "this disk shares instead of copying";
  EXPECT_GE(told.size(), 3U);
  EXPECT_EQ(told.back(), 1.0);
  EXPECT_EQ(VideoFile::open(folder / "day/v.mkv")->frame_count(), 60U);
}

TEST(Recorder, PuttingBackCanBeStoppedAndKeepsWhatIsThere) {
  const TemporaryFolder folder;
  auto recorder = long_and_removed(folder, 60);
  Job* running = nullptr;
  std::chrono::steady_clock::time_point stopped;
  Job job([&](double, std::string_view what) {
    if (what.find("back: 0 of") != std::string_view::npos) return;  // the journal
    stopped = std::chrono::steady_clock::now();
    running->request_stop();
  });
  running = &job;
  const Status status = recorder->finish("done", job);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - stopped;
  ASSERT_FALSE(status.ok());
  if (!job.stop_requested()) GTEST_SKIP() << "this disk shares instead of copying";
  EXPECT_THAT(status.error().sentence(), HasSubstr("stopped when 16 of"));
  EXPECT_LT(took.count(), 1);
  auto video = VideoFile::open(folder / "day/v.mkv");
  ASSERT_TRUE(video.ok()) << video.error().sentence();
  EXPECT_GT(video->frame_count(), 5U);
  EXPECT_LT(video->frame_count(), 60U);
}

TEST(Recorder, AJobThatWasStoppedBeforeStillPutsTheRecordingBack) {
  const TemporaryFolder folder;
  auto recorder = long_and_removed(folder, 3);
  Job job;
  job.request_stop();  // Ctrl-C is how recordings end
  EXPECT_THAT(recorder->finish("stopped by hand", job).error().sentence(),
              HasSubstr("was put back"));
  EXPECT_EQ(VideoFile::open(folder / "day/v.mkv")->frame_count(), 3U);
}

TEST(Recorder, GoesOnInAFolderThatIsMoved) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "day");
  auto recorder = started(folder / "day/v.mkv", settings_for(VideoCodec::kMagicYuv));
  for (std::uint32_t i = 0; i < 10; ++i) ASSERT_TRUE(recorder->add_waiting(camera_frame(i, false)));
  while (recorder->counts().recorded < 10) std::this_thread::yield();
  fs::rename(folder / "day", folder / "night");
  for (std::uint32_t i = 10; i < 20; ++i)
    ASSERT_TRUE(recorder->add_waiting(camera_frame(i, false)));
  ASSERT_TRUE(recorder->finish("done").ok());
  EXPECT_EQ(exact_frames(folder / "night/v.mkv", false), 20U);
}

TEST(Recorder, CanBeReadWhileItRecordsAndIsNotMendedThen) {
  const TemporaryFolder folder;
  const fs::path file = folder / "v.mkv";
  auto recorder = started(file, settings_for(VideoCodec::kMagicYuv));
  for (std::uint32_t i = 0; i < 10; ++i) ASSERT_TRUE(recorder->add_waiting(camera_frame(i, false)));
  while (recorder->counts().recorded < 10) std::this_thread::yield();
  const Result<bool> mended = mend_recording(file, Job());
  ASSERT_FALSE(mended.ok());
  EXPECT_THAT(mended.error().sentence(), HasSubstr("being recorded or mended right now"));
  EXPECT_EQ(exact_frames(file, false), 10U);
  for (std::uint32_t i = 10; i < 20; ++i)
    ASSERT_TRUE(recorder->add_waiting(camera_frame(i, false)));
  ASSERT_TRUE(recorder->finish("done").ok());
  EXPECT_EQ(exact_frames(file, false), 20U);
}

/// Runs recording_child for a while and kills it; how many frames its camera had given by then.
std::uint32_t killed_recording(const fs::path& file,
                               const char* codec,
                               std::chrono::milliseconds after) {
  const fs::path counter = file.parent_path() / "counter";
  std::ofstream(counter, std::ios::binary).write("\0\0\0\0", 4);
  const int descriptor = ::open(counter.c_str(), O_RDONLY | O_CLOEXEC);
  void* shared = ::mmap(nullptr, 4, PROT_READ, MAP_SHARED, descriptor, 0);
  ::close(descriptor);
  EXPECT_NE(shared, MAP_FAILED);
  const auto* given = static_cast<const std::atomic<std::uint32_t>*>(shared);
  std::string words[] = {ALLTACT_RECORDING_CHILD, file.string(), codec, "100", counter.string()};
  char* arguments[] = {
      words[0].data(), words[1].data(), words[2].data(), words[3].data(), words[4].data(), nullptr};
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
    const auto again = mend_recording(file, Job());
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
      EXPECT_FALSE(*mend_recording(cut, Job()));
    } else {
      EXPECT_FALSE(VideoFile::open(cut).ok());
    }
  }
  for (const auto& entry : fs::directory_iterator(folder.path()))
    EXPECT_THAT(entry.path().filename().string(), testing::AnyOf("whole.mkv", "cut.mkv"));
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
  const auto mended = mend_recording(file, Job());
  ASSERT_FALSE(mended.ok());
  EXPECT_THAT(mended.error().sentence(), HasSubstr("the disk is full"));
  EXPECT_EQ(exact_frames(file, false), 30U);
  auto video = VideoFile::open(file);
  for (const std::uint32_t number : {29U, 3U, 17U, 0U})
    EXPECT_EQ(
        cv::norm((*video->frame(number))->grey, camera_frame(number, false)->grey, cv::NORM_INF),
        0);
}

/// Resident memory of this program, MB.
double memory_mb() {
  std::ifstream statm("/proc/self/statm");
  double all = 0, resident = 0;
  statm >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

TEST(Recorder, MemoryDoesNotGrowWithTheRecording) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers keep freed memory";
#endif
  // ALLTACT_SOAK_SECONDS of recorded time at 30 frames a second, as fast as it goes.
  const char* wanted = std::getenv("ALLTACT_SOAK_SECONDS");
  const std::uint32_t frames = 30 * (wanted != nullptr ? std::atoi(wanted) : 30);
  const TemporaryFolder folder;
  std::vector<FramePtr> given;  // the same pictures over and over
  for (std::uint32_t i = 0; i < 10; ++i) given.push_back(camera_frame(i, false, {320, 240}));
  auto recorder = started(folder / "v.mkv", settings_for(VideoCodec::kMagicYuv, 2));
  double before_mb = 0;
  for (std::uint32_t i = 0; i < frames; ++i) {
    auto frame = std::make_shared<Frame>(*given[i % given.size()]);
    frame->sequence = i;
    frame->time_ns = kPeriodNs * i;
    ASSERT_TRUE(recorder->add_waiting(frame));
    if (i == 300) before_mb = memory_mb();
  }
  const double growth_mb = memory_mb() - before_mb;
  ASSERT_TRUE(recorder->finish("done").ok());
  fmt::print("{} frames, memory grew by {:.2f} MB\n", frames, growth_mb);
  EXPECT_LT(growth_mb, 5);
  EXPECT_EQ(recorder->counts().recorded, frames);
}

}  // namespace
}  // namespace alltact::test
