// Pictures of fewer pixels against means by hand, and their camera against the rays of the whole.
#include "core/camera/camera.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(ReducedPicture, EveryPixelIsTheMeanOfItsSquare) {
  std::mt19937 random(3);
  cv::Mat grey(43, 58, CV_8UC1);
  for (int v = 0; v < grey.rows; ++v)
    for (int u = 0; u < grey.cols; ++u)
      grey.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(random() % 256);
  EXPECT_EQ(reduced_image(grey, 1).data, grey.data);
  for (const int by : {2, 4}) {
    const cv::Mat reduced = reduced_image(grey, by);
    ASSERT_EQ(reduced.size(), cv::Size(58 / by, 43 / by));
    for (int v = 0; v < reduced.rows; ++v)
      for (int u = 0; u < reduced.cols; ++u) {
        int sum = 0;
        for (int y = 0; y < by; ++y)
          for (int x = 0; x < by; ++x) sum += grey.at<std::uint8_t>(v * by + y, u * by + x);
        EXPECT_NEAR(reduced.at<std::uint8_t>(v, u), sum / static_cast<double>(by * by), 0.51);
      }
  }
}

TEST(ReducedPicture, ItsCameraSeesTheSameRaysAtTheMiddlesOfTheSquares) {
  for (const CameraModel model : {CameraModel::kPinhole, CameraModel::kBrown, CameraModel::kFisheye,
                                  CameraModel::kOrthographic}) {
    CameraParameters whole;
    whole.model = model;
    whole.width_px = 962;
    whole.height_px = 543;
    whole.fx_px = 523.9;
    whole.fy_px = 519.1;
    whole.cx_px = 471.25;
    whole.cy_px = 280.5;
    if (model == CameraModel::kOrthographic) whole.mm_per_px = 0.06;
    if (model == CameraModel::kBrown) whole.distortion = {-0.05, 0.01, 0.001, -0.002, 0.0};
    if (model == CameraModel::kFisheye) whole.distortion = {-0.02, 0.003, 0.0, 0.0};
    const auto camera = Camera::create(whole);
    ASSERT_TRUE(camera.ok());
    for (const int by : {2, 4}) {
      const auto reduced = Camera::create(reduced_camera(whole, by));
      ASSERT_TRUE(reduced.ok());
      EXPECT_EQ(reduced->size(), cv::Size(962 / by, 543 / by));
      for (int v = 0; v < reduced->size().height; v += 13)
        for (int u = 0; u < reduced->size().width; u += 17) {
          // The middle of the square of pixels by u ... by u + by - 1.
          const Eigen::Vector2d middle(by * u + 0.5 * (by - 1), by * v + 0.5 * (by - 1));
          EXPECT_DOUBLE_EQ(full_px(u, by), middle.x());
          EXPECT_NEAR(reduced_px(middle.x(), by), u, 1e-12);
          const auto a = camera->unproject(middle), b = reduced->unproject({u, v});
          ASSERT_TRUE(a && b);
          EXPECT_LT((a->point_at(60.0) - b->point_at(60.0)).norm(), 1e-9);
        }
    }
  }
}

}  // namespace
}  // namespace alltact
