// Pushes on simulated fingers drawn at random: which face, and which way.
#include "core/sensing/contact/finger_contact.h"

#include "tests/core/sensing/contact/drawn_push.h"
#include "tests/support/slow_run.h"

#include <array>
#include <map>
#include <numbers>

namespace alltact {
namespace {

double degrees_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

void print_distribution(const char* what, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  printf("%s: median %.2f, 95 %% %.2f, 99 %% %.2f, worst %.2f (%zu)\n", what, at(0.5), at(0.95),
         at(0.99), values.back(), values.size());
}

// How likely an error of this sd leaves the eighth of the circle that a direction lies in.
double chance_to_leave_side(double angle_rad, double sd_deg) {
  const double eighth = std::numbers::pi / 4;
  const double off_deg =
      std::remainder(angle_rad, eighth) * 180 / std::numbers::pi;  // from the side's middle
  const auto beyond = [&](double deg) { return 0.5 * std::erfc(deg / sd_deg / std::sqrt(2.0)); };
  return beyond(22.5 - off_deg) + beyond(22.5 + off_deg);
}

// Ways over whole sides: those that lie within their error of a border can be told to lie beyond
// it, as many as the errors told say.
TEST(FingerContact, OneOfEightWaysIsToldOnDrawnFingers) {
  const int fingers = test::as_many_as(12, 60);
  int right = 0, sure = 0, sure_right = 0, count = 0;
  double expected_wrong = 0, normalised = 0;
  std::vector<double> off_deg;
  Parameters random(41);
  for (int f = 0; f < fingers; ++f) {
    const PushedDrawnFinger finger(random, 2);
    for (int displacement = 0; displacement < 8; ++displacement) {
      const double angle =
          (45 * displacement + random.between(-22.5, 22.5)) * std::numbers::pi / 180;
      const double mm = random.between(1.5, 5);  // as far as pushes move a finger
      const std::string motion = fmt::format(
          "motion: {{kind: poses, poses: [{{}}, {{q1_mm: {}, q2_mm: {}, sway_mm: {}}}]}}\n",
          -mm * std::cos(angle), 0.3 * mm * std::cos(angle) * random.between(-1, 1),
          mm * std::sin(angle));
      const auto told = told_of(
          motion +
              finger.with("  - {use: bend, q1_mm: {from: -6, to: 6}, q2_mm: {from: -3, to: 3}}\n"
                          "  - {use: sway, sway_mm: {from: -6, to: 6}}\n"),
          random);
      ASSERT_TRUE(told && told->contact && told->contact->direction) << f << ' ' << displacement;
      const double found = std::atan2(told->displacement->displacement_mm.y(),
                                      told->displacement->displacement_mm.x());
      const double off =
          std::remainder(found - angle, 2 * std::numbers::pi) * 180 / std::numbers::pi;
      const double sd_deg = told->contact->direction_sd_deg.value();
      off_deg.push_back(std::abs(off));
      normalised += off * off / (sd_deg * sd_deg);
      const bool is_right =
          (static_cast<int>(std::lround(found / (std::numbers::pi / 4))) + 8) % 8 == displacement;
      const double chance = chance_to_leave_side(found, sd_deg);
      expected_wrong += chance;
      right += is_right;
      ++count;
      if (chance > 0.01) continue;
      ++sure;
      sure_right += is_right;
    }
  }
  printf("one of 8 ways: right %d of %d, %.1f wrong by the errors told; of %d sure ones %d\n",
         right, count, expected_wrong, sure, sure_right);
  printf("direction: NEES %.2f\n", normalised / count);
  print_distribution("degrees off the way", off_deg);
  EXPECT_LE(count - right, std::max(1.0, 0.005 * count));
  EXPECT_LT(expected_wrong, 0.02 * count);
  EXPECT_GT(sure, 0.93 * count);
  EXPECT_EQ(sure_right, sure);
  EXPECT_GT(normalised / count, 0.6);
  EXPECT_LT(normalised / count, 1.3);
}

TEST(FingerContact, TheFaceThatIsPushedIsToldOnDrawnFingers) {
  const int fingers = test::as_many_as(12, 45);
  std::map<std::string, std::array<int, 2>> right;
  std::vector<double> off_deg;
  Parameters random(77);
  int count = 0, good = 0, below = 0;
  for (int f = 0; f < fingers; ++f) {
    const PushedDrawnFinger finger(random);
    const std::string body = drawn_body(random, 0.2, 0.8);
    for (const std::string face : {"contact", "back", "upper", "lower"}) {
      const std::string push =
          pushing(fmt::format("s_mm: {}, y_mm: {}, radius_mm: 5, force_N: {}",
                              random.between(0.5, 0.85) * finger.length_mm, random.between(-3, 3),
                              reaching(random.between(0.5, 1.5))),
                  face);
      const auto told = told_of(finger.with(push + body), random);
      if (!told) continue;
      if (!told->contact) {
        ++below;
        continue;
      }
      ++count;
      const bool is_right = told->contact->face == told->truth.contacts[0].face;
      good += is_right;
      ++right[face][is_right ? 0 : 1];
      off_deg.push_back(
          degrees_between(*told->contact->direction, told->truth.contacts[0].direction));
    }
  }
  for (const auto& [face, counts] : right)
    printf("%s: right %d, wrong %d\n", face.c_str(), counts[0], counts[1]);
  printf("faces: right %d of %d; %d moved the markers too little\n", good, count, below);
  print_distribution("degrees between the way told and the force", off_deg);
  EXPECT_GT(count, 3.1 * fingers);
  EXPECT_GE(good, 0.995 * count);
}

// What is pressed in tells the face, however the finger is dragged.
TEST(FingerContact, ADentTellsTheFaceAndTheMarkersTheWay) {
  Face face;
  face.kind = FaceKind::kFlat;
  face.layer_mm = 1.5, face.plane_z_mm = 30;
  CameraParameters camera;
  camera.width_px = 320, camera.height_px = 180;
  camera.fx_px = camera.fy_px = 170, camera.cx_px = 160, camera.cy_px = 90;
  const FaceShape shape = FaceShape::plane(Camera::create(camera).value(), face);
  // A drag towards +y, as the markers show it.
  ContactEvidence evidence;
  evidence.push = 4;
  evidence.deflection = {PushedFace::kUpper, Eigen::Vector3d::UnitY(), 0.6, std::nullopt};
  EXPECT_EQ(FingerContactTracker()(evidence)->face, PushedFace::kUpper);
  ContactRegion region;
  region.position_mm = region.deepest_point_mm = {0, 0, 31.2};
  region.position_px = {160, 90};
  region.deepest_on_face_mm = {12, 3};
  region.deepest_mm = 0.3;
  ContactEvidence dented = evidence;
  dented.add_regions({region}, shape, nullptr);
  FingerContactTracker contacts;
  const auto dragged = contacts(dented);
  ASSERT_TRUE(dragged && dragged->position);
  EXPECT_EQ(dragged->face, PushedFace::kContact);
  EXPECT_EQ(dragged->direction, Eigen::Vector3d::UnitY());
  EXPECT_EQ(dragged->direction_sd_deg, 0.6);
  EXPECT_EQ(dragged->position->along_mm, 12);
  EXPECT_EQ(dragged->position->across_mm, 3);
  EXPECT_FALSE(dragged->position->along_sd_mm) << "the region tells none";
  // A slight dent is that of a contact which pressed there before, and else of none.
  region.deepest_mm = 0.12;
  ContactEvidence slight = evidence;
  slight.add_regions({region}, shape, nullptr);
  EXPECT_EQ(FingerContactTracker()(slight)->face, PushedFace::kUpper);
  EXPECT_EQ(contacts(slight)->face, PushedFace::kContact);
}

}  // namespace
}  // namespace alltact
