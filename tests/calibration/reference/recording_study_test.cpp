// What is found out about a recording, against what was put into it.
#include "calibration/reference/make_reference.h"
#include "calibration/reference/recording_pass.h"
#include "calibration/reference/reference_recording.h"
#include "core/base/atomic_file.h"
#include "core/live/recording_feed.h"
#include "core/recording/video_file.h"
#include "core/sources/file_source.h"
#include "tests/support/marked_recording.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <future>
#include <optional>
#include <random>
#include <set>

#include <gmock/gmock.h>

namespace alltact {
namespace {

using test::Bend;
using test::described;
using test::MarkedFinger;
using test::MemorySource;
using test::scratch_folder;
using test::small_finger;

/// Poses that are visited again and again, each time a little otherwise.
Bend loop(int i, int frames_a_loop) {
  const double t = 2 * M_PI * i / frames_a_loop;
  return {0.3 * std::sin(t), 0.1 * std::sin(2.03 * t + 1), 5 * std::cos(3.01 * t),
          0.02 * std::sin(1.7 * t)};
}

/// A disc of the face is darker: something presses there.
MarkedFinger::Extra dent(const MarkedFinger& f, const cv::Mat& image, double u, double radius_px,
                         double darker) {
  const double v = 0.5 * (f.height - 1);
  const double level = image.at<float>(static_cast<int>(v), static_cast<int>(u));
  return {{u, v, radius_px, radius_px}, level * (1.0 - darker)};
}

std::set<int> numbers_of(const ReferenceReport& report) {
  std::set<int> numbers;
  for (const ReferenceStretch& stretch : report.stretches)
    for (int i = stretch.first; i <= stretch.last; ++i) numbers.insert(i);
  return numbers;
}

TEST(RecordingStudy, FramesWithSomethingOnTheFaceAreLeftOutAndNoOthers) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(21);
  MemorySource source;
  std::set<int> touched;
  constexpr int kFrames = 160;
  for (int i = 0; i < kFrames; ++i) {
    const Bend bend = loop(i, 40);
    std::vector<MarkedFinger::Extra> extras;
    // One long touch, and a short one elsewhere.
    if ((i >= 50 && i < 62) || (i >= 120 && i < 123)) {
      extras.push_back(dent(f, f.clean(bend), i < 100 ? 180 : 120, 14, 0.12));
      touched.insert(i);
    }
    source.images.push_back(f.with_noise(f.clean(bend, {}, extras), random));
  }
  Finger finger = described(f);
  const auto report = install_reference(source, scratch_folder("touched"), finger, Job{});
  ASSERT_TRUE(report.ok()) << report.error().sentence();
  const std::set<int> found = numbers_of(*report);
  EXPECT_THAT(
      report->rejected,
      ::testing::Contains(::testing::Property(
          &Message::english, ::testing::HasSubstr("something pressed on the contact face"))));
  EXPECT_TRUE(std::includes(found.begin(), found.end(), touched.begin(), touched.end()));
  // A frame in a pose of its own just before or after a touch may go with it.
  for (const int i : found)
    EXPECT_TRUE(touched.contains(i) || touched.contains(i - 1) || touched.contains(i + 1)) << i;
  EXPECT_LE(found.size(), touched.size() + 2);
  EXPECT_EQ(report->frames_retained + report->repeated + static_cast<int>(found.size()), kFrames);
  const auto count = [&](FrameUse use) {
    return static_cast<int>(std::count(report->uses.begin(), report->uses.end(), use));
  };
  EXPECT_EQ(std::ssize(report->uses), kFrames);
  EXPECT_EQ(count(FrameUse::kRetained), report->frames_retained);
  EXPECT_EQ(count(FrameUse::kRepeatsPose), report->repeated);
  for (const int i : found)
    EXPECT_EQ(report->uses[static_cast<std::size_t>(i)], FrameUse::kInContact) << i;
  // The light falls off smoothly and the poses lie close: the rest is told to a thousandth.
  EXPECT_LT(report->error_median, 0.003);
  EXPECT_GE(report->error_median_mm, report->error_median * finger.face.layer_mm);
}

TEST(RecordingStudy, AFingerAtRestIsKeptOnce) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(22);
  MemorySource source;
  constexpr int kResting = 60, kMoving = 120;
  for (int i = 0; i < kResting + kMoving; ++i)
    source.images.push_back(f.with_noise(f.clean(loop(std::max(0, i - kResting), 120)), random));
  Finger finger = described(f);
  const auto report = install_reference(source, scratch_folder("resting"), finger, Job{});
  ASSERT_TRUE(report.ok()) << report.error().sentence();
  EXPECT_GT(report->repeated, kResting / 2);
  EXPECT_GT(report->frames_retained, kMoving / 2);
}

