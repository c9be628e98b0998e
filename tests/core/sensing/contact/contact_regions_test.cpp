#include "core/sensing/contact/contact_regions.h"

#include "core/sensing/depth/depth_map.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kMmPerPx = 0.05;
constexpr int kWidth = 460, kHeight = 345;

struct FlatFace {
  FlatFace() : shape(make()) {}
  static Face face() {
    Face f;
    f.kind = FaceKind::kFlat;
    f.layer_mm = 2.0;
    f.plane_z_mm = 10.0;
    return f;
  }
  static FaceShape make() {
    CameraParameters p;
    p.model = CameraModel::kOrthographic;
    p.width_px = kWidth, p.height_px = kHeight;
    p.cx_px = 0.5 * (kWidth - 1), p.cy_px = 0.5 * (kHeight - 1);
    p.mm_per_px = kMmPerPx;
    return FaceShape::plane(Camera::create(p).value(), face());
  }
  FaceShape shape;
};

/// A paraboloid dent with half axes a, b (mm) where its depth is 0, turned by an angle.
void press(DepthMap& map, double x, double y, double a, double b, double deepest,
           double angle_deg) {
  const double c = std::cos(angle_deg * M_PI / 180.0), s = std::sin(angle_deg * M_PI / 180.0);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const double dx = (u - 0.5 * (kWidth - 1)) * kMmPerPx - x;
      const double dy = (v - 0.5 * (kHeight - 1)) * kMmPerPx - y;
      const double p = (c * dx + s * dy) / a, q = (-s * dx + c * dy) / b;
      const double d = deepest * (1.0 - p * p - q * q);
      float& depth = map.depth_mm.at<float>(v, u);
      depth = std::max(depth, static_cast<float>(d));
    }
  }
}

DepthMap untouched() {
  DepthMap map;
  map.depth_mm = cv::Mat::zeros(kHeight, kWidth, CV_32FC1);
  map.flags = cv::Mat::zeros(kHeight, kWidth, CV_8UC1);
  return map;
}

std::vector<ContactRegion> regions_of(const DepthMap& map, double threshold_mm = 0.05) {
  const FlatFace flat;
  RegionOptions options;
  options.threshold_mm = threshold_mm;
  DepthMap with_cells = map;
  with_cells.cells_mm = depth_cells(map.depth_mm);
  return contact_regions(with_cells, flat.shape, FlatFace::face(), options);
}

TEST(ContactRegions, MeasuresWhatAnEllipticDentIs) {
  std::mt19937 engine(9);
  for (int run = 0; run < 20; ++run) {
    const auto draw = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(engine);
    };
    const double x = draw(-5, 5), y = draw(-3, 3), a = draw(3.0, 4.5), b = draw(1.2, 2.2);
    const double deepest = draw(0.4, 1.2), angle = draw(-89, 90);
    DepthMap map = untouched();
    press(map, x, y, a, b, deepest, angle);
    const auto regions = regions_of(map);
    ASSERT_EQ(regions.size(), 1U);
    const ContactRegion& r = regions[0];
    // of a paraboloid cut at the threshold h: area pi a b (1 - h/D), volume above 0 within it
    const double cut = 1.0 - 0.05 / deepest;
    EXPECT_NEAR(r.area_mm2, M_PI * a * b * cut, 0.02 * M_PI * a * b);
    EXPECT_NEAR(r.volume_mm3, M_PI * a * b * deepest * (cut - 0.5 * cut * cut),
                0.01 * a * b * deepest);
    EXPECT_NEAR(r.deepest_mm, deepest, 0.01);
    EXPECT_NEAR(r.position_mm.x(), x, 0.02);
    EXPECT_NEAR(r.position_mm.y(), y, 0.02);
    EXPECT_NEAR(r.deepest_point_mm.z(), 12.0 - deepest, 0.02);
    ASSERT_TRUE(r.angle_deg.has_value());
    const double turned = std::remainder(*r.angle_deg - angle, 180.0);  // axial
    EXPECT_LT(std::abs(turned), 0.5);
    EXPECT_GT(*r.angle_deg, -90.0);
    EXPECT_LE(*r.angle_deg, 90.0);
  }
}

