// A calibrated finger held against new presses: what changed is told, what did not is not.
#include "calibration/checks/check_history.h"
#include "core/base/atomic_file.h"
#include "core/image/image_file.h"
#include "tests/support/flat_finger.h"
#include "tests/support/made_meshes.h"

#include <cmath>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

class PressCheck : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(flat_.make().status, 0);
    ASSERT_EQ(flat_.calibrate().status, 0);
  }
  /// Three presses that the calibration did not see; `layer` times the darkening, `light` times
  /// all.
  std::vector<std::string> presses(double layer, double light) {
    ++set_;
    const double places[3][3] = {{120, 90, 0.5}, {200, 150, 0.7}, {150, 140, 0.35}};
    std::vector<std::string> files;
    for (int i = 0; i < 3; ++i) {
      cv::Mat pressed, untouched;
      const auto seed = static_cast<std::uint64_t>(1000 * set_ + i);
      pressed_picture(ball_depth_mm(places[i][0], places[i][1], places[i][2]), seed)
          .convertTo(pressed, CV_32F);
      untouched_picture(7).convertTo(untouched, CV_32F);
      cv::GaussianBlur(untouched, untouched, {}, 2);
      // Where it is darker than noise, the same relief under another layer.
      for (int v = 0; v < pressed.rows; ++v)
        for (int u = 0; u < pressed.cols; ++u) {
          const float drop = untouched.at<float>(v, u) - pressed.at<float>(v, u);
          pressed.at<float>(v, u) -= static_cast<float>(layer - 1) * drop;
        }
      cv::Mat image;
      cv::Mat(pressed * light).convertTo(image, CV_8U);
      files.push_back(
          flat_.file("check_" + std::to_string(set_) + "_" + std::to_string(i) + ".png"));
      EXPECT_TRUE(write_image(files.back(), image).ok());
    }
    return files;
  }
  [[nodiscard]] ProgramRun check(const std::vector<std::string>& files,
                                 const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words = {"check", flat_.finger(), "--presses"};
    words.insert(words.end(), files.begin(), files.end());
    words.insert(words.end(), options.begin(), options.end());
    return run_alltact(words);
  }
  [[nodiscard]] json verdict(const std::vector<std::string>& files) const {
    return json::parse(check(files, {"--json"}).output);
  }
  FlatFinger flat_;
  int set_ = 0;
};

