#include "core/finger/press_set.h"

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

PressSet some_notes() {
  PressSet press_set;
  press_set.ball_radius_mm = 3.975;
  press_set.operator_name = "Ada \"the first\": Lovelace";
  PressNote& twelve = press_set.notes["12"];
  twelve.ball_radius_mm = 6.0;
  twelve.depth = GivenDepth{1.25, 0.0125};
  twelve.ball_mm = {0, 0, 1e-3};
  press_set.notes["press_1"].step_mm = 0.5;
  press_set.notes["press_1"].excluded = "";
  press_set.notes["press_2"].body = "bodies/it's a rod.stl";
  press_set.notes["it's, a [press]"].ball_mm = {1.25, -2, 48.0625};
  press_set.notes["press_0"].excluded = "glove in view";
  return press_set;
}

TEST(PressSet, SaysOnlyWhatIsSaid) {
  PressSet press_set = some_notes();
  EXPECT_EQ(press_set.radius_of("12"), 6.0);
  EXPECT_EQ(press_set.radius_of("press_1"), 3.975);
  EXPECT_TRUE(press_set.has_other_balls());
  EXPECT_EQ(press_set.of("press_9"), PressNote());
  EXPECT_EQ(press_set.only({"12", "press_9"}).notes.size(), 1U);
  PressNote note = press_set.of("12");
  note.ball_radius_mm.reset();
  press_set.say("12", note);
  EXPECT_FALSE(press_set.has_other_balls());
  press_set.say("12", {});
  EXPECT_FALSE(press_set.notes.contains("12"));
}

TEST(PressSet, ComeBackAsTheyWereWritten) {
  for (const PressSet& notes : {some_notes(), PressSet()}) {
    const auto back = PressSet::parse(notes.to_yaml(), "f");
    ASSERT_TRUE(back.ok()) << back.error().sentence();
    EXPECT_EQ(*back, notes);
  }
}

TEST(PressSet, EveryTruncationIsToldInASentence) {
  const std::string whole = some_notes().to_yaml();
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
    const auto notes = PressSet::parse(whole.substr(0, length), "the/file.yaml");
    if (notes.ok()) {
      // Cut between two keys it is a file that says less; never one that says something else.
      EXPECT_EQ(notes->of("press_0"), PressNote());
      continue;
    }
    EXPECT_THAT(notes.error().sentence(), HasSubstr("the/file.yaml"));
  }
}

TEST(PressSet, SpoiltValuesAreNamed) {
  const auto refused = [](const std::string& rest, const char* key) {
    const auto notes =
        PressSet::parse("format: alltact-press-notes/1\n" + rest + "\n", "notes.yaml");
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
  refused("bodies: [a]\nbody_files: []", "body_files");
  refused("excluded: [a]\nexcluded_because: []", "excluded_because");
  EXPECT_FALSE(PressSet::parse("format: other/9\n", "notes.yaml").ok());
}

TEST(PressSet, IsThatOfTheCalibrationUntilThereIsAFileOfItsOwn) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(PressSet::load(folder.path()).value(), PressSet());
  const fs::path inputs = folder.path() / "calibration_inputs.yaml";
  ASSERT_TRUE(write_file_atomically(inputs,
                                    "format: alltact-calibration/1\ndate: \"x\"\n"
                                    "operator: Ada\nball_radius_mm: 5\n"
                                    "balls: [p]\nballs_mm: [[1, 2, 3]]\npresses: [p, q]\n")
                  .ok());
  const auto calibrated = PressSet::load(folder.path()).value();
  EXPECT_EQ(calibrated.ball_radius_mm, 5);
  EXPECT_EQ(calibrated.operator_name, "Ada");
  EXPECT_EQ(calibrated.of("p").ball_mm, Eigen::Vector3d(1, 2, 3));
  // Once there is a file of its own that alone counts.
  ASSERT_TRUE(some_notes().save(folder.path()).ok());
  EXPECT_EQ(PressSet::load(folder.path()).value(), some_notes());
}

}  // namespace
}  // namespace alltact
