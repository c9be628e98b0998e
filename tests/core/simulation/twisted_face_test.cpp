// Twisted faces and faces behind a window: rays met one by one, against geometry made here.
#include "core/camera/camera.h"
#include "tests/core/simulation/scene_text.h"

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

using Vector = Eigen::Matrix<long double, 3, 1>;

constexpr long double kLengthOfFace = 116, kHalfWidth = 12, kThickness = 1.5L;

struct TwistPose {
  double q1, q2, sway, twist_deg;
};

// Where the section at s lies: middle line by a fine midpoint rule, and how it is turned.
struct Section {
  Vector middle, along, across, normal;
};

class TwistedFinger {
 public:
  explicit TwistedFinger(const TwistPose& pose) : pose_(pose) {
    Vector at{-25, 0, 28};
    for (int i = 0; i <= kSteps; ++i) {
      middles_.push_back(at);
      const long double middle = theta((i + 0.5L) * kLengthOfFace / kSteps);
      at += kLengthOfFace / kSteps * Vector(std::cos(middle), 0, std::sin(middle));
    }
  }
  [[nodiscard]] Section at(long double s) const {
    const long double cell = s / kLengthOfFace * kSteps;
    const auto i = static_cast<std::size_t>(std::clamp<long double>(cell, 0, kSteps - 1));
    const Vector middle =
        middles_[i] + (cell - static_cast<long double>(i)) * (middles_[i + 1] - middles_[i]);
    const long double t = s / kLengthOfFace, a = theta(s);
    const long double twist = pose_.twist_deg * std::numbers::pi_v<long double> / 180 * t;
    const Vector y(0, 1, 0), up(-std::sin(a), 0, std::cos(a));
    return {middle + pose_.sway * t * t * y,
            {std::cos(a), 0, std::sin(a)},
            std::cos(twist) * y + std::sin(twist) * up,
            std::cos(twist) * up - std::sin(twist) * y};
  }
  /// The section in whose plane (at right angles to the middle line in x and z) the point lies.
  [[nodiscard]] long double section_of(const Vector& point) const {
    long double low = -10, high = kLengthOfFace + 10;
    for (int i = 0; i < 80; ++i) {
      const long double s = (low + high) / 2;
      const Section section = at(s);
      ((point - section.middle).dot(section.along) > 0 ? low : high) = s;
    }
    return (low + high) / 2;
  }
  [[nodiscard]] Vector outer(long double s, long double r) const {
    constexpr long double kBy = 1e-4L;
    const auto point = [&](long double at_s, long double at_r) -> Vector {
      const Section section = at(at_s);
      return section.middle + at_r * section.across;
    };
    const Vector normal = (point(s + kBy, r) - point(s - kBy, r))
                              .cross(point(s, r + kBy) - point(s, r - kBy))
                              .normalized();
    return point(s, r) + Vector(0, 0, kThickness / normal.z());
  }

 private:
  static constexpr int kSteps = 20000;
  [[nodiscard]] long double theta(long double s) const {
    const long double t = s / kLengthOfFace;
    return 34 * std::numbers::pi_v<long double> / 180 +
           (2 * pose_.q1 * t + pose_.q2 * (3 * t * t - 2 * t)) / kLengthOfFace;
  }
  TwistPose pose_;
  std::vector<Vector> middles_;
};

std::string text_of(const TwistPose& pose, const std::string& effects) {
  return fmt::format(
             "motion: {{kind: hold, pose: {{q1_mm: {}, q2_mm: {}, sway_mm: {}, "
             "twist_deg: {}}}}}\n",
             pose.q1, pose.q2, pose.sway, pose.twist_deg) +
         scene_text(
             "  - {use: bend, q1_mm: {from: -6, to: 6}, q2_mm: {from: -6, to: 6}}\n"
             "  - {use: sway, sway_mm: {from: -4, to: 4}}\n"
             "  - {use: twist, twist_deg: {from: -30, to: 30}}\n" +
             effects);
}

std::vector<TwistPose> random_twists(int n) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<TwistPose> poses;
  for (int i = 0; i < n; ++i)
    poses.push_back({5 * unit(random), 5 * unit(random), 3 * unit(random), 20 * unit(random)});
  return poses;
}

