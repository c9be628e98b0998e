// A finger's calibration is read again from its own file, whatever becomes of its reports.
#include "calibration/finger/calibration_file.h"

#include "calibration/finger/calibrate_presses.h"
#include "calibration/finger/calibration_report.h"
#include "calibration/report/press_resolution.h"
#include "core/base/atomic_file.h"
#include "core/base/yaml.h"
#include "tests/support/flat_calibration.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::FlatFinger;
using testing::HasSubstr;

class CalibrationFile : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(flat_.make().status, 0);
    auto done = calibrate_finger(flat_calibration(flat_), Job());
    ASSERT_TRUE(done) << done.error().sentence();
    done_ = std::move(*done);
  }
  [[nodiscard]] fs::path file() const { return fs::path(flat_.finger()) / kCalibrationFile; }

  FlatFinger flat_;
  FingerCalibration done_;
};

TEST_F(CalibrationFile, HoldsAllFiguresAndNothingIsMeasuredForThem) {
  ASSERT_TRUE(fs::remove(fs::path(flat_.finger()) / kReportJson));
  const auto measured = press_measurements();
  const auto stored = stored_calibration(flat_.finger());
  ASSERT_TRUE(stored) << stored.error().sentence();
  EXPECT_EQ(press_measurements(), measured);
  EXPECT_EQ(calibration_yaml(*stored), calibration_yaml(done_));
  const Calibration &now = stored->calibration, &then = done_.calibration;
  ASSERT_EQ(now.balls.size(), then.balls.size());
  ASSERT_GE(now.balls.size(), 4U);
  for (std::size_t i = 0; i < now.balls.size(); ++i) {
    EXPECT_EQ(now.balls[i].press, then.balls[i].press);
    EXPECT_EQ(now.balls[i].centre_mm, then.balls[i].centre_mm);
    EXPECT_EQ(now.balls[i].held_out_mm, then.balls[i].held_out_mm);
  }
  EXPECT_EQ(now.mapping.a_mm, then.mapping.a_mm);
  EXPECT_EQ(now.mapping.chebyshev, then.mapping.chebyshev);
  EXPECT_EQ(now.remarks, then.remarks);
  EXPECT_EQ(now.left_out, then.left_out);
  EXPECT_EQ(now.degree_choice, then.degree_choice);
  ASSERT_TRUE(now.next_press && then.next_press);
  EXPECT_EQ(now.next_press->sentence, then.next_press->sentence);
  EXPECT_EQ(now.next_press->depth_mm, then.next_press->depth_mm);
  EXPECT_EQ(stored->verdict.sentence, done_.verdict.sentence);
  EXPECT_EQ(zone_sentence(stored->zones), zone_sentence(done_.zones));
  EXPECT_EQ(stored->fault_signs, done_.fault_signs);
  EXPECT_EQ(stored->pixel_mm, done_.pixel_mm);
  ASSERT_TRUE(worst_resolution(done_.residuals));
  EXPECT_EQ(resolution_json(*stored), resolution_json(done_));
  ASSERT_EQ(stored->residuals.size(), done_.residuals.size());
  for (std::size_t i = 0; i < done_.residuals.size(); ++i) {
    const auto &read = stored->residuals[i].samples, &made = done_.residuals[i].samples;
    EXPECT_EQ(stored->residuals[i].along_mm, done_.residuals[i].along_mm);
    ASSERT_EQ(read.size(), made.size());
    ASSERT_GT(made.size(), 100U);
    for (std::size_t k = 0; k < made.size(); ++k) {
      EXPECT_NEAR(read[k].residual_mm, made[k].residual_mm, 5e-6);
      EXPECT_NEAR(read[k].ball_depth_mm, made[k].ball_depth_mm, 1e-4);
      EXPECT_NEAR(read[k].pixel.x(), made[k].pixel.x(), 1e-2);
      EXPECT_NEAR(read[k].across_mm, made[k].across_mm, 1e-3);
    }
  }
}

TEST_F(CalibrationFile, IsRefusedWhereItIsAbsentSpoiltOrOfAnotherCalibration) {
  const std::string yaml = *read_file(file());
  const auto with = [&](const std::string& before, const std::string& after) {
    std::string other = yaml;
    other.replace(other.find(before), before.size(), after);
    EXPECT_TRUE(write_file_atomically(file(), other).ok());
    const auto stored = stored_calibration(flat_.finger());
    return stored ? std::string() : stored.error().sentence();
  };
  EXPECT_THAT(with("press: press_0", "press: press_9"),
              HasSubstr("this is not the file of the finger's calibration"));
  EXPECT_THAT(with("samples: \"", "samples: \"a "), HasSubstr("is not a number"));
  EXPECT_THAT(with("samples: \"", "samples: \"1 "), HasSubstr("is not a number"));
  EXPECT_THAT(with("depth_mm: ", "depth_um: "), HasSubstr("depth_mm"));
  EXPECT_THAT(with("alltact-finger-calibration/1", "alltact-finger-calibration/9"),
              HasSubstr("cannot be read by this version"));
  fs::remove(file());
  EXPECT_THAT(with("format", "format"), "") << "the file itself is good";
  fs::remove(file());
  EXPECT_FALSE(stored_calibration(flat_.finger()));
  EXPECT_TRUE(open_finger(flat_.finger()).value()->mapping) << "the finger measures all the same";
}

TEST_F(CalibrationFile, StaysReadableWithHundredsOfPresses) {
  FingerCalibration many = done_;
  many.calibration.balls.clear();
  many.residuals.clear();
  for (int i = 0; i < 300; ++i) {
    many.calibration.balls.push_back(done_.calibration.balls.front());
    many.residuals.push_back(done_.residuals.front());
    many.residuals.back().samples.resize(800, done_.residuals.front().samples.front());
    many.calibration.balls.back().press = many.residuals.back().press = fmt::format("p{:03}", i);
  }
  const std::string yaml = calibration_yaml(many);
  EXPECT_LT(yaml.size(), YamlFile::kMaxBytes);
  const auto read = parse_calibration(yaml, "calibration.yaml");
  ASSERT_TRUE(read) << read.error().sentence();
  ASSERT_EQ(read->residuals.size(), 300U);
  EXPECT_EQ(read->residuals.back().samples.size(), 160U);
}

}  // namespace
}  // namespace alltact
