// What two fingers tell of an object between them, against objects that are put there.
#include "core/gripper/held_object.h"

#include "core/geometry/surface_distance.h"
#include "tests/core/gripper/gripper_files.h"

#include <cmath>
#include <cstdio>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

using Vector = Eigen::Vector3d;
constexpr double kToDeg = 180.0 / M_PI;

Gripper held_gripper() {
  auto gripper = Gripper::parse(test::kGripper, "gripper.yaml");
  EXPECT_TRUE(gripper);
  return *gripper;
}

double axial_apart(double a_deg, double b_deg) { return std::remainder(a_deg - b_deg, 180.0); }

/// A contact of a stick of this direction in the gripper, as the finger's camera sees it.
ObservedContact contact_in(const FingerPose& finger, const Vector& at_mm, const Vector& along,
                           const Vector& normal) {
  const RigidTransform camera = finger.gripper_from_camera.inverse();
  ObservedContact contact;
  contact.position_mm = camera.point(at_mm);
  contact.axis = camera.direction(along.normalized());
  contact.axis_sd_deg = 1.0;
  contact.face_normal = camera.direction(normal);
  return contact;
}

TEST(HeldObject, ItsWidthIsAsSureAsItSays) {
  const Gripper gripper = held_gripper();
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0, 1);
  double normalised = 0, mean = 0;
  constexpr int kRuns = 2000;
  constexpr double kMotorSd = 0.02;
  for (int run = 0; run < kRuns; ++run) {
    const double told = 2 + 6.0 * run / kRuns, stands = told + kMotorSd * normal(random);
    const auto truth = gripper.pose_at(stands), pose = gripper.pose_at(told, kMotorSd);
    ASSERT_TRUE(truth && pose);
    const std::array<Vector, 2> places{Vector(-9, 1, 90), Vector(11, -2, 95)};
    std::array<ObservedContact, 2> contacts;
    for (std::size_t i = 0; i < 2; ++i) {
      contacts[i].position_mm = truth->fingers[i].gripper_from_camera.inverse().point(places[i]);
      Eigen::Matrix3d half;
      half << 0.03, 0.01, 0, 0, 0.02, 0.04, -0.02, 0, 0.05;
      contacts[i].position_covariance_mm2 = half * half.transpose();
      contacts[i].position_mm += half * Vector(normal(random), normal(random), normal(random));
    }
    const HeldWidth width = held_width(*pose, contacts);
    ASSERT_TRUE(width.sd_mm);
    mean += (width.mm - 20) / kRuns;
    normalised += std::pow((width.mm - 20) / *width.sd_mm, 2) / kRuns;
    contacts[1].position_covariance_mm2.reset();
    EXPECT_FALSE(held_width(*pose, contacts).sd_mm) << "absent, never zero";
  }
  std::printf("[ figures  ] width: normalised error squared %.3f, bias %.4f mm\n", normalised,
              mean);
  EXPECT_NEAR(normalised, 1, 4 * std::sqrt(2.0 / kRuns));
  EXPECT_LT(std::abs(mean), 0.02);
}

TEST(HeldObject, TheTurnBringsItUpright) {
  const Gripper gripper = held_gripper();
  std::mt19937 random(12);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int run = 0; run < 500; ++run) {
    const auto pose = gripper.pose_at(draw(0, 10), 0.0);
    const std::size_t finger = run % 2;
    const Vector along(draw(-0.3, 0.3), draw(-1, 1), draw(-1, 1)),
        up(draw(-0.5, 0.5), draw(-1, 1), draw(-1, 1));
    if (along.tail<2>().norm() < 0.4 || up.tail<2>().norm() < 0.4) continue;
    const Vector across = along.cross(Vector::UnitX()).normalized();
    const ObservedContact contact =
        contact_in(pose->fingers[finger], {0, 0, 80}, along, along.cross(across).normalized());
    const auto turn = upright_turn_deg(*pose, finger, contact, up);
    ASSERT_TRUE(turn);
    EXPECT_GT(turn->deg, -90.0);
    EXPECT_LE(turn->deg, 90.0);
    // Turned so, the axis and the way up are one, seen along x.
    const Vector turned = Eigen::AngleAxisd(turn->deg / kToDeg, Vector::UnitX()) * along;
    const double sine = (turned.y() * up.z() - turned.z() * up.y()) /
                        (turned.tail<2>().norm() * up.tail<2>().norm());
    EXPECT_NEAR(sine, 0, 1e-9);
    // The nearer way: the other is longer.
    EXPECT_LE(std::abs(turn->deg), std::abs(turn->deg > 0 ? turn->deg - 180 : turn->deg + 180));
  }
  // 30 degrees from y towards z, with z up: 60 degrees on.
  const auto pose = gripper.pose_at(5, 0.0);
  const ObservedContact tilted = contact_in(
      pose->fingers[0], {0, 0, 80}, {0, std::cos(M_PI / 6), std::sin(M_PI / 6)}, Vector::UnitX());
  EXPECT_NEAR(upright_turn_deg(*pose, 0, tilted, {0, 0, 1})->deg, 60, 1e-9);
  EXPECT_NEAR(upright_turn_deg(*pose, 0, tilted, {0, 0, -5})->deg, 60, 1e-9);
  EXPECT_NEAR(upright_turn_deg(*pose, 0, tilted, {0, 1, 0})->deg, -30, 1e-9);
  EXPECT_NEAR(upright_turn_deg(*pose, 0, tilted, {0, 0, 1})->sd_deg, 1, 1e-9);
}