TEST(TwistedFace, LiesWhereItsSectionsLie) {
  for (const TwistPose& pose : random_twists(4)) {
    const TwistedFinger finger(pose);
    const Plan plan = plan_of(text_of(pose, ""));
    const Truth truth = plan.truth(0);
    int compared = 0;
    for (int v = 1; v < 180; v += 7)
      for (int u = 9; u < 320; u += 11) {
        const float z = truth.view_z_mm.at<float>(v, u);
        if (std::isnan(z)) continue;
        const Vector point = z * Vector((u - 158.5L) / 170, (v - 90.25L) / 172, 1);
        const long double s = finger.section_of(point);
        const Section section = finger.at(s);
        const Vector off = point - section.middle;
        EXPECT_NEAR(off.dot(section.normal), 0, 2e-5) << u << ' ' << v;
        EXPECT_LT(std::abs(off.dot(section.across)), kHalfWidth + 0.15L);
        if (s < 1 || s > kLengthOfFace - 1) continue;
        const long double t0 = truth.untouched_z_mm.at<float>(v, u) - z;
        const Vector outer = finger.outer(s, off.dot(section.across));
        EXPECT_NEAR(t0, outer.z() - point.z(), 3e-5);
        ++compared;
      }
    EXPECT_GT(compared, 120);
  }
}

// The face's edges in the picture are those of the sections' ends.
TEST(TwistedFace, EndsWhereItsEdgesAre) {
  for (const TwistPose& pose : random_twists(3)) {
    const TwistedFinger finger(pose);
    const cv::Mat_<float> image = plan_of(text_of(pose, "")).render(0);
    for (long double s = 12; s < 100; s += 9) {
      const Section section = finger.at(s);
      for (const int side : {-1, 1}) {
        const Vector edge = section.middle + side * kHalfWidth * section.across;
        const long double u = 158.5L + 170 * edge.x() / edge.z();
        const long double v = 90.25L + 172 * edge.y() / edge.z();
        if (u < 3 || u > 316 || v < 8 || v > 171) continue;
        // Straight between the two columns beside it: how much of them is face, from 8 px within.
        long double here = 0;
        const int left = static_cast<int>(std::floor(u));
        const int inner = static_cast<int>(std::lround(v)) - side * 6;
        for (int column = left; column <= left + 1; ++column) {
          long double rows = 0;
          for (int row = inner; row >= 0 && row < 180 && row != inner + side * 13; row += side)
            rows += image(row, column);
          const long double end = inner + side * (rows - 0.5L);
          here += (column == left ? left + 1 - u : u - left) * end;
        }
        EXPECT_NEAR(here, v, 0.03) << "s " << s << " side " << side;
      }
    }
  }
}

TEST(TwistedFace, CarriesItsDots) {
  for (const TwistPose& pose : random_twists(3)) {
    const TwistedFinger finger(pose);
    const Truth truth = plan_of(text_of(pose,
                                        "  - {use: sides, albedo: 0.3, depth_mm: 10}\n"
                                        "  - {use: markers, radius_mm: 0.5, setback_mm: 3, first: "
                                        "0.1, last: 0.9, albedo: 0.9}\n"))
                            .truth(0);
    ASSERT_EQ(truth.markers.size(), 12U);
    for (std::size_t i = 0; i < 12; ++i) {
      const Section section = finger.at(kLengthOfFace * (0.1L + 0.8L * (i % 6) / 5));
      const Vector centre =
          section.middle + (i < 6 ? -1 : 1) * kHalfWidth * section.across - 3 * section.normal;
      EXPECT_NEAR(truth.markers[i].u, 158.5L + 170 * centre.x() / centre.z(), 0.02);
      EXPECT_NEAR(truth.markers[i].v, 90.25L + 172 * centre.y() / centre.z(), 0.02);
    }
  }
}

const char* const kWholeFinger =
    "  - {use: ball, radius_mm: 4, depth_mm: 0.9, s_mm: 60, y_mm: 1}\n"
    "  - {use: rolloff, kind: hertz, length_mm: 0.8}\n"
    "  - {use: layer, scatter_per_mm: 0.6, along: normal}\n"
    "  - {use: sides, albedo: 0.3, depth_mm: 10}\n"
    "  - {use: markers, radius_mm: 1, setback_mm: 3, first: 0.1, last: 0.9, albedo: 0.9}\n"
    "  - {use: leds, lamps: [{at_mm: [0, 3, 0], power: 540000}]}\n";

// On the face the pictures are one. Where the side faces end, the columns' way tells a pixel's part
// by the distance across the ray, the rays' way by the one along the side: there they differ.
void expect_the_same(const Plan& a, const Plan& b) {
  const cv::Mat_<float> left = a.render(0), right = b.render(0);
  const cv::Mat differs = cv::abs(left - right) > 0.1;
  EXPECT_LT(cv::countNonZero(differs), 0.02 * static_cast<double>(left.total()));
  const cv::Mat face = a.truth_maps(0).labels == static_cast<int>(PixelLabel::kFace);
  cv::Mat inner;
  cv::erode(face, inner, cv::Mat());
  EXPECT_GT(cv::countNonZero(inner), 5000);
  EXPECT_EQ(cv::countNonZero(differs & inner), 0);
  cv::Mat rim;
  cv::dilate(face, rim, cv::Mat());
  rim -= inner;
  EXPECT_LT(cv::countNonZero(differs & rim), 0.2 * cv::countNonZero(rim));
}