/// A thicker layer reads too deep: by that, with its sign, two operators are compared on two
/// fingers.
TEST_F(PressCheck, IsAReadingOfAGageStudy) {
  const json first =
      json::parse(check(presses(1.2, 1), {"--operator", "Ann, \"late\"", "--json"}).output);
  double bias_mm = 0;
  for (const json& press : first.at("presses"))
    bias_mm += press.at("depth_mm").get<double>() * (1 / press.at("factor").get<double>() - 1) / 3;
  EXPECT_GT(bias_mm, 0.02);
  EXPECT_NEAR(first.at("bias_mm").get<double>(), bias_mm, 1e-12);
  auto checks = load_checks(flat_.finger(), nullptr);
  ASSERT_TRUE(checks.ok());
  ASSERT_EQ(checks->size(), 1U);
  EXPECT_EQ(checks->front().operator_name, "Ann, \"late\"");
  EXPECT_EQ(checks->front().bias_mm, first.at("bias_mm").get<double>());

  EXPECT_THAT(run_alltact({"check", "--gage", flat_.finger(), flat_.finger()}).errors,
              HasSubstr("named twice"));
  const fs::path other = flat_.file("other");
  fs::copy(flat_.finger(), other, fs::copy_options::recursive);
  CheckEntry reading = checks->front();
  ASSERT_TRUE(fs::remove(other / kCheckFile));
  // Made-up readings: finger, operator, mm.
  const std::vector<std::tuple<fs::path, std::string, double>> readings{
      {flat_.finger(), "Bob", 0.010},
      {flat_.finger(), "Bob", 0.012},
      {flat_.finger(), "Ann, \"late\"", 0.011},
      {other, "Bob", 0.031},
      {other, "Bob", 0.030},
      {other, "Ann, \"late\"", 0.029},
      {other, "Ann, \"late\"", 0.032},
      {other, "", 0.5}};
  for (const auto& [finger, person, value] : readings) {
    reading.operator_name = person;
    reading.bias_mm = value;
    ASSERT_TRUE(append_check(finger, reading).ok());
  }
  const ProgramRun run = run_alltact(
      {"check", "--gage", flat_.finger(), other.string(), "--tolerance-mm", "0.2", "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.errors, HasSubstr("without an operator is left out"));
  const json study = json::parse(run.output);
  EXPECT_EQ(study.at("parts"), (json{"finger", "other"}));
  EXPECT_EQ(study.at("repeats"), 2);
  const double total = study.at("total_sd_mm").get<double>();
  EXPECT_NEAR(std::pow(study.at("gage_sd_mm").get<double>(), 2) +
                  std::pow(study.at("parts_sd_mm").get<double>(), 2),
              total * total, 1e-12);
  EXPECT_NEAR(study.at("gage_percent_of_tolerance").get<double>(),
              600 * study.at("gage_sd_mm").get<double>() / 0.2, 1e-9);
  EXPECT_EQ(run_alltact({"check", "--tolerance-mm", "1"}).status, 2);
}

/// A flat punch of 10 x 9 mm, its one half pressed in by 0.55 mm, the other by a step less; the
/// skin comes back from edges over 0.15 mm.
cv::Mat_<float> punch_depth_mm(double step_mm) {
  cv::Mat_<float> depth(FlatSensor::kHeight, FlatSensor::kWidth, 0.0F);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      const double x = FlatSensor::kMmPerPx * (u - 160), y = FlatSensor::kMmPerPx * (v - 120);
      const double beside =
          std::hypot(std::max(0.0, std::abs(x) - 5.0), std::max(0.0, std::abs(y) - 4.5));
      const double lower = x < 0 ? 0.0 : step_mm * (1 - std::exp(-x / 0.15));
      depth(v, u) = static_cast<float>((0.55 - lower) * std::exp(-beside / 0.15));
    }
  return depth;
}

TEST_F(PressCheck, ReadsThePunchOfAKnownStep) {
  const std::string file = flat_.file("punch.png");
  ASSERT_TRUE(write_image(file, pressed_picture(punch_depth_mm(0.3), 77)).ok());
  const json right = json::parse(check({file}, {"--step", "punch=0.3", "--json"}).output);
  EXPECT_EQ(right.at("verdict"), "too_few") << "one press\n" << right.dump(1);
  EXPECT_LT(right.at("error_mm").get<double>(), 0.012);
  EXPECT_NEAR(right.at("factor").get<double>(), 1, 0.03);
  const json wrong = json::parse(check({file}, {"--step", "punch=0.4", "--json"}).output);
  EXPECT_NE(wrong.at("verdict"), "pass");
  EXPECT_NEAR(wrong.at("error_mm").get<double>(), 0.1, 0.012);
  EXPECT_THAT(check({file}, {"--step", "other=0.3"}).errors,
              HasSubstr("no press is named 'other'"));
  EXPECT_EQ(check({file}, {"--step", "punch"}).status, 2);
}

/// A rod of radius 3 mm and length 10 mm, turned by 25 degrees in the face.
cv::Mat_<float> rod_depth_mm(double depth_mm) {
  cv::Mat_<float> depth(FlatSensor::kHeight, FlatSensor::kWidth, 0.0F);
  const double turn = 25 * M_PI / 180;
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      const double x = FlatSensor::kMmPerPx * (u - 160), y = FlatSensor::kMmPerPx * (v - 120);
      const double along = std::cos(turn) * x + std::sin(turn) * y,
                   across = -std::sin(turn) * x + std::cos(turn) * y;
      if (std::abs(across) >= 3) continue;
      const double outside = std::max(0.0, std::abs(along) - 5.0);
      const double sunk = depth_mm - 3 + std::sqrt(9 - across * across);
      depth(v, u) = static_cast<float>(std::max(0.0, sunk) * std::exp(-outside / 0.15));
    }
  return depth;
}

