// Where the view face ends along the finger: at its tip and at its base.
#pragma once

#include "core/camera/camera.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

struct FaceEdges;

/// One end of the face, a straight line across it, as the lens shows it:
/// u = u_px + slope (v - v_px) + bow (v - v_px)^2.
struct FaceEnd {
  double u_px = 0, v_px = 0;  ///< a place on it
  double slope = 0;           ///< du/dv; 0 unless the finger twists or sways
  double bow_per_px = 0;      ///< 0 unless the lens or a window before it bends straight lines
  double sd_px = 0;           ///< standard deviation of u there

  [[nodiscard]] double at(double v) const {
    const double off = v - v_px;
    return u_px + off * (slope + bow_per_px * off);
  }
};

/// What looks at the face, and how wide this is: how a straight line across it looks.
struct FaceView {
  Camera camera;
  double width_mm;
};

/// The ends at small and at large u. Absent where the face goes on to the picture's border, and
/// where no end could be seen.
struct FaceEnds {
  std::optional<FaceEnd> first, last;
};

/// The face ends where its brightness ends: the face between its two edges is read in strips along
/// the finger, each gives its steps to something darker (brighter, where the face is the darker
/// one), and the straight line that collects most of them is the end. What presses on the end hides
/// some strips and shows a border of its own in others, which is no straight line across. With a
/// view the line is straight on the finger, else in the picture.
[[nodiscard]] FaceEnds find_face_ends(const cv::Mat& grey,
                                      const FaceEdges& edges,
                                      const FaceView* view = nullptr);

}  // namespace alltact