/// Of a video, but it does not tell which file that is.
class PlainSource : public Source {
 public:
  explicit PlainSource(VideoSource& video) : video_(video) {}
  Result<FramePtr> next() override { return video_.next(); }
  std::optional<std::size_t> count() const override { return video_.count(); }
  bool is_continuous() const override { return true; }
  double frames_per_s() const override { return video_.frames_per_s(); }

 private:
  VideoSource& video_;
};

// A recording without loss is copied instead of being encoded again: the files are the same.
TEST(RecordingStudy, ALosslessRecordingIsCopied) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(24);
  const std::filesystem::path folder = scratch_folder("take"), take = folder / "take.mkv";
  std::optional<VideoWriter> writer;
  constexpr int kResting = 30, kMoving = 100;
  for (int i = 0; i < kResting + kMoving; ++i) {
    Frame frame;
    frame.grey = f.with_noise(f.clean(loop(std::max(0, i - kResting), 120)), random);
    frame.time_ns = 1'000'000'000 + 33'400'000LL * i;
    if (!writer) writer = VideoWriter::create(take, frame, VideoCodec::kMagicYuv, 30).value();
    ASSERT_TRUE(writer->add(frame).ok());
  }
  ASSERT_TRUE(writer->finish().ok());
  std::array<std::string, 2> videos;
  for (const bool is_copied : {false, true}) {
    VideoSource video(VideoFile::open(take).value(), {});
    ASSERT_EQ(video.lossless_file(), take);
    PlainSource plain(video);
    Finger finger = described(f);
    const auto installed = scratch_folder(is_copied ? "copied" : "encoded");
    const auto report = install_reference(is_copied ? static_cast<Source&>(video) : plain,
                                          installed, finger, Job{});
    ASSERT_TRUE(report.ok()) << report.error().sentence();
    EXPECT_GT(report->repeated, 0) << "not all frames are retained";
    videos[is_copied ? 1 : 0] = read_file(installed / kReferenceVideo).value();
  }
  EXPECT_EQ(videos[0].size(), videos[1].size());
  EXPECT_TRUE(videos[0] == videos[1]);
}

