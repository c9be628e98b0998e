#include "calibration/finger/press_notes.h"

#include "core/io/atomic_file.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

PressNotes some_notes() {
  PressNotes notes;
  notes.ball_radius_mm = 3.975;
  notes.operator_name = "Ada \"the first\": Lovelace";
  notes.other_balls = {{"12", 6.0}};
  notes.depths = {{"12", {1.25, 0.0125}}};
  notes.steps = {{"press_1", 0.5}};
  notes.balls = {{"it's, a [press]", {1.25, -2, 48.0625}}, {"12", {0, 0, 1e-3}}};
  notes.excluded = {{"press_0", "glove in view"}, {"press_1", ""}};
  return notes;
}

TEST(PressNotes, ComeBackAsTheyWereWritten) {
  for (const PressNotes& notes : {some_notes(), PressNotes()}) {
    const auto back = PressNotes::parse(notes.to_yaml(), "f");
    ASSERT_TRUE(back.ok()) << back.error().sentence();
    EXPECT_EQ(*back, notes);
  }
}

TEST(PressNotes, EveryTruncationIsToldInASentence) {
  const std::string whole = some_notes().to_yaml();
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
    const auto notes = PressNotes::parse(whole.substr(0, length), "the/file.yaml");
    if (notes.ok()) {
      // Cut between two keys it is a file that says less; never one that says something else.
      EXPECT_TRUE(notes->excluded.empty());
      continue;
    }
    EXPECT_THAT(notes.error().sentence(), HasSubstr("the/file.yaml"));
  }
}

TEST(PressNotes, SpoiltValuesAreNamed) {
  const auto refused = [](const std::string& rest, const char* key) {
    const auto notes =
        PressNotes::parse("format: alltact-press-notes/1\n" + rest + "\n", "notes.yaml");
    ASSERT_FALSE(notes.ok()) << rest;
    EXPECT_THAT(notes.error().sentence(), HasSubstr(key)) << rest;
  };
  refused("ball_radius_mm: -4", "ball_radius_mm");
  refused("balls: [a]\nballs_mm: []", "balls_mm");
  refused("balls: [a]\nballs_mm: [[1, 2]]", "balls_mm");
  refused("balls: [a]\nballs_mm: [[1, 2, -3]]", "balls_mm");
  refused("balls: [a]\nballs_mm: [[1, .inf, 3]]", "balls_mm");
  refused("depths: [a]\ndepths_mm: [[1]]", "depths_mm");
  refused("depths: [a]\ndepths_mm: [[1, 0]]", "depths_mm");
  refused("depths: [a]\ndepths_mm: []", "depths_mm");
  refused("steps: [a]\nsteps_mm: [-0.5]", "steps_mm");
  refused("excluded: [a]\nexcluded_because: []", "excluded_because");
  EXPECT_FALSE(PressNotes::parse("format: other/9\n", "notes.yaml").ok());
}

TEST(PressNotes, WhatWasSaidLastCounts) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(PressNotes::load(folder.path()).value(), PressNotes());
  ASSERT_TRUE(some_notes().save(folder.path()).ok());
  EXPECT_EQ(PressNotes::load(folder.path()).value(), some_notes());

  CalibrationInputs inputs;
  inputs.date = "2026-01-31T12:00:00Z";
  inputs.program_version = "0.1.0";
  inputs.ball_radius_mm = 5;
  inputs.finger_checksum = inputs.reference_checksum = "0123456789abcdef";
  inputs.presses = {{"p", "0000000000000001"}};
  inputs.balls = {{"p", {1, 2, 3}}};
  const fs::path file = folder.path() / CalibrationInputs::kFileName;
  ASSERT_TRUE(write_file_atomically(file, inputs.to_yaml()).ok());
  const auto notes_time = fs::last_write_time(folder.path() / PressNotes::kFileName);
  fs::last_write_time(file, notes_time + std::chrono::seconds(1));
  const auto calibrated = PressNotes::load(folder.path()).value();
  EXPECT_EQ(calibrated.ball_radius_mm, 5);
  EXPECT_EQ(calibrated.balls, inputs.balls);
  fs::last_write_time(file, notes_time - std::chrono::seconds(1));
  EXPECT_EQ(PressNotes::load(folder.path()).value(), some_notes());
}

TEST(PressNotes, KeptPressesAreThePicturesInTheirFolder) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(kept_presses(folder.path()).value().empty());
  fs::create_directories(folder.path() / kPressFolder);
  EXPECT_TRUE(kept_presses(folder.path()).value().empty());
  for (const char* name : {"b.png", "a.png", "notes.txt"})
    ASSERT_TRUE(write_file_atomically(folder.path() / kPressFolder / name, "x").ok());
  const auto files = kept_presses(folder.path()).value();
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].filename(), "a.png");
}

}  // namespace
}  // namespace alltact
