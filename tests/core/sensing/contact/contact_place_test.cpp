// Where on the finger a ball presses, from picture to millimetres: bent fingers drawn at random,
// noise of a grey level, every ball elsewhere.
#include "core/sensing/pipeline.h"
#include "core/simulation/plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

// A bent finger of a drawn size, slope, layer, camera and light, and a ball of a drawn place, size
// and depth that is pressed into it.
class PressedFinger {
 public:
  /// The ball's place lies between these parts of the length.
  explicit PressedFinger(unsigned seed, double from = 0.2, double to = 0.6) : random_(seed) {
    const double q1 = between(-1.2, 1.2), q2 = between(-2, 2);
    bend_ = fmt::format("poses: [{{q1_mm: {}, q2_mm: {}}}]", q1, q2);
    focal_ = between(490, 540), width_ = between(20, 26), incline_ = between(30, 37);
    length_ = between(100, 120);
    layer_mm_ = between(1.2, 2.0), scatter_per_mm_ = between(0.4, 0.8);
    base_x_ = between(-24, -20), base_z_ = between(27, 31), light_ = between(0.7, 1.0);
    press_ = fmt::format(
        "  - {{use: ball, radius_mm: {}, s_mm: {}, y_mm: {}, depth_mm: {}}}\n"
        "  - {{use: rolloff, {}}}\n",
        between(3, 5), length_ * between(from, to), between(-4, 4), between(0.3, 1.0),
        seed % 2 == 0 ? "kind: smooth, length_mm: 0.2" : "kind: hertz, length_mm: 0.8");
  }
  /// A user's camera file: each number off by a drawn error of this sd, px.
  void misjudge_lens(double focal_sd_px, double centre_sd_px) {
    const std::vector<double> sd_px{focal_sd_px, focal_sd_px, centre_sd_px, centre_sd_px};
    const double off_px = drawn(focal_sd_px);  // fx and fy share their errors
    lens_off_ = Lens{off_px, drawn(centre_sd_px), drawn(centre_sd_px), sd_px};
  }
  /// Out of the picture, on the left.
  void hide_base() { base_x_ = -34; }
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
        s, s + along_mm, 0.4 + deeper_mm));
    Pipeline pipeline = over(plan(""));
    std::vector<FrameResult> results;
    for (int i = 0; i < 16; ++i) results.push_back(pipeline(frame_of(moving, i)).value());
    return results;
  }
  Truth truth;

 private:
  [[nodiscard]] Pipeline over(const Plan& untouched) const {
    Finger finger = untouched.finger();
    finger.camera.fx_px += lens_off_.focal_px, finger.camera.fy_px += lens_off_.focal_px;
    finger.camera.cx_px += lens_off_.cx_px, finger.camera.cy_px += lens_off_.cy_px;
    finger.camera.sd_px = lens_off_.sd_px;
    // Exact for a layer without absorption.
    const double s = scatter_per_mm_ * layer_mm_;
    MappingParameters mapping;
    mapping.kind = MappingKind::kMoebius;
    mapping.along = MappingAlong::kProjected;
    mapping.a_mm = layer_mm_ * (1 + s), mapping.b = s, mapping.x_max = 0.9;
    finger.mapping = mapping;
    return Pipeline::with_library(ReferenceLibrary::single(untouched.render(0, 2)).value(),
                                  FingerSnapshot::of({}, finger).value(), {});
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
  double drawn(double sd) { return std::normal_distribution<double>(0, sd)(random_); }
  [[nodiscard]] Plan plan(const std::string& press) const {
    const std::string text = fmt::format(
        "name: places\nwhy: to learn what a place is worth\nframes: 16\n"
        "finger:\n"
        "  camera: {{model: pinhole, size: [960, 540], fx: {0}, fy: {0}, cx: 479.5, cy: 269.5}}\n"
        "  face: {{kind: fin_ray, width_mm: {1}, layer_mm: {2}}}\n"
        "untouched: {{x_mm: {8}, z_mm: {9}, incline_deg: {3}, length_mm: {4}}}\n"
        "motion: {{kind: poses, {5}}}\n"
        "effects:\n  - {{use: bend, q1_mm: {{from: -2, to: 2}}, q2_mm: {{from: -3, to: 3}}}}\n{6}"
        "  - {{use: layer, scatter_per_mm: {7}, along: normal}}\n"
        "  - {{use: sides, albedo: 0.12, depth_mm: 14.0}}\n"
        "  - use: leds\n    lamps:\n"
        "      - {{at_mm: [0.0, -3.0, 0.0], power: {10}}}\n"
        "      - {{at_mm: [0.0, 3.0, 0.0], power: {10}}}\n"
        "      - {{at_mm: [4.0, 0.0, -20.0], power: {11}, aim_mm: [71.0, 0.0, 93.0], lobe: 8}}\n"
        "  - {{use: read, sd: 1.0}}\n  - {{use: quantisation}}\n",
        focal_, width_, layer_mm_, incline_, length_, bend_, press, scatter_per_mm_, base_x_,
        base_z_, light_ * 270000, light_ * 3300000);
    const auto scene = Scene::parse(text, "places");
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
    return Plan::compile(*scene, press.empty() ? 1 : 2).value();
  }

  struct Lens {
    double focal_px = 0, cx_px = 0, cy_px = 0;
    std::vector<double> sd_px;
  };

  std::mt19937 random_;
  Lens lens_off_;
  std::string bend_, press_;
  double focal_ = 0, width_ = 0, incline_ = 0, length_ = 0;
  double layer_mm_ = 0, scatter_per_mm_ = 0, base_x_ = 0, base_z_ = 0, light_ = 0;
};