/// Followed from its first frame on, with choices that are made at its end. Returns the report.
ReferenceReport expect_the_same_when_followed(int frames) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(25);
  const std::filesystem::path folder = scratch_folder("followed" + std::to_string(frames)),
                              take = folder / "take.mkv";
  const auto feed = std::make_shared<RecordingFeed>(take);
  ReferenceChoices choices;
  choices.rest_frame = 7;
  choices.leave_out = {{20, 24}};
  const auto made_in = [&](Source& source, const std::string& name,
                           const ChoicesWhenRead& when_read) {
    Finger finger = described(f);
    const auto into = scratch_folder(name + std::to_string(frames));
    const auto report = install_reference(source, into, finger, Job{}, when_read);
    EXPECT_TRUE(report.ok()) << (report ? "" : report.error().sentence());
    return std::tuple(into, report.value(), finger.to_yaml().value());
  };
  const Job job;
  std::atomic<bool> is_over{false};
  auto following = std::async(std::launch::async, [&] {
    FollowedRecording followed(feed, job);
    return made_in(followed, "while", [&] {
      EXPECT_TRUE(is_over) << "choices are made at the end";
      return choices;
    });
  });
  std::optional<VideoWriter> writer;
  for (int i = 0; i < frames; ++i) {
    auto frame = std::make_shared<Frame>();
    frame->grey = f.with_noise(f.clean(loop(i, 120)), random);
    frame->time_ns = 1'000'000'000 + 33'400'000LL * i;
    if (!writer) {
      writer = VideoWriter::create(take, *frame, VideoCodec::kMagicYuv, 30).value();
      feed->begin(30, VideoCodec::kMagicYuv);
    }
    EXPECT_TRUE(writer->add(*frame).ok());
    feed->add(frame);
  }
  EXPECT_TRUE(writer->finish().ok());
  is_over = true;
  feed->end(true);
  const auto [while_in, while_report, while_yaml] = following.get();
  VideoSource video(VideoFile::open(take).value(), {});
  const auto [after_in, after_report, after_yaml] =
      made_in(video, "after", [&] { return choices; });
  EXPECT_EQ(while_yaml, after_yaml);
  EXPECT_EQ(while_report.uses, after_report.uses);
  EXPECT_EQ(while_report.error_p95, after_report.error_p95);
  EXPECT_EQ(while_report.frames_read, frames);
  for (const char* name : {kReferenceVideo, kReferenceTable})
    EXPECT_TRUE(read_file(while_in / name).value() == read_file(after_in / name).value()) << name;
  return while_report;
}

TEST(RecordingStudy, ARecordingThatIsFollowedGivesTheSameReference) {
  EXPECT_EQ(expect_the_same_when_followed(130).rest_frame, 7);
}

TEST(RecordingStudy, ALongRecordingIsThinnedWhileItRunsAsItIsFromItsFile) {
  constexpr int kFrames = kMaxExamined + 33;
  const ReferenceReport report = expect_the_same_when_followed(kFrames);
  EXPECT_EQ(report.rest_frame, 6) << "the examined frame before the requested one";
  for (int i = 0; i < kFrames; ++i) {
    const FrameUse use = report.uses[static_cast<std::size_t>(i)];
    if (i % 2 == 1)
      EXPECT_EQ(use, FrameUse::kRepresented) << i;
    else if (i >= 20 && i <= 24)
      EXPECT_EQ(use, FrameUse::kExcluded) << i;
    else
      EXPECT_TRUE(use == FrameUse::kRetained || use == FrameUse::kRepeatsPose) << i;
  }
}

TEST(RecordingStudy, BendingIsMeasuredInMillimetres) {
  const MarkedFinger f = small_finger();
  std::mt19937 random(23);
  MemorySource source;
  // Sideways only: 4 mm at the tip each way.
  for (int i = 0; i < 40; ++i)
    source.images.push_back(
        f.with_noise(f.clean({0, 0, 4.0 * std::sin(2 * M_PI * i / 40), 0}), random));
  Finger finger = described(f);
  const auto report = install_reference(source, scratch_folder("swaying"), finger, Job{});
  ASSERT_TRUE(report.ok()) << report.error().sentence();
  // Told where the picture shows the face between the last dots before its end.
  const auto points = f.arc({0, 0, 4.0, 0});
  const auto dots = f.discs({0, 0, 4.0, 0});
  const double end = f.project(points.back().x, 0, points.back().z).x();
  double last = 0, sway = 0;
  for (int i = 0; i < f.per_row; ++i)
    if (const double u = dots[static_cast<std::size_t>(i)].u; u < std::min(end, f.width - 1.0))
      last = u;
  for (const auto& point : points)
    if (f.project(point.x, point.y, point.z).x() < last) sway = point.y;
  EXPECT_GT(sway, 1.0);
  EXPECT_NEAR(report->coverage.sway_mm().most, sway, 0.03 * sway);
  EXPECT_NEAR(report->coverage.sway_mm().least, -sway, 0.03 * sway);
  EXPECT_LT(report->coverage.bend_mm().most, 0.3);
  EXPECT_THAT(report->remarks, ::testing::Contains(::testing::Property(
                                   &Message::english, ::testing::HasSubstr("bend it further"))));
}

}  // namespace
}  // namespace alltact
