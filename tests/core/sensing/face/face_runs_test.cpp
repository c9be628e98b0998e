#include "core/sensing/depth/depth_map.h"
#include "core/sensing/face/face_pixels.h"
#include "core/sensing/reference/image_warp.h"
#include "tests/support/marked_finger.h"

#include <cstring>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

bool same_bytes(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

TEST(FaceRuns, AreEveryPixelWithinTheMarginAndNoOther) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 12; ++trial) {
    test::MarkedFinger finger;
    finger.mirrored = trial % 2 != 0;
    const FaceShape shape = finger.shape(test::random_bend(random));
    const double margin_px = 0.5 * trial;
    const cv::Size size(finger.width, finger.height);
    const FaceRuns runs = face_runs(shape, margin_px, size);
    cv::Mat shown(size, CV_8UC1, cv::Scalar(0));
    std::uint32_t before = 0;
    for (int v = 0; v < size.height; ++v) {
      int end_before = -1;
      for (const FaceRun& run : runs.of_row(v)) {
        EXPECT_EQ(run.row, v);
        EXPECT_GT(run.first, end_before) << "two runs of a row that touch are one";
        EXPECT_LT(run.first, run.end);
        EXPECT_EQ(run.before, before);
        before += static_cast<std::uint32_t>(run.size());
        end_before = run.end;
        shown(cv::Range(v, v + 1), cv::Range(run.first, run.end)) = 255;
      }
    }
    EXPECT_EQ(runs.pixels(), before);
    EXPECT_GT(before, 20000U);
    for (int u = 0; u < size.width; ++u) {
      const auto rows = shape.rows(u, margin_px);
      for (int v = 0; v < size.height; ++v)
        ASSERT_EQ(shown.at<std::uint8_t>(v, u) != 0, v >= rows.first && v <= rows.last)
            << u << ' ' << v;
    }
  }
}

TEST(LocalDepth, InOnePassGivesTheSameBytesAsOneAfterTheOther) {
  std::mt19937 random(12);
  const test::MarkedFinger finger;
  MappingParameters parameters;
  parameters.kind = MappingKind::kMoebius;
  parameters.x_max = 0.6;
  parameters.a_mm = 2.4;
  parameters.b = 0.6;
  for (const MappingAlong along : {MappingAlong::kZ, MappingAlong::kNormal}) {
    parameters.along = along;
    const Mapping mapping = Mapping::create(parameters).value();
    const FaceShape shape = finger.shape(test::random_bend(random));
    cv::Mat live(finger.height, finger.width, CV_8UC1), levels(live.size(), CV_32FC1);
    cv::randu(live, 30, 120);
    cv::randu(levels, 60.0, 130.0);
    Reference reference;
    reference.image = ReferenceImage(levels);
    for (const double smoothing_px : {0.0, 0.4, 1.0, 2.7}) {
      DifferenceOptions options;
      options.smoothing = smoothing_of(smoothing_px);
      const Difference x = difference(live, reference, shape, options);
      const DepthMap depth = depth_map(x, mapping, shape);
      const DepthMap at_once = depth_map(live, reference, shape, options, mapping);
      EXPECT_TRUE(same_bytes(depth.depth_mm, at_once.depth_mm));
      EXPECT_TRUE(same_bytes(depth.flags, at_once.flags));
    }
  }
}

TEST(PicturePool, GivesMemoryBackAndNeverSharesIt) {
  const cv::Size size(311, 77);
  const uchar* first = nullptr;
  {
    cv::Mat image = pooled_image(size, CV_32FC1);
    image.setTo(1.0F);
    first = image.data;
    const cv::Mat held = image;  // the same picture
    image.release();
    const cv::Mat other = pooled_image(size, CV_32FC1);
    EXPECT_NE(other.data, held.data);
    EXPECT_EQ(held.at<float>(76, 310), 1.0F);
  }
  const cv::Mat a = pooled_image(size, CV_32FC1), b = pooled_image(size, CV_32FC1);
  EXPECT_TRUE(a.data == first || b.data == first);
  EXPECT_TRUE(a.isContinuous());
}

}  // namespace
}  // namespace alltact
