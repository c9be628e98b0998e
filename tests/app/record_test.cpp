// Recording and live measurement from the command line.
#include "calibration/force/collect_force.h"
#include "core/recording/video_file.h"
#include "tests/rigs/serial_line.h"
#include "tests/support/flat_finger.h"
#include "tests/support/small_disk.h"

#include <atomic>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// A small flat sensor that is pressed; never still, as its noise shows.
void write_scene(const fs::path& file, const std::string& more = "") {
  write_text(file,
             "name: small\nwhy: to record\nframes: 12\nframes_per_s: 60\nfinger:\n"
             "  camera: {model: orthographic, size: [320, 240], mm_per_px: 0.06, cx: 159.5, "
             "cy: 119.5}\n"
             "  face: {kind: flat, layer_mm: 3.0, plane_z_mm: 30.0}\neffects:\n"
             "  - use: leds\n    lamps: [{at_mm: [0.0, 0.0, 0.0], power: 130000.0}]\n"
             "  - {use: layer, scatter_per_mm: 0.6, along: normal}\n"
             "  - {use: read, sd: 1.0}\n  - {use: quantisation}\n" +
                 more);
}

ProgramRun record(const fs::path& source, const fs::path& video,
                  const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments = {"record", source.string(), "-o", video.string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_alltact(arguments);
}

TEST(Record, WhatWasAssumedAboutImagesIsReported) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "in");
  for (const char* name : {"in/1.png", "in/2.png"})
    cv::imwrite((folder / name).string(), cv::Mat(48, 64, CV_16UC1, cv::Scalar(3600)));
  const ProgramRun run = record(folder / "in", folder / "v.mkv", {"--pace", "asked"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.errors, HasSubstr("only the lower 12 are in use"));
}

