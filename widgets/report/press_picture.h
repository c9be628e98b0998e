// A press as a person can judge it: the picture around the contact, with the ball's outline.
#pragma once

#include "calibration/joint/calibrate.h"
#include "core/camera/camera.h"

#include <QImage>
#include <QSize>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// The part of an oriented grey picture around the ball, enlarged or reduced to `size` px, with the
/// ball's exact outline as the camera sees it, its middle, and dashed the border of what it
/// touches. `touched`: pixels of that part; may be empty. Parts beyond the picture are grey.
[[nodiscard]] QImage press_picture(const cv::Mat& grey,
                                   const Camera& camera,
                                   const BallFit& ball,
                                   const std::vector<Eigen::Vector2d>& touched,
                                   const QSize& size);

/// The whole picture, for a press without a ball.
[[nodiscard]] QImage whole_picture(const cv::Mat& grey, const QSize& size);

}  // namespace alltact