// Errors of many runs and what was told of them.
class ErrorsTold {
 public:
  void add(double error, double sd) {
    errors_.push_back(std::abs(error));
    sum_ += error;
    normalised_ += error * error / (sd * sd);
  }
  [[nodiscard]] double mean() const {
    return std::accumulate(errors_.begin(), errors_.end(), 0.0) / count();
  }
  [[nodiscard]] double worst() const { return *std::max_element(errors_.begin(), errors_.end()); }
  [[nodiscard]] double nees() const { return normalised_ / count(); }
  void print(const char* what) const {
    std::vector<double> sorted = errors_;
    std::sort(sorted.begin(), sorted.end());
    printf("[ figures  ] %s: mean %.3f mm (bias %+.3f), 95 %% %.3f, worst %.3f of %zu; NEES %.2f\n",
           what, mean(), sum_ / count(), sorted[sorted.size() * 95 / 100], sorted.back(),
           sorted.size(), nees());
  }

 private:
  [[nodiscard]] double count() const { return static_cast<double>(errors_.size()); }
  std::vector<double> errors_;
  double sum_ = 0, normalised_ = 0;
};

// Of the skin: where it is smoothed at the ball's rim it does not reach the ball's own depth.
double greatest_depth_mm(const Truth& truth) {
  cv::Mat depth_mm = truth.depth_mm.clone();
  cv::patchNaNs(depth_mm, 0);
  double greatest = 0;
  cv::minMaxLoc(depth_mm, nullptr, &greatest);
  return greatest;
}

struct PlaceErrors {
  ErrorsTold along, across, depth;
};

PlaceErrors place_errors(unsigned first_seed, int runs, double from, double to) {
  PlaceErrors errors;
  for (unsigned run = 0; run < static_cast<unsigned>(runs); ++run) {
    PressedFinger finger(first_seed + run, from, to);
    const FrameResult result = finger.seen();
    EXPECT_TRUE(result.contact && result.contact->position) << run;
    if (!result.contact || !result.contact->position) continue;
    const FingerContact& contact = *result.contact;
    const ContactTruth& truth = finger.truth.contacts.at(0);
    EXPECT_EQ(contact.face, PushedFace::kContact);
    EXPECT_TRUE(contact.is_new && contact.no_position.empty());
    EXPECT_GT(contact.direction->dot(truth.direction), std::cos(0.05));
    const PositionOnFinger& position = *contact.position;
    errors.along.add(position.along_mm - truth.along_mm, position.along_sd_mm.value());
    errors.across.add(position.across_mm.value() - truth.across_mm, position.across_sd_mm.value());
    errors.depth.add(position.depth_mm.value() - greatest_depth_mm(finger.truth),
                     position.depth_sd_mm.value());
  }
  return errors;
}