TEST(Record, ASceneIsRecordedExactlyAndToldInJson) {
  const TemporaryFolder folder;
  write_scene(folder / "s.yaml");
  const ProgramRun run =
      record(folder / "s.yaml", folder / "v.mkv", {"--pace", "asked", "--json", "--seed", "3"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const json answer = json::parse(run.output);
  EXPECT_EQ(answer.at("frames"), 12);
  EXPECT_EQ(answer.at("dropped"), 0);
  EXPECT_EQ(answer.at("missing"), 0);
  EXPECT_NEAR(answer.at("seconds").get<double>(), 11 / 60.0, 1e-6);
  EXPECT_EQ(answer.at("bytes"), fs::file_size(folder / "v.mkv"));
  ASSERT_EQ(run_alltact({"simulate", (folder / "s.yaml").string(), "-o", (folder / "out").string(),
                         "--seed", "3"})
                .status,
            0);
  auto video = VideoFile::open(folder / "v.mkv");
  ASSERT_TRUE(video.ok());
  ASSERT_EQ(video->frame_count(), 12U);
  for (std::size_t i = 0; i < 12; ++i) {
    const FramePtr frame = *video->frame(i);
    const cv::Mat truth = cv::imread((folder / ("out/" + frame->name + ".png")).string(), 0);
    EXPECT_EQ(cv::norm(frame->grey, truth, cv::NORM_INF), 0) << i;
  }
}

TEST(Record, PicturesAndVideosAreRecordedToo) {
  const TemporaryFolder folder;
  write_scene(folder / "s.yaml", "  - {use: mjpeg, quality: 90}\n");
  ASSERT_EQ(record(folder / "s.yaml", folder / "a.mkv", {"--pace", "asked"}).status, 0);
  // A recording of a recording: the same packets, times and numbers.
  const ProgramRun copy =
      record(folder / "a.mkv", folder / "b.mkv", {"--json", "--frames", "7", "--codec", "mjpeg"});
  ASSERT_EQ(copy.status, 0) << copy.errors;
  auto a = VideoFile::open(folder / "a.mkv"), b = VideoFile::open(folder / "b.mkv");
  ASSERT_EQ(b->frame_count(), 7U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(*(*a->frame(i))->jpeg, *(*b->frame(i))->jpeg);
    EXPECT_EQ((*a->frame(i))->time_ns, (*b->frame(i))->time_ns);
  }
  ASSERT_EQ(run_alltact({"simulate", (folder / "s.yaml").string(), "-o", folder / "out"}).status,
            0);
  const ProgramRun images = record(folder / "out", folder / "c.mkv", {"--codec", "ffv1", "--json"});
  ASSERT_EQ(images.status, 0) << images.errors;
  EXPECT_EQ(json::parse(images.output).at("codec"), "FFV1");
  EXPECT_EQ(VideoFile::open(folder / "c.mkv")->frame_count(), 12U);
}

TEST(Record, LostFramesAreTold) {
  const TemporaryFolder folder;
  write_scene(folder / "s.yaml", "  - {use: drop, share: 0.5}\n");
  const ProgramRun run = record(folder / "s.yaml", folder / "v.mkv", {"--pace", "asked"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.errors, HasSubstr("frames never came from the source"));
  EXPECT_THAT(text_of(folder / "v.frames.csv"), HasSubstr("never came from the source"));
}

TEST(Record, EndsWholeOnCtrlC) {
  const TemporaryFolder folder;
  write_scene(folder / "s.yaml");
  const ProgramRun run =
      run_shell_until("'" ALLTACT_PROGRAM "' record '" + (folder / "s.yaml").string() + "' -o '" +
                          (folder / "v.mkv").string() + "'",
                      "[ $(wc -l < '" + (folder / "v.frames.csv").string() + "') -gt 30 ]");
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(text_of(folder / "v.frames.csv"), HasSubstr("# ended: stopped by hand\n"));
  const auto video = VideoFile::open(folder / "v.mkv");
  ASSERT_TRUE(video.ok());
  EXPECT_GT(video->frame_count(), 12U) << "beyond the scene's frames";
}

TEST(Record, SaysWhyItCannot) {
  const TemporaryFolder folder;
  write_scene(folder / "s.yaml");
  write_text(folder / "old.mkv", "precious");
  const ProgramRun exists = record(folder / "s.yaml", folder / "old.mkv");
  EXPECT_EQ(exists.status, 1);
  EXPECT_THAT(exists.errors, HasSubstr("old.mkv: the file exists already"));
  EXPECT_EQ(text_of(folder / "old.mkv"), "precious");
  EXPECT_EQ(record(folder / "s.yaml", folder / "none/v.mkv").status, 1);
  EXPECT_EQ(record(folder / "none.yaml", folder / "v.mkv").status, 1);
  EXPECT_EQ(record(folder / "s.yaml", folder / "v.mkv", {"--codec", "h264"}).status, 2);
  const ProgramRun no_button = record(folder / "s.yaml", folder / "p.png");
  EXPECT_EQ(no_button.status, 2);
  EXPECT_THAT(no_button.errors, HasSubstr("images need a --button"));
  const ProgramRun nonsense = record(folder / "s.yaml", folder / "v.mkv", {"--button", "pedal"});
  EXPECT_EQ(nonsense.status, 2);
  EXPECT_THAT(nonsense.errors, HasSubstr("alltact devices --learn-button"));
  EXPECT_EQ(record(folder / "s.yaml", folder / "v.mkv", {"--brightness", "1"}).status, 2);
  const ProgramRun packets = record(folder / "s.yaml", folder / "v.mkv", {"--codec", "mjpeg"});
  EXPECT_EQ(packets.status, 1);
  EXPECT_THAT(packets.errors, HasSubstr("the source delivers no JPEG packets"));
  EXPECT_FALSE(fs::exists(folder / "v.mkv"));
}

TEST(Record, EndsWholeBeforeTheDiskIsFull) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder / "disk", 8000);
  if (!disk.mounted()) GTEST_SKIP() << disk.problem();
  write_scene(folder / "s.yaml");
  const ProgramRun run = record(folder / "s.yaml", folder / "disk/v.mkv",
                                {"--reserve-mb", "7", "--seconds", "60", "--json"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("the disk is nearly full"));
  const json answer = json::parse(run.output);
  EXPECT_GT(answer.at("frames"), 5);
  EXPECT_EQ(VideoFile::open(folder / "disk/v.mkv")->frame_count(), answer.at("frames"));
  EXPECT_THAT(text_of(folder / "disk/v.frames.csv"), HasSubstr("# ended: "));
}

TEST(Live, GivesALineForEachFrameUntilCtrlC) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  ASSERT_EQ(flat.calibrate().status, 0);
  const cv::Mat image = cv::imread(flat.presses[0].string(), cv::IMREAD_GRAYSCALE);
  // A camera that looks at a press for as long as the test wants.
  fs::create_directory(flat.folder / "in");
  for (const char* name : {"a", "b", "c", "d"})
    cv::imwrite(flat.file(std::string("in/") + name + ".png"), image);
  ASSERT_EQ(record(flat.folder / "in", flat.folder / "v.mkv").status, 0);
  const ProgramRun run = run_alltact({"reconstruct", flat.finger(), flat.file("v.mkv"), "--live"});
  ASSERT_EQ(run.status, 0) << run.errors;
  std::istringstream lines(run.output);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const json told = json::parse(line);
    EXPECT_EQ(told.at("index"), count);
    ASSERT_EQ(told.at("regions").size(), 1U);
    EXPECT_GT(told.at("regions")[0].at("deepest_mm").get<double>(), 0.1);
  }
  EXPECT_GE(count, 1);  // the newest wins: a slow computer measures fewer
  EXPECT_LE(count, 4);
  EXPECT_THAT(run.errors, HasSubstr("skipped to keep up"));

  write_scene(flat.folder / "s.yaml");
  const std::string lines_so_far = flat.file("lines");
  const ProgramRun stopped =
      run_shell_until("'" ALLTACT_PROGRAM "' reconstruct '" + flat.finger() + "' '" +
                          flat.file("s.yaml") + "' --live > '" + lines_so_far + "'",
                      "grep -q '\"index\":2' '" + lines_so_far + "'");
  EXPECT_EQ(stopped.status, 0) << stopped.errors;
  EXPECT_THAT(text_of(lines_so_far), HasSubstr("\"index\":2"));
}

