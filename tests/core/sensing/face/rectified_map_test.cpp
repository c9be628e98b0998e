// Maps over the face: values stand where their positions in millimetres say.
#include "core/sensing/face/rectified_map.h"

#include "core/base/atomic_file.h"
#include "tests/support/made_press.h"
#include "tests/support/scratch_folder.h"

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact {
namespace {

using testing::HasSubstr;

/// Of each pixel on the face, by its place: mm along the face, or across it.
cv::Mat positions(const FaceShape& shape, int axis) {
  cv::Mat by_pixel(540, 960, CV_32FC1, cv::Scalar(std::numeric_limits<double>::quiet_NaN()));
  for (int v = 0; v < by_pixel.rows; ++v)
    for (int u = 0; u < by_pixel.cols; ++u)
      if (shape.at(u, v))
        by_pixel.at<float>(v, u) = static_cast<float>(shape.position_mm(u, v)[axis]);
  return by_pixel;
}

TEST(RectifiedMap, APixelStandsWhereItsAxesSay) {
  const made::MadeScene scene = made::finger_scene(32.0, 35.0);
  for (const int axis : {0, 1}) {
    const RectifiedMap map = rectified_map(positions(scene.shape, axis), scene.shape, 0.25);
    ASSERT_FALSE(map.values.empty());
    const PixelsOnPlane& plane = map.plane;
    for (const double first_mm : {plane.first_column_mm, plane.first_row_mm})
      EXPECT_NEAR(first_mm / 0.25, std::round(first_mm / 0.25), 1e-9) << "round steps";
    int measured = 0;
    double most_off_mm = 0;
    for (int j = 0; j < map.values.rows; ++j)
      for (int i = 0; i < map.values.cols; ++i) {
        const float value = map.values.at<float>(j, i);
        if (!std::isfinite(value)) continue;
        const double expected = axis == 0 ? plane.first_column_mm + i * plane.step_mm
                                          : plane.first_row_mm + j * plane.step_mm;
        most_off_mm = std::max(most_off_mm, std::abs(static_cast<double>(value) - expected));
        ++measured;
      }
    EXPECT_LT(most_off_mm, 0.03) << axis << ", a third of a pixel";
    EXPECT_GT(measured, 0.9 * 24.0 / 0.25 * map.values.cols) << "all of a face 24 mm wide";
  }
}

TEST(RectifiedMap, IsEmptyWithoutAFace) {
  const made::MadeScene scene = made::flat_scene();
  const cv::Mat nothing(300, 400, CV_32FC1, cv::Scalar(std::numeric_limits<double>::quiet_NaN()));
  const RectifiedMap map = rectified_map(nothing, scene.shape);
  EXPECT_EQ(cv::countNonZero(map.values == map.values), 0);
}

TEST(RectifiedMap, OtherProgramsReadTheTiffWithItsAxes) {
  cv::Mat values(7, 11, CV_32FC1);
  cv::randu(values, -0.1, 1.0);
  values.at<float>(3, 4) = std::numeric_limits<float>::quiet_NaN();
  const auto file = test::scratch_folder("rectified") / "map.tiff";
  const std::string tiff = depth_tiff(values, PixelsOnPlane{0.1, 2.5, -1.2});
  ASSERT_TRUE(write_file_atomically(file, tiff));
  const cv::Mat read = cv::imread(file.string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(read.size(), values.size());
  ASSERT_EQ(read.type(), CV_32FC1);
  EXPECT_EQ(std::memcmp(read.data, values.data, values.total() * sizeof(float)), 0);
  // The pixel of the origin, and mm as the unit of ten pixels for each.
  EXPECT_THAT(tiff, HasSubstr("unit=mm\nxorigin=-25.000000\nyorigin=12.000000\n"));
  EXPECT_EQ(depth_tiff(values).find("ImageJ"), std::string::npos);
}

}  // namespace
}  // namespace alltact
