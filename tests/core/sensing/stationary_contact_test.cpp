// When a contact holds still: told once, and not while it moves.
#include "core/sensing/stationary_contact.h"

#include "core/geometry/ball.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr double kFrame_s = 1.0 / 30;

/// Feeds frames and counts how often it says so.
class Contact {
 public:
  int hold(double seconds, const Eigen::Vector2d& speed_mm_s = {0, 0}, double deeper_part_s = 0) {
    int told = 0;
    for (double t = 0; t < seconds; t += kFrame_s) {
      patch_.position_mm += kFrame_s * speed_mm_s;
      patch_.darkness *= 1 + kFrame_s * deeper_part_s;
      // What noise does to it.
      DarkPatch seen = patch_;
      seen.position_mm.x() += (frame_ % 2 != 0 ? 0.03 : -0.03);
      seen.darkness *= frame_ % 3 == 0 ? 1.01 : 0.995;
      ++frame_;
      told += watch_.add(seen, time_ += kFrame_s) ? 1 : 0;
    }
    return told;
  }
  int lift(double seconds) {
    int told = 0;
    for (double t = 0; t < seconds; t += kFrame_s)
      told += watch_.add(std::nullopt, time_ += kFrame_s) ? 1 : 0;
    return told;
  }

 private:
  StationaryContactDetector watch_;
  DarkPatch patch_{{30, 2}, 0.3};
  double time_ = 100;
  int frame_ = 0;
};

TEST(StationaryContactDetector, TellsOnceOfAContactThatHoldsStill) {
  Contact contact;
  EXPECT_EQ(contact.hold(0.35), 0) << "too short yet";
  EXPECT_EQ(contact.hold(0.2), 1);
  EXPECT_EQ(contact.hold(5), 0);
}

TEST(StationaryContactDetector, TellsAgainAfterLiftingAndAfterMovingOn) {
  Contact contact;
  EXPECT_EQ(contact.hold(1), 1);
  EXPECT_EQ(contact.lift(0.2), 0);
  EXPECT_EQ(contact.hold(1), 1);
  EXPECT_EQ(contact.hold(0.5, {6, 0}), 0);  // 3 mm further
  EXPECT_EQ(contact.hold(1), 1);
  EXPECT_EQ(contact.hold(0.5, {2, 0}), 0);  // 1 mm: still the same place
  EXPECT_EQ(contact.hold(2), 0);
}

TEST(StationaryContactDetector, NeverTellsOfWhatMovesOrIsPressedIn) {
  Contact sliding;
  EXPECT_EQ(sliding.hold(4, {0, 3}), 0);
  Contact pressing;
  EXPECT_EQ(pressing.hold(2, {0, 0}, 0.5), 0);
  Contact empty;
  EXPECT_EQ(empty.lift(3), 0);
}

TEST(StationaryContactDetector, DoesNotCountATimeWithoutFrames) {
  StationaryContactDetector watch;
  const DarkPatch patch{{30, 2}, 0.3};
  EXPECT_FALSE(watch.add(patch, 1.0));
  EXPECT_FALSE(watch.add(patch, 1.1));
  EXPECT_FALSE(watch.add(patch, 9.0)) << "nobody knows what it did meanwhile";
}

TEST(StationaryContactDetector, TellsWhyItWaits) {
  StationaryContactDetector watch;
  const auto state_after = [&](const std::optional<DarkPatch>& patch, double time_s) {
    static_cast<void>(watch.add(patch, time_s));
    return watch.hold().state;
  };
  EXPECT_EQ(state_after(std::nullopt, 0), HoldState::kNothing);
  EXPECT_EQ(state_after(DarkPatch{{30, 2}, 0.3}, 0.1), HoldState::kHolds);
  EXPECT_EQ(state_after(DarkPatch{{31, 2}, 0.3}, 0.2), HoldState::kMoves);
  EXPECT_NEAR(watch.hold().moved_mm, 1, 1e-12);
  EXPECT_EQ(watch.hold().hold_fraction, 0);
  EXPECT_EQ(state_after(DarkPatch{{31, 2}, 0.2}, 0.3), HoldState::kMoves) << "it is lifted";
  EXPECT_EQ(state_after(DarkPatch{{31, 2}, 0.2}, 0.4), HoldState::kHolds);
  EXPECT_EQ(state_after(DarkPatch{{31, 2}, 0.2}, 0.55), HoldState::kHolds);
  EXPECT_NEAR(watch.hold().hold_fraction, 0.5, 1e-9);
  EXPECT_TRUE(watch.add(DarkPatch{{31, 2}, 0.2}, 0.81));
  EXPECT_EQ(state_after(DarkPatch{{31, 2}, 0.2}, 0.9), HoldState::kTaken);
}

TEST(StationaryContactDetector, WaitsLongerWhereFramesAreFew) {
  StationaryContactDetector watch;
  const DarkPatch patch{{30, 2}, 0.3};
  int told = 0, frames = 0;
  for (double time_s = 0; told == 0 && frames < 20; time_s += 0.8, ++frames)
    told += watch.add(patch, time_s) ? 1 : 0;
  EXPECT_EQ(frames, static_cast<int>(StationaryContactDetector::kMinFrames))
      << "a loaded computer shows few frames, and a contact that holds still all the same";
}

/// A ball's cap in an orthographic picture of a flat face, 0.05 mm a pixel.
FrameResult capped(double depth_mm, double radius_mm) {
  CameraParameters parameters;
  parameters.model = CameraModel::kOrthographic;
  parameters.width_px = 400;
  parameters.height_px = 300;
  parameters.cx_px = 200;
  parameters.cy_px = 150;
  parameters.mm_per_px = 0.05;
  Face face;
  face.kind = FaceKind::kFlat;
  face.layer_mm = 1.5;
  face.plane_z_mm = 20;
  FrameResult result;
  result.shape = FaceShape::plane(Camera::create(parameters).value(), face);
  result.evidence.emplace().is_face_pressed = true;
  DepthMap depth;
  depth.depth_mm = cv::Mat(300, 400, CV_32FC1, cv::Scalar(0));
  for (int v = 0; v < 300; ++v)
    for (int u = 0; u < 400; ++u) {
      const double r = 0.05 * std::hypot(u - 240, v - 130);
      const double below = radius_mm * radius_mm - r * r;
      const double cap = below > 0 ? depth_mm - radius_mm + std::sqrt(below) : 0;
      depth.depth_mm.at<float>(v, u) = static_cast<float>(std::max(0.0, cap));
    }
  result.depth = depth;
  return result;
}

TEST(DarkPatch, TellsHowLargeTheDiscIsAndSoHowDeepTheBallIs) {
  for (const double depth : {0.4, 0.8, 1.2}) {
    const auto patch = dark_patch(capped(depth, 4));
    ASSERT_TRUE(patch);
    EXPECT_NEAR(patch->pixel.x(), 240, 2);
    EXPECT_NEAR(patch->pixel.y(), 130, 2);
    EXPECT_NEAR(patch->darkness, depth, 0.08 * depth);
    EXPECT_NEAR(disc_depth_mm(patch->disc_radius_mm, 4), depth, 0.12 * depth);
  }
  FrameResult free = capped(0.5, 4);
  free.evidence->is_face_pressed = false;
  EXPECT_FALSE(dark_patch(free));
}

}  // namespace
}  // namespace alltact
