// Live use for a while, as at a bench: a camera with faults, a finger measured from its newest
// frame, one recording after the other, a finger calibrated again and again, a slow onlooker.
// ALLTACT_SOAK_SECONDS makes it longer; then its figures lie in ALLTACT_SOAK_FILE.
#include "calibration/reference/reference_recording.h"
#include "core/devices/v4l2_camera.h"
#include "core/recording/journal.h"
#include "core/recording/recorder.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/result_json.h"
#include "tests/rigs/fake_camera.h"
#include "tests/support/flat_calibration.h"
#include "tests/support/marked_finger.h"
#include "tests/support/process_figures.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

#include <cstdlib>
#include <fstream>
#include <random>

#include <gtest/gtest.h>
#include <malloc.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact {
namespace {

using namespace std::chrono_literals;
using test::Bend;
using test::MarkedFinger;
using Clock = std::chrono::steady_clock;

std::chrono::seconds duration() {
  const char* text = std::getenv("ALLTACT_SOAK_SECONDS");
  return std::chrono::seconds(text == nullptr ? 6 : std::atoi(text));
}

class Pictures : public Source {
 public:
  std::vector<cv::Mat> images;
  Result<FramePtr> next() override {
    if (at_ == images.size()) return FramePtr();
    auto frame = std::make_shared<Frame>();
    frame->grey = images[at_++];
    return FramePtr(std::move(frame));
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return images.size(); }
  [[nodiscard]] bool is_continuous() const override { return true; }

 private:
  std::size_t at_ = 0;
};

/// A small finger that bends to and fro, with a reference and a mapping; and what its camera sends
/// while something dark is pressed against it.
struct Bench {
  static constexpr int kPoses = 48;
  test::TemporaryFolder folder;
  Finger finger;
  test::FakeOptions camera;

