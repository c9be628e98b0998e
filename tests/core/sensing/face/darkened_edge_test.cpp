// Edges at known positions, of faces that darken towards them: drawn with sixteen rows for one,
// blurred, averaged and with noise.
#include "core/sensing/face/darkened_edge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

struct DrawnFace {
  double step = 0.5;       // of the face's brightness at the very edge
  double length_px = 5.0;  // of the recovery
  double blur_px = 0.8;
  double noise_grey = 1.0;
};

constexpr int kColumns = 640, kRows = 360, kFine = 16;

double upper_row(double u) { return 62.3 + 0.031 * u; }
double lower_row(double u) { return 301.7 - 0.027 * u; }

cv::Mat draw(const DrawnFace& face, std::mt19937& random) {
  constexpr double kOutside = 35.0, kInside = 180.0;
  cv::Mat fine(kRows * kFine, kColumns, CV_32FC1);
  for (int u = 0; u < kColumns; ++u)
    for (int i = 0; i < fine.rows; ++i) {
      const double v = (i + 0.5) / kFine - 0.5;
      const double inside = std::min(v - upper_row(u), lower_row(u) - v);
      const double part =
          inside > 0 ? 1.0 - (1.0 - face.step) * std::exp(-inside / face.length_px) : 0.0;
      fine.at<float>(i, u) = static_cast<float>(kOutside + (kInside - kOutside) * part);
    }
  cv::GaussianBlur(fine, fine, {0, 0}, 0.01, face.blur_px * kFine);
  cv::Mat image, grey;
  cv::resize(fine, image, {kColumns, kRows}, 0, 0, cv::INTER_AREA);
  std::normal_distribution<float> noise(0.0F, static_cast<float>(face.noise_grey));
  for (int v = 0; v < kRows; ++v)
    for (int u = 0; u < kColumns; ++u) image.at<float>(v, u) += noise(random);
  image.convertTo(grey, CV_8U);
  return grey;
}

struct EdgeErrors {
  double bias_px = 0;   // inwards, mean of both edges
  double worst_px = 0;  // of the mean over an eighth of an edge
};
EdgeErrors errors_of(const FaceEdges& edges) {
  constexpr std::size_t kParts = 8;
  EdgeErrors errors;
  for (const bool is_upper : {true, false}) {
    const Edge& edge = is_upper ? edges.upper : edges.lower;
    double sums[kParts] = {}, counts[kParts] = {};
    for (std::size_t i = 0; i < edges.u.size(); ++i) {
      if (!edge.valid[i]) continue;
      const double off =
          is_upper ? edge.v[i] - upper_row(edges.u[i]) : lower_row(edges.u[i]) - edge.v[i];
      sums[i * kParts / edges.u.size()] += off;
      counts[i * kParts / edges.u.size()] += 1;
    }
    for (std::size_t part = 0; part < kParts; ++part) {
      EXPECT_GT(counts[part], 0);
      errors.bias_px += sums[part] / counts[part] / (2 * kParts);
      errors.worst_px = std::max(errors.worst_px, std::abs(sums[part] / counts[part]));
    }
  }
  return errors;
}

/// Finds the edges of twelve faces between `least` and `most`; the largest bias, px.
double largest_bias_px(const DrawnFace& least, const DrawnFace& most, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto between = [&](double from, double to) { return from + (to - from) * uniform(random); };
  double largest_px = 0;
  for (int run = 0; run < 12; ++run) {
    const DrawnFace face{between(least.step, most.step), between(least.length_px, most.length_px),
                         between(least.blur_px, most.blur_px),
                         between(least.noise_grey, most.noise_grey)};
    SCOPED_TRACE(testing::Message() << "step " << face.step << " length " << face.length_px
                                    << " blur " << face.blur_px);
    const auto edges = FaceEdgeFinder()(draw(face, random));
    if (!edges) {
      ADD_FAILURE() << edges.error().sentence();
      continue;
    }
    for (const Edge* edge : {&edges->upper, &edges->lower})
      EXPECT_GT(std::count(edge->valid.begin(), edge->valid.end(), 1),
                0.9 * static_cast<double>(edges->u.size()));
    const EdgeErrors errors = errors_of(*edges);
    EXPECT_LT(std::abs(errors.bias_px), 0.05);
    EXPECT_LT(errors.worst_px, 0.15);
    largest_px = std::max(largest_px, std::abs(errors.bias_px));
  }
  return largest_px;
}

TEST(DarkenedEdge, IsFoundWhereItWasDrawn) {
  std::printf(
      "[ figures  ] faces that darken towards their edges: bias of the edges at most %.3f px\n",
      largest_bias_px({0.4, 3.0, 0.5, 0.5}, {0.7, 12.0, 1.2, 2.0}, 41));
}

// Over twelve rows behind such a step the face gains more than in the step.
TEST(DarkenedEdge, ASmallStepBeforeALongRiseIsTheEdge) {
  std::printf("[ figures  ] small steps before long rises: bias of the edges at most %.3f px\n",
              largest_bias_px({0.15, 12.0, 0.5, 0.5}, {0.3, 30.0, 1.0, 1.2}, 43));
}

TEST(DarkenedEdge, AnEvenFaceIsLeftAlone) {
  std::mt19937 random(42);
  const cv::Mat grey = draw({1.0, 5.0, 0.8, 1.5}, random);
  const auto edges = FaceEdgeFinder()(grey);
  ASSERT_TRUE(edges.ok());
  EXPECT_LT(std::abs(errors_of(*edges).bias_px), 0.02);
  Edge moved = edges->upper;
  move_to_darkened_edge(grey, edges->u, true, &moved);
  EXPECT_EQ(moved.v, edges->upper.v);
}

TEST(DarkenedEdge, AProfileOfAnotherFormTellsNothing) {
  AcrossEdge ramp, wave;
  for (int i = 0; i < AcrossEdge::kCount; ++i) {
    const auto k = static_cast<std::size_t>(i);
    ramp.brightness[k] = 40.0 + 6.0 * i;
    wave.brightness[k] = 100.0 + 60.0 * std::sin(1.3 * i);
  }
  EXPECT_FALSE(fit_darkened_edge(ramp));
  EXPECT_FALSE(fit_darkened_edge(wave));
  ramp.brightness[3] = std::nan("");
  EXPECT_FALSE(fit_darkened_edge(ramp));
}

}  // namespace
}  // namespace alltact