TEST_F(PressCheck, ReadsABodyOfKnownShape) {
  const std::string image = flat_.file("rod.png"), mesh = flat_.file("rod.stl");
  ASSERT_TRUE(write_image(image, pressed_picture(rod_depth_mm(0.6), 78)).ok());
  write_stl(mesh, rod(3, 5));
  const ProgramRun first = check({image}, {"--body", "rod=" + mesh, "--json"});
  ASSERT_EQ(first.errors, "");
  const json right = json::parse(first.output);
  EXPECT_EQ(right.at("verdict"), "too_few") << "one press\n" << right.dump(1);
  EXPECT_NEAR(right.at("factor").get<double>(), 1, 0.02);
  EXPECT_LT(right.at("error_mm").get<double>(), 0.012);
  EXPECT_NEAR(right.at("presses").at(0).at("depth_mm").get<double>(), 0.6, 0.02);
  // Another radius is another scale of depth.
  write_stl(mesh, rod(3.6, 5));
  const ProgramRun checked = check({image}, {"--body", "rod=" + mesh, "--json"});
  ASSERT_FALSE(checked.output.empty()) << checked.errors << checked.status;
  const json wrong = json::parse(checked.output);
  EXPECT_NEAR(wrong.at("factor").get<double>(), 3 / 3.6, 0.03);
  EXPECT_GT(wrong.at("error_mm").get<double>(), 0.06);
  TriangleMesh metres = rod(3, 5);
  for (Eigen::Vector3d& point : metres.points) point /= 1000;
  write_stl(mesh, metres);
  EXPECT_THAT(check({image}, {"--body", "rod=" + mesh}).errors,
              HasSubstr("rod.stl: in millimetres, this body would be 0.01 mm long"));
}

TEST_F(PressCheck, ABodyIsCopiedIntoTheFingerThatItCalibrates) {
  const std::string image = flat_.file("rod.png"), mesh = flat_.file("rod.stl");
  ASSERT_TRUE(write_image(image, pressed_picture(rod_depth_mm(0.6), 78)).ok());
  write_stl(mesh, rod(3, 5));
  std::vector<std::string> inputs{image, "--body", "rod=" + mesh};
  for (const auto& press : flat_.presses) inputs.push_back(press.string());
  const ProgramRun made = flat_.calibrate(inputs);
  ASSERT_EQ(made.status, 0) << made.errors;
  EXPECT_THAT(made.output, HasSubstr("rod: depths on rod.stl read "));
  const fs::path finger = flat_.finger();
  const auto report = [&] { return json::parse(*read_file(finger / "calibration_report.json")); };
  const json body = report().at("bodies").at(0);
  EXPECT_EQ(body.at("body"), "rod.stl");
  EXPECT_NEAR(body.at("scale").get<double>(), 1, 0.02);
  EXPECT_GT(body.at("sd").get<double>(), 0.0005);
  fs::remove(mesh);
  const ProgramRun again = run_alltact({"calibrate", finger.string(), "--again"});
  EXPECT_EQ(again.status, 0) << again.errors;
  EXPECT_EQ(report().at("bodies").at(0), body);
  // Another mesh of that name is another body.
  const std::string first = *read_file(finger / "bodies/rod.stl");
  write_stl(mesh, rod(3.01, 5));
  EXPECT_EQ(run_alltact({"calibrate", finger.string(), "--again", "--body", "rod=" + mesh}).status,
            0);
  EXPECT_EQ(*read_file(finger / "bodies/rod.stl"), first);
  EXPECT_EQ(report().at("bodies").at(0).at("body"), "rod-2.stl");
}

TEST_F(PressCheck, AnUnchangedFingerPasses) {
  for (int i = 0; i < 3; ++i) {
    const json answer = verdict(presses(1, 1));
    EXPECT_EQ(answer.at("verdict"), "pass") << answer.dump(1);
    EXPECT_LT(answer.at("error_mm").get<double>(), 0.02);
    EXPECT_NEAR(answer.at("factor").get<double>(), 1, 0.04);
    EXPECT_NEAR(answer.at("light_percent").get<double>(), 0, 0.5);
  }
}

TEST_F(PressCheck, LightThatDriftedIsTold) {
  const ProgramRun brighter = check(presses(1, 1.03));
  EXPECT_EQ(brighter.status, 0) << brighter.errors;
  EXPECT_THAT(brighter.output, HasSubstr("Verdict: drifting"));
  EXPECT_THAT(brighter.output, HasSubstr("% brighter than before"));
  const json darker = verdict(presses(1, 0.97));
  EXPECT_EQ(darker.at("verdict"), "drifting");
  EXPECT_NEAR(darker.at("light_percent").get<double>(), -3, 0.4);
}

