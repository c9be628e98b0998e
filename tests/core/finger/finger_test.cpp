// What a finger file says, and that it stays when it is written.
#include "core/finger/finger.h"

#include "core/base/atomic_file.h"
#include "core/base/typed_number.h"
#include "tests/core/finger/finger_files.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace alltact {
namespace {

using test::kFinRay;
using test::kFlat;
using testing::ElementsAre;
using testing::HasSubstr;

using FingerFile = test::FingerFiles;

TEST_F(FingerFile, EveryValueIsRead) {
  std::vector<Message> warnings;
  const auto finger = load(kFinRay, &warnings);
  ASSERT_TRUE(finger.ok()) << finger.error().sentence();
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(finger->name, "left-07");
  EXPECT_EQ(finger->camera.model, CameraModel::kBrown);
  EXPECT_EQ(finger->camera.width_px, 960);
  EXPECT_EQ(finger->camera.height_px, 540);
  EXPECT_EQ(finger->camera.fx_px, 523.9);
  EXPECT_EQ(finger->camera.fy_px, 524.5);
  EXPECT_THAT(finger->camera.distortion, ElementsAre(-0.05, 0.01, 0.0001, -0.0002, 0.001));
  EXPECT_EQ(finger->camera.orientation, Orientation::kFlipV);
  EXPECT_EQ(finger->face.kind, FaceKind::kFinRay);
  EXPECT_EQ(finger->face.width_mm, 24);
  EXPECT_EQ(finger->face.layer_mm, 1.5);
  EXPECT_EQ(finger->marker_count(), 4);
  EXPECT_EQ(finger->markers.polarity, Polarity::kBright);
  ASSERT_TRUE(finger->mapping);
  EXPECT_EQ(finger->mapping->along, MappingAlong::kNormal);
  EXPECT_EQ(finger->mapping->x_max, 0.5);
  EXPECT_THAT(finger->mapping->chebyshev, ElementsAre(2.0, 0.5));
  EXPECT_EQ(finger->mapping->covariance(1, 1), 0.0002);
  ASSERT_TRUE(finger->mapping_record);
  EXPECT_EQ(finger->mapping_record->method, "joint");
  EXPECT_THAT(finger->mapping_record->presses, ElementsAre("press_000", "press_001"));
  EXPECT_EQ(finger->mapping_record->residual_mm, 0.012);
  EXPECT_EQ(finger->mapping_record->held_out_mm, 0.02);
  EXPECT_EQ(finger->mapping_record->spread_mm, 0.015);
  EXPECT_EQ(finger->reference->video, "reference.mkv");
  EXPECT_EQ(finger->reference->markers, "reference.csv");
  EXPECT_EQ(finger->contact->rest_markers[1], Eigen::Vector2d(205.25, 41));
  EXPECT_EQ(finger->force_model, "force.yaml");
  EXPECT_EQ(finger->gripper_from_camera->translation_mm, Eigen::Vector3d(40.5, 0, -12));
  EXPECT_EQ(finger->gripper_from_camera->rotation.coeffs(), Eigen::Vector4d(0, -0.8, 0, 0.6));
  EXPECT_EQ(finger->provenance.at("ball_radius_mm"), "3");
  EXPECT_EQ(finger->provenance.at("operator"), "null");
}

TEST_F(FingerFile, AMappingThatVariesOverTheFaceComesBack) {
  std::string text = kFinRay;
  const std::string plain = "  covariance: [[0.0001, 0.00001], [0.00001, 0.0002]]\n";
  const auto place = text.find(plain);
  ASSERT_NE(place, std::string::npos);
  text.replace(place, plain.size(),
               "  varies: {along: 0.05, across: -0.01, middle_mm: [52.0, 0.5], half_mm: [30.0, "
               "6.0]}\n  covariance: [[0.0001, 0.0, 0.0, 0.0], [0.0, 0.0002, 0.0, 0.0], [0.0, 0.0, "
               "0.0004, 0.0], [0.0, 0.0, 0.0, 0.0005]]\n");
  const auto finger = load(text);
  ASSERT_TRUE(finger.ok()) << finger.error().sentence();
  const FaceVariation& varies = finger->mapping->variation;
  EXPECT_EQ(varies.part, Eigen::Vector2d(0.05, -0.01));
  EXPECT_EQ(varies.middle_mm, Eigen::Vector2d(52.0, 0.5));
  EXPECT_EQ(varies.half_mm, Eigen::Vector2d(30.0, 6.0));
  const auto written = finger->to_yaml();
  ASSERT_TRUE(written.ok());
  const auto again = load(*written);
  ASSERT_TRUE(again.ok()) << again.error().sentence();
  EXPECT_EQ(again->mapping->variation.part, varies.part);
  EXPECT_EQ(*again->to_yaml(), *written);

  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string spoilt = text;
    spoilt.replace(spoilt.find(from), from.size(), to);
    const auto result = load(spoilt);
    return result.ok() ? std::string("accepted") : result.error().sentence();
  };
  EXPECT_THAT(refused("along: 0.05", "along: 0.6"), HasSubstr("mapping.varies"));
  EXPECT_THAT(refused("half_mm: [30.0, ", "half_mm: [0.0, "), HasSubstr("mapping.varies"));
  EXPECT_THAT(refused("middle_mm: [52.0, 0.5]", "middle_mm: [52.0]"), HasSubstr("middle_mm"));
}

