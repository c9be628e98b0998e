#include "calibration/report/problem_image.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

int coloured(const cv::Mat& image) {
  int count = 0;
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) {
      const auto& p = image.at<cv::Vec3b>(y, x);
      count += p[0] != p[1] || p[1] != p[2];
    }
  return count;
}

TEST(ProblemPicture, ShowsThePictureWhatWasFoundAndTheWords) {
  ProblemScene scene;
  scene.grey = cv::Mat(100, 300, CV_8UC1, cv::Scalar(77));
  scene.words = {"only one of two markers was found"};
  const cv::Mat bare = problem_image(scene);
  EXPECT_EQ(bare.type(), CV_8UC3);
  EXPECT_EQ(bare.cols, 600) << "small pictures are drawn at twice their size";
  EXPECT_GT(bare.rows, 200);
  EXPECT_EQ(coloured(bare.rowRange(0, 200)), 0);
  EXPECT_EQ(bare.at<cv::Vec3b>(50, 50), cv::Vec3b(77, 77, 77));

  scene.marks.push_back({ProblemMark::Kind::kUsed, 30, 40, 3, 0});
  const cv::Mat used = problem_image(scene);
  EXPECT_GT(coloured(used.rowRange(0, 200)), 0);
  EXPECT_GT(used.rows, bare.rows) << "the key says what the circle means";
  for (const auto kind : {ProblemMark::Kind::kRefused, ProblemMark::Kind::kExpected})
    scene.marks.push_back({kind, 100, 60, 3, -1});
  EXPECT_GT(coloured(problem_image(scene)), coloured(used));

  scene.marks.assign(1, {ProblemMark::Kind::kUsed, std::nan(""), 1e9, 3, 1});
  EXPECT_EQ(coloured(problem_image(scene).rowRange(0, 200)), 0);
}

TEST(ProblemPicture, DrawsEdgesAndBreaksLongSentences) {
  ProblemScene scene;
  scene.grey = cv::Mat(200, 1000, CV_8UC1, cv::Scalar(10));
  const int one_line = problem_image({scene.grey, {}, {}, {"short"}}).rows;
  std::string sentence;
  for (int i = 0; i < 60; ++i) sentence += "word and ";
  const cv::Mat long_words = problem_image({scene.grey, {}, {}, {sentence}});
  EXPECT_EQ(long_words.cols, 1000);
  EXPECT_GE(long_words.rows, one_line + 2 * 24);
  scene.edges.u = {100, 900};
  scene.edges.upper = {50, 60};
  scene.edges.lower = {150, 140};
  scene.edges.along_mm = {0, 50};
  EXPECT_GT(coloured(problem_image(scene).rowRange(0, 200)), 1000);
}

}  // namespace
}  // namespace alltact
