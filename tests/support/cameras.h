// The camera that the tests look through.
#pragma once

#include "core/camera/camera.h"

namespace alltact {

/// 85 degrees wide, 960 x 540: that of the simulated finger.
inline CameraParameters pinhole() {
  CameraParameters p;
  p.width_px = 960, p.height_px = 540;
  p.fx_px = p.fy_px = 523.9;
  p.cx_px = 479.5, p.cy_px = 269.5;
  return p;
}

}  // namespace alltact
