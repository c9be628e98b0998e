// Image of a press for visual inspection: the region around the contact, with the ball's outline.
#pragma once

#include "calibration/joint/calibrate.h"
#include "core/camera/camera.h"

#include <QImage>
#include <QSize>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// The part of an oriented grey image around the ball, scaled to `size` px. It shows the ball's
/// exact outline as the camera sees it, its centre, and dashed the border of the contact.
/// `contact_pixels`: of that part; may be empty. Parts beyond the image are grey.
[[nodiscard]] QImage press_image(const cv::Mat& grey,
                                 const Camera& camera,
                                 const BallFit& ball,
                                 const std::vector<Eigen::Vector2d>& contact_pixels,
                                 const QSize& size);

/// The full image, for a press without a ball.
[[nodiscard]] QImage full_image(const cv::Mat& grey, const QSize& size);

}  // namespace alltact
