#include "calibration/finger/calibration_inputs.h"

#include "calibration/finger/calibration_report.h"
#include "core/base/atomic_file.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

CalibrationInputs some_inputs() {
  CalibrationInputs inputs;
  inputs.date = "2026-01-31T12:00:00Z";
  inputs.program_version = "0.1.0";
  inputs.press_set.operator_name = "Ada \"the first\": Lovelace";
  inputs.press_set.ball_radius_mm = 3.975;
  inputs.calibration.degree = 3;
  inputs.calibration.along = AlongChoice::kNormal;
  inputs.pipeline.smoothing_px = 1.25;
  inputs.is_continuous = true;
  inputs.finger_checksum = "0123456789abcdef";
  inputs.reference_checksum = "fedcba9876543210";
  inputs.presses = {{"press_0", "0000000000000001"},
                    {"12", "1111111111111111"},
                    {"it's, a [press]", "abcdefabcdefabcd"}};
  auto& notes = inputs.press_set.notes;
  notes["press_0"].ball_radius_mm = 6.25;
  notes["press_0"].depth = GivenDepth{0.5, 0.02};
  notes["press_0"].ball_mm = {1.5, -2.25, 48.0625};
  notes["12"].depth = GivenDepth{1.25, 0.0125};
  notes["12"].excluded = "glove in view";
  notes["it's, a [press]"].step_mm = 0.5;
  notes["it's, a [press]"].excluded = "";
  return inputs;
}

TEST(CalibrationInputs, ComeBackAsTheyWereWritten) {
  const CalibrationInputs inputs = some_inputs();
  std::vector<Message> warnings;
  const auto back = CalibrationInputs::parse(inputs.to_yaml(), "f", &warnings);
  ASSERT_TRUE(back.ok()) << back.error().sentence();
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(back->to_yaml(), inputs.to_yaml());
  EXPECT_EQ(back->press_set, inputs.press_set);
  EXPECT_EQ(back->calibration.degree, 3);
  EXPECT_EQ(back->calibration.along, AlongChoice::kNormal);
  EXPECT_EQ(back->pipeline.smoothing_px, 1.25);
  EXPECT_TRUE(back->is_continuous);
  ASSERT_EQ(back->presses.size(), 3U);
  EXPECT_EQ(back->presses[1].name, "12");
  EXPECT_EQ(back->presses[2].name, "it's, a [press]");
  EXPECT_EQ(back->presses[2].checksum, "abcdefabcdefabcd");
}

TEST(CalibrationInputs, EveryTruncationIsToldInASentence) {
  const std::string whole = some_inputs().to_yaml();
  // Without its last line break the file still says everything.
  ASSERT_TRUE(CalibrationInputs::parse(whole.substr(0, whole.size() - 1), "f").ok());
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
    const auto inputs = CalibrationInputs::parse(whole.substr(0, length), "the/file.yaml");
    ASSERT_FALSE(inputs.ok()) << length << ": " << whole.substr(0, length);
    EXPECT_THAT(inputs.error().sentence(), HasSubstr("the/file.yaml"));
  }
}

TEST(CalibrationInputs, SpoiltValuesAreNamed) {
  const std::string whole = some_inputs().to_yaml();
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    const auto inputs = CalibrationInputs::parse(text, "f");
    return inputs ? std::string("taken") : inputs.error().sentence();
  };
  EXPECT_THAT(with("calibration/1", "calibration/2"), HasSubstr("'alltact-calibration/2' cannot"));
  EXPECT_THAT(with("3.975", "-3.975"), HasSubstr("ball_radius_mm"));
  EXPECT_THAT(with("3.975", "3,975"), HasSubstr("can mean 3.975 or 3975"));
  EXPECT_THAT(with("6.25", "0"), HasSubstr("other_balls_mm"));
  EXPECT_THAT(with("6.25", "6.25, 3"), HasSubstr("2 entries for 1 presses"));
  EXPECT_THAT(with("other_balls: [press_0]", "other_balls: [press_7]"),
              HasSubstr("'press_7' is annotated, but is not among the presses"));
  EXPECT_THAT(with("degree: 3", "degree: 33"), HasSubstr("0 to 8"));
  EXPECT_THAT(with("along: normal", "along: x"), HasSubstr("auto or z or normal"));
  EXPECT_THAT(with("0123456789abcdef", "0123456789abcde"), HasSubstr("finger"));
  EXPECT_THAT(with("[press_0, ", "[../press_0, "), HasSubstr("not an image name"));
  EXPECT_THAT(with("[press_0, ", "[\"12\", "), HasSubstr("twice"));
  EXPECT_THAT(with("[press_0, ", "["), HasSubstr("3 entries for 2 presses"));
  EXPECT_THAT(with("excluded: [\"12\"", "excluded: [\"13\""),
              HasSubstr("'13' is annotated, but is not among"));
}