TEST_F(PressCheck, MuchOtherLightOrAnotherLayerAsksForACalibration) {
  const ProgramRun dark = check(presses(1, 0.9));
  EXPECT_EQ(dark.status, 1);
  EXPECT_THAT(dark.output, HasSubstr("Verdict: recalibrate"));
  EXPECT_THAT(dark.errors, HasSubstr("must be calibrated again"));
  const json thin = verdict(presses(1.3, 1));
  EXPECT_EQ(thin.at("verdict"), "recalibrate") << thin.dump(1);
  EXPECT_LT(thin.at("factor").get<double>(), 0.9) << "it reads too deep";
}

TEST_F(PressCheck, TheOrderOfThePressesDoesNotMatter) {
  std::vector<std::string> files = presses(1.05, 1.01);
  const json first = verdict(files);
  std::sort(files.begin(), files.end());
  do {
    json other = verdict(files);
    EXPECT_EQ(other, first);
  } while (std::next_permutation(files.begin(), files.end()));
}

TEST_F(PressCheck, TheBallIsThatOfTheCalibrationUnlessTold) {
  const auto files = presses(1, 1);
  EXPECT_EQ(verdict(files).at("ball_radius_mm"), 4.0);
  const json other = json::parse(check(files, {"--json", "--ball-radius-mm", "5"}).output);
  EXPECT_EQ(other.at("ball_radius_mm"), 5.0);
  EXPECT_LT(other.at("factor").get<double>(), 0.9) << "a larger ball is flatter";
}

TEST_F(PressCheck, IsKeptAndShown) {
  const fs::path file = fs::path(flat_.finger()) / "checks.csv";
  EXPECT_FALSE(fs::exists(file));
  const auto finger = text_of(fs::path(flat_.finger()) / "finger.yaml");
  const auto files = presses(1, 1);
  ASSERT_EQ(check(files).status, 0);
  const std::string one = text_of(file);
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 2);
  ASSERT_EQ(check(presses(1, 0.97)).status, 0);
  const std::string two = text_of(file);
  EXPECT_THAT(two, testing::StartsWith(one));
  EXPECT_EQ(std::count(two.begin(), two.end(), '\n'), 3);
  EXPECT_EQ(text_of(fs::path(flat_.finger()) / "finger.yaml"), finger);

  const ProgramRun shown = run_alltact({"check", flat_.finger()});
  EXPECT_EQ(shown.status, 0) << shown.errors;
  EXPECT_THAT(shown.output, HasSubstr(": pass "));
  EXPECT_THAT(shown.output, HasSubstr(": drifting "));
  const json answer = json::parse(run_alltact({"check", flat_.finger(), "--json"}).output);
  ASSERT_EQ(answer.at("checks").size(), 2U);
  EXPECT_EQ(answer.at("checks")[1].at("verdict"), "drifting");

  // A line spoilt by hand costs that line only.
  write_text(file, two + "2026-01-01T00:00:00Z,fine,1\n");
  const ProgramRun spoilt = run_alltact({"check", flat_.finger(), "--json"});
  EXPECT_EQ(json::parse(spoilt.output).at("checks").size(), 2U);
  EXPECT_THAT(spoilt.errors, HasSubstr("checks.csv:4: this line is not a check"));
}

TEST_F(PressCheck, WhatCannotBeCheckedIsToldAndNotKept) {
  const ProgramRun untouched = check({flat_.file("ref.png")});
  EXPECT_EQ(untouched.status, 1);
  EXPECT_THAT(untouched.errors, HasSubstr("no press can be used: ref"));
  EXPECT_FALSE(fs::exists(fs::path(flat_.finger()) / "checks.csv"));
  EXPECT_EQ(run_alltact({"check", flat_.finger(), "--ball-radius-mm", "4"}).status, 2);
  EXPECT_EQ(run_alltact({"check", "--presses", "a.png"}).status, 2);
  const FlatFinger other;
  ASSERT_EQ(other.make().status, 0);
  EXPECT_THAT(run_alltact({"check", other.finger(), "--presses", flat_.presses[0].string()}).errors,
              HasSubstr("not calibrated"));
}

}  // namespace
}  // namespace alltact::test
