// First values for a lens and for the board's poses, from the corners alone.
#pragma once

#include "calibration/lens/board.h"
#include "calibration/lens/view_cost.h"
#include "core/camera/camera.h"

#include <vector>

namespace alltact {

/// The possible poses of a board in a view, best first; at most two: a small or distant board looks
/// nearly the same tilted in two directions. Empty when the camera cannot have seen it.
[[nodiscard]] std::vector<BoardPose> poses_of(const BoardView& view, const Camera& camera);

/// Root mean square distance of projected and seen corners, px; infinite where a corner cannot be
/// seen at all.
[[nodiscard]] double pose_error_px(const BoardView& view,
                                   const Camera& camera,
                                   const BoardPose& pose);

/// Searches a wide table of focal lengths (and for brown of bends) for the lens with which flat
/// boards explain the corners best. The principal point is the middle of the image. It works where
/// a homography of the pixels does not, as with a fisheye. Error: none explains them.
[[nodiscard]] Result<CameraParameters> first_lens(const std::vector<BoardView>& views,
                                                  CameraModel model,
                                                  cv::Size size);

}  // namespace alltact