  Bench() {
    MarkedFinger drawn;
    drawn.width = 480, drawn.height = 270, drawn.focal = 262, drawn.dot_mm = 0.9, drawn.noise = 0.4;
    std::mt19937 random(11);
    Pictures recording;
    for (int i = 0; i < kPoses; ++i) {
      const double t = 2 * M_PI * i / kPoses;
      const Bend bend{0.35 * std::sin(t), 0.2 * std::sin(2 * t + 1), 6 * std::cos(3 * t), 0};
      recording.images.push_back(drawn.with_noise(drawn.clean(bend), random));
      const cv::Mat touched = drawn.with_noise(
          drawn.clean(bend, {}, {{{0.5 * drawn.width, 0.5 * drawn.height, 14, 14}, 60}}), random);
      camera.packets.emplace_back();
      cv::imencode(".jpg", touched, camera.packets.back(), {cv::IMWRITE_JPEG_QUALITY, 95});
    }
    camera.sizes = {{480, 270}};
    camera.rates = {60};
    finger.name = "drawn";
    finger.camera = drawn.camera();
    finger.face = drawn.face();
    finger.markers = {drawn.per_row, Polarity::kAuto};
    const auto report = install_reference(recording, folder.path(), finger, Job());
    EXPECT_TRUE(report.ok()) << report.error().sentence();
    finger.mapping.emplace();
    finger.mapping->kind = MappingKind::kMoebius;
    finger.mapping->x_max = 0.7;
    finger.mapping->a_mm = 1.5;
    finger.mapping->b = 0.5;
  }
};

/// What `alltact reconstruct --live` does: the newest frame, measured, as a line.
void measure(V4l2Camera& camera, Pipeline& pipeline, std::size_t& measured, std::size_t& touched,
             const std::atomic<bool>& is_over) {
  LatestFrameReader reader = camera.frames().reader();
  while (!is_over) {
    const FramePtr frame = reader.next(500ms);
    if (frame == nullptr) continue;
    const auto result = pipeline(frame);
    ASSERT_TRUE(result.ok()) << result.error().sentence();
    ASSERT_FALSE(result_line(*result, measured, pipeline.settings().reference).empty());
    touched += result->regions.empty() ? 0 : 1;
    ++measured;
  }
}

/// What recordings came to, and frames of which nothing tells.
struct Recorded {
  std::uint64_t frames = 0, dropped = 0, missing = 0, silent = 0;
};

/// Every number between the first frame of a recording and its last is in it or told as lost.
void account_for(const std::filesystem::path& video, const RecorderCounts& counts, Recorded& all) {
  const auto entries = read_journal(journal_of(video));
  ASSERT_TRUE(entries.ok()) << entries.error().sentence();
  EXPECT_EQ(entries->size(), counts.recorded);
  all.frames += counts.recorded, all.dropped += counts.dropped, all.missing += counts.missing;
  if (entries->empty()) return;
  const std::uint64_t numbers = entries->back().sequence - entries->front().sequence + 1;
  const std::uint64_t told = counts.recorded + counts.dropped + counts.missing;
  all.silent += numbers > told ? numbers - told : 0;
}

/// What `alltact record` does, again and again, packets and grey in turn.
void record(const std::shared_ptr<V4l2Camera>& camera, const test::TemporaryFolder& folder,
            Recorded& recorded, const std::atomic<bool>& is_over) {
  for (int number = 0; !is_over; ++number) {
    CameraSource source(camera);
    RecorderSettings settings;
    settings.codec = number % 2 == 0 ? VideoCodec::kMjpeg : VideoCodec::kMagicYuv;
    settings.reserve_mb = 0;
    const auto file = folder / "v.mkv";
    auto recorder = Recorder::start(file, settings, source.frames_per_s(), "soak");
    ASSERT_TRUE(recorder.ok()) << recorder.error().sentence();
    for (const auto end = Clock::now() + 2s; Clock::now() < end;) {
      auto frame = source.next();
      if (!frame.ok() || *frame == nullptr) continue;
      (void)(*recorder)->add(std::move(*frame));  // a full queue is counted
    }
    ASSERT_TRUE((*recorder)->finish("the test's").ok());
    account_for(file, (*recorder)->counts(), recorded);
    std::filesystem::remove(file);
    std::filesystem::remove(journal_of(file));
  }
}

/// What `alltact calibrate` does, again and again.
void calibrate(const test::FlatFinger& flat, int& calibrated, const std::atomic<bool>& is_over) {
  const FingerCalibrationInput input = test::flat_calibration(flat);
  while (!is_over) {
    const auto done = calibrate_finger(input, Job());
    ASSERT_TRUE(done.ok()) << done.error().sentence();
    ++calibrated;
    for (const auto end = Clock::now() + duration() / 10; Clock::now() < end && !is_over;)
      std::this_thread::sleep_for(50ms);
  }
}

/// Every fault that passes, in turn.
class Disturbance {
 public:
  explicit Disturbance(test::FakeCamera& fake) : fake_(fake) {}
  void go_on(std::chrono::milliseconds time) {
    for (const auto end = Clock::now() + time; Clock::now() < end; ++step_) {
      std::this_thread::sleep_for(25ms);
      if (step_ % 40 == 0) fake_.truncate(1);
      if (step_ % 40 == 10)
        fake_.set_from_outside(V4L2_CID_GAIN, 20 + static_cast<int>(random_() % 50));
      if (step_ % 40 == 20) fake_.skip(3);
      if (step_ % 120 == 60) fake_.unplug();
      if (step_ % 120 == 70) fake_.plug_in();
    }
  }
  void end() { fake_.plug_in(); }

