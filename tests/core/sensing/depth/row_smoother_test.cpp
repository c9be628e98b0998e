#include "core/sensing/depth/smoothing.h"
#include "core/sensing/reference/image_warp.h"

#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

/// The same as it is written down: sums of what is given, in double precision.
double plainly_smoothed(const cv::Mat& level, const std::vector<double>& weights, int u, int v) {
  const int radius = static_cast<int>(weights.size()) - 1;
  double sum = 0;
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i) {
      if (u + i < 0 || u + i >= level.cols || v + j < 0 || v + j >= level.rows) continue;
      sum += weights[static_cast<std::size_t>(std::abs(i))] *
             weights[static_cast<std::size_t>(std::abs(j))] * level.at<double>(v + j, u + i);
    }
  return sum;
}

/// The outer weights as whole 2^-9, which is all that pictures of 256 levels need; the middle one
/// makes the sum 1.
std::vector<double> rounded(std::vector<double> weights) {
  weights.front() = 1.0;
  for (std::size_t k = 1; k < weights.size(); ++k) {
    weights[k] = std::round(512.0 * weights[k]) / 512.0;
    weights.front() -= 2.0 * weights[k];
  }
  return weights;
}

/// Random levels, of which each row has up to two runs, and of these only `part` of the pixels.
struct Given {
  cv::Mat level;  // 0 where none is given
  std::vector<std::vector<FaceRun>> runs;
};
Given random_picture(std::mt19937& engine, cv::Size size, double part) {
  std::uniform_real_distribution<double> even(0.0, 1.0);
  std::uniform_int_distribution<int> column(0, size.width);
  Given given{cv::Mat::zeros(size, CV_64FC1), {}};
  const double brightest = even(engine) < 0.5 ? 249.9 : 250.0 * even(engine);
  for (int v = 0; v < size.height; ++v) {
    std::array<int, 4> ends{column(engine), column(engine), column(engine), column(engine)};
    std::sort(ends.begin(), ends.end());
    std::vector<FaceRun>& runs = given.runs.emplace_back();
    for (const int k : {0, 2})
      if (ends[static_cast<std::size_t>(k)] < ends[static_cast<std::size_t>(k) + 1])
        runs.push_back(
            {v, ends[static_cast<std::size_t>(k)], ends[static_cast<std::size_t>(k) + 1]});
    for (const FaceRun& run : runs)
      for (int u = run.first; u < run.end; ++u)
        if (even(engine) < part)
          given.level.at<double>(v, u) =
              std::floor(kGreySteps * brightest * (0.9 + 0.1 * even(engine))) / kGreySteps;
  }
  return given;
}

TEST(RowSmoother, IsThePlainSumOfWhatIsGiven) {
  double furthest = 0, square = 0;
  long count = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 engine(seed);
    const double smoothing_px = std::array{0.0, 0.6, 1.0, 2.0, 3.0}[seed % 5];
    const Smoothing smoothing =
        seed % 2 == 0 ? smoothing_of(smoothing_px) : gaussian_smoothing(smoothing_px);
    const std::vector<double> weights = rounded(smoothing.weights);
    // Amid bright pixels that are missing, sums are the largest there can be.
    const Given given = random_picture(engine, {97, 40}, seed % 3 == 0 ? 1.0 : 0.3);
    RowSmoother smoother(smoothing, given.level.cols);
    const auto give = [&](int row) {
      const bool is_inside = row < given.level.rows;
      const auto runs =
          is_inside ? given.runs[static_cast<std::size_t>(row)] : std::vector<FaceRun>();
      std::int16_t* line = smoother.begin_row(row, runs);
      for (const FaceRun& run : runs)
        for (int u = run.first; u < run.end; ++u)
          line[u] =
              static_cast<std::int16_t>(std::lround(kGreySteps * given.level.at<double>(row, u)));
    };
    for (int row = 0; row < smoother.radius(); ++row) give(row);
    for (int row = 0; row < given.level.rows; ++row) {
      give(row + smoother.radius());
      for (const FaceRun& run : given.runs[static_cast<std::size_t>(row)]) {
        const std::int16_t* smooth = smoother.smoothed(row, run);
        for (int u = run.first; u < run.end; ++u) {
          const double off = static_cast<double>(smooth[u - run.first]) / kGreySteps -
                             plainly_smoothed(given.level, weights, u, row);
          ASSERT_LT(std::abs(off), 0.4) << "seed " << seed << ", row " << row << ", column " << u;
          furthest = std::max(furthest, std::abs(off));
          square += off * off;
          ++count;
        }
      }
    }
  }
  EXPECT_LT(std::sqrt(square / static_cast<double>(count)), 0.05) << "grey levels";
  std::printf("[ figures  ] smoothing off by %.3f grey levels rms, %.3f at most\n",
              std::sqrt(square / static_cast<double>(count)), furthest);
}

}  // namespace
}  // namespace alltact
