#include "calibration/hard_cases/groups.h"
#include "core/grey_range.h"
#include "core/sensing/depth/local_depth.h"
#include "core/sensing/reference/reference_weights.h"

#include <random>

namespace alltact {
namespace {

HardAnswer answer_at(const Difference& difference, int v, int u) {
  switch (difference.flags.at<std::uint8_t>(v, u)) {
    case kMeasured:
      return number(static_cast<double>(difference.x.at<float>(v, u)));
    case kTooDark:
      return refused("too dark");
    case kSaturated:
      return refused("saturated");
    default:
      return refused("off the face");
  }
}

/// Pairs of grey levels. A number is required where the face has 12 to 249 levels and the live
/// image is not clipped, else the reason. Live pixels below three noise deviations, and faces of 8
/// to 11 levels, are not tested.
HardRow grey_pairs() {
  HardRow row{"brightness differences of all pairs of grey levels: wrong ones",
              "bytes subtracted and divided",
              "part wrong",
              0,
              HardMeasure::kWrong};
  constexpr int kDark = 12, kLeastLive = 3;
  cv::Mat live(256, 256, CV_8UC1), untouched(256, 256, CV_32FC1);
  for (int i = 0; i < 256; ++i)
    for (int k = 0; k < 256; ++k)
      live.at<std::uint8_t>(i, k) = static_cast<std::uint8_t>(i),
                               untouched.at<float>(i, k) = static_cast<float>(k);
  Reference reference;
  reference.image = ReferenceImage(untouched);
  const FaceShape shape = flat_sensor({256, 256}, 0.05);
  const Difference own = difference(live, reference, shape, {.smoothing = {}});
  for (int i = kLeastLive; i < 256; ++i)
    for (int k = 0; k < 256; ++k) {
      if (k >= kTooDarkBelow && k < kDark) continue;
      const double truth = static_cast<double>(k - i) / std::max(k, 1);
      const auto wrapped = static_cast<std::uint8_t>(k - i);
      row.ask(k < kTooDarkBelow ? expected_refusal({"too dark"})
              : k >= kClippedFrom || i >= kClippedFrom
                  ? expected_refusal({"saturated"})
                  : expected(truth, 1e-6 * (1.0 + std::abs(truth))),
              number(static_cast<double>(wrapped) / k),
              answer_at(own, i, k));
    }
  return row;
}

/// A press that takes a fifth of the brightness, on faces from 12 to 40 grey levels, 1 grey level
/// of noise in both images: the mean of the quotient is not the quotient of the means.
HardRow dark_reference() {
  HardRow row{"mean difference where the untouched face has 12 to 40 grey levels, truth 0.2: error",
              "(I_ref - I) / I_ref of each pixel",
              "of x",
              0.0015};
  constexpr double kTruth = 0.2, kNoise = 1.0;
  constexpr int kSide = 512, kLeast = 12, kMost = 40;
  const FaceShape shape = flat_sensor({kSide, kSide}, 0.05);
  std::mt19937 random(17);
  std::normal_distribution<double> noise(0.0, kNoise);
  for (int level = kLeast; level <= kMost; level += 4) {
    cv::Mat live(kSide, kSide, CV_8UC1), untouched(kSide, kSide, CV_32FC1);
    double naive = 0;
    for (int v = 0; v < kSide; ++v)
      for (int u = 0; u < kSide; ++u) {
        const double below = std::round(level + noise(random));
        live.at<std::uint8_t>(v, u) =
            cv::saturate_cast<std::uint8_t>((1.0 - kTruth) * level + noise(random));
        untouched.at<float>(v, u) = static_cast<float>(std::max(0.0, below));
        naive += (below - live.at<std::uint8_t>(v, u)) / below / (kSide * kSide);
      }
    Reference reference;
    reference.image = ReferenceImage(untouched);
    const Difference own = difference(live, reference, shape, {});
    const cv::Mat measured = own.flags == kMeasured;
    const bool enough = cv::countNonZero(measured) > 0.99 * kSide * kSide;
    row.ask(expected(kTruth, 1),
            number(naive),
            enough ? number(cv::mean(own.x, measured)[0]) : refused("too dark"));
  }
  return row;
}

/// Brightness that follows three modes of the pose, smoothly.
double brightness_at(const Eigen::Vector3d& pose) {
  const Eigen::Vector3d m = pose / 60.0;
  return 100.0 + 25.0 * m[0] - 12.0 * m[1] + 8.0 * m[2] + 6.0 * m[0] * m[0] - 4.0 * m[0] * m[1];
}

HardRow reference_brightness() {
  HardRow row{"brightness of a pose between 1650 recorded ones",
              "nearest frame",
              "relative, rms",
              0.0008,
              HardMeasure::kRms};
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-60.0, 60.0);
  constexpr int kRecorded = 1650, kNear = 12;
  std::vector<Eigen::Vector3d> poses;
  for (int i = 0; i < kRecorded; ++i)
    poses.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d query =
        0.9 * Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random));
    std::partial_sort(poses.begin(),
                      poses.begin() + kNear,
                      poses.end(),
                      [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                        return (a - query).squaredNorm() < (b - query).squaredNorm();
                      });
    Eigen::MatrixXd points(kNear, 3);
    for (int k = 0; k < kNear; ++k) points.row(k) = poses[static_cast<std::size_t>(k)].transpose();
    const Eigen::VectorXd weights = local_linear_weights(points, query, 0.5, 3.0);
    double mixed = 0;
    for (int k = 0; k < kNear; ++k)
      mixed += weights[k] * brightness_at(poses[static_cast<std::size_t>(k)]);
    row.ask(expected(brightness_at(query)), number(brightness_at(poses.front())), number(mixed));
  }
  return row;
}

}  // namespace

std::vector<HardRow> hard_brightness() {
  return {grey_pairs(), dark_reference(), reference_brightness()};
}

}  // namespace alltact