// By columns a swaying side is as far aside as its column's point of the face: no sway here.
// Met ray by ray a face that is hardly twisted gives the picture of one that is met by columns.
TEST(TwistedFace, WithoutTwistIsTheFace) {
  const TwistPose hardly{3, -2, 0, 1e-6};
  const std::string untwisted =
      "motion: {kind: hold, pose: {q1_mm: 3, q2_mm: -2}}\n" +
      scene_text(std::string("  - {use: bend, q1_mm: {from: -6, to: 6}, q2_mm: {from: -6, to: 6}}\n"
                             "  - {use: sway, sway_mm: {from: -4, to: 4}}\n") +
                 kWholeFinger);
  const Plan plain = plan_of(untwisted), twisted = plan_of(text_of(hardly, kWholeFinger));
  expect_the_same(plain, twisted);
  const Truth a = plain.truth(0), b = twisted.truth(0);
  for (std::size_t i = 0; i < a.markers.size(); ++i) {
    EXPECT_NEAR(a.markers[i].u, b.markers[i].u, 1e-6);
    EXPECT_EQ(a.markers[i].visible, b.markers[i].visible);
  }
}

TEST(Port, OfAirIsNone) {
  const std::string through =
      std::string("  - {use: port, gap_mm: 3, plate_mm: 2, plate_index: 1, medium_index: 1}\n") +
      kWholeFinger;
  expect_the_same(plan_of(scene_text(kWholeFinger)), plan_of(scene_text(through)));
}

// Snell's law at both sides of the plate, by the angles, and the face's straight line.
TEST(Port, BendsTheRaysBySnell) {
  const Plan plan =
      plan_of(scene_text("  - {use: port, gap_mm: 3, plate_mm: 2, plate_index: 1.49}\n"));
  const Truth truth = plan.truth(0);
  int compared = 0;
  for (int v = 3; v < 180; v += 9)
    for (int u = 4; u < 320; u += 9) {
      const float z = truth.view_z_mm.at<float>(v, u);
      if (std::isnan(z)) continue;
      const long double x = (u - 158.5L) / 170, y = (v - 90.25L) / 172;
      const long double r = std::hypot(x, y), in_air = std::atan(r);
      const long double in_plate = std::asin(std::sin(in_air) / 1.49L);
      const long double in_silicone = std::asin(std::sin(in_air) / 1.41L);
      const long double off = 3 * r + 2 * std::tan(in_plate) + (z - 5) * std::tan(in_silicone);
      const long double at_x = r > 0 ? off * x / r : 0;
      const long double s = (at_x + 25) / std::cos(34 * std::numbers::pi_v<long double> / 180);
      if (s < 0.5L || s > kLengthOfFace - 0.5L) continue;
      EXPECT_NEAR(z, 28 + s * std::sin(34 * std::numbers::pi_v<long double> / 180), 3e-5);
      ++compared;
    }
  EXPECT_GT(compared, 150);
  EXPECT_TRUE(plan.finger().camera.port.has_value());
}

TEST(Twist, ByThreadsIsTheSame) {
  const Plan plan = plan_of(text_of({3, -2, 1.5, 9}, kWholeFinger));
  const cv::Mat one = plan.render(0);
  for (const int threads : {2, 3}) EXPECT_TRUE(same_bytes(one, plan.render(0, threads)));
}

TEST(Twist, RefusesWhatCannotBe) {
  EXPECT_THAT(refusal(text_of({0, 0, 0, 31}, "")), testing::HasSubstr("twist_deg"));
  EXPECT_THAT(refusal(scene_text("  - {use: port, gap_mm: 1, plate_mm: 2, until: 1}\n")),
              testing::HasSubstr("a lens does not change over time"));
  EXPECT_THAT(refusal(scene_text("  - {use: port, gap_mm: 1, plate_mm: 2, plate_index: 4}\n")),
              testing::HasSubstr("plate_index"));
  // Folds over within the picture.
  EXPECT_THAT(refusal(scene_text("  - {use: distortion, coefficients: [-2.0]}\n")),
              testing::HasSubstr("test.yaml:10: distortion"));
}

}  // namespace
}  // namespace alltact
