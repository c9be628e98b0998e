// A finger keeps all that its calibration was made from: again gives the same bytes.
#include "tests/support/flat_finger.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class Repetition : public testing::Test {
 protected:
  /// Made once; each test has its copy.
  static const FlatFinger& calibrated() {
    static const FlatFinger made;
    static const bool is_made = made.make().status == 0 && made.calibrate().status == 0;
    EXPECT_TRUE(is_made);
    return made;
  }
  void SetUp() override { ASSERT_FALSE(before_.empty()); }
  [[nodiscard]] ProgramRun again(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"calibrate", flat_.finger(), "--again"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_alltact(arguments);
  }
  [[nodiscard]] std::string kept(const std::string& name) const {
    return text_of(fs::path(flat_.finger()) / name);
  }
  /// Sets the clock of what is stored back, so that a new date can be seen.
  void grow_old() const {
    for (const char* name : {"finger.yaml", "calibration_inputs.yaml"}) {
      std::string text = kept(name);
      const std::size_t place = text.find("date: \"20") + 7;
      ASSERT_NE(place, std::string::npos + 7);
      text.replace(place, 4, "2001");
      write_text(fs::path(flat_.finger()) / name, text);
    }
  }
  const FlatFinger flat_{calibrated()};
  std::vector<std::pair<std::string, std::string>> before_ = contents_of(flat_.finger());
};

TEST_F(Repetition, GivesTheSameBytes) {
  grow_old();
  const auto before = contents_of(flat_.finger());
  // Neither the pictures it was first given nor the untouched one are needed.
  for (const fs::path& press : flat_.presses) fs::remove(press);
  fs::remove(flat_.file("ref.png"));
  const ProgramRun run = again();
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  for (const auto& [name, bytes] : before)
    if (!name.ends_with(".html") && !name.ends_with(".pdf")) {  // these carry the date set back
      EXPECT_EQ(kept(name), bytes) << name;
    }
  // And from elsewhere, with another name for the folder.
  const auto second = contents_of(flat_.finger());
  const ProgramRun elsewhere =
      run_shell(fmt::format("cd '{}' && '{}' calibrate ./finger/../finger --again",
                            flat_.folder.path().string(), ALLTACT_PROGRAM));
  ASSERT_EQ(elsewhere.status, 0) << elsewhere.errors;
  for (const auto& [name, bytes] : second) EXPECT_TRUE(kept(name) == bytes) << name;
}

