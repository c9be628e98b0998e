// Recordings with touches at random: none deeper than 0.1 mm is installed, and few clean frames are
// left out. A few by default; `packaging/test --slow` draws a thousand and two hundred clean ones.
#include "calibration/reference/reference_recording.h"
#include "core/numerics/parts.h"
#include "tests/support/marked_recording.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/slow_run.h"
#include "tests/support/touched_recording.h"

#include <cstdio>

#include <gmock/gmock.h>

namespace alltact {
namespace {

using test::TouchedRecording;

constexpr double kDeep_mm = 0.1;

struct Outcome {
  int deep = 0, deep_left_in = 0;
  int clean = 0, clean_left_out = 0;

  Outcome& operator+=(const Outcome& other) {
    deep += other.deep, deep_left_in += other.deep_left_in;
    clean += other.clean, clean_left_out += other.clean_left_out;
    return *this;
  }
  [[nodiscard]] double lost() const {
    return clean > 0 ? static_cast<double>(clean_left_out) / clean : 0.0;
  }
};

Result<ReferenceReport> installed(const TouchedRecording& recording,
                                  Finger& finger,
                                  const ReferenceChoices& choices = {}) {
  const Plan plan = recording.plan();
  test::MemorySource source;
  source.pictures.resize(static_cast<std::size_t>(recording.frames));
  over_parts(recording.frames, all_cores(), [&](int first, int last) {
    for (int i = first; i < last; ++i)
      source.pictures[static_cast<std::size_t>(i)] = plan.render(i);
  });
  finger = plan.finger();
  return install_reference(source, test::scratch_folder("clean_reference"), finger, Job{}, choices);
}

bool is_left_out(const ReferenceReport& report, int frame) {
  return std::any_of(report.stretches.begin(), report.stretches.end(), [&](const auto& stretch) {
    return !stretch.is_kept && stretch.first <= frame && frame <= stretch.last;
  });
}

Outcome outcome_of(const TouchedRecording& recording) {
  Finger finger;
  const auto report = installed(recording, finger);
  EXPECT_TRUE(report.ok()) << recording.description() << ": " << report.error().sentence();
  Outcome outcome;
  if (!report) return outcome;
  for (int i = 0; i < recording.frames; ++i) {
    const double depth_mm = recording.depth_at(i);
    const bool out = is_left_out(*report, i);
    outcome.deep += depth_mm > kDeep_mm;
    outcome.deep_left_in += depth_mm > kDeep_mm && !out;
    outcome.clean += depth_mm == 0;
    outcome.clean_left_out += depth_mm == 0 && out;
  }
  if (outcome.deep_left_in > 0 || outcome.lost() > 0.05)
    std::printf("[ figures  ] %s: %d of %d deep left in, %d of %d clean left out\n",
                recording.description().c_str(),
                outcome.deep_left_in,
                outcome.deep,
                outcome.clean_left_out,
                outcome.clean);
  return outcome;
}

void print(const char* what, const Outcome& all) {
  std::printf(
      "[ figures  ] %s: %d of %d frames deeper than 0.1 mm left in, %.2f %% of %d clean left "
      "out\n",
      what,
      all.deep_left_in,
      all.deep,
      100 * all.lost(),
      all.clean);
}

TEST(CleanReference, NothingThatPressesAtRandomIsInstalled) {
  Outcome all;
  const int runs = test::as_many_as(6, 1000);
  for (int i = 0; i < runs; ++i)
    all += outcome_of(test::drawn_recording(1 + static_cast<std::uint64_t>(i), true));
  print("touched at random", all);
  EXPECT_EQ(all.deep_left_in, 0);
  EXPECT_LT(all.lost(), 0.03);  // beside touches, whose fading ends are not told from noise
}

TEST(CleanReference, FramesOfUntouchedRecordingsStay) {
  Outcome all;
  const int runs = test::as_many_as(3, 200);
  for (int i = 0; i < runs; ++i)
    all += outcome_of(test::drawn_recording(100001 + static_cast<std::uint64_t>(i), false));
  print("untouched", all);
  EXPECT_LT(all.lost(), 0.02);
}

TEST(CleanReference, SlowTouchesInHalfOfTheFramesFromTheFirstOnAreFound) {
  Outcome all;
  const int runs = test::as_many_as(3, 100);
  for (int i = 0; i < runs; ++i)
    all += outcome_of(test::half_touched_recording(200001 + static_cast<std::uint64_t>(i)));
  print("half touched", all);
  EXPECT_GT(all.deep, 60 * runs);
  EXPECT_EQ(all.deep_left_in, 0);
  EXPECT_LT(all.lost(), 0.02);
}

TEST(CleanReference, StretchesAreNamedAndChoicesHonoured) {
  TouchedRecording recording = test::half_touched_recording(200001);
  recording.touches.resize(1);  // frames 0 to 29
  recording.touches[0].s_mm = recording.touches[0].to_s_mm = 50;
  Finger finger;
  const auto report = installed(recording, finger);
  ASSERT_TRUE(report.ok()) << report.error().sentence();
  ASSERT_FALSE(report->stretches.empty());
  const ReferenceStretch& stretch = report->stretches.front();
  EXPECT_NEAR(stretch.first, 0, 4);
  EXPECT_NEAR(stretch.last, 29, 4);
  EXPECT_NEAR(stretch.along_mm, 50, 6);  // the grid begins a little before the face's base
  EXPECT_GT(stretch.darker, 0.02);
  EXPECT_THAT(report->rejected,
              ::testing::Contains(::testing::Property(
                  &Message::english,
                  ::testing::HasSubstr(
                      fmt::format("frames {} to {}: something", stretch.first, stretch.last)))));
  ReferenceChoices choices;
  choices.keep = {{0, 40}};
  choices.leave_out = {{100, 119}};
  const auto chosen = installed(recording, finger, choices);
  ASSERT_TRUE(chosen.ok()) << chosen.error().sentence();
  EXPECT_TRUE(chosen->stretches.front().is_kept);
  EXPECT_FALSE(is_left_out(*chosen, 10));
  // Some of the frames that are left out show no face, and are left out in both.
  EXPECT_NEAR(chosen->frames_kept + chosen->repeated,
              report->frames_kept + report->repeated + (stretch.last - stretch.first + 1) - 20,
              8);
}

TEST(CleanReference, ARecordingThatIsMostlyTouchedIsNeverCalledClean) {
  TouchedRecording recording = test::half_touched_recording(200002);
  recording.touches.resize(1);
  test::DrawnTouch& touch = recording.touches[0];
  touch.profile = test::TouchProfile::kAbrupt;
  touch.first = 0, touch.end = 160;
  touch.depth_mm = 0.8;
  Finger finger;
  const auto report = installed(recording, finger);
  ASSERT_TRUE(report.ok()) << report.error().sentence();
  EXPECT_FALSE(report->stretches.empty());
}

}  // namespace
}  // namespace alltact
