// Grey levels of painted faces.
#include "core/sensing/face/face_levels.h"

#include "tests/support/synthetic_face.h"

#include <numeric>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::SyntheticFace;

SyntheticFace straight_face() {
  SyntheticFace face;
  face.upper = [](double u) { return 150.3 + 0.02 * u; };
  face.lower = [](double u) { return 390.1 - 0.03 * u; };
  face.blur_px = 1.0;
  return face;
}

TEST(FaceLevels, CountsWhatIsTooBrightAndTooDarkOnTheFace) {
  cv::Mat grey = straight_face().draw(4);
  const auto edges = FaceEdgeFinder()(grey);
  ASSERT_TRUE(edges.ok());
  const FaceLevels before = face_levels(grey, &*edges);
  EXPECT_TRUE(before.is_of_face);
  EXPECT_EQ(before.too_bright, 0);
  EXPECT_EQ(before.too_dark, 0);
  const int all = std::accumulate(before.counts.begin(), before.counts.end(), 0);
  grey(cv::Rect(300, 200, 50, 40)).setTo(255);
  grey(cv::Rect(500, 220, 30, 20)).setTo(2);
  grey(cv::Rect(500, 20, 100, 20)).setTo(255);  // off the face
  const FaceLevels after = face_levels(grey, &*edges);
  EXPECT_NEAR(after.too_bright * all, 50 * 40, 0.5);
  EXPECT_NEAR(after.too_dark * all, 30 * 20, 0.5);
  EXPECT_EQ(std::accumulate(after.counts.begin(), after.counts.end(), 0), all);
  EXPECT_EQ(after.counts.back(), 50 * 40);
}

TEST(FaceLevels, IsThatOfTheEntireImageWhereNoFaceIsFound) {
  const cv::Mat grey(40, 60, CV_8UC1, cv::Scalar(251));
  const FaceLevels levels = face_levels(grey, nullptr);
  EXPECT_FALSE(levels.is_of_face);
  EXPECT_EQ(levels.too_bright, 1);
  EXPECT_EQ(levels.counts[251 / FaceLevels::kLevelsPerBin], 40 * 60);
}

}  // namespace
}  // namespace alltact
