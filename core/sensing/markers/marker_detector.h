// Finds dots on the side faces.
#pragma once

#include "core/sensing/face/face_pixels.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Finds dots on the side faces (outside the face's edges) by multi-scale blob response, sub-pixel
/// by the centroid above the local background. Stateless.
class MarkerDetector : public DotFinder {
 public:
  explicit MarkerDetector(MarkerRows rows) : rows_(rows) {}

  /// With Polarity::kAuto the polarity with the more even rows is used and reported.
  [[nodiscard]] FoundDots operator()(const cv::Mat& grey, const FaceShape& shape) const override;

 private:
  MarkerRows rows_;
};

// Selects the row of markers among many dots: those with even steps and similar appearance.

/// A row of dots from base to tip, as indices into the dots that it was chosen from.
struct DotRow {
  std::vector<int> dots;
  double unevenness = 0;  ///< mean change of step, size and contrast over the row; 0: perfect
};

/// A row above this unevenness is rejected: an omitted dot or a false one costs more.
inline constexpr double kMaxUnevenness = 0.25;

/// Computes the position of each dot on the finger (along_mm, face_px, off_face). The side faces
/// are modelled as extending from the face's edges normal to the face, at constant y. So a dot's
/// ray meets its side face in one point, whose foot on the face is the nearest point.
void locate_on_finger(std::vector<Dot>& dots, const FaceShape& shape, const SideEdges& edges);

/// The most even choice of `per_row` dots of one side, judged in mm along the finger and not in
/// pixels. In the order of u from base to tip, by dynamic programming over pairs of neighbours.
/// nullopt where there are fewer dots.
[[nodiscard]] std::optional<DotRow> choose_row(const std::vector<Dot>& dots, bool upper,
                                               int per_row, bool base_at_low_u);

/// The dots of both rows in the order of the markers' numbers; nullopt where a row is not even.
[[nodiscard]] std::optional<std::vector<Dot>> two_rows(const std::vector<Dot>& dots, int per_row,
                                                       bool base_at_low_u);

}  // namespace alltact