TEST(ContactRegions, TheAnglesErrorIsWhatItSaysItIs) {
  // Dents of random form and noise as after smoothing: normalised error squared over 400 runs.
  std::mt19937 engine(31);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  constexpr double kNoiseMm = 0.01, kSmoothingPx = 1.0;
  cv::RNG noise(17);
  double squares = 0;
  for (int run = 0; run < 400; ++run) {
    const double a = draw(2.0, 4.0), b = a * draw(0.25, 0.7), angle = draw(-89, 90);
    DepthMap map = untouched();
    press(map, draw(-3, 3), draw(-2, 2), a, b, draw(0.4, 1.2), angle);
    cv::Mat grain(map.depth_mm.size(), CV_32FC1);
    noise.fill(grain, cv::RNG::NORMAL, 0.0, kNoiseMm * 2.0 * std::sqrt(M_PI) * kSmoothingPx);
    cv::GaussianBlur(grain, grain, {}, kSmoothingPx);
    map.depth_mm = cv::max(map.depth_mm + grain, 0.0F);
    map.cells_mm = depth_cells(map.depth_mm);
    RegionOptions options;
    options.noise_mm = kNoiseMm;
    options.correlated_px2 = 4 * M_PI * kSmoothingPx * kSmoothingPx;
    const FlatFace flat;
    const auto regions = contact_regions(map, flat.shape, FlatFace::face(), options);
    ASSERT_EQ(regions.size(), 1U);
    ASSERT_TRUE(regions[0].angle_deg.has_value());
    const double error = std::remainder(*regions[0].angle_deg - angle, 180.0);
    squares += std::pow(error / *regions[0].angle_sd_deg, 2) / 400;
  }
  std::printf("[ figures  ] angle of a contact: normalised error squared %.3f\n", squares);
  EXPECT_GT(squares, 0.85);
  EXPECT_LT(squares, 1.15);
}

TEST(ContactRegions, ARoundContactHasNoAngleAndSaysSo) {
  DepthMap map = untouched();
  press(map, 0, 0, 0.9, 0.9, 0.5, 0);
  const auto regions = regions_of(map);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_FALSE(regions[0].angle_deg.has_value());
  EXPECT_FALSE(regions[0].angle_sd_deg.has_value());
}

TEST(ContactRegions, TwoContactsAreTwoRegionsLargestFirst) {
  DepthMap map = untouched();
  press(map, -5, 0, 1.0, 1.0, 0.5, 0);
  press(map, 5, 2, 2.0, 2.0, 0.8, 0);
  const auto regions = regions_of(map);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_NEAR(regions[0].position_mm.x(), 5.0, 0.02);
  EXPECT_NEAR(regions[1].position_mm.x(), -5.0, 0.02);
}

TEST(ContactRegions, UntouchedOrUnmeasuredIsNoRegion) {
  EXPECT_TRUE(regions_of(untouched()).empty());
  DepthMap map = untouched();
  map.depth_mm = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(regions_of(map).empty());
  DepthMap speck = untouched();
  press(speck, 0, 0, 0.15, 0.15, 1.0, 0);  // smaller than a quarter of a square millimetre
  EXPECT_TRUE(regions_of(speck).empty());
}

TEST(ContactRegions, MissingPixelsInsideDoNotSplitOrPoisonARegion) {
  DepthMap map = untouched();
  press(map, 0, 0, 3.0, 2.0, 0.8, 30);
  for (int v = 0; v < kHeight; v += 7)
    for (int u = v % 5; u < kWidth; u += 5)
      map.depth_mm.at<float>(v, u) = std::numeric_limits<float>::quiet_NaN();
  const auto regions = regions_of(map);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_NEAR(regions[0].deepest_mm, 0.8, 0.01);
  EXPECT_NEAR(*regions[0].angle_deg, 30.0, 1.0);
}

TEST(ContactRegions, ThePolygonIsTheDentsOutline) {
  for (const double angle : {0.0, 25.0, -70.0}) {
    DepthMap map = untouched();
    press(map, 1.0, -0.5, 4.0, 1.8, 0.8, angle);
    const auto regions = regions_of(map);
    ASSERT_EQ(regions.size(), 1U);
    const auto& polygon = regions[0].polygon_mm;
    ASSERT_GE(polygon.size(), 12U);
    EXPECT_LE(polygon.size(), 80U);
    double twice = 0;
    const FlatFace flat;
    const Eigen::Vector2d middle = flat.shape.position_mm(0.5 * (kWidth - 1), 0.5 * (kHeight - 1));
    const double c = std::cos(angle * M_PI / 180.0), s = std::sin(angle * M_PI / 180.0);
    const double cut = std::sqrt(1.0 - 0.05 / 0.8);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()],
                            &after = polygon[(i + 2) % polygon.size()];
      twice += a.x() * b.y() - a.y() * b.x();
      const Eigen::Vector2d one = b - a, next = after - b;
      EXPECT_NE(one.x() * next.y() - one.y() * next.x(), 0.0);
      // Every corner lies on the ellipse to a pixel.
      const Eigen::Vector2d d = a - middle - Eigen::Vector2d(1.0, -0.5);
      const double p = (c * d.x() + s * d.y()) / 4.0, q = (-s * d.x() + c * d.y()) / 1.8;
      EXPECT_NEAR(std::hypot(p, q), cut, 1.5 * kMmPerPx / 1.8);
    }
    EXPECT_NEAR(0.5 * std::abs(twice), M_PI * 4.0 * 1.8 * cut * cut, 0.02 * M_PI * 4.0 * 1.8);
  }
}