TEST_F(FingerFile, APlaceInTheGripperComesBackToTheLastDigit) {
  const Finger plain = *load(kFlat);
  EXPECT_FALSE(plain.gripper_from_camera) << "files from before it was known are read";
  const bool holds = rc::check("places in the gripper", [&] {
    const auto number = [](double scale) {
      return scale * static_cast<double>(*rc::gen::inRange<long>(-(1L << 52), 1L << 52)) /
             static_cast<double>(1L << 52);
    };
    Finger finger = plain;
    RigidTransform& pose = finger.gripper_from_camera.emplace();
    pose.translation_mm = {number(1e4), number(100), number(1e-9)};
    pose.rotation = rotation_from_rpy_deg({number(180), number(90), number(180)});
    const auto once = finger.to_yaml();
    RC_ASSERT(once.ok());
    const auto again = load(*once);
    RC_ASSERT(again.ok());
    RC_ASSERT(again->gripper_from_camera == finger.gripper_from_camera);
    RC_ASSERT(*again->to_yaml() == *once);
  });
  EXPECT_TRUE(holds);
}

TEST_F(FingerFile, APlaceInTheGripperThatIsNoneIsRefused) {
  const auto reported = [&](const std::string& pose) {
    const auto finger = load(std::string(kFlat) + "gripper_from_camera: {" + pose + "}\n");
    return finger.ok() ? std::string("accepted") : finger.error().sentence();
  };
  EXPECT_EQ(reported("translation_mm: [1, 2, 3], rotation: [0.7071, 0, 0.7071, 0]"), "accepted");
  EXPECT_THAT(reported("translation_mm: [1, 2, 3], rotation: [1, 1, 0, 0]"), HasSubstr("length 1"));
  EXPECT_THAT(reported("translation_mm: [1, 2, 3], rotation: [0, 0, 0, 0]"), HasSubstr("length 1"));
  EXPECT_THAT(reported("translation_mm: [1, 2, 3], rotation: [1, 0, 0]"),
              HasSubstr("four numbers"));
  EXPECT_THAT(reported("translation_mm: [1, 2], rotation: [1, 0, 0, 0]"),
              HasSubstr("three numbers"));
  EXPECT_THAT(reported("translation_mm: [1, 2, 20000], rotation: [1, 0, 0, 0]"),
              HasSubstr("gripper_from_camera.translation_mm"));
  EXPECT_NE(reported("translation_mm: [1, 2, .nan], rotation: [1, 0, 0, 0]"), "accepted");
  EXPECT_NE(reported("translation_mm: [1, 2, 3]"), "accepted");
}

TEST_F(FingerFile, FlatSensorsHaveNoMarkersAndDefaults) {
  const auto finger = load(kFlat);
  ASSERT_TRUE(finger.ok()) << finger.error().sentence();
  EXPECT_EQ(finger->face.kind, FaceKind::kFlat);
  EXPECT_EQ(finger->marker_count(), 0);
  EXPECT_EQ(finger->camera.orientation, Orientation::kNone);
  EXPECT_EQ(finger->mapping->a_mm, 2.5);
  EXPECT_FALSE(finger->mapping_record);
  EXPECT_EQ(finger->reference->image, "ref.png");
}

