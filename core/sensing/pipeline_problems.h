// Messages for the problems of a frame.
#pragma once

#include "core/message.h"

namespace alltact {

inline Message pose_not_recorded(double distance_px) {
  return en::say(
      "this pose was never recorded: the nearest reference frame is {:.1f} px away; record the "
      "finger bending further in this direction",
      distance_px);
}

inline Message camera_frozen() {
  return en::say(
      "the picture is the same as the one before to the last grey level: the camera stands "
      "still; plug it in again");
}

inline Message sparse_pose(double error_factor) {
  return en::say(
      "few recorded frames are near this pose: its reference is {:.0f} times less "
      "sure than usual; record the finger bending slowly through it",
      error_factor);
}

inline Message pose_from_shape() {
  return en::say(
      "the markers were not found: the face's shape alone tells this pose, so that depth is less "
      "sure and neither twist nor what touches the finger is told; uncover and light the dots on "
      "the side faces");
}

inline Message force_out_of_range() {
  return en::say(
      "the force model was trained with nothing like this frame: its force cannot be "
      "relied on; add rows with such forces to the table and train it again");
}

}  // namespace alltact
