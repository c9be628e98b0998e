// Each noise against its law, by a million draws seen in pictures. Every bound is five standard
// deviations of what is estimated, so that one in two million right laws would fail it.
#include "tests/core/simulation/effects/effect_scene.h"

#include <array>
#include <cstdlib>

namespace alltact {
namespace {

constexpr double kSigmas = 5;

/// What is compared with a standard normal law.
struct NormalSample {
  std::array<double, 5> sums{};  // of the powers 0 to 4
  std::array<long, 2> beyond{};  // 3, 4
  std::array<long, 64> slices{};

  void add(double z) {
    double power = 1;
    for (double& sum : sums) sum += power, power *= z;
    beyond[0] += std::abs(z) > 3;
    beyond[1] += std::abs(z) > 4;
    const double part = 0.5 * std::erfc(-z / std::sqrt(2.0));
    ++slices[static_cast<std::size_t>(std::min(part * 64, 63.0))];
  }

  // Variances of the sample's moments: 1, 2, 15 and 96 over n; of a count n p (1 - p).
  void expect_standard_normal(const std::string& what, double least_draws = 1e6) const {
    const double n = sums[0];
    EXPECT_GE(n, least_draws) << what;
    EXPECT_LT(std::abs(sums[1] / n), kSigmas * std::sqrt(1 / n)) << what << ": mean";
    EXPECT_LT(std::abs(sums[2] / n - 1), kSigmas * std::sqrt(2 / n)) << what << ": variance";
    EXPECT_LT(std::abs(sums[3] / n), kSigmas * std::sqrt(15 / n)) << what << ": third moment";
    EXPECT_LT(std::abs(sums[4] / n - 3), kSigmas * std::sqrt(96 / n)) << what << ": kurtosis";
    for (const std::size_t i : {0U, 1U}) {
      const double p = std::erfc(static_cast<double>(3 + i) / std::sqrt(2.0));
      EXPECT_LT(std::abs(static_cast<double>(beyond[i]) - n * p), kSigmas * std::sqrt(n * p))
          << what << ": beyond " << 3 + i << " standard deviations";
    }
    double chi2 = 0;  // of 63 degrees of freedom, variance 126
    for (const long count : slices) chi2 += std::pow(double(count) - n / 64, 2) / (n / 64);
    EXPECT_LT(chi2, 63 + kSigmas * std::sqrt(126)) << what << ": shape";
  }
};

/// One million standard normal draws, or what should be such.
using Field = cv::Mat_<float>;

Field noise_of(const std::string& effect, double level, double sd, int frame = 0) {
  const std::string leak =
      level > 1 ? fmt::format("  - {{use: leak, grey: {}}}\n", level - 1) : std::string();
  Field image = rendered(million_text(leak + "  - {use: " + effect + "}\n"), frame);
  image -= static_cast<float>(level);
  image *= static_cast<float>(1 / sd);
  return image;
}

void expect_standard_normal(const Field& field, const std::string& what) {
  NormalSample sample;
  for (const float z : field) sample.add(z);
  sample.expect_standard_normal(what);
}

/// The mean product of independent standard normal numbers has variance 1 / n.
void expect_uncorrelated(const cv::Mat& a, const cv::Mat& b, const std::string& what) {
  const double n = static_cast<double>(a.total());
  EXPECT_LT(std::abs(a.dot(b) / n), kSigmas / std::sqrt(n)) << what;
}

// Pixels beside, below and far from one another, and squares too, so that no pair is brighter or
// noisier together.
void expect_white(const Field& field, const std::string& what) {
  struct {
    int u, v;
  } const lags[]{{1, 0}, {2, 0}, {3, 0}, {7, 0}, {8, 0}, {16, 0}, {256, 0}, {0, 1}, {0, 2}, {1, 1}};
  Field squares;
  cv::multiply(field, field, squares, std::sqrt(0.5));
  squares -= static_cast<float>(std::sqrt(0.5));
  for (const auto& lag : lags) {
    const cv::Rect here(0, 0, field.cols - lag.u, field.rows - lag.v);
    const cv::Rect there = here + cv::Point(lag.u, lag.v);
    const std::string which = fmt::format("{}: {}, {}", what, lag.u, lag.v);
    expect_uncorrelated(field(here), field(there), which);
    expect_uncorrelated(squares(here), squares(there), which + ", squared");
  }
}

TEST(NoiseLaw, OfEveryPixelIsNormalAndWhite) {
  Parameters random(81);
  for (int i = 0; i < 3; ++i) {
    const double sd = random.between(0.2, 20), gain = random.between(0.01, 2);
    const double level = random.between(2, 200), prnu = random.between(0.003, 0.15);
    const std::vector<std::pair<std::string, Field>> noises{
        {"read", noise_of(fmt::format("read, sd: {}", sd), 1, sd)},
        {"shot", noise_of(fmt::format("shot, gain: {}", gain), level, std::sqrt(gain * level))},
        {"prnu", noise_of(fmt::format("fixed-pattern, prnu: {}", prnu), level, prnu * level)},
        {"dsnu", noise_of(fmt::format("fixed-pattern, dsnu: {}", sd), 1, sd)}};
    for (const auto& [name, field] : noises) {
      expect_standard_normal(field, name);
      if (i == 0) expect_white(field, name);
    }
  }
}

// Variance sr^2 + g I, of read and shot noise together.
TEST(NoiseLaw, OfShotAndReadTogetherIsTheirSum) {
  Parameters random(82);
  for (const double level : {1.0, 17.0, 120.0, 230.0}) {
    const double sd = random.between(0.3, 2), gain = random.between(0.01, 0.3);
    expect_standard_normal(
        noise_of(fmt::format("shot, gain: {}}}\n  - {{use: read, sd: {}", gain, sd), level,
                 std::sqrt(sd * sd + gain * level)),
        fmt::format("grey level {}", level));
  }
}

TEST(NoiseLaw, FramesEffectsAndScenesShareNothing) {
  const std::vector<std::pair<std::string, Field>> fields{
      {"read 0", noise_of("read, sd: 1", 1, 1, 0)},
      {"read 1", noise_of("read, sd: 1", 1, 1, 1)},
      {"read 2", noise_of("read, sd: 1", 1, 1, 2)},
      {"read 300", noise_of("read, sd: 1", 1, 1, 300)},
      {"shot 0", noise_of("shot, gain: 1", 1, 1, 0)},
      {"shot 1", noise_of("shot, gain: 1", 1, 1, 1)},
      {"prnu", noise_of("fixed-pattern, prnu: 0.1", 1, 0.1)},
      {"dsnu", noise_of("fixed-pattern, dsnu: 1", 1, 1)},
      {"seed 8", Field(plan_of(million_text("  - {use: read, sd: 1}\n"), 8).render(0) - 1.0)}};
  for (std::size_t i = 0; i < fields.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      expect_uncorrelated(fields[i].second, fields[j].second,
                          fields[i].first + " and " + fields[j].first);
  // The pattern is the camera's: the same in all frames.
  EXPECT_EQ(
      cv::norm(fields[6].second, noise_of("fixed-pattern, prnu: 0.1", 1, 0.1, 77), cv::NORM_INF),
      0);
}

TEST(NoiseLaw, OfRowsIsNormalAndWhiteFromRowToRowAndFrameToFrame) {
  const Plan plan =
      plan_of(flat_text("  - {use: row-noise, sd: 0.8}\n",
                        "model: orthographic, size: [16, 16384], mm_per_px: 0.01, cx: 8, cy: 8"));
  Field offsets(62, 16384);
  for (int frame = 0; frame < offsets.rows; ++frame) {
    const cv::Mat column = (plan.render(frame).col(3) - 1) / 0.8;
    cv::Mat(column.t()).copyTo(offsets.row(frame));
  }
  expect_standard_normal(offsets, "row noise");
  expect_white(offsets, "row noise");
}

// A knot of the drift for each of 20000 frames; between knots the variance stays 1.
TEST(NoiseLaw, OfTheGainsDriftIsNormal) {
  const std::string camera = "model: orthographic, size: [16, 16], mm_per_px: 0.01, cx: 8, cy: 8";
  for (const double every_frames : {1.0, 1.0 / 1.37}) {
    const Plan plan = plan_of(flat_text(
        fmt::format("  - {{use: gain-drift, sd: 0.05, every_s: {}}}\n", every_frames / 30),
        camera));
    NormalSample sample;
    for (int frame = 0; frame < 60000; frame += 3)
      sample.add((plan.render(frame).at<float>(5, 5) - 1) / 0.05);
    sample.expect_standard_normal(fmt::format("a knot every {} frames", every_frames), 20000);
  }
}

void expect_share(double count, double n, double p, const std::string& what) {
  EXPECT_LT(std::abs(count - n * p), kSigmas * std::sqrt(n * p * (1 - p))) << what;
}

// As many as a coin for each pixel gives, on the whole, in rows and side by side.
TEST(NoiseLaw, OfDeadPixelsIsACoinForEachOfThem) {
  for (const double p : {1e-3, 0.02, 0.3}) {
    const Field image = rendered(million_text(
        fmt::format("  - {{use: leak, grey: 9}}\n  - {{use: dead-pixels, dead: {}}}\n", p)));
    const cv::Mat dead = (image == 0) / 255;
    const double n = 1e6;
    expect_share(cv::countNonZero(dead), n, p, "dead pixels");
    const auto both = [&](int u, int v) {
      const cv::Rect here(0, 0, 1000 - u, 1000 - v);
      expect_share(cv::countNonZero(dead(here).mul(dead(here + cv::Point(u, v)))), here.area(),
                   p * p, fmt::format("both, {} and {} apart", u, v));
    };
    both(1, 0), both(2, 0), both(0, 1), both(1, 1);
    // Counts of the 1000 rows: their variance n p q, known within sqrt(2 / 999) of it and what the
    // fourth moment of so few adds.
    Moments rows;
    for (int v = 0; v < 1000; ++v) rows.add(cv::countNonZero(dead.row(v)));
    const double law = 1000 * p * (1 - p);
    EXPECT_LT(std::abs(rows.variance() / law - 1), kSigmas * std::sqrt((2 + 1 / law) / 999.0));
    for (const int column : {0, 1, 998, 999})
      expect_share(cv::countNonZero(dead.col(column)), 1000, p, "column");
  }
}

TEST(NoiseLaw, OfLostAndLateFramesIsACoinForEachOfThem) {
  constexpr int kFrames = 1000000;
  const Plan plan = plan_of(million_text(
      "  - {use: drop, share: 0.2}\n  - {use: late, share: 0.3, by_ms: {from: 10, to: 50}}\n"));
  long lost = 0, late = 0, both = 0, lost_twice = 0;
  bool before = false;
  Moments by;
  for (int frame = 0; frame < kFrames; ++frame) {
    const Arrival arrival = plan.arrival(frame);
    lost += arrival.is_dropped;
    late += arrival.late_ms > 0;
    both += arrival.is_dropped && arrival.late_ms > 0;
    lost_twice += arrival.is_dropped && before;
    before = arrival.is_dropped;
    if (arrival.late_ms > 0) by.add((arrival.late_ms - 10) / 40);
  }
  expect_share(double(lost), kFrames, 0.2, "lost");
  expect_share(double(late), kFrames, 0.3, "late");
  expect_share(double(both), kFrames, 0.06, "both");
  expect_share(double(lost_twice), kFrames - 1, 0.04, "lost, and the one before too");
  // Even in [0, 1]: variance 1/12 and fourth central moment 1/80.
  const auto n = static_cast<double>(by.n);
  EXPECT_LT(std::abs(by.mean() - 0.5), kSigmas * std::sqrt(1 / (12 * n)));
  EXPECT_LT(std::abs(by.variance() - 1.0 / 12), kSigmas * std::sqrt((1.0 / 80 - 1.0 / 144) / n));
}

// Each dot as often as any other, and pairs of them as without a rule.
TEST(NoiseLaw, OfHiddenDotsIsTheSameForEachOfThem) {
  constexpr int kFrames = 4000;
  const Plan plan = plan_of(scene_text(
      "  - {use: sides, albedo: 0.1, depth_mm: 9}\n"
      "  - {use: markers, radius_mm: 1, setback_mm: 4, first: 0.2, last: 0.8, albedo: 1}\n"
      "  - {use: occlusion, count: 3}\n",
      "model: pinhole, size: [32, 18], fx: 17, fy: 17.2, cx: 15.8, cy: 9"));
  std::array<std::array<long, 12>, 12> hidden{};
  for (int frame = 0; frame < kFrames; ++frame) {
    const auto dots = plan.truth(frame).markers;
    for (std::size_t i = 0; i < 12; ++i)
      for (std::size_t j = 0; j <= i; ++j) hidden[i][j] += !dots[i].visible && !dots[j].visible;
  }
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      expect_share(double(hidden[i][j]), kFrames, i == j ? 3.0 / 12 : 3.0 / 12 * 2 / 11,
                   fmt::format("dots {} and {}", i, j));
}

}  // namespace
}  // namespace alltact
