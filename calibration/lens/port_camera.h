// One camera that stands for a lens in air and the flat window before it.
#pragma once

#include "core/camera/camera.h"
#include "core/camera/flat_port.h"

namespace alltact {

struct PortCamera {
  CameraParameters camera;  ///< brown for a pinhole or brown lens, fisheye for a fisheye
  /// Its centre lies so far behind the lens's: z in its frame is z from the lens plus this.
  double shift_mm = 0;
  /// Differences from the exact path of light where it was fitted: root mean square and greatest.
  double rms_px = 0, worst_px = 0;
};

/// On the axis a window does nothing but lengthen the focal length by the medium's index and move
/// the centre; off the axis it bends like a lens. So a camera whose lens takes up that bend stands
/// for both, and everything that knows cameras can be used unchanged; what is left over depends on
/// the distance and is told. `air`: the lens in air, perspective. Fitted over the whole picture
/// between the two distances from the lens. Errors: no such port, distances not behind the plate,
/// or no camera that does it.
[[nodiscard]] Result<PortCamera> camera_behind_port(const CameraParameters& air,
                                                    const FlatPort& port,
                                                    double near_mm,
                                                    double far_mm);

}  // namespace alltact
