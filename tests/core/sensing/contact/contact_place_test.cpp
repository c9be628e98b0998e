// Where on the finger a ball presses, from picture to millimetres: bent fingers drawn at random,
// noise of a grey level, every ball elsewhere.
#include "core/sensing/pipeline.h"
#include "core/simulation/plan.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

class PressedFinger {
 public:
  explicit PressedFinger(unsigned seed) : random_(seed) {
    const double q1 = between(-1.2, 1.2), q2 = between(-2, 2);
    bend_ = fmt::format("poses: [{{q1_mm: {}, q2_mm: {}}}]", q1, q2);
    focal_ = between(490, 540), width_ = between(20, 26), incline_ = between(30, 37);
    length_ = between(100, 120);
    press_ = fmt::format(
        "  - {{use: ball, radius_mm: {}, s_mm: {}, y_mm: {}, depth_mm: {}}}\n"
        "  - {{use: rolloff, kind: smooth, length_mm: 0.2}}\n",
        between(3, 5),
        between(25, 65),
        between(-4, 4),
        between(0.3, 1.0));
  }
  FrameResult seen() {
    const Plan untouched = plan(""), pressed = plan(press_);
    truth = pressed.truth(0);
    Pipeline pipeline = over(untouched);
    EXPECT_FALSE(pipeline(frame_of(untouched, 0))->contact) << "of the untouched finger";
    pipeline.forget();
    return pipeline(frame_of(pressed, 0)).value();
  }
  /// Of 16 frames in half a second, in which the ball goes so far along and deeper.
  std::vector<FrameResult> seen_moving(double along_mm, double deeper_mm) {
    const double s = between(30, 50);
    const Plan moving = plan(fmt::format(
        "  - {{use: ball, radius_mm: 4, s_mm: [{{at: 0, is: {}}}, {{at: 15, is: {}}}], y_mm: 1, "
        "depth_mm: [{{at: 0, is: 0.4}}, {{at: 15, is: {}}}]}}\n",
        s,
        s + along_mm,
        0.4 + deeper_mm));
    Pipeline pipeline = over(plan(""));
    std::vector<FrameResult> results;
    for (int i = 0; i < 16; ++i) results.push_back(pipeline(frame_of(moving, i)).value());
    return results;
  }
  Truth truth;

 private:
  static constexpr double kScatter_per_mm = 0.6, kLayer_mm = 1.5;

  static Pipeline over(const Plan& untouched) {
    Finger finger = untouched.finger();
    // Exact for a layer without absorption.
    const double s = kScatter_per_mm * kLayer_mm;
    MappingParameters mapping;
    mapping.kind = MappingKind::kMoebius;
    mapping.along = MappingAlong::kProjected;
    mapping.a_mm = kLayer_mm * (1 + s), mapping.b = s, mapping.x_max = 0.9;
    finger.mapping = mapping;
    return Pipeline::over(ReferenceLibrary::single(untouched.render(0, 2)).value(),
                          FingerSnapshot::of({}, finger).value(),
                          {});
  }
  static FramePtr frame_of(const Plan& plan, int i) {
    auto frame = std::make_shared<Frame>();
    frame->sequence = static_cast<std::uint64_t>(i);
    frame->time_ns = 1000000000 + i * std::int64_t{33333333};
    frame->grey = plan.render(i, 2);
    return frame;
  }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  [[nodiscard]] Plan plan(const std::string& press) const {
    const std::string text = fmt::format(
        "name: places\nwhy: to learn what a place is worth\nframes: 16\n"
        "finger:\n"
        "  camera: {{model: pinhole, size: [960, 540], fx: {0}, fy: {0}, cx: 479.5, cy: 269.5}}\n"
        "  face: {{kind: fin_ray, width_mm: {1}, layer_mm: {2}}}\n"
        "untouched: {{x_mm: -21.0, z_mm: 28.0, incline_deg: {3}, length_mm: {4}}}\n"
        "motion: {{kind: poses, {5}}}\n"
        "effects:\n  - {{use: bend, q1_mm: {{from: -2, to: 2}}, q2_mm: {{from: -3, to: 3}}}}\n{6}"
        "  - {{use: layer, scatter_per_mm: {7}, along: normal}}\n"
        "  - {{use: sides, albedo: 0.12, depth_mm: 14.0}}\n"
        "  - use: leds\n    lamps:\n"
        "      - {{at_mm: [0.0, -3.0, 0.0], power: 270000.0}}\n"
        "      - {{at_mm: [0.0, 3.0, 0.0], power: 270000.0}}\n"
        "      - {{at_mm: [4.0, 0.0, -20.0], power: 3300000.0, aim_mm: [71.0, 0.0, 93.0], lobe: "
        "8}}\n"
        "  - {{use: read, sd: 1.0}}\n  - {{use: quantisation}}\n",
        focal_,
        width_,
        kLayer_mm,
        incline_,
        length_,
        bend_,
        press,
        kScatter_per_mm);
    const auto scene = Scene::parse(text, "places");
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
    return Plan::compile(*scene, press.empty() ? 1 : 2).value();
  }

