// Brightness and focus in words.
#include "widgets/panels/brightness_box.h"

#include "tests/support/cameras.h"

#include <QLabel>
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

/// A face between two horizontal edges that are so many pixels wide.
FrameResult face_with_edges(int width_px) {
  constexpr double kUpper = 150, kLower = 390;
  FrameResult result;
  result.grey = cv::Mat(540, 960, CV_8UC1);
  for (int v = 0; v < 540; ++v) {
    const double into = std::min(v - kUpper, kLower - v) / width_px + 0.5;
    result.grey.row(v).setTo(20 + 140 * std::clamp(into, 0.0, 1.0));
  }
  FaceEdges edges;
  for (int u = 4; u < 960; u += 8) edges.u.push_back(u);
  const auto count = edges.u.size();
  const std::vector<double> sd(count, 0.1);
  const std::vector<char> valid(count, 1);
  edges.upper = {std::vector(count, kUpper), sd, valid};
  edges.lower = {std::vector(count, kLower), sd, valid};
  Face face;
  face.width_mm = 24;
  result.shape = FaceShape::fit(edges, Camera::create(pinhole()).value(), face, 2).value();
  result.edges = edges;
  return result;
}

std::string texts(const BrightnessBox& box) {
  std::string all;
  for (const QLabel* label : box.findChildren<QLabel*>()) all += label->text().toStdString() + "\n";
  return all;
}

TEST(BrightnessBox, SaysHowSharpTheImageIsAndHowSharpItWas) {
  BrightnessBox box;
  EXPECT_THAT(texts(box), HasSubstr("No image yet"));
  for (const int width_px : {6, 4, 8}) {
    const FrameResult result = face_with_edges(width_px);
    box.show_image(&result);
  }
  EXPECT_THAT(texts(box), HasSubstr("Focus at the base: 7.8 px (best: 4.0 px)"));
  EXPECT_THAT(texts(box), HasSubstr("Focus at the tip: 7.8 px (best: 4.0 px)"));
  box.show_image(nullptr);
  EXPECT_THAT(texts(box), HasSubstr("no edges in view"));
}

TEST(BrightnessBox, SaysHowMuchIsTooBrightEvenIfItIsAlmostNothing) {
  BrightnessBox box;
  FrameResult result = face_with_edges(4);
  result.grey(cv::Rect(400, 250, 3, 3)).setTo(255);
  box.show_image(&result);
  EXPECT_THAT(texts(box), HasSubstr("Face: < 0.1 % too bright, 0.0 % too dark"));
}

}  // namespace
}  // namespace alltact::test