TEST_F(Repetition, ComparesWithOtherMethodsWhereAsked) {
  const auto methods = [&] {
    const auto report = nlohmann::json::parse(kept("calibration_report.json"));
    return report.contains("methods") ? report.at("methods").size() : 0;
  };
  EXPECT_EQ(methods(), 0U);
  const auto before = contents_of(flat_.finger());
  const ProgramRun run = again({"--compare"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(methods(), 4U);
  EXPECT_THAT(run.output, HasSubstr("all methods, same presses"));
  for (const auto& [name, bytes] : before)
    if (!name.starts_with("calibration_report")) {
      EXPECT_EQ(kept(name), bytes) << name;
    }
}

TEST_F(Repetition, ComparesTheJointMethodAlone) {
  const ProgramRun run = again({"--compare", "--method", "circle"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("only the joint method is compared with others"));
  auto now = contents_of(flat_.finger());
  std::erase_if(now, [](const auto& file) {
    return file.first == "calibration.problem.png";  // of every calibration that fails
  });
  EXPECT_EQ(now, before_);
}

TEST_F(Repetition, KnowsWhichPressWasMadeWithAnotherBall) {
  const ProgramRun other = again({"--other-ball", "press_2=4.2"});
  ASSERT_EQ(other.status, 0) << other.errors;
  EXPECT_THAT(kept("calibration_inputs.yaml"), testing::AllOf(HasSubstr("other_balls: [press_2]"),
                                                              HasSubstr("other_balls_mm: [4.2]"),
                                                              HasSubstr("ball_radius_mm: 4.0\n")));
  EXPECT_THAT(kept("calibration_report.json"), HasSubstr("\"ball_radius_mm\": 4.2"));
  const std::string yaml = kept("finger.yaml");
  ASSERT_EQ(again().status, 0);
  EXPECT_EQ(kept("finger.yaml"), yaml) << "the other ball was not kept";
  EXPECT_THAT(again({"--other-ball", "press_9=3"}).errors,
              HasSubstr("no press is named 'press_9'"));
  EXPECT_EQ(again({"--other-ball", "press_2"}).status, 2);
  EXPECT_EQ(again({"--other-ball", "press_2=-1"}).status, 2);
}

TEST_F(Repetition, KnowsAMeasuredDepthAndTakesItBack) {
  const auto indentation_mm = [&] {
    const auto report = nlohmann::json::parse(kept("calibration_report.json"));
    for (const auto& press : report.at("presses"))
      if (press.at("press") == "press_2") return press.at("pressed_in_mm").get<double>();
    return 0.0;
  };
  const double by_pictures_mm = indentation_mm();
  const ProgramRun measured =
      again({"--depth", fmt::format("press_2={}+-0.001", by_pictures_mm + 0.01)});
  ASSERT_EQ(measured.status, 0) << measured.errors;
  EXPECT_THAT(kept("calibration_inputs.yaml"),
              testing::AllOf(HasSubstr("depths: [press_2]"), HasSubstr("0.001]]")));
  EXPECT_THAT(measured.output, HasSubstr("press_2: measured"));
  EXPECT_NEAR(indentation_mm(), by_pictures_mm + 0.01, 0.003);
  const std::string yaml = kept("finger.yaml");
  ASSERT_EQ(again().status, 0);
  EXPECT_EQ(kept("finger.yaml"), yaml) << "the measured depth was not kept";

  // A gauge that was not set to zero.
  const ProgramRun wrong = again({"--depth", fmt::format("press_2={}+-0.001", by_pictures_mm + 1)});
  ASSERT_EQ(wrong.status, 0) << wrong.errors;
  EXPECT_THAT(wrong.errors, HasSubstr("Left out: press_2: its measured depth of"));
  ASSERT_EQ(again({"--depth", "press_2=none"}).status, 0);
  EXPECT_EQ(indentation_mm(), by_pictures_mm);
  for (const char* impossible : {"press_2", "press_2=-1", "press_2=1+-0", "press_2=deep"})
    EXPECT_EQ(again({"--depth", impossible}).status, 2) << impossible;
  EXPECT_THAT(again({"--depth", "press_9=1"}).errors, HasSubstr("no press is named 'press_9'"));
  EXPECT_THAT(again({"--depth", "press_2=1", "--method", "cone"}).errors,
              HasSubstr("only the joint method uses measured depths"));
}

TEST_F(Repetition, ABallIsNoPunchWithAStep) {
  const ProgramRun step = again({"--step", "press_2=0.5"});
  ASSERT_EQ(step.status, 0) << step.errors;
  EXPECT_THAT(step.errors, HasSubstr("Left out: press_2: "));
  EXPECT_THAT(kept("calibration_inputs.yaml"), HasSubstr("steps: [press_2]"));
  EXPECT_EQ(again({"--step", "press_2=0"}).status, 2);
}

TEST_F(Repetition, BurstsOfFramesHeldStillAreOnePressEach) {
  cv::RNG random(5);
  std::vector<std::string> folders{"--bursts"};
  for (const fs::path& press : flat_.presses) {
    const fs::path folder = flat_.file("burst_" + press.stem().string());
    fs::create_directory(folder);
    const cv::Mat grey = cv::imread(press.string(), cv::IMREAD_GRAYSCALE);
    for (int i = 0; i < 12; ++i) {
      cv::Mat grain(grey.size(), CV_16SC1), noisy;
      random.fill(grain, cv::RNG::NORMAL, 0.0, 2.0);
      cv::add(grey, grain, noisy, cv::noArray(), CV_8U);
      ASSERT_TRUE(cv::imwrite((folder / fmt::format("{:02}.png", i)).string(), noisy));
    }
    folders.push_back(folder.string());
  }
  const ProgramRun run = flat_.calibrate(folders);
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("burst_press_1: the mean of 12 still frames, of 12 read"));
  // What is kept are the means: again needs no burst.
  const std::string yaml = kept("finger.yaml");
  EXPECT_TRUE(fs::exists(fs::path(flat_.finger()) / "presses" / "burst_press_1.png"));
  ASSERT_EQ(again().status, 0);
  EXPECT_EQ(kept("finger.yaml"), yaml);
  EXPECT_EQ(again({"--bursts"}).status, 2);
}

TEST_F(Repetition, LeavesOutWhatIsExcludedAndTakesItBack) {
  const ProgramRun without = again({"--exclude", "press_2=glove in view"});
  ASSERT_EQ(without.status, 0) << without.errors;
  EXPECT_THAT(without.errors, HasSubstr("Left out: press_2: excluded, glove in view"));
  EXPECT_THAT(kept("calibration_report.json"), HasSubstr("\"because\": \"glove in view\""));
  EXPECT_THAT(kept("finger.yaml"), HasSubstr("presses: [press_0, press_1, press_3]"));
  grow_old();
  const std::string yaml = kept("finger.yaml");
  ASSERT_EQ(again().status, 0);
  EXPECT_EQ(kept("finger.yaml"), yaml) << "the exclusion was not kept";

  ASSERT_EQ(again({"--include", "press_2"}).status, 0);
  for (const auto& [name, bytes] : before_)
    if (name == "calibration_report.json") {
      EXPECT_EQ(kept(name), bytes);
    }
  EXPECT_THAT(kept("calibration_inputs.yaml"), Not(HasSubstr("excluded")));
  EXPECT_THAT(kept("calibration_inputs.yaml"), Not(HasSubstr("2001")));

  EXPECT_THAT(again({"--exclude", "press_9"}).errors, HasSubstr("one of press_0, press_1"));
  EXPECT_THAT(again({"--include", "press_1"}).errors, HasSubstr("'press_1' is not excluded"));
}

TEST_F(Repetition, BeginsWhereAHandPutABallAndForgetsItAgain) {
  const auto report = nlohmann::json::parse(kept("calibration_report.json"));
  const auto& centre = report.at("presses").at(1).at("centre_mm");
  const std::string ball =
      fmt::format("press_1={},{},{}", centre.at(0).get<double>() + 0.2,
                  centre.at(1).get<double>() - 0.1, centre.at(2).get<double>());
  ASSERT_EQ(again({"--ball", ball}).status, 0);
  EXPECT_THAT(kept("calibration_inputs.yaml"), HasSubstr("balls: [press_1]\nballs_mm: [["));
  const auto moved = nlohmann::json::parse(kept("calibration_report.json"));
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(moved.at("presses").at(1).at("centre_mm").at(i).get<double>(),
                centre.at(i).get<double>(), 0.01);
  ASSERT_EQ(again({"--ball", "press_1=find"}).status, 0);
  EXPECT_THAT(kept("calibration_inputs.yaml"), Not(HasSubstr("balls")));
  EXPECT_EQ(nlohmann::json::parse(kept("calibration_report.json")), report);
  EXPECT_THAT(again({"--ball", "press_9=1,2,3"}).errors, HasSubstr("no press is named 'press_9'"));
  EXPECT_THAT(again({"--ball", "press_1=1,2"}).errors, HasSubstr("NAME=X,Y,Z"));
}

TEST_F(Repetition, ADateThatIsToldIsKept) {
  std::vector<std::string> arguments = {"calibrate", flat_.finger()};
  for (const fs::path& press : flat_.presses) arguments.push_back(press.string());
  for (const std::string& word :
       std::vector<std::string>{"--reference", flat_.file("ref.png"), "--ball-radius-mm", "4",
                                "--date", "2001-02-03T04:05:06Z"})
    arguments.push_back(word);
  const ProgramRun run = run_alltact(arguments);
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(kept("calibration_inputs.yaml"), HasSubstr("date: \"2001-02-03T04:05:06Z\""));
  EXPECT_THAT(kept("finger.yaml"), HasSubstr("2001-02-03T04:05:06Z"));
  arguments.back() = "yesterday";
  EXPECT_EQ(run_alltact(arguments).status, 2);
}

TEST_F(Repetition, ChangesWhatItIsToldTo) {
  grow_old();
  ASSERT_EQ(again({"--ball-radius-mm", "4.1", "--family", "polynomial"}).status, 0);
  EXPECT_THAT(kept("finger.yaml"), HasSubstr("ball_radius_mm: 4.1\n"));
  EXPECT_THAT(kept("finger.yaml"), HasSubstr("kind: polynomial"));
  EXPECT_THAT(kept("finger.yaml"), Not(HasSubstr("2001-"))) << "a new calibration has its own date";
  ASSERT_EQ(again({"--ball-radius-mm", "4", "--family", "auto"}).status, 0);
  for (const auto& [name, bytes] : before_)
    if (name == "calibration_report.json") {
      EXPECT_EQ(kept(name), bytes);
    }
}

TEST_F(Repetition, RefusesPicturesThatAreNotTheSame) {
  const fs::path press = fs::path(flat_.finger()) / "presses/press_1.png";
  cv::Mat image = cv::imread(press.string(), cv::IMREAD_GRAYSCALE);
  image.at<std::uint8_t>(5, 5) ^= 1;
  cv::imwrite(press.string(), image);
  const auto before = contents_of(flat_.finger());
  const ProgramRun changed = again();
  EXPECT_EQ(changed.status, 1);
  EXPECT_THAT(changed.errors, HasSubstr("press_1.png: this is not the image that"));
  fs::remove(press);
  EXPECT_THAT(again().errors, HasSubstr("press_1.png"));
  fs::copy_file(flat_.presses[1], press);
  EXPECT_EQ(again().status, 0);
  EXPECT_EQ(contents_of(flat_.finger()).size(), before.size());
}

TEST_F(Repetition, SaysThatAnotherReferenceMakesANewCalibration) {
  cv::Mat reference = cv::imread(flat_.file("ref.png"), cv::IMREAD_GRAYSCALE);
  reference.at<std::uint8_t>(9, 9) ^= 1;
  cv::imwrite(flat_.file("ref.png"), reference);
  ASSERT_EQ(run_alltact({"reference", flat_.finger(), flat_.file("ref.png")}).status, 0);
  const ProgramRun run = again();
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.errors, HasSubstr("reference has changed since its calibration"));
  EXPECT_EQ(again().errors, "");
}

TEST_F(Repetition, IsRefusedInASentenceWhereInputsAreMissingOrSpoilt) {
  const fs::path inputs = fs::path(flat_.finger()) / "calibration_inputs.yaml";
  const std::string whole = text_of(inputs);
  for (const std::size_t length : {std::size_t{0}, whole.size() / 3, whole.size() - 3}) {
    write_text(inputs, whole.substr(0, length));
    const auto before = contents_of(flat_.finger());
    const ProgramRun run = again();
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.errors, HasSubstr("calibration_inputs.yaml")) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_EQ(contents_of(flat_.finger()), before);
  }
  fs::remove(inputs);
  EXPECT_THAT(again().errors, HasSubstr("nothing to repeat"));
  EXPECT_THAT(run_alltact({"check", flat_.finger()}).output, HasSubstr("cannot be repeated"));
}

TEST_F(Repetition, AWritingThatWasCutOffIsSeenAndCompleted) {
  // The inputs of a calibration that never came to finger.yaml.
  const auto finger = kept("finger.yaml");
  grow_old();
  write_text(fs::path(flat_.finger()) / "finger.yaml", finger);
  EXPECT_THAT(run_alltact({"check", flat_.finger()}).output, HasSubstr("--again"));
  ASSERT_EQ(again().status, 0);
  EXPECT_THAT(kept("finger.yaml"), HasSubstr("calibration_date: \"2001-"));
  EXPECT_THAT(run_alltact({"check", flat_.finger()}).output, Not(HasSubstr("--again")));
}

TEST(RepetitionUsage, IsToldInOneLine) {
  const FlatFinger flat;
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"calibrate", flat.finger()},
                                             {"calibrate", flat.finger(), "a.png"},
                                             {"calibrate", flat.finger(), "a.png", "--again"},
                                             {"calibrate", flat.finger(), "--include", "a"}})
    EXPECT_EQ(run_alltact(words).status, 2) << testing::PrintToString(words);
}

}  // namespace
}  // namespace alltact::test