TEST_F(FingerFile, SavedTwiceIsTheSameBytesAndTheSameFinger) {
  for (const std::string text : {kFinRay, kFlat}) {
    const auto first = load(text);
    ASSERT_TRUE(first.ok());
    const std::string once = saved(*first);
    ASSERT_TRUE(first->save(folder_.path()).ok());
    EXPECT_EQ(*read_file(folder_ / Finger::kFileName), once);
    const auto second = Finger::load(folder_.path());
    ASSERT_TRUE(second.ok()) << second.error().sentence();
    EXPECT_EQ(saved(*second), once);
    EXPECT_EQ(second->camera, first->camera);
    EXPECT_EQ(second->provenance, first->provenance);
    EXPECT_EQ(second->mapping->chebyshev, first->mapping->chebyshev);
    EXPECT_EQ(second->mapping->covariance, first->mapping->covariance);
    EXPECT_EQ(second->contact.has_value(), first->contact.has_value());
    EXPECT_EQ(second->gripper_from_camera, first->gripper_from_camera);
  }
}

TEST_F(FingerFile, UnknownKeysAreKeptAtEveryLevelAndWarnedOf) {
  std::string text = kFinRay;
  for (const char* section :
       {"camera", "face", "markers", "mapping", "reference", "contact", "force"}) {
    const std::size_t at = text.find("\n" + std::string(section) + ":\n");
    ASSERT_NE(at, std::string::npos);
    text.insert(at + std::string(section).size() + 3,
                fmt::format("  new_in_{}: {{a: [1, two, \"3\", ~], b: !colour red}}\n", section));
  }
  text +=
      "  nested: {x: 1}\nlater:\n  - 1.50\n  - {deep: [yes, 'no: maybe']}\n'odd key: x': |\n"
      "  several\n  lines\n";
  std::vector<Message> warnings;
  const auto finger = load(text, &warnings);
  ASSERT_TRUE(finger.ok()) << finger.error().sentence();
  EXPECT_EQ(warnings.size(), 10U);
  EXPECT_THAT(warnings[0].english(),
              HasSubstr("finger.yaml:4: camera.new_in_camera: is not known"));
  const std::string once = saved(*finger);
  for (const char* section :
       {"camera", "face", "markers", "mapping", "reference", "contact", "force"})
    EXPECT_THAT(once, HasSubstr(fmt::format(
                          "new_in_{}: {{a: [1, two, \"3\", ~], b: !<!colour> red}}", section)));
  EXPECT_THAT(once, HasSubstr("later: [1.50, {deep: [yes, \"no: maybe\"]}]"));
  EXPECT_THAT(once, HasSubstr("\"odd key: x\": \"several\\nlines\\n\""));
  EXPECT_THAT(once, HasSubstr("  nested: {x: 1}"));
  const auto again = load(once, &warnings);
  ASSERT_TRUE(again.ok()) << again.error().sentence();
  EXPECT_EQ(warnings.size(), 10U);
  EXPECT_EQ(saved(*again), once);
}

TEST_F(FingerFile, AnyTextsAndNumbersSurvive) {
  const auto any_text = [] {
    return *rc::gen::container<std::string>(
        rc::gen::oneOf(rc::gen::inRange<char>(1, 127),
                       rc::gen::elementOf(std::string("\"'\\:#\n\t-?,[]{}&*!|>%@`~ "))));
  };
  const bool holds = rc::check("texts and numbers survive", [&] {
    Finger finger = *load(kFinRay);
    finger.name = "n" + any_text();
    RC_PRE(finger.name.size() <= 200);
    finger.mapping_record->degree_choice = any_text();
    finger.mapping_record->presses = {any_text(), any_text()};
    finger.provenance = {{"k" + any_text().substr(0, 50), any_text()}, {"plain", "0.50"}};
    finger.face.width_mm = kFaceWidth.possible.low + *rc::gen::inRange(1, 1 << 30) / 7e7;
    finger.contact->rest_markers[2].x() = *rc::gen::inRange(-1000, 1000) * 1e-9;
    const std::string once = saved(finger);
    const auto loaded = load(once);
    RC_ASSERT(loaded.ok());
    RC_ASSERT(loaded->name == finger.name);
    RC_ASSERT(loaded->mapping_record->degree_choice == finger.mapping_record->degree_choice);
    RC_ASSERT(loaded->mapping_record->presses == finger.mapping_record->presses);
    RC_ASSERT(loaded->provenance == finger.provenance);
    RC_ASSERT(loaded->face.width_mm == finger.face.width_mm);
    RC_ASSERT(loaded->contact->rest_markers[2] == finger.contact->rest_markers[2]);
    RC_ASSERT(saved(*loaded) == once);
  });
  EXPECT_TRUE(holds);
}