TEST(Live, WantsEitherAFolderOrLines) {
  EXPECT_EQ(run_alltact({"reconstruct", "f", "v.mkv"}).status, 2);
  EXPECT_EQ(run_alltact({"reconstruct", "f", "v.mkv", "--live", "-o", "out"}).status, 2);
  EXPECT_EQ(run_alltact({"reconstruct", "f", "v.mkv", "--live", "--format", "ply"}).status, 2);
  const ProgramRun both = run_alltact({"reconstruct", "f", "v.mkv", "--live", "--json"});
  EXPECT_EQ(both.status, 1);
  EXPECT_THAT(both.errors, HasSubstr("without --json"));
}

// Whoever types waits until the recording runs.
TEST(RecordGauge, WhatIsTypedLiesBesideTheVideo) {
  const TemporaryFolder folder;
  write_scene(folder / "s.yaml");
  const std::string log = (folder / "press.gauge.csv").string();
  const ProgramRun run = run_shell(
      "(while [ ! -s '" + log +
      "' ]; do sleep 0.05; done; sleep 0.3; echo 1,5; sleep 0.2; echo 'y 250 g'; echo nonsense; "
      "echo) | '" ALLTACT_PROGRAM "' record '" +
      (folder / "s.yaml").string() + "' -o '" + (folder / "press.mkv").string() +
      "' --seconds 5 --gauge typed");
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("2 gauge readings in"));
  EXPECT_THAT(run.errors, HasSubstr("'nonsense' is not a reading"));
  const auto gauge = ForceGauge::load(log);
  ASSERT_TRUE(gauge) << gauge.error().sentence();
  ASSERT_EQ(gauge->readings.size(), 3U) << text_of(log);
  EXPECT_TRUE(gauge->is_on_frame_clock);
  EXPECT_TRUE(gauge->readings[0].holds);
  EXPECT_EQ(gauge->readings[0].force_N.x(), 1.5);
  EXPECT_NEAR(gauge->readings[1].force_N.y(), 2.4516625, 1e-6);
  EXPECT_EQ(gauge->readings[1].block, "typed 2");
  EXPECT_FALSE(gauge->readings[2].has_force);
  // On the scene's clock, which begins at 0 with the recording.
  EXPECT_GT(gauge->readings[0].time_s, 0);
  EXPECT_LT(gauge->readings[1].time_s, 5.5);
}

