// Recordings with touches at random: hardly a frame deeper than 0.1 mm is installed, and few clean
// ones are left out. A few by default; `packaging/test --slow` draws a thousand and two hundred
// clean ones.
#include "calibration/reference/reference_recording.h"
#include "core/numerics/parallel.h"
#include "tests/support/contact_recording.h"
#include "tests/support/marked_recording.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/slow_run.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include <gmock/gmock.h>

namespace alltact {
namespace {

using test::TouchedRecording;

constexpr double kDeep_mm = 0.1;
constexpr double kPlain_mm = 0.15;  // ends of touches are less deep
// Of frames deeper than kDeep_mm in a slow run. None is wanted; seeds 1001 to 2000 left 1.3 % in:
// touches of 0.3 mm that last for a third of the recording, in poses that hardly any other frame
// shows, and ends of touches.
constexpr double kMostLeftIn = 0.02;

struct Outcome {
  int deep = 0, deep_left_in = 0, plain_left_in = 0;
  int clean = 0, clean_left_out = 0;

  Outcome& operator+=(const Outcome& other) {
    deep += other.deep, deep_left_in += other.deep_left_in;
    plain_left_in += other.plain_left_in;
    clean += other.clean, clean_left_out += other.clean_left_out;
    return *this;
  }
  [[nodiscard]] double lost() const {
    return clean > 0 ? static_cast<double>(clean_left_out) / clean : 0.0;
  }
};

test::MemorySource rendered(const TouchedRecording& recording, const Plan& plan) {
  test::MemorySource source;
  source.images.resize(static_cast<std::size_t>(recording.frames));
  parallel_for(recording.frames, default_threads(), [&](int first, int last) {
    for (int i = first; i < last; ++i) source.images[static_cast<std::size_t>(i)] = plan.render(i);
  });
  return source;
}

Result<ReferenceReport> installed(const TouchedRecording& recording, Finger& finger,
                                  const ReferenceChoices& choices = {}) {
  const Plan plan = recording.plan();
  test::MemorySource source = rendered(recording, plan);
  finger = plan.finger();
  return install_reference(source, test::scratch_folder("clean_reference"), finger, Job{}, choices);
}

/// Of a finger that was recorded untouched before, with other light and noise.
Result<ReferenceReport> installed_again(const TouchedRecording& before,
                                        const TouchedRecording& recording,
                                        const ReferenceChoices& choices = {}) {
  const std::filesystem::path folder = test::scratch_folder("clean_reference_again");
  const Plan first = before.plan();
  test::MemorySource source = rendered(before, first);
  Finger finger = first.finger();
  const auto report = install_reference(source, folder, finger, Job{});
  if (!report) return report.error();
  test::MemorySource again = rendered(recording, recording.plan());
  return install_reference(again, folder, finger, Job{}, choices);
}

bool is_left_out(const ReferenceReport& report, int frame) {
  return std::any_of(report.stretches.begin(), report.stretches.end(), [&](const auto& stretch) {
    return !stretch.is_retained && stretch.first <= frame && frame <= stretch.last;
  });
}

/// It shows no face or too few markers.
bool is_unusable(const ReferenceReport& report, int frame) {
  return std::any_of(report.rejected.begin(), report.rejected.end(), [&](const Message& reason) {
    return reason.english().starts_with(fmt::format("frame {}: ", frame));
  });
}

Outcome outcome_of(const TouchedRecording& recording, const TouchedRecording* before = nullptr) {
  Finger finger;
  const auto report = before ? installed_again(*before, recording) : installed(recording, finger);
  EXPECT_TRUE(report.ok()) << recording.description() << ": " << report.error().sentence();
  Outcome outcome;
  if (!report) return outcome;
  std::string stretches, left_in;
  for (int i = 0; i < recording.frames; ++i) {
    const double depth_mm = recording.depth_at(i);
    const bool out = is_left_out(*report, i);
    outcome.deep += depth_mm > kDeep_mm;
    const bool is_installed = !out && !is_unusable(*report, i);
    outcome.deep_left_in += depth_mm > kDeep_mm && is_installed;
    outcome.plain_left_in += depth_mm > kPlain_mm && is_installed;
    if (depth_mm > kDeep_mm && is_installed) left_in += fmt::format(" {}", i);
    outcome.clean += depth_mm == 0;
    outcome.clean_left_out += depth_mm == 0 && out;
  }
  for (const ReferenceStretch& stretch : report->stretches)
    stretches += fmt::format(" {}-{}{} ({:.0f} mm, {:+.0f} mm, {:.1f} %)", stretch.first,
                             stretch.last, stretch.is_doubtful ? "?" : "", stretch.along_mm,
                             stretch.across_mm, 100 * stretch.darker);
  if (outcome.deep_left_in > 0 || outcome.lost() > 0.05 || std::getenv("ALLTACT_RECORDINGS"))
    std::printf("[ figures  ] %s:%s: %d (%s) of %d deep left in, %d of %d clean left out\n",
                recording.description().c_str(), stretches.c_str(), outcome.deep_left_in,
                left_in.c_str(), outcome.deep, outcome.clean_left_out, outcome.clean);
  return outcome;
}

void print(const char* what, const Outcome& all) {
  std::printf(
      "[ figures  ] %s: %d of %d frames deeper than 0.1 mm left in, %d of them deeper than 0.15 "
      "mm; "
      "%.2f %% of %d clean left out\n",
      what, all.deep_left_in, all.deep, all.plain_left_in, 100 * all.lost(), all.clean);
}

/// Development seeds are 1 to 120; the statement is made on 1001 to 2000, which are drawn for
/// nothing else. ALLTACT_RECORDINGS=FIRST-LAST runs others.
std::pair<std::uint64_t, std::uint64_t> seeds_of_touches() {
  std::uint64_t first = test::is_slow_run() ? 1001 : 1, last = test::is_slow_run() ? 2000 : 6;
  if (const char* text = std::getenv("ALLTACT_RECORDINGS")) {
    EXPECT_EQ(std::sscanf(text, "%lu-%lu", &first, &last), 2) << text;
  }
  return {first, last};
}

TEST(CleanReference, NothingThatPressesAtRandomIsInstalled) {
  Outcome all;
  const auto [first, last] = seeds_of_touches();
  for (std::uint64_t seed = first; seed <= last; ++seed)
    all += outcome_of(test::drawn_recording(seed, true));
  print("touched at random", all);
  EXPECT_LE(all.deep_left_in, test::is_slow_run() ? kMostLeftIn * all.deep : 0);
  EXPECT_LT(all.lost(), 0.02);
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
  EXPECT_NEAR(stretch.along_mm, 50, 2.5);
  EXPECT_GT(stretch.darker, 0.02);
  EXPECT_THAT(
      report->rejected,
      ::testing::Contains(::testing::Property(
          &Message::english, ::testing::HasSubstr(fmt::format("frames {} to {}: something",
                                                              stretch.first, stretch.last)))));
  ReferenceChoices choices;
  choices.keep = {{0, 40}};
  choices.leave_out = {{100, 119}};
  const auto chosen = installed(recording, finger, choices);
  ASSERT_TRUE(chosen.ok()) << chosen.error().sentence();
  EXPECT_TRUE(chosen->stretches.front().is_retained);
  EXPECT_FALSE(is_left_out(*chosen, 10));
  for (std::size_t i = 100; i < 120; ++i)
    EXPECT_THAT(chosen->uses[i],
                ::testing::AnyOf(FrameUse::kExcluded, FrameUse::kUnusable))  // without a face
        << i;
  // Some of the frames that are left out show no face, and are left out in both.
  EXPECT_NEAR(chosen->frames_retained + chosen->repeated,
              report->frames_retained + report->repeated + (stretch.last - stretch.first + 1) - 20,
              8);
  choices.leave_out = {{stretch.first, stretch.last}};
  const auto left_out = installed(recording, finger, choices);
  ASSERT_TRUE(left_out.ok()) << left_out.error().sentence();
  EXPECT_LT(left_out->frames_retained + left_out->repeated,
            chosen->frames_retained + chosen->repeated)
      << "leaving out wins over keeping";
}

TEST(CleanReference, AReferenceFromBeforeAccusesNoUntouchedFrame) {
  Outcome all;
  const int runs = test::as_many_as(3, 100);
  for (int i = 0; i < runs; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const TouchedRecording before = test::drawn_recording(300001 + 2 * seed, false);
    all += outcome_of(test::drawn_recording(300002 + 2 * seed, false), &before);
  }
  print("untouched, recorded again", all);
  EXPECT_LT(all.lost(), 0.02);
}

/// Pressed all the time at one place, which no frame of the recording itself tells.
TouchedRecording pressed_all_the_time(std::uint64_t seed) {
  TouchedRecording recording = test::drawn_recording(seed, true);
  recording.touches.resize(1);
  test::DrawnTouch& touch = recording.touches[0];
  touch.profile = test::TouchProfile::kAbrupt;
  touch.first = 0, touch.end = recording.frames;
  touch.depth_mm = std::max(touch.depth_mm, 0.25);
  touch.to_s_mm = touch.s_mm;
  return recording;
}

TEST(CleanReference, WhatPressesAllTheTimeIsRefusedWhereThereIsAReferenceFromBefore) {
  int found = 0;
  const int runs = test::as_many_as(4, 100);
  for (int i = 0; i < runs; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const TouchedRecording before = test::drawn_recording(400001 + 2 * seed, false);
    const TouchedRecording recording = pressed_all_the_time(400002 + 2 * seed);
    const auto refused = installed_again(before, recording);
    found += !refused.ok();
    if (refused.ok()) std::printf("[ figures  ] not found: %s\n", recording.description().c_str());
  }
  std::printf("[ figures  ] pressed all the time: %d of %d refused\n", found, runs);
  EXPECT_GE(found, 0.9 * runs);
}

TEST(CleanReference, ARefusalNamesThePlaceAndLeavesAPicture) {
  const TouchedRecording before = test::drawn_recording(500001, false);
  TouchedRecording recording = pressed_all_the_time(500002);
  recording.touches[0].s_mm = recording.touches[0].to_s_mm = 52;
  const auto refused = installed_again(before, recording);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().sentence(),
              ::testing::AllOf(::testing::HasSubstr("something pressed on the contact face 5"),
                               ::testing::HasSubstr(kReferenceProblem)));
  ReferenceChoices choices;
  choices.skin_was_changed = true;
  const auto kept = installed_again(before, recording, choices);
  ASSERT_TRUE(kept.ok()) << kept.error().sentence();
  EXPECT_EQ(kept->contact_frames, 0);
}

TEST(CleanReference, OtherLightIsNoTouch) {
  const TouchedRecording before = test::drawn_recording(600001, false);
  TouchedRecording recording = test::drawn_recording(600002, false);
  recording.lamp_power = 0.8;
  recording.lamp_moved_mm = 2;
  Outcome all = outcome_of(recording, &before);
  print("with other light", all);
  EXPECT_LT(all.lost(), 0.02);
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