TEST(HeldObject, WhereThereIsNoAxisThereIsNoTurn) {
  const auto pose = held_gripper().pose_at(5, 0.0);
  ObservedContact contact = contact_in(pose->fingers[0], {0, 0, 80}, {0, 1, 0}, Vector::UnitX());
  EXPECT_TRUE(upright_turn_deg(*pose, 0, contact, {0, 0, 1}));
  EXPECT_FALSE(upright_turn_deg(*pose, 0, contact, {1, 0, 0})) << "no turn about x brings it there";
  EXPECT_FALSE(upright_turn_deg(*pose, 0, contact, {0, 0, 0}));
  const ObservedContact closing =
      contact_in(pose->fingers[0], {0, 0, 80}, {1, 0.1, 0}, Vector::UnitZ());
  EXPECT_FALSE(upright_turn_deg(*pose, 0, closing, {0, 0, 1}));
  contact.axis.reset();
  EXPECT_FALSE(upright_turn_deg(*pose, 0, contact, {0, 0, 1})) << "round";
}

TEST(HeldObject, TurnsOfOneFingerAndOfTwoAreAsSureAsTheySay) {
  // Faces inclined to the closing direction, so that a turn within the face is another seen along
  // x.
  const Gripper gripper = held_gripper();
  std::mt19937 random(13);
  std::normal_distribution<double> normal(0, 1);
  double one = 0, both = 0, apart = 0;
  constexpr int kRuns = 2000;
  for (int run = 0; run < kRuns; ++run) {
    const auto pose = gripper.pose_at(2 + 6.0 * run / kRuns, 0.0);
    const double beta = M_PI * run / kRuns;
    std::array<UprightTurn, 2> turns;
    const double truth = axial_apart(90, beta * kToDeg);
    for (std::size_t i = 0; i < 2; ++i) {
      const double side = i == 0 ? 1.0 : -1.0;
      const Vector face = Vector(side, 0, 0.4).normalized();
      // The stick as seen along x, laid into the face.
      Vector along(0, std::cos(beta), std::sin(beta));
      along.x() = -face.tail<2>().dot(along.tail<2>()) / face.x();
      along = Eigen::AngleAxisd((i == 0 ? 0.8 : 2.0) / kToDeg * normal(random), face) * along;
      ObservedContact contact = contact_in(pose->fingers[i], {0, 0, 80}, along, face);
      contact.axis_sd_deg = i == 0 ? 0.8 : 2.0;
      const auto turn = upright_turn_deg(*pose, i, contact, {0, 0, 1});
      ASSERT_TRUE(turn);
      turns[i] = *turn;
      one += std::pow(axial_apart(turn->deg, truth) / turn->sd_deg, 2) / (2 * kRuns);
    }
    const auto joint = joint_turn(turns[0], turns[1]);
    ASSERT_TRUE(joint);
    EXPECT_GT(joint->mean.deg, -90.0);
    EXPECT_LE(joint->mean.deg, 90.0);
    both += std::pow(axial_apart(joint->mean.deg, truth) / joint->mean.sd_deg, 2) / kRuns;
    apart += std::pow(joint->difference_sds, 2) / kRuns;
    EXPECT_LT(joint->mean.sd_deg, std::min(turns[0].sd_deg, turns[1].sd_deg));
    EXPECT_TRUE(joint->agree || joint->difference_sds > 4);
  }
  std::printf(
      "[ figures  ] upright turn: normalised error squared %.3f of one finger, %.3f of two; "
      "their difference %.3f\n",
      one, both, apart);
  EXPECT_NEAR(one, 1, 4 * std::sqrt(1.0 / kRuns));
  EXPECT_NEAR(both, 1, 4 * std::sqrt(2.0 / kRuns));
  EXPECT_NEAR(apart, 1, 4 * std::sqrt(2.0 / kRuns));
}

TEST(HeldObject, TheMeanOfAxesHasNoSeamAndSaysWhenTheyDiffer) {
  // NUMERICS: 179.5, 0.5 are one axis; the naive mean is at right angles to both.
  const auto seam = joint_turn({89.5, 0.5}, {-89.5, 0.5});
  ASSERT_TRUE(seam);
  EXPECT_NEAR(std::abs(seam->mean.deg), 90, 1e-9);
  EXPECT_NEAR(seam->difference_deg, 1, 1e-9);
  EXPECT_TRUE(seam->agree);
  EXPECT_NEAR(seam->mean.sd_deg, 0.5 / std::sqrt(2.0), 1e-12);
  const auto differ = joint_turn({10, 0.5}, {20, 0.5});
  ASSERT_TRUE(differ);
  EXPECT_FALSE(differ->agree);
  EXPECT_NEAR(differ->difference_sds, 10 / std::hypot(0.5, 0.5), 1e-9);
  EXPECT_FALSE(joint_turn({0, 1}, {90, 1})) << "no mean";
  EXPECT_NEAR(joint_turn({0, 1}, {90, 3})->mean.deg, 0, 1e-9) << "the surer one";
  const auto exact = joint_turn({30, 0}, {30, 0});
  ASSERT_TRUE(exact);
  EXPECT_TRUE(std::isfinite(exact->mean.deg) && std::isfinite(exact->difference_sds));
}

