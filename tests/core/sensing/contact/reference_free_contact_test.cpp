// Touching before there is a reference: pictures of the simulated finger, whose presses are known.
#include "core/sensing/contact/finger_contact.h"
#include "core/sensing/face/face_edges.h"
#include "core/simulation/plan.h"

#include <cstdio>
#include <functional>

#include <gtest/gtest.h>

namespace alltact {
namespace {

class Simulated {
 public:
  explicit Simulated(const std::string& scene)
      : plan_(Plan::compile(Scene::load(std::filesystem::path(ALLTACT_SOURCE_DIR) /
                                        "resources/scenes" / scene)
                                .value(),
                            3)
                  .value()),
        camera_(Camera::create(plan_.finger().camera).value()) {}

  /// What the detector says of one frame; `change` may do something to the picture first.
  std::optional<ReferenceFreeContact> look(ReferenceFreeContactDetector& detector, int frame,
                                           const std::function<void(cv::Mat&)>& change = {}) const {
    cv::Mat grey = plan_.render(frame);
    if (change) change(grey);
    const auto edges = FaceEdgeFinder()(grey);
    EXPECT_TRUE(edges.ok()) << frame;
    const auto shape = FaceShape::fit(*edges, camera_, plan_.finger().face, 7);
    EXPECT_TRUE(shape.ok()) << frame;
    return detector(grey, *shape);
  }

 private:
  Plan plan_;
  Camera camera_;
};

TEST(ReferenceFreeContact, SeesAPressThatComesAndSlidesAndGoes) {
  // 150 frames: from frame 46 a ball of 4 mm comes, is 0.4 mm deep from frame 59 to 136, slides
  // along the face meanwhile, and is gone in frame 149.
  const Simulated finger("studio_finger.yaml");
  ReferenceFreeContactDetector detector;
  int false_frames = 0, missed = 0;
  for (int i = 0; i < 150; ++i) {
    const bool is_seen = finger.look(detector, i).has_value();
    EXPECT_EQ(detector.is_ready(), i >= 4);
    false_frames += is_seen && i < 46;
    missed += !is_seen && i >= 59 && i <= 136;
  }
  std::printf("[ figures  ] %d of 46 untouched frames warned of, %d of 78 touched ones missed\n",
              false_frames, missed);
  EXPECT_EQ(false_frames, 0);
  EXPECT_EQ(missed, 0);
}

TEST(ReferenceFreeContact, SaysWhereItIs) {
  const Simulated finger("studio_finger.yaml");
  ReferenceFreeContactDetector detector;
  for (int i = 0; i < 40; ++i) static_cast<void>(finger.look(detector, i));
  const auto contact = finger.look(detector, 70);  // at 40 mm, 0.84 mm deep
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->along_mm, 40, 6);  // the scene counts from a little further down the finger
  EXPECT_GT(contact->darker, 0.1);
}

TEST(ReferenceFreeContact, BendingAloneIsNoTouch) {
  // The demonstration's reference recording: bent and swayed in all directions, untouched.
  const Simulated finger("demo_reference.yaml");
  ReferenceFreeContactDetector detector;
  int warned = 0;
  for (int i = 0; i < 240; i += 2) warned += finger.look(detector, i).has_value();
  std::printf("[ figures  ] %d of 120 frames warned of\n", warned);
  EXPECT_LE(warned, 1);
}

TEST(ReferenceFreeContact, MarkedSkinIsNoTouch) {
  const Simulated finger("studio_finger.yaml");
  ReferenceFreeContactDetector detector;
  // A dark spot that is always there.
  const auto mark = [](cv::Mat& grey) {
    cv::Mat spot = grey(cv::Rect(grey.cols / 2, grey.rows / 2, 12, 12));
    spot.convertTo(spot, -1, 0.7);
  };
  for (int i = 0; i < 46; ++i) EXPECT_FALSE(finger.look(detector, i, mark)) << i;
  EXPECT_TRUE(finger.look(detector, 70, mark));
}

TEST(ReferenceFreeContact, WhatPressesFromTheStartIsSeenOnceItLetGo) {
  const Simulated finger("studio_finger.yaml");
  ReferenceFreeContactDetector detector;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(finger.look(detector, 70 - i % 2)) << i;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(finger.look(detector, i)) << i;
  EXPECT_TRUE(finger.look(detector, 70));
  detector.forget();
  EXPECT_FALSE(detector.is_ready());
  EXPECT_FALSE(finger.look(detector, 70));
}

}  // namespace
}  // namespace alltact
