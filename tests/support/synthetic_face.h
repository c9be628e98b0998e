// A bright band between two smooth edges, drawn by area: an independent stand-in for a finger's
// picture in tests of single steps.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact::test {

struct SyntheticFace {
  int width = 960, height = 540;
  std::function<double(double u)> upper, lower;                           ///< edges, px
  std::function<double(double u)> bright = [](double) { return 150.0; };  ///< of the face
  double beside = 25.0;              ///< grey levels of the side faces
  double first_u = 0, last_u = 1e9;  ///< the face ends beyond these columns
  double noise_sd = 1.0;
  double blur_px = 0.0;

  [[nodiscard]] cv::Mat draw(unsigned seed) const {
    cv::Mat exact(height, width, CV_32FC1);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        double covered = 0;
        if (u >= first_u && u <= last_u) {
          const double top = std::max(upper(u), v - 0.5), bottom = std::min(lower(u), v + 0.5);
          covered = std::max(0.0, bottom - top);
        }
        exact.at<float>(v, u) = static_cast<float>(beside + covered * (bright(u) - beside));
      }
    }
    if (blur_px > 0.0) cv::GaussianBlur(exact, exact, {}, blur_px);
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    cv::Mat image(height, width, CV_8UC1);
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u)
        image.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(
            std::lround(static_cast<double>(exact.at<float>(v, u)) + noise_sd * noise(engine)));
    return image;
  }
};

}  // namespace alltact::test
