// The light's change against what was done to the pictures.
#include "core/sensing/depth/light_gain.h"

#include "core/sensing/depth/depth_map.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr int kWidth = 480, kHeight = 320;

FaceShape plane() {
  CameraParameters p;
  p.model = CameraModel::kOrthographic;
  p.width_px = kWidth, p.height_px = kHeight;
  p.cx_px = 0.5 * (kWidth - 1), p.cy_px = 0.5 * (kHeight - 1);
  p.mm_per_px = 0.05;
  Face face;
  face.kind = FaceKind::kFlat;
  face.layer_mm = 1.5;
  return FaceShape::plane(Camera::create(p).value(), face);
}

FaceRuns whole_face() { return face_runs(plane(), 2.0, {kWidth, kHeight}); }

/// A change of the light: what it multiplies the brightness with.
struct Change {
  double constant = 1, tilt_u = 0, tilt_v = 0, bow = 0;
  [[nodiscard]] double at(int u, int v) const {
    const double s = 2.0 * u / kWidth - 1.0, t = 2.0 * v / kHeight - 1.0;
    return constant * (1.0 + tilt_u * s + tilt_v * t + bow * (s * s + 0.5 * t * t));
  }
};

/// Dark discs with soft rims and bright halos, as balls make them.
struct Dents {
  struct Disc {
    double u, v, radius_px, depth;
  };
  std::vector<Disc> discs;
  [[nodiscard]] double at(int u, int v) const {
    double light = 1.0;
    for (const Disc& disc : discs) {
      const double r = std::hypot(u - disc.u, v - disc.v) / disc.radius_px;
      light *= 1.0 - disc.depth * std::max(0.0, 1.0 - r * r) +
               0.02 * std::exp(-std::pow((r - 1.2) / 0.15, 2));
    }
    return light;
  }
};

struct Pictures {
  cv::Mat live = cv::Mat(kHeight, kWidth, CV_8UC1);
  ReferenceImage untouched;

  Pictures(const Change& change, const Dents& dents, std::mt19937_64& random) {
    std::normal_distribution<double> noise(0.0, 1.0);
    cv::Mat levels(kHeight, kWidth, CV_32FC1);
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u) {
        const double level = 130.0 - 0.1 * u - 40.0 * std::pow(2.0 * v / kHeight - 1.0, 2);
        levels.at<float>(v, u) = static_cast<float>(level + noise(random));
        live.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(
            level * change.at(u, v) * dents.at(u, v) + noise(random));
      }
    untouched = ReferenceImage(levels);
  }
};

/// Root mean square of q times the true change, less 1, over the picture.
double error_of(const LightGain& light, const Change& change) {
  double sum = 0;
  int count = 0;
  for (int v = 5; v < kHeight; v += 10)
    for (int u = 5; u < kWidth; u += 10, ++count)
      sum += std::pow(light.at(u, v) * change.at(u, v) - 1.0, 2);
  return std::sqrt(sum / count);
}

LightGain gain_of(const Pictures& images) {
  return light_gain(images.live, images.untouched, whole_face(), 1.0, 1.0);
}

TEST(LightGain, FindsNoChangeWhereThereIsNone) {
  std::mt19937_64 random(1);
  for (int run = 0; run < 10; ++run) {
    const LightGain light = gain_of(Pictures({}, {}, random));
    EXPECT_LT(error_of(light, {}), 1e-3);
    EXPECT_GT(light.inlier_fraction(), 0.8);
    EXPECT_NEAR(light.change(), 0.0, 1e-3);
  }
}

TEST(LightGain, FindsAnySmoothChangeBesideContacts) {
  std::mt19937_64 random(2);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<double> errors;
  for (int run = 0; run < 40; ++run) {
    const Change change{between(0.7, 1.2), between(-0.04, 0.04), between(-0.04, 0.04),
                        between(-0.04, 0.04)};
    Dents dents;
    for (int i = 0, n = static_cast<int>(between(0, 3.99)); i < n; ++i)
      dents.discs.push_back(
          {between(0, kWidth), between(0, kHeight), between(20, 80), between(0.05, 0.5)});
    const double error = error_of(gain_of(Pictures(change, dents, random)), change);
    // Contacts whose soft rims cover much of the face may leave a little of themselves in it.
    EXPECT_LT(error, 0.01) << "run " << run << ", " << dents.discs.size() << " contacts";
    errors.push_back(error);
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[20], 0.001);
  EXPECT_LT(errors[35], 0.004);
}

TEST(LightGain, AContactOnMoreThanHalfOfTheFaceIsNoChangeOfTheLight) {
  std::mt19937_64 random(3);
  const Change change{0.97, 0.01, 0.0, 0.0};
  Pictures images(change, {}, random);
  // A flat thing presses evenly on three fifths of the face.
  images.live(cv::Rect(kWidth * 2 / 5, 0, kWidth * 3 / 5, kHeight)) *= 0.8;
  EXPECT_LT(error_of(gain_of(images), change), 0.02);
}