TEST(ContactRegions, TheAxisInSpaceIsTheAngleOnTheFace) {
  DepthMap map = untouched();
  press(map, 0, 0, 4.0, 1.5, 0.8, 35);
  const auto regions = regions_of(map);
  ASSERT_EQ(regions.size(), 1U);
  ASSERT_TRUE(regions[0].axis);
  const Eigen::Vector3d& axis = *regions[0].axis;
  EXPECT_NEAR(axis.norm(), 1.0, 1e-12);
  EXPECT_NEAR(axis.z(), 0.0, 1e-12) << "the face is the plane z = const";
  EXPECT_NEAR(std::atan2(axis.y(), axis.x()) * 180.0 / M_PI, *regions[0].angle_deg, 1e-9);
  EXPECT_FALSE(regions[0].position_covariance_mm2) << "nothing was told of the depth's error";
}

TEST(ContactRegions, OverUnevenNoiseTheAxisIsAsSureAsItSays) {
  // The noise grows by a factor of 4 in 8 mm along the face, as it does far from the lamps. Weighed
  // by it the axis scatters as much as it says, and no more than with all counted alike.
  std::mt19937 engine(8);
  cv::RNG noise(5);
  const FlatFace flat;
  const auto noise_at = [](int u, int) {
    return 0.02 * std::pow(4.0, (u - 0.5 * kWidth) * kMmPerPx / 8.0);
  };
  double even = 0, weighed = 0, normalised = 0, normalised_position = 0;
  constexpr int kRuns = 300;
  for (int run = 0; run < kRuns; ++run) {
    const double angle = std::uniform_real_distribution<double>(-89, 90)(engine);
    DepthMap map = untouched();
    press(map, 0, 0, 4.5, 0.9, 0.9, angle);
    cv::Mat grain(map.depth_mm.size(), CV_32FC1);
    noise.fill(grain, cv::RNG::NORMAL, 0.0, 1.0);
    cv::GaussianBlur(grain * 2.0 * std::sqrt(M_PI), grain, {}, 1.0);
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u) {
        float& depth = map.depth_mm.at<float>(v, u);
        if (depth > 0) depth += static_cast<float>(noise_at(u, v)) * grain.at<float>(v, u);
      }
    map.cells_mm = depth_cells(map.depth_mm);
    RegionOptions options;
    options.noise_mm = 0.02, options.correlated_px2 = 4 * M_PI;
    const auto error_of = [&](const std::vector<ContactRegion>& regions) {
      EXPECT_TRUE(!regions.empty() && regions[0].angle_deg);
      return std::remainder(*regions[0].angle_deg - angle, 180.0);
    };
    even += std::pow(error_of(contact_regions(map, flat.shape, FlatFace::face(), options)), 2);
    options.untouched = [&](int u, int v) { return UntouchedSd{noise_at(u, v), 0.0}; };
    options.pressed = [&](int u, int v, double) {
      DepthErrorTerms causes;
      causes.noise = noise_at(u, v);
      return causes;
    };
    const auto regions = contact_regions(map, flat.shape, FlatFace::face(), options);
    const double error = error_of(regions);
    weighed += error * error;
    normalised += std::pow(error / *regions[0].angle_sd_deg, 2) / kRuns;
    // The plane is known and so is the lens: the position errs on the face by noise alone.
    ASSERT_TRUE(regions[0].position_covariance_mm2);
    const Eigen::Matrix2d by_noise_mm2 = regions[0].position_covariance_mm2->topLeftCorner<2, 2>();
    const Eigen::Vector2d off_mm = regions[0].position_mm.head<2>();  // pressed at 0, 0
    normalised_position += off_mm.dot(by_noise_mm2.inverse() * off_mm) / (2 * kRuns);
  }
  std::printf(
      "[ figures  ] axis over uneven noise: even weights %.3f, 1/variance %.3f degrees rms; "
      "normalised error squared %.3f, of the position %.3f\n",
      std::sqrt(even / kRuns), std::sqrt(weighed / kRuns), normalised, normalised_position);
  EXPECT_GT(normalised_position, 0.7);
  EXPECT_LT(normalised_position, 1.4);
  EXPECT_LT(weighed, 1.1 * even);
  EXPECT_NE(weighed, even) << "the weights do something";
  EXPECT_GT(normalised, 0.8);
  EXPECT_LT(normalised, 1.2);
}

TEST(ContactRegions, ThePlacesCovarianceIsSightAndDepth) {
  DepthMap map = untouched();
  press(map, 0, 0, 3.0, 2.0, 0.8, 10);
  map.cells_mm = depth_cells(map.depth_mm);
  RegionOptions options;
  options.pressed = [](int, int, double) { return DepthErrorTerms{0.0, 0.03, 0.04, 0.12, 5.0}; };
  const FlatFace flat;
  const auto regions = contact_regions(map, flat.shape, FlatFace::face(), options);
  ASSERT_EQ(regions.size(), 1U);
  ASSERT_TRUE(regions[0].position_covariance_mm2);
  EXPECT_NEAR((*regions[0].position_covariance_mm2)(2, 2), 0.13 * 0.13, 1e-12)
      << "what the whole contact shares, and nothing of single edges";
}

}  // namespace
}  // namespace alltact
