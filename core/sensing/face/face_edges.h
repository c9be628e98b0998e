// Upper and lower edge of the view face in each column: the first step of an image's analysis.
#pragma once

#include "core/base/result.h"
#include "core/camera/camera.h"

#include <optional>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

// Ends of the view face along the finger: at its tip and at its base.

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
[[nodiscard]] FaceEnds find_face_ends(const cv::Mat& grey, const FaceEdges& edges,
                                      const FaceView* view = nullptr);

/// One of the two edges of the view face, sampled at the columns FaceEdges::u. Positions in pixels
/// of the oriented image; sd: the standard deviation expected from the noise and contrast around
/// the position. A value that is not `valid` has no meaning.
struct Edge {
  std::vector<double> v;
  std::vector<double> sd;
  std::vector<char> valid;
};

struct FaceEdges {
  std::vector<double> u;      ///< centre column of each sample, ascending
  Edge upper;                 ///< at small v
  Edge lower;                 ///< at large v
  FaceEnds ends;              ///< across the finger; no sample beyond them is valid
  double noise_sd = 0;        ///< standard deviation of the image's noise, grey levels
  bool bright_inside = true;  ///< the face is brighter than its surroundings
};

enum class EdgeMethod {
  kCrossing = 1,  ///< crossing of the mean of both sides' levels, corrected where the face darkens
  kInteger,       ///< the steepest integer pixel
};

/// Finds both edges in an 8-bit grey image, independently of earlier images. A reduced image gives
/// their rough path by dynamic programming over its columns. Then only a band around it is read at
/// full resolution, `columns` at a time averaged along the edge's own slope.
class FaceEdgeFinder {
 public:
  struct Options {
    EdgeMethod method = EdgeMethod::kCrossing;
    int columns = 8;  ///< columns averaged into one sample
    std::optional<FaceView> view =
        std::nullopt;  ///< for the ends; none: straight lines are assumed to stay straight
  };
  FaceEdgeFinder() = default;
  explicit FaceEdgeFinder(Options options) : options_(std::move(options)) {}

  /// Error: no pair of edges could be followed along a fifth of the image.
  [[nodiscard]] Result<FaceEdges> operator()(const cv::Mat& grey) const;

 private:
  Options options_;
};

// Jumps of the face's outline: a finger that is bent until one part of it hides another.

/// Transition of the outline from one part of the face to another that is nearer or further away.
struct OutlineJump {
  /// Middle between the last trusted column of one part and the first of the other
  double u_px;
  double
      shorter_fraction;    ///< fraction of the trusted columns on the side that has fewer, 0 to 0.5
  bool shorter_at_high_u;  ///< the side with fewer is at large u
};

/// The largest permanent jump of both edges in opposite directions. It is at least 5 % of the
/// face's width in the image, and far more than bend and scatter on either side. An object over
/// both edges makes a jump that returns, which does not count. A column is trusted where both edges
/// are. nullopt: no jump with two trusted columns or more on either side and a gap of less than a
/// tenth of the outline.
[[nodiscard]] std::optional<OutlineJump> outline_jump(const FaceEdges& edges);

/// The edges without the shorter side of a jump: its samples are invalid, and its end is unset.
[[nodiscard]] FaceEdges longer_side(FaceEdges edges, const OutlineJump& jump);

}  // namespace alltact