TEST(RecordGauge, ASerialGaugeIsReadAsLongAsTheRecordingRuns) {
  const TemporaryFolder folder;
  write_scene(folder / "s.yaml");
  const SerialLine line;
  std::atomic<bool> is_over{false};
  std::thread gauge([&] {
    for (int i = 0; !is_over; ++i) {
      const std::string asked = line.hear(20);
      if (!asked.empty()) line.say(i % 7 == 3 ? "OVER\r\n" : "0.25 lbF\r\n");
    }
  });
  const ProgramRun run = record(folder / "s.yaml", folder / "v.mkv",
                                {"--seconds", "3", "--gauge", "serial:" + line.node(),
                                 "--gauge-model", "mark10", "--gauge-direction", "-y", "--json"});
  is_over = true;
  gauge.join();
  ASSERT_EQ(run.status, 0) << run.errors;
  const json answer = json::parse(run.output);
  EXPECT_EQ(answer.at("gauge"), (folder / "v.gauge.csv").string());
  EXPECT_GT(answer.at("readings").get<int>(), 5);
  const auto told = ForceGauge::load(folder / "v.gauge.csv");
  ASSERT_TRUE(told) << told.error().sentence();
  int over = 0;
  for (const GaugeReading& reading : told->readings) {
    if (reading.has_force)
      EXPECT_NEAR(reading.force_N.y(), -0.25 * 4.4482216, 1e-5);
    else
      ++over;
  }
  EXPECT_GT(over, 0);
  EXPECT_EQ(static_cast<int>(told->readings.size()) - over, answer.at("readings").get<int>());
}

TEST(RecordGauge, WhatCannotBeReadIsSaidBeforeAnythingIsRecorded) {
  const TemporaryFolder folder;
  write_scene(folder / "s.yaml");
  const auto refused = [&](const std::vector<std::string>& options, int status, const char* words) {
    const ProgramRun run = record(folder / "s.yaml", folder / "v.mkv", options);
    EXPECT_EQ(run.status, status) << words;
    EXPECT_THAT(run.errors, HasSubstr(words));
    EXPECT_FALSE(fs::exists(folder / "v.mkv"));
    EXPECT_FALSE(fs::exists(folder / "v.gauge.csv"));
  };
  refused({"--gauge", "serial:/dev/ttyNone"}, 1, "no such serial line");
  refused({"--gauge", "hid:ffff:ffff", "--gauge-report", "at=1"}, 1, "HID device");
  refused({"--gauge", "scale"}, 1, "'scale' is not a gauge");
  refused({"--gauge", "typed", "--gauge-model", "mark10"}, 1, "only to a serial gauge");
  refused({"--gauge-unit", "g"}, 2, "--gauge");
  refused({"--gauge", "serial:/dev/ttyS0", "--gauge-baud", "123"}, 2, "123");
}

}  // namespace
}  // namespace alltact::test