TEST_F(FingerFile, KeepsWhatACalibrationRestsOn) {
  const std::string line =
      "  basis: {ball_radii_mm: [2.5, 4.0], face_mm: [24.0, 1.5, 0.0], "
      "camera: "
      "\"0123456789abcdef\", reference: \"\", positions: 5, thirds: [1, 3, 1], position_leverage: "
      "0.5, depths_mm: [0.4, 1.1], scale_sd_mm: 0.012, pixel_sd_mm: 0.01, halo_mm: 0.0, "
      "undetected_spread: 0.25, depth_per_radius: -1.25, left_out: 1, complete: true, "
      "contradictions: "
      "[\"depth_beyond_mapping\"], contradictions_mm: [[2.0, 6.0, 1.1, 1.2, 1.3]]}\n";
  std::string text = kFinRay;
  text.insert(text.find("reference:\n  video"), line);
  const auto finger = load(text);
  ASSERT_TRUE(finger.ok()) << (finger ? "" : finger.error().sentence());
  ASSERT_TRUE(finger->mapping_record && finger->mapping_record->basis);
  const CalibrationBasis& basis = *finger->mapping_record->basis;
  EXPECT_EQ(basis.ball_radii_mm, (std::vector<double>{2.5, 4}));
  EXPECT_EQ(basis.width_mm, 24);
  EXPECT_EQ(basis.camera, "0123456789abcdef");
  EXPECT_EQ(basis.thirds, (std::array<int, 3>{1, 3, 1}));
  EXPECT_EQ(basis.deepest_mm, 1.1);
  EXPECT_EQ(basis.undetected_spread, 0.25);
  EXPECT_EQ(basis.depth_per_radius, -1.25);
  ASSERT_EQ(basis.contradictions.size(), 1U);
  EXPECT_EQ(basis.contradictions[0],
            (RecordedContradiction{"depth_beyond_mapping", 2, 6, 1.1, 1.2, 1.3}));
  const auto again = load(saved(*finger));
  ASSERT_TRUE(again.ok()) << (again ? "" : again.error().sentence());
  EXPECT_EQ(*again->mapping_record->basis, basis);
  EXPECT_EQ(saved(*again), saved(*finger));
  Finger impossible = *finger;
  impossible.mapping_record->basis->scale_sd_mm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(impossible.validate());
  std::string cut = text;
  cut.replace(cut.find("[1, 3, 1]"), 9, "[1, 3]");
  EXPECT_FALSE(load(cut));
}

TEST_F(FingerFile, AnyNumberOfTheCameraChangesItsFingerprint) {
  const auto finger = load(kFinRay);
  ASSERT_TRUE(finger.ok());
  const CameraParameters& camera = finger->camera;
  const std::string before = camera_fingerprint(camera);
  EXPECT_EQ(before.size(), 16U);
  EXPECT_EQ(camera_fingerprint(load(saved(*finger))->camera), before) << "through a file";
  for (double CameraParameters::*member : {&CameraParameters::fx_px, &CameraParameters::fy_px,
                                           &CameraParameters::cx_px, &CameraParameters::cy_px}) {
    CameraParameters other = camera;
    other.*member = std::nextafter(other.*member, 1e9);
    EXPECT_NE(camera_fingerprint(other), before);
  }
  CameraParameters bent = camera;
  bent.distortion.back() += 1e-12;
  EXPECT_NE(camera_fingerprint(bent), before);
}

}  // namespace
}  // namespace alltact
