#include "calibration/study/evaluate.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kZ = 50.0F;

Camera camera() {
  CameraParameters parameters;
  parameters.model = CameraModel::kPinhole;
  parameters.width_px = 200;
  parameters.height_px = 100;
  parameters.fx_px = parameters.fy_px = 500;  // 0.1 mm a pixel at 50 mm
  parameters.cx_px = 100;
  parameters.cy_px = 50;
  return Camera::create(parameters).value();
}

/// A flat face at z = 50 mm with a block pressed in 0.5 mm deep, columns 20 to 39.
Truth block() {
  Truth truth;
  truth.depth_mm = cv::Mat(100, 200, CV_32FC1, cv::Scalar(0));
  truth.depth_mm.colRange(20, 40).setTo(0.5F);
  truth.depth_mm.rowRange(0, 5).setTo(kNaN);
  truth.untouched_z_mm = cv::Mat(100, 200, CV_32FC1, cv::Scalar(kZ));
  truth.markers = {{10, 10, true}, {20, 10, true}, {30, 10, false}};
  return truth;
}

cv::Mat points_at(float untouched_z, const cv::Mat& depth_mm) {
  cv::Mat points(depth_mm.size(), CV_32FC3);
  for (int v = 0; v < points.rows; ++v)
    for (int u = 0; u < points.cols; ++u)
      points.at<cv::Vec3f>(v, u) = {0, 0, untouched_z - depth_mm.at<float>(v, u)};
  return points;
}

TEST(Evaluate, ThePerfectAnswerHasNoError) {
  const Truth truth = block();
  Evaluator evaluator(camera());
  evaluator.add(truth, truth.depth_mm, points_at(kZ, truth.depth_mm),
                {{10, 10, true, 0}, {20, 10, true, 0}, {30, 10, false, 0}});
  const Evaluation evaluation = evaluator.evaluation();
  EXPECT_EQ(evaluation.frames, 1);
  EXPECT_EQ(evaluation.contact_depth_mm, 0.0);
  EXPECT_EQ(evaluation.contact_coverage, 1.0);
  EXPECT_EQ(evaluation.false_depth_mm, 0.0);
  EXPECT_EQ(evaluation.position_mm, 0.0);
  EXPECT_EQ(evaluation.marker_seen_px, 0.0);
  EXPECT_EQ(evaluation.marker_hidden_px, 0.0);
  EXPECT_FALSE(evaluation.time_ms.has_value());
}

TEST(Evaluate, EachErrorIsCountedWhereItBelongs) {
  const Truth truth = block();
  cv::Mat depth = truth.depth_mm.clone();
  depth.colRange(20, 30).setTo(0.4F);     // half of the contact: 0.1 mm off
  depth.colRange(30, 35).setTo(kNaN);     // a quarter: nothing
  depth.colRange(45, 48).setTo(9.0F);     // 0.6 mm from the contact: neither here nor there
  depth.colRange(100, 200).setTo(0.02F);  // far away
  Evaluator evaluator(camera());
  evaluator.add(truth, depth, points_at(kZ + 0.03F, depth),
                {{10, 10.5, true, 0}, {99, 10, false, 0}, {30, 12, false, 0}});
  evaluator.add_time(3);
  evaluator.add_time(1);
  evaluator.add_time(2);
  evaluator.add_missing();
  const Evaluation evaluation = evaluator.evaluation();
  EXPECT_EQ(evaluation.frames_missing, 1);
  EXPECT_NEAR(*evaluation.contact_depth_mm, 0.1 * 10 / 15, 1e-6);
  EXPECT_NEAR(*evaluation.contact_coverage, 0.75, 1e-9);
  // Away: columns 0 to 9 and 50 on, as 39 is the last pressed one and 1 mm is 10 px.
  EXPECT_NEAR(*evaluation.false_depth_mm, 0.02 * 100 / (9 + 150), 2e-4);
  EXPECT_NEAR(*evaluation.position_mm, 0.03, 1e-5);
  EXPECT_NEAR(*evaluation.marker_seen_px, 0.5, 1e-12)
      << "a visible marker that was only estimated is not 'seen'";
  EXPECT_NEAR(*evaluation.marker_hidden_px, 2.0, 1e-12);
  EXPECT_EQ(*evaluation.time_ms, 2.0);
}

TEST(Evaluate, WhatCannotBeMeasuredIsAbsent) {
  const Evaluation nothing = Evaluator(camera()).evaluation();
  EXPECT_FALSE(nothing.contact_depth_mm || nothing.false_depth_mm || nothing.position_mm ||
               nothing.marker_seen_px);
}

}  // namespace
}  // namespace alltact
