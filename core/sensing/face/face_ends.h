// Ends of the view face along the finger: at its tip and at its base.
#pragma once

#include "core/camera/camera.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

struct FaceEdges;

/// One end of the face: a straight line across it, as the lens images it:
/// u = u_px + slope (v - v_px) + bow (v - v_px)^2.
struct FaceEnd {
  double u_px = 0, v_px = 0;  ///< a point on the line
  double slope = 0;           ///< du/dv; 0 unless the finger twists or sways
  double bow_per_px = 0;      ///< 0 unless the lens or a window in front of it bends straight lines
  double sd_px = 0;           ///< standard deviation of u at that point

  [[nodiscard]] double at(double v) const {
    const double off = v - v_px;
    return u_px + off * (slope + bow_per_px * off);
  }
};

/// The camera and the width of the face, which determine the image of a straight line across the
/// face.
struct FaceView {
  Camera camera;
  double width_mm;
};

/// The ends at small and at large u. Absent where the face extends to the border of the image, and
/// where no end was found.
struct FaceEnds {
  std::optional<FaceEnd> first, last;
};

/// Finds the straight lines across the finger where the brightness of the face ends. The face
/// between its edges is read in strips along the finger. Each strip gives its steps to something
/// darker (brighter, where the face is the darker side). The line that collects the highest
/// contrast is the end. An object that presses on the end hides some strips and shows its own
/// border in others, which is not straight across. With a view the line is straight on the finger,
/// else in the image.
[[nodiscard]] FaceEnds find_face_ends(const cv::Mat& grey,
                                      const FaceEdges& edges,
                                      const FaceView* view = nullptr);

}  // namespace alltact
