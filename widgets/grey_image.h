// Grey images as Qt draws them.
#pragma once

#include <QImage>

#include <opencv2/core.hpp>

namespace alltact {

/// Shares the pixels (CV_8UC1); valid while `grey` lives.
[[nodiscard]] inline QImage grey_image(const cv::Mat& grey) {
  return {grey.data,
          grey.cols,
          grey.rows,
          static_cast<qsizetype>(grey.step),
          QImage::Format_Grayscale8};
}

}  // namespace alltact
