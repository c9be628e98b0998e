// The source paper's reconstruction of the untouched face from a grey image. It binarises and takes
// the border of the bright part for the two edges of the face. Then z = fy W / (v2 - v1) in every
// column, one polynomial along the finger, straight lines across it.
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/result.h"
#include "core/sensing/face/face_shape.h"

#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Edges of the view face by column, at integer pixels and a half (between the last dark and the
/// first bright pixel). NaN where the column does not show both: no bright pixel, or one at the
/// border of the image.
struct PaperEdges {
  std::vector<double> upper_v, lower_v;
  int seen = 0;  ///< columns that show both edges
};

/// Binarises strips of 32 columns, each by Otsu's threshold, and takes the largest connected bright
/// part for the face. The light falls by ten times from base to tip, so that one threshold would
/// cut off the tip.
[[nodiscard]] PaperEdges paper_edges(const cv::Mat& grey);

/// The face as a profile z = P(x) in the plane of the finger, P of degree 5, and a middle line.
class PaperFace {
 public:
  /// Errors: both edges are seen in fewer than a fifth of the columns; no z is finite and positive;
  /// an orthographic camera.
  [[nodiscard]] static Result<PaperFace> fit(const PaperEdges& edges,
                                             const Camera& camera,
                                             const Face& face);

  /// z of the profile by column, mm; NaN where the column does not show both edges.
  [[nodiscard]] const std::vector<double>& z_mm() const { return z_mm_; }

  /// The same face as a FaceShape: within 0.01 mm of z_mm() on its columns.
  [[nodiscard]] Result<FaceShape> shape(const Camera& camera, const Face& face) const;

 private:
  std::vector<double> z_mm_, middle_y_;  // by column; middle: y / z of the line between the edges
};

}  // namespace alltact
