// What a frame tells as far as the finger is known: nobody described it, it was described, it has
// its reference. Pictures of the simulated finger, whose presses are known.
#include "core/sensing/pipeline.h"

#include "core/simulation/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

Plan plan_of(const std::string& scene) {
  return Plan::compile(
             Scene::load(std::filesystem::path(ALLTACT_SOURCE_DIR) / "resources/scenes" / scene)
                 .value(),
             3)
      .value();
}

/// The camera's next.
FramePtr frame_of(const cv::Mat& grey) {
  static std::uint64_t next = 0;
  auto frame = std::make_shared<Frame>();
  frame->grey = grey;
  frame->name = "frame";
  frame->origin = "/dev/video9";
  frame->sequence = next++;
  return frame;
}

FrameResult measured(Pipeline& pipeline, const cv::Mat& grey) {
  auto result = pipeline(frame_of(grey));
  EXPECT_TRUE(result.ok());
  return std::move(result).value();
}

cv::Mat smaller(const cv::Mat& grey) {
  cv::Mat half;
  cv::resize(grey, half, {}, 0.5, 0.5, cv::INTER_AREA);
  return half;
}

TEST(PipelineOfAnUnknownFinger, TellsTheEdgesAloneOfPicturesOfAnySize) {
  Pipeline pipeline = Pipeline::without_finger();
  EXPECT_FALSE(pipeline.has_reference());
  const cv::Mat grey = plan_of("studio_finger.yaml").render(70);
  for (const cv::Mat& image : {grey, smaller(grey), grey}) {
    const FrameResult result = measured(pipeline, image);
    EXPECT_EQ(result.grey.data, image.data);
    EXPECT_TRUE(result.edges);
    EXPECT_FALSE(result.shape || result.markers || result.reference || result.depth);
    EXPECT_EQ(is_face_pressed(result), std::nullopt);
    EXPECT_THAT(result.problems, testing::IsEmpty()) << "the same picture again is none";
    EXPECT_GT(result.times_ms.edges, 0);
    EXPECT_GE(result.times_ms.total, result.times_ms.edges);
  }
}

TEST(PipelineOfAnUnknownFinger, SaysOnceThatThereIsNoFace) {
  Pipeline pipeline = Pipeline::without_finger();
  const FrameResult result = measured(pipeline, cv::Mat(120, 160, CV_8UC1, cv::Scalar(0)));
  EXPECT_FALSE(result.edges);
  EXPECT_THAT(result.problems, testing::SizeIs(1));
}

class PipelineWithoutReference : public testing::Test {
 protected:
  FrameResult look(int frame) { return measured(pipeline_, plan_.render(frame)); }

  Plan plan_ = plan_of("studio_finger.yaml");
  Pipeline pipeline_ = Pipeline::without_reference(FingerSnapshot::of({}, plan_.finger()).value(),
                                                   PipelineSettings{});
};

TEST_F(PipelineWithoutReference, TellsShapeAndMarkersAndNothingThatNeedsTheReference) {
  EXPECT_FALSE(pipeline_.has_reference());
  const FrameResult result = look(0);
  ASSERT_TRUE(result.edges && result.shape && result.markers);
  EXPECT_EQ(result.shape->width_px(), result.grey.cols);
  EXPECT_EQ(static_cast<int>(result.markers->size()), plan_.finger().marker_count());
  EXPECT_THAT(result.dots, testing::IsEmpty());
  EXPECT_FALSE(result.reference || result.difference || result.depth || result.push);
  EXPECT_THAT(result.problems, testing::IsEmpty());
}

TEST_F(PipelineWithoutReference, TellsDotsThatAreNoMarkersYet) {
  cv::Mat grey = plan_.render(0);
  const FrameResult plain = measured(pipeline_, grey);
  ASSERT_TRUE(plain.markers);
  pipeline_.forget();
  // One dot of the upper row is covered.
  const Marker& dot = (*plain.markers)[2];
  const auto u = static_cast<int>(dot.u), v = static_cast<int>(dot.v);
  cv::circle(grey, {u, v}, 16, grey.at<std::uint8_t>(v, u + 30), cv::FILLED);
  const FrameResult covered = measured(pipeline_, grey);
  EXPECT_FALSE(covered.markers);
  EXPECT_GE(covered.dots.size(), plain.markers->size() / 2);
}

TEST_F(PipelineWithoutReference, TellsTouchAfterItsFirstFramesAndAnewWhenItForgets) {
  // Frame 70: the ball is in by 0.84 mm; before frame 46 nothing presses.
  for (int i = 0; i < 4; ++i) EXPECT_EQ(is_face_pressed(look(i)), std::nullopt) << i;
  for (int i = 4; i < 20; ++i) EXPECT_EQ(is_face_pressed(look(i)), false) << i;
  EXPECT_EQ(is_face_pressed(look(70)), true);
  pipeline_.forget();
  EXPECT_EQ(is_face_pressed(look(70)), std::nullopt);
}

TEST_F(PipelineWithoutReference, RefusesAPictureOfAnotherSizeAndGoesOnAfterIt) {
  for (int i = 0; i < 6; ++i) static_cast<void>(look(i));
  const auto refused = pipeline_(frame_of(smaller(plan_.render(6))));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().where.english(), "/dev/video9");
  EXPECT_EQ(refused.error().advice.english(),
            "the finger that belongs to this camera, or this finger's camera");
  EXPECT_EQ(is_face_pressed(look(7)), false) << "it remembers the frames before";
}

TEST_F(PipelineWithoutReference, SaysNothingOfACameraThatStandsStill) {
  const cv::Mat grey = plan_.render(0);
  static_cast<void>(measured(pipeline_, grey));
  EXPECT_THAT(measured(pipeline_, grey.clone()).problems, testing::IsEmpty());
}

TEST(PipelineOfAFlatSensor, TellsItsShapeWithTheReferenceAlone) {
  const Plan pressed = plan_of("flat_press.yaml"), untouched = plan_of("flat_reference.yaml");
  const FingerSnapshot finger = FingerSnapshot::of({}, pressed.finger()).value();
  Pipeline without = Pipeline::without_reference(finger, PipelineSettings{});
  EXPECT_FALSE(measured(without, pressed.render(2)).shape);

  const cv::Mat free = untouched.render(0);
  Pipeline pipeline =
      Pipeline::with_library(ReferenceLibrary::single(free).value(), finger, PipelineSettings{});
  EXPECT_TRUE(pipeline.has_reference());
  const FrameResult result = measured(pipeline, pressed.render(2));
  EXPECT_TRUE(result.shape && result.difference);
  EXPECT_EQ(is_face_pressed(result), true);
  EXPECT_EQ(is_face_pressed(measured(pipeline, free)), false);
  EXPECT_THAT(measured(pipeline, free.clone()).problems, testing::SizeIs(2))
      << "not calibrated, and the camera stands still";
  pipeline.forget();
  EXPECT_THAT(measured(pipeline, free.clone()).problems, testing::SizeIs(1));
  const auto refused = pipeline(frame_of(smaller(free)));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().advice.english(),
            "an image of the size that the finger was calibrated with");
}

}  // namespace
}  // namespace alltact