/// A dome towards the other finger, its top at x in the gripper, as that finger's camera sees it.
cv::Mat dome(const FingerPose& finger, double top_x, double way, const cv::Mat& noise_mm,
             double z_error) {
  constexpr int kSide = 90;
  const RigidTransform camera = finger.gripper_from_camera.inverse();
  cv::Mat points(kSide, kSide, CV_32FC3);
  for (int v = 0; v < kSide; ++v)
    for (int u = 0; u < kSide; ++u) {
      const double y = 0.1 * (u - 44), z = 0.1 * (v - 40);
      const Vector at(top_x + way * (y * y + z * z) / 80.0, y, 90 + z);
      Vector seen = camera.point(at);
      seen += z_error / seen.z() * seen;
      seen.z() += noise_mm.empty() ? 0.0 : static_cast<double>(noise_mm.at<float>(v, u));
      points.at<cv::Vec3f>(v, u) = {static_cast<float>(seen.x()), static_cast<float>(seen.y()),
                                    static_cast<float>(seen.z())};
    }
  return points;
}

TEST(FaceGap, IsThatOfTwoDomesAndAsSureAsItSays) {
  const Gripper gripper = held_gripper();
  std::mt19937 random(14);
  cv::RNG grains(3);
  std::normal_distribution<double> normal(0, 1);
  constexpr int kRuns = 60;
  const double kMotorSd = 0.005, kZSd = 0.02, kNoise = 0.02;
  double normalised = 0, bias = 0, plain = 0;
  for (int run = 0; run < kRuns; ++run) {
    const double told = 2 + 6.0 * run / kRuns, gap = 0.5 + 0.3 * run;
    const auto truth = gripper.pose_at(told + kMotorSd * normal(random)),
               pose = gripper.pose_at(told, kMotorSd);
    std::array<GapFace, 2> faces;
    std::array<PosedSurface, 2> surfaces;
    for (std::size_t i = 0; i < 2; ++i) {
      const double side = i == 0 ? -1.0 : 1.0;
      cv::Mat grain(90, 90, CV_32FC1);
      grains.fill(grain, cv::RNG::NORMAL, 0.0, kNoise * 2 * std::sqrt(M_PI));
      cv::GaussianBlur(grain, grain, {}, 1.0);
      faces[i].points_mm =
          dome(truth->fingers[i], side * gap / 2, side, grain, kZSd * normal(random));
      faces[i].z_sd_mm = [=](double) { return std::optional<double>(kZSd); };
      faces[i].correlated_px2 = 4 * M_PI;
      surfaces[i] = {faces[i].points_mm, pose->fingers[i].gripper_from_camera};
    }
    const auto found = face_gap(*pose, faces);
    ASSERT_TRUE(found && found->sd_mm);
    bias += (found->mm - gap) / kRuns;
    plain += (nearest_points(surfaces[0], surfaces[1])->distance() - gap) / kRuns;
    normalised += std::pow((found->mm - gap) / *found->sd_mm, 2) / kRuns;
    EXPECT_NEAR((found->second_mm - found->first_mm).norm(), std::abs(found->mm), 1e-6);
    faces[1].z_sd_mm = {};
    EXPECT_FALSE(face_gap(*pose, faces)->sd_mm);
  }
  std::printf(
      "[ figures  ] gap: normalised error squared %.3f, bias %.4f mm (nearest points as they "
      "are: %.4f mm)\n",
      normalised, bias, plain);
  EXPECT_NEAR(normalised, 1, 4 * std::sqrt(2.0 / kRuns));
  EXPECT_LT(std::abs(bias), std::abs(plain));
}

TEST(FaceGap, OfExactDomesIsExactAndOfNothingAbsent) {
  const auto pose = held_gripper().pose_at(5, 0.0);
  std::array<GapFace, 2> faces;
  for (std::size_t i = 0; i < 2; ++i)
    faces[i].points_mm = dome(pose->fingers[i], i == 0 ? -3.5 : 2.5, i == 0 ? -1 : 1, {}, 0);
  const auto found = face_gap(*pose, faces);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mm, 6.0, 1e-4);
  EXPECT_NEAR((found->first_mm - Vector(-3.5, 0, 90)).norm(), 0, 0.1);
  faces[0].points_mm.setTo(cv::Scalar::all(std::nan("")));
  EXPECT_FALSE(face_gap(*pose, faces));
  faces[0].points_mm = cv::Mat();
  EXPECT_FALSE(face_gap(*pose, faces));
}

}  // namespace
}  // namespace alltact