 private:
  test::FakeCamera& fake_;
  std::mt19937 random_{20240611};
  int step_ = 0;
};

TEST(LiveUse, NothingGrowsAndNoFrameIsLostInSilence) {
  const Bench bench;
  const test::FlatFinger flat;
  std::filesystem::create_directory(flat.finger());
  ASSERT_TRUE(test::flat_sensor_finger(false).save(flat.finger()).ok());
  test::FakeCamera fake(bench.camera);
  auto opened = V4l2Camera::open(
      {&fake, "soak",
       [&]() -> Result<std::string> {
         if (fake.is_plugged()) return std::string("/dev/video0");
         return Error{en::say("the camera is not connected"), std::string("soak"), ""};
       }},
      {});
  ASSERT_TRUE(opened.ok());
  const std::shared_ptr<V4l2Camera> camera = std::move(*opened);
  ASSERT_TRUE(camera->lock().ok());
  auto pipeline = Pipeline::create(FingerSnapshot::of(bench.folder.path(), bench.finger).value(),
                                   PipelineSettings(), Job());
  ASSERT_TRUE(pipeline.ok()) << pipeline.error().sentence();
  std::atomic<bool> is_over{false};
  std::size_t measured = 0, touched = 0;
  Recorded recorded;
  int calibrated = 0;
  std::uint64_t seen = 0, missed = 0;
  std::thread measuring([&] { measure(*camera, *pipeline, measured, touched, is_over); });
  std::thread recording([&] { record(camera, bench.folder, recorded, is_over); });
  std::thread calibrating([&] { calibrate(flat, calibrated, is_over); });
  std::thread looking([&] {
    LatestFrameReader reader = camera->frames().reader();
    for (; !is_over; std::this_thread::sleep_for(170ms)) seen += reader.next(500ms) ? 1 : 0;
    missed = reader.missed();
  });
  Disturbance faults(fake);
  faults.go_on(4s + duration() / 10);
  constexpr int kSamples = 120;
  std::vector<test::ProcessFigures> samples;
  for (int i = 0; i < kSamples; ++i) {
    malloc_trim(0);
    samples.push_back(test::process_figures(bench.folder.path()));
    faults.go_on(std::chrono::milliseconds(duration()) / kSamples);
  }
  faults.end();
  is_over = true;
  for (std::thread* thread : {&measuring, &recording, &calibrating, &looking}) thread->join();
  test::keep_figures(samples);
  const double growth_mb = test::rise_of(samples, &test::ProcessFigures::resident_mb);
  const CameraStatus status = camera->status();
  RecordProperty("growth_mb", std::to_string(growth_mb));
  std::printf(
      "[ figures  ] %zu measured (%zu with contact), %llu recorded (%llu dropped, %llu never came, "
      "%llu in silence), %d calibrated, %llu passed over by the onlooker; memory %.1f MB, grew "
      "%.2f "
      "MB; descriptors grew %.1f, threads %.1f, files %.1f\n",
      measured, touched, static_cast<unsigned long long>(recorded.frames),
      static_cast<unsigned long long>(recorded.dropped),
      static_cast<unsigned long long>(recorded.missing),
      static_cast<unsigned long long>(recorded.silent), calibrated,
      static_cast<unsigned long long>(missed), samples.front().resident_mb, growth_mb,
      test::rise_of(samples, &test::ProcessFigures::descriptors),
      test::rise_of(samples, &test::ProcessFigures::threads),
      test::rise_of(samples, &test::ProcessFigures::files));
  // Sanitizers keep what was freed.
  if (!test::kIsSanitized) {
    EXPECT_LT(growth_mb, 5.0);
  }
  EXPECT_LT(test::rise_of(samples, &test::ProcessFigures::descriptors), 2);
  EXPECT_LT(test::rise_of(samples, &test::ProcessFigures::threads), 2);
  EXPECT_LT(test::rise_of(samples, &test::ProcessFigures::files), 1);
  EXPECT_EQ(recorded.silent, 0U);
  EXPECT_GT(calibrated, 0);
  EXPECT_GT(measured, 50U);
  EXPECT_GT(touched, measured / 2);
  EXPECT_GT(recorded.frames, 100U);
  EXPECT_GT(seen, 10U);
  EXPECT_GT(missed, seen) << "and it says so";
  EXPECT_GT(status.damaged, 0U);
  EXPECT_GT(status.lost, 0U);
  EXPECT_GT(status.unplugged, 0U);
  EXPECT_LE(status.remarks.size(), 20U);
}

}  // namespace
}  // namespace alltact
