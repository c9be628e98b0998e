// A picture saved with what is drawn over it.
#include "widgets/panels/image_panel.h"

#include <QPainter>

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(Snapshot, IsThePictureInItsOwnSizeWithWhatIsDrawnOverIt) {
  cv::Mat grey(40, 60, CV_8UC1, cv::Scalar(90));
  grey.at<std::uint8_t>(5, 7) = 200;
  const Overlay square = [](QPainter& painter, const ImageTransform& transform) {
    painter.fillRect(QRectF(transform.to_widget({19.5, 9.5}), QSizeF(4, 4)), Qt::red);
  };
  const QImage image = image_with_overlays(grey, {square});
  EXPECT_EQ(image.size(), QSize(60, 40));
  EXPECT_EQ(image.pixelColor(7, 5), QColor(200, 200, 200));
  EXPECT_EQ(image.pixelColor(0, 0), QColor(90, 90, 90));
  EXPECT_EQ(image.pixelColor(21, 11), QColor(Qt::red));
  EXPECT_EQ(image_with_overlays(grey, {}).pixelColor(21, 11), QColor(90, 90, 90));
}

}  // namespace
}  // namespace alltact
