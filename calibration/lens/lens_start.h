// First values for a lens and for where each board stands, from nothing but the corners.
#pragma once

#include "calibration/lens/board.h"
#include "calibration/lens/view_cost.h"
#include "core/camera/camera.h"

#include <vector>

namespace alltact {

/// The poses in which a camera may see a board so, best first; at most two: a small or distant
/// board looks nearly the same tilted either way. Empty when the camera cannot have seen it.
[[nodiscard]] std::vector<BoardPose> poses_of(const BoardView& view, const Camera& camera);

/// Root mean square distance of projected and seen corners, px; infinite where a corner cannot be
/// seen at all.
[[nodiscard]] double pose_error_px(const BoardView& view,
                                   const Camera& camera,
                                   const BoardPose& pose);

/// The focal length (and for brown the bend) among a wide table of lenses with which flat boards
/// explain the corners best; the principal point is the picture's middle. Works where a homography
/// of the pixels does not, as with a fisheye. Error: none explains them.
[[nodiscard]] Result<CameraParameters> first_lens(const std::vector<BoardView>& views,
                                                  CameraModel model,
                                                  cv::Size size);

}  // namespace alltact