TEST(CalibrationInputs, KeysOfAnotherVersionAreKeptAndToldOf) {
  std::string text = some_inputs().to_yaml();
  text.insert(text.find("continuous"), "ball_material: steel\n");
  text.insert(text.find("method:"), "weather: dry, ");
  std::vector<Message> warnings;
  const auto inputs = CalibrationInputs::parse(text, "f", &warnings);
  ASSERT_TRUE(inputs.ok()) << inputs.error().sentence();
  EXPECT_THAT(warnings,
              testing::UnorderedElementsAre(
                  testing::Property(&Message::english, HasSubstr("ball_material")),
                  testing::Property(&Message::english, HasSubstr("calibration.weather"))));
  EXPECT_THAT(inputs->to_yaml(), HasSubstr("ball_material: steel\n"));
  EXPECT_THAT(inputs->to_yaml(), HasSubstr("weather: dry"));
  EXPECT_EQ(CalibrationInputs::parse(inputs->to_yaml(), "f")->to_yaml(), inputs->to_yaml());
}

TEST(CalibrationInputs, TheSameIsTheSameWhateverItsDate) {
  CalibrationInputs a = some_inputs(), b = some_inputs();
  b.date = "2027-01-01T00:00:00Z";
  EXPECT_TRUE(same_but_for_date(a, b));
  b.press_set.notes["12"].excluded.reset();
  EXPECT_FALSE(same_but_for_date(a, b));
}

RC_GTEST_PROP(CalibrationInputs, AnyNamesAndReasonsComeBack, ()) {
  CalibrationInputs inputs = some_inputs();
  const auto word = rc::gen::container<std::string>(rc::gen::inRange<char>(' ', '~'));
  std::string name = *word;
  std::erase(name, '/');
  inputs.press_set.operator_name = *word;
  inputs.presses.push_back({"=" + name, "0123456789abcdef"});
  inputs.press_set.notes["=" + name].excluded = *word;
  const auto back = CalibrationInputs::parse(inputs.to_yaml(), "f");
  RC_ASSERT(back.ok());
  RC_ASSERT(back->press_set == inputs.press_set);
  RC_ASSERT(back->presses.back().name == inputs.presses.back().name);
}

TEST(KeptPresses, AreThePicturesInTheirFolder) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(stored_presses(folder.path()).value().empty());
  std::filesystem::create_directories(folder.path() / kPressFolder);
  EXPECT_TRUE(stored_presses(folder.path()).value().empty());
  for (const char* name : {"b.png", "a.png", "notes.txt"})
    ASSERT_TRUE(write_file_atomically(folder.path() / kPressFolder / name, "x").ok());
  const auto files = stored_presses(folder.path()).value();
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].filename(), "a.png");
}

TEST(PictureChecksum, SeesOnePixelAndTheShape) {
  cv::Mat a(30, 41, CV_8UC1, cv::Scalar(7)), b = a.clone();
  EXPECT_EQ(image_checksum(a), image_checksum(b));
  for (const cv::Point place : {cv::Point(0, 0), cv::Point(40, 29), cv::Point(40, 0)}) {
    b = a.clone();
    b.at<std::uint8_t>(place) = 8;
    EXPECT_NE(image_checksum(a), image_checksum(b)) << place;
  }
  EXPECT_NE(image_checksum(a), image_checksum(a.reshape(1, 41)));
}

RC_GTEST_PROP(ShellQuoted, IsReadBackByTheShell, ()) {
  const auto word = *rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127));
  // printf %s. keeps line breaks at the end, which $( ) would eat.
  const auto run = test::run_shell("printf '%s.' " + shell_quoted(word));
  RC_ASSERT(run.output == word + ".");
}

TEST(RepeatCommand, NamesTheFolderAsAShellReadsIt) {
  EXPECT_EQ(repeat_command("/data/left-07"), "alltact calibrate left-07 --again");
  EXPECT_EQ(repeat_command("/data/left 07/"), "alltact calibrate 'left 07' --again");
}

TEST(CalibrateCommand, SaysAllThatIsNotAsUsual) {
  FingerCalibrationInput input;
  input.folder = "/data/left 07";
  input.presses.files = {"/data/left 07/presses"};
  input.press_set.ball_radius_mm = 3.975;
  EXPECT_EQ(calibrate_command(input),
            "alltact calibrate '/data/left 07' '/data/left 07/presses' --ball-radius-mm 3.975");
  input.calibration.degree = 3;
  input.pipeline.smoothing_px = 1.5;
  input.press_set.notes["press_2"].excluded = "glove in view";
  input.press_set.notes["press_3"].excluded = "";
  input.press_set.notes["press_4"].ball_mm = {1.5, -2, 48.25};
  input.press_set.operator_name = "Ada";
  input.date = "2026-01-31T12:00:00Z";
  EXPECT_EQ(calibrate_command(input),
            "alltact calibrate '/data/left 07' '/data/left 07/presses' --ball-radius-mm 3.975 "
            "--ball 'press_4=1.5,-2,48.25' --exclude 'press_2=glove in view' --exclude press_3 "
            "--degree 3 --smoothing-px 1.5 --operator Ada --date 2026-01-31T12:00:00Z");
}

}  // namespace
}  // namespace alltact
