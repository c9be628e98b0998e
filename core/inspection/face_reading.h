// Readings of a measured face between two positions on it: distance, radius, area, volume, depth,
// roughness, step, angle and section, each with its standard deviation.
#pragma once

#include "core/base/message.h"
#include "core/sensing/surface_measurement.h"

#include <optional>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Position on the face, mm: along it from its base and across it from its middle
/// (FaceShape::position_mm). It moves with the finger.
struct FacePosition {
  double along_mm = 0, across_mm = 0;
  bool operator==(const FacePosition&) const = default;
};

/// What is read between the positions A and B. The box has A and B as its corners.
enum class Measurand {
  kDistance = 1,  ///< straight, from A to B
  kRadius,        ///< of the ball whose cap is the deepest part of the box
  kArea,          ///< deeper than kLeastDepthMm, within the box
  kVolume,        ///< displaced there
  kMeanDepth,     ///< there
  kRoughness,     ///< root mean square height within the box, by a RoughnessFilter
  kStep,          ///< on the line from A to B
  kAngle,         ///< between the surfaces kAroundPx around A and B
  // Of the section along the line from A to B (LineSection).
  kSectionDepth,
  kSectionWidth,
  kSectionArea,
};
inline constexpr double kLeastDepthMm = 0.05;  ///< smaller depths may be noise
inline constexpr int kAroundPx = 6;

/// In files: "distance", "radius", "area", "volume", "mean_depth", "roughness", "step", "angle",
/// "section_depth", "section_width", "section_area".
[[nodiscard]] std::string_view to_string(Measurand measurand);
/// In files: "mm", "mm2", "mm3", "deg".
[[nodiscard]] std::string_view unit_of(Measurand measurand);
/// All of them, in their order.
[[nodiscard]] const std::vector<Measurand>& all_measurands();

struct FaceReading {
  std::optional<MeasuredValue> measured;
  Message reason;               ///< where it is empty
  bool is_lower_bound = false;  ///< a part is at the layer's limit: the value is at least that
};

/// A frame with depth, by a calibrated finger. What it refers to must outlive it.
struct MeasuredFace {
  const FrameResult& result;
  const Face& face;
  const Mapping& mapping;
  double smoothing_px = 0;  ///< applied before the mapping
  const cv::Mat& sd_mm;     ///< of the depth, as depth_sd_mm() returns it
};

/// Of a line over the face, where it is deeper than kLeastDepthMm.
struct LineSection {
  MeasuredValue depth_mm;  ///< the greatest, along z; of many noisy ones it is above the truth
  Result<MeasuredValue> width_mm;  ///< along the face, between both sides at half of that depth
  MeasuredValue area_mm2;          ///< below the untouched skin
  bool is_lower_bound = false;     ///< depth and area: a point is at a limit
};
/// Errors: no point is deeper. Of the width: the line ends before half of the depth; a point is at
/// a limit.
[[nodiscard]] Result<LineSection> section_of(const SurfaceLine& line);

/// Reads what lies between two pixels; the patch of the box is extracted once, where it is needed.
class FaceReader {
 public:
  FaceReader(const MeasuredFace& face, cv::Point2d a, cv::Point2d b,
             const RoughnessFilter& filter = {});
  [[nodiscard]] FaceReading operator()(Measurand measurand);

 private:
  [[nodiscard]] const SurfacePatch& box();
  [[nodiscard]] SurfacePatch patch(const cv::Rect& box) const;
  [[nodiscard]] FaceReading angle() const;
  [[nodiscard]] FaceReading step() const;
  [[nodiscard]] SurfaceLine line() const;
  [[nodiscard]] FaceReading section(Measurand measurand) const;

  MeasuredFace face_;
  cv::Point2d a_, b_;
  RoughnessFilter filter_;
  std::optional<SurfacePatch> box_;
};

/// The pixel of a position on the face. A position computed from a pixel gives that pixel again.
/// nullopt: the frame does not show it, or shows no face.
[[nodiscard]] std::optional<cv::Point2d> pixel_of(const FrameResult& result,
                                                  const FacePosition& position);

/// The pixel with the nearest centre.
[[nodiscard]] cv::Point2d nearest_pixel(cv::Point2d pixel);

}  // namespace alltact