TEST(LightGain, AContactOnFourFifthsOrMoreIsNoChangeOfTheLight) {
  std::mt19937_64 random(5);
  for (const double untouched : {0.12, 0.15, 0.2, 0.25})
    for (const double darker : {0.1, 0.25, 0.5})
      for (const double relief : {0.0, 0.1}) {
        const Change change{0.9, 0.004, 0.0, 0.0};
        Pictures images(change, {}, random);
        const int first = static_cast<int>(untouched * kWidth);
        for (int v = 0; v < kHeight; ++v)
          for (int u = first; u < kWidth; ++u) {
            auto& level = images.live.at<std::uint8_t>(v, u);
            const double x = darker + relief * (u - first) / (kWidth - first);
            level = cv::saturate_cast<std::uint8_t>(level * (1.0 - x));
          }
        const LightGain light = gain_of(images);
        EXPECT_LT(error_of(light, change), 0.01) << untouched << ", " << darker << ", " << relief;
        EXPECT_LT(light.brighter(), 0.01);
      }
}

TEST(LightGain, ASpotThatIsBrighterIsNotTheLight) {
  // A reflection, a twentieth of the face; and skin of another finger, bright and dark in patches.
  std::mt19937_64 random(6);
  Pictures spot({}, {}, random);
  spot.live(cv::Rect(0, 0, kWidth / 4, kHeight / 5)) *= 1.15;
  EXPECT_LT(error_of(gain_of(spot), {}), 0.003);
  Pictures other({}, {}, random);
  for (int v = 0; v < kHeight; v += 20)
    for (int u = 0; u < kWidth; u += 20)
      other.live(cv::Rect(u, v, 20, 20)) *= std::normal_distribution<double>(1.0, 0.15)(random);
  const LightGain light = gain_of(other);
  EXPECT_GT(light.brighter(), 0.1);
  EXPECT_LT(std::abs(light.change()), 0.15);
}

TEST(LightGain, RowsAndPlacesAgree) {
  const LightGain light({20, 10, 300, 200}, {0.03, -0.02, 0.01, 0.015, -0.01, 0.02}, 1.0);
  for (int v = 0; v < 240; v += 7) {
    const auto row = light.of_row(v);
    for (int u = 0; u < 360; u += 11)
      EXPECT_NEAR(static_cast<double>(row[0] + static_cast<float>(u) *
                                                   (row[1] + static_cast<float>(u) * row[2])),
                  light.at(u, v), 1e-6);
  }
}

TEST(LightGain, NothingToCompareChangesNothing) {
  const FaceRuns face = whole_face();
  const ReferenceImage dark(cv::Mat(kHeight, kWidth, CV_32FC1, cv::Scalar(3.0)));
  const ReferenceImage white(cv::Mat(kHeight, kWidth, CV_32FC1, cv::Scalar(255.0)));
  const ReferenceImage even(cv::Mat(kHeight, kWidth, CV_32FC1, cv::Scalar(100.0)));
  for (const int level : {0, 255})
    for (const ReferenceImage* reference : {&dark, &white, &even}) {
      const LightGain light = light_gain(cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(level)),
                                         *reference, face, 1.0, 1.0);
      for (const double part : {0.0, 0.5, 1.0}) {
        const double q = light.at(part * kWidth, part * kHeight);
        EXPECT_TRUE(std::isfinite(q));
        EXPECT_EQ(q, 1.0) << level;
      }
    }
  const LightGain none =
      light_gain(cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(90)), even,
                 FaceRuns{{}, std::vector<std::uint32_t>(kHeight + 1, 0)}, 1.0, 1.0);
  EXPECT_EQ(none.at(3, 4), 1.0);
}

TEST(LightGain, DepthIsThatUnderTheOldLight) {
  std::mt19937_64 random(4);
  const Dents dents{{{240, 160, 60, 0.4}}};
  Reference reference;
  const FaceShape shape = plane();
  DifferenceOptions options;
  options.correct_light = true;
  for (const double brightness : {0.9, 1.0, 1.1}) {
    const Pictures images({brightness, 0.02, -0.02, 0.0}, dents, random);
    reference.image = images.untouched;
    const Difference with = difference(images.live, reference, shape, options);
    double sum = 0;
    int count = 0;
    for (int v = 100; v < 220; v += 2)
      for (int u = 180; u < 300; u += 2, ++count)
        sum += static_cast<double>(with.x.at<float>(v, u)) - (1.0 - dents.at(u, v));
    EXPECT_LT(std::abs(sum / count), 0.003) << brightness;
  }
}

}  // namespace
}  // namespace alltact