  std::mt19937 random_;
  std::string bend_, press_;
  double focal_ = 0, width_ = 0, incline_ = 0, length_ = 0;
};

TEST(ContactPlace, OfABallIsTheTruths) {
  std::vector<double> along, across, depth;
  double across_nees = 0, mean_along_sd = 0, mean_across_sd = 0, mean_depth_sd = 0;
  constexpr int kRuns = 24;
  for (unsigned run = 0; run < kRuns; ++run) {
    PressedFinger finger(500 + run);
    const FrameResult result = finger.seen();
    ASSERT_TRUE(result.contact && result.contact->place) << run;
    const FingerContact& contact = *result.contact;
    const ContactTruth& truth = finger.truth.contacts.at(0);
    EXPECT_EQ(contact.face, PushedFace::kContact);
    EXPECT_TRUE(contact.is_new && contact.no_place.empty());
    EXPECT_GT(contact.direction->dot(truth.direction), std::cos(0.05));
    const PlaceOnFinger& place = *contact.place;
    ASSERT_TRUE(place.along_sd_mm && place.across_sd_mm && place.depth_sd_mm);
    along.push_back(place.along_mm - truth.along_mm);
    across.push_back(std::abs(place.across_mm - truth.across_mm));
    across_nees += std::pow(across.back() / *place.across_sd_mm, 2) / kRuns;
    depth.push_back(std::abs(place.depth_mm - truth.depth_mm));
    mean_along_sd += *place.along_sd_mm / kRuns;
    mean_across_sd += *place.across_sd_mm / kRuns;
    mean_depth_sd += *place.depth_sd_mm / kRuns;
  }
  for (auto* values : {&along, &across, &depth}) std::sort(values->begin(), values->end());
  printf(
      "along off by %.3f to %.3f mm (sd told %.3f), across at most %.3f (%.3f), depth at most "
      "%.3f (%.3f)\n",
      along.front(),
      along.back(),
      mean_along_sd,
      across.back(),
      mean_across_sd,
      depth.back(),
      mean_depth_sd);
  printf("across: NEES %.2f\n", across_nees);
  EXPECT_LT(std::max(-along.front(), along.back()), 0.5);
  EXPECT_LT(across.back(), 0.02);
  EXPECT_LT(depth.back(), 0.04);
}

TEST(ContactPlace, ABallThatSlidesIsToldToSlipAndOneThatIsPressedDeeperIsNot) {
  for (unsigned run = 0; run < 4; ++run) {
    PressedFinger finger(700 + run);
    const auto sliding = finger.seen_moving(run % 2 == 0 ? 4 : -4, 0);
    const auto pressed = finger.seen_moving(0, 0.5);
    for (std::size_t i = 0; i < 16; ++i) {
      ASSERT_TRUE(sliding[i].contact && pressed[i].contact) << i;
      EXPECT_EQ(sliding[i].contact->is_new, i == 0);
      EXPECT_NEAR(sliding[i].contact->held_s.value(), static_cast<double>(i) / 30, 1e-6);
      EXPECT_FALSE(pressed[i].contact->is_slipping.value()) << run << ' ' << i;
      if (i >= 4) {
        EXPECT_TRUE(sliding[i].contact->is_slipping.value()) << run << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace alltact