// Nobody knows how much of the face lies before the picture.
TEST(ContactPlace, AlongHasNoErrorToTellWhereTheBaseIsNotSeen) {
  PressedFinger finger(1300);
  finger.hide_base();
  const FrameResult result = finger.seen();
  ASSERT_TRUE(result.contact && result.contact->position);
  EXPECT_FALSE(result.shape->base_sd_mm());
  const PositionOnFinger& position = *result.contact->position;
  EXPECT_FALSE(position.along_sd_mm);
  EXPECT_TRUE(position.across_sd_mm && position.depth_sd_mm);
  EXPECT_LT(position.along_mm, finger.truth.contacts.at(0).along_mm - 1);
}

// What a mean of so many squares, each 1 on average, may be off by.
double nees_scatter(int runs) { return 3 * std::sqrt(2.0 / runs); }

TEST(ContactPlace, OfABallIsTheTruthsAroundTheMiddle) {
  // The middle 40 mm of a finger of 100 to 120 mm, and some more.
  constexpr int kRuns = 48;
  const PlaceErrors errors = place_errors(500, kRuns, 0.3, 0.7);
  errors.along.print("along");
  errors.across.print("across");
  errors.depth.print("depth");
  EXPECT_LT(errors.along.worst(), 0.1);
  EXPECT_LT(errors.across.worst(), 0.1);
  EXPECT_LT(errors.depth.worst(), 0.05);
  EXPECT_NEAR(errors.along.nees(), 1.1, nees_scatter(kRuns));
  EXPECT_NEAR(errors.across.nees(), 0.95, nees_scatter(kRuns));
}

TEST(ContactPlace, OfABallIsTheTruthsAtTheTip) {
  constexpr int kRuns = 32;
  const PlaceErrors errors = place_errors(900, kRuns, 0.85, 0.94);
  errors.along.print("along, at the tip");
  errors.across.print("across, at the tip");
  EXPECT_LT(errors.along.worst(), 0.3);
  EXPECT_LT(errors.across.worst(), 0.3);
  EXPECT_NEAR(errors.along.nees(), 1.1, nees_scatter(kRuns));
  EXPECT_NEAR(errors.across.nees(), 0.95, nees_scatter(kRuns));
}

TEST(ContactPlace, InTheCameraMovesWithTheLensByWhatItSays) {
  constexpr int kRuns = 96;
  double squares = 0;
  for (unsigned run = 0; run < kRuns; ++run) {
    PressedFinger exact(5000 + run, 0.3, 0.7), misjudged(5000 + run, 0.3, 0.7);
    misjudged.misjudge_lens(1.0, 0.5);
    const FrameResult truth = exact.seen(), told = misjudged.seen();
    ASSERT_FALSE(truth.regions.empty() || told.regions.empty()) << run;
    const ContactRegion& region = told.regions.front();
    const Eigen::Vector3d off_mm = region.position_mm - truth.regions.front().position_mm;
    const Eigen::Matrix3d covariance_mm2 =
        lens_covariance_mm2(*told.shape, region.position_px, region.position_mm);
    squares += off_mm.dot(covariance_mm2.inverse() * off_mm) / 3;
    // It is a part of the entire covariance, but not of the position on the finger.
    const auto plane = contact_plane(*told.shape, region.position_px).value();
    const Eigen::Matrix2d in_plane =
        plane.transpose() * (*region.position_covariance_mm2 - covariance_mm2) * plane;
    EXPECT_LT((in_plane - *region.on_face_covariance_mm2).norm(), 1e-9);
  }
  printf("[ figures  ] lens off by half a pixel: normalised error squared %.2f\n", squares / kRuns);
  EXPECT_NEAR(squares / kRuns, 1.0, 3 * std::sqrt(2.0 / (3 * kRuns)));
}

// The deepest of noisy pixels, and what smoothing takes off a ball that is a few pixels wide.
TEST(ContactPlace, TheDepthIsAsSureAsItSays) {
  ErrorsTold middle, tip;
  constexpr int kRuns = 96;
  for (const auto& [first_seed, from, to, told] :
       {std::tuple{2000U, 0.3, 0.7, &middle}, std::tuple{3000U, 0.85, 0.94, &tip}})
    *told = place_errors(first_seed, kRuns, from, to).depth;
  middle.print("depth");
  tip.print("depth, at the tip");
  for (const ErrorsTold* told : {&middle, &tip}) {
    EXPECT_GT(told->nees(), 0.7);
    EXPECT_LT(told->nees(), 1.4);
  }
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
