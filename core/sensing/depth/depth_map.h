// Depth of each pixel from its brightness against the reference.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/depth/light_gain.h"
#include "core/sensing/depth/smoothing.h"
#include "core/sensing/face/face_pixels.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/reference/face_chart.h"
#include "core/sensing/reference/reference_image.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

// Reasons why the depth of a pixel is missing or doubtful.

/// Why a pixel has no depth, or a doubtful one. 0: measured.
enum PixelFlag : std::uint8_t {
  kMeasured = 0,
  kOffFace = 1,       ///< no face here: NaN
  kTooDark = 2,       ///< the reference is too dark to divide by (grey_range.h): NaN
  kSaturated = 3,     ///< live or reference image is clipped (grey_range.h): NaN
  kExtrapolated = 4,  ///< darker than anything calibrated: extrapolated with the end slope
  kBeyondLayer = 5,   ///< deeper than the layer is thick: set to the thickness
  kNoReference = 6,   ///< the recording does not show this part of the face in this pose: NaN
  kHiddenEnd = 7,     ///< the face continues here, but something hides its end: NaN
  kBulgeLimit = 8,    ///< bulges by more than the layer is thick: set to minus the thickness
};
constexpr std::size_t kPixelFlagCount = 9;  ///< number of flags

/// Whether the depth is only a lower bound (kBeyondLayer) or an upper bound (kBulgeLimit).
[[nodiscard]] constexpr bool is_at_limit(std::uint8_t flag) {
  return flag == kBeyondLayer || flag == kBulgeLimit;
}

/// Fractions of the face by flag, over the pixels that are not kOffFace, from one in `every_row`
/// rows. All 0 where there is no face.
struct FlagFractions {
  std::array<double, kPixelFlagCount> of;  ///< by PixelFlag
};
[[nodiscard]] FlagFractions flag_fractions(const cv::Mat& flags, int every_row = 1);

/// Sets kHiddenEnd in these columns where the flag is kOffFace. flags: CV_8UC1 of PixelFlag.
void flag_hidden(const std::vector<HiddenColumn>& columns, cv::Mat* flags);

/// What the removal of the spread of light did to a frame (light_spread.h). Empty: nothing.
struct SpreadRemoved {
  cv::Mat sd;       ///< CV_32FC1: of x after it, by the uncertain scattering
  cv::Mat lost_mm;  ///< CV_32FC1: sd of the depth along the normal by detail too fine to be seen
  std::vector<float> noise_gain;  ///< by column: noise of a pixel after over before
  std::vector<float> level_gain;  ///< by column: the same for errors that are wider than the skirt
  [[nodiscard]] bool is_none() const { return sd.empty(); }
};

/// x = (I_ref - q I) / I_ref after smoothing, with q the requested correction of the light.
/// CV_32FC1, NaN where there is no measurement; `flags` hold the reason.
struct Difference {
  cv::Mat x;
  cv::Mat flags;  ///< CV_8UC1 of PixelFlag
  FaceRuns face;  ///< every pixel outside is kOffFace
  /// Noise of both images after smoothing, grey levels. sd(x) of a contact-free pixel is grey_sd /
  /// I_ref.
  double grey_sd = 0;
  double blur_px2 = 0;  ///< variance of the blur of x, see Smoothing
  LightGain light;      ///< change of the light, if requested
  SpreadRemoved spread_removed;
};

struct DepthMap {
  cv::Mat depth_mm;  ///< CV_32FC1 along z, < 0 where skin bulges, NaN where flags require it
  cv::Mat flags;     ///< CV_8UC1 of PixelFlag
  cv::Mat cells_mm;  ///< CV_32FC1: mean depth over each cell
  /// Standard deviation of a pixel's depth at light pressure, at the face's mean brightness.
  double noise_mm = 0;
  double live_sd = 0;             ///< noise of the image alone after smoothing, grey levels
  LightGain light;                ///< change of the light, if requested
  bool is_light_unknown = false;  ///< it was requested, but too little of the face shows it
  SpreadRemoved spread_removed = {};
};

struct DifferenceOptions {
  Smoothing smoothing = smoothing_of(1.0);
  double edge_margin_px = 1.0;           ///< pixels this near the face's edges are off the face
  cv::Range columns = cv::Range::all();  ///< all others are off the face
  /// Noise of the image, grey levels. It weights pixels for the light, sets the level below which
  /// the reference is too dark, and determines standard deviations unless measured.
  double noise_sd = 1.0;
  /// Computes standard deviations, and nothing else, from the noise against the reference.
  /// Falls back to noise_sd where too few pixels qualify.
  bool measure_noise = false;
  bool correct_light = false;  ///< correct for the change of the light (light_gain.h)
};

/// Compares an image with its reference on the face.
[[nodiscard]] Difference difference(const cv::Mat& grey, const Reference& reference,
                                    const FaceShape& shape, const DifferenceOptions& options);

/// Applies the mapping, after the spread of light is removed if the mapping has one and
/// `difference` still contains it: depth < 0 where x < 0 (bulge), with flags beyond the calibrated
/// domain. The layer's thickness limits depths of both signs (along z: layer / cos(incline),
/// incline at most 75 degrees). Noise of contact-free skin has both signs, so means of depth are
/// unbiased. Depths of a mapping along the normal are converted to depths along z.
[[nodiscard]] DepthMap depth_map(const Difference& difference, const Mapping& mapping,
                                 const FaceShape& shape);

/// Both in one pass, without storing the differences unless light spreads: the same bytes at half
/// the memory traffic.
[[nodiscard]] DepthMap depth_map(const cv::Mat& grey, const Reference& reference,
                                 const FaceShape& shape, const DifferenceOptions& options,
                                 const Mapping& mapping);

// Mean depth over small square cells: contacts show in a sixteenth of the numbers, with less noise
// than in single pixels.

constexpr int kDepthCellPx = 4;  ///< a side

/// Accumulated row by row while the depths are in the processor's cache.
class DepthCells {
 public:
  explicit DepthCells(const cv::Size& image_size);

  /// Rows are added in order, from 0 to the last. `depth_mm`: the full row; only the runs are read,
  /// and NaN counts as 0.
  void add_row(int row, std::span<const FaceRun> runs, const float* depth_mm);
  /// CV_32FC1, mm, one value per cell. Cells that the image border cuts are divided by the full
  /// area.
  [[nodiscard]] const cv::Mat& mean_mm() const { return mean_mm_; }

 private:
  cv::Size image_size_;
  cv::Mat mean_mm_;
  std::vector<float> sum_;  // of a row of cells, by column
};

/// The same from a complete depth map, CV_32FC1.
[[nodiscard]] cv::Mat depth_cells(const cv::Mat& depth_mm);

// Noise of a face's image, estimated from its difference to the reference.

/// Standard deviation of the noise of one image, grey levels. With D = I - I_ref on the face,
///   sd^2 = var(D(u - 1) - 2 D(u) + D(u + 1)) / (6 (1 + noise_gain^2)),
/// from some rows. Light, contacts and their smooth slopes do not affect second differences, and
/// engravings or prints on the skin are in the reference, too. Differences beyond 3 sd (rims, dirt)
/// are ignored, and so are pixels that are clipped or too dark (grey_range.h) in either image. The
/// result is at least that of quantisation, 1/sqrt(12). Noise that neighbouring pixels share after
/// compression is not included: see LightGain::noise_ratio.
/// nullopt: fewer than 100 differences qualify. grey: CV_8UC1 of the reference's size. noise_gain:
/// the reference's noise relative to that of one image, >= 0.
[[nodiscard]] std::optional<double> noise_against_reference(const cv::Mat& grey,
                                                            const ReferenceImage& reference,
                                                            double noise_gain,
                                                            const FaceRuns& face);

// Scales the mapping's output to millimetres along z where these differ by a factor only.

/// Factor of every pixel: the mapping's variation over the face. For a mapping of projected depths
/// also the ratio of the path along z to that along the normal. Made for one frame.
class DepthScale {
 public:
  DepthScale(const MappingParameters& mapping, const FaceShape& shape);

  /// True when the factor is 1 everywhere.
  [[nodiscard]] bool is_one() const { return by_column_.empty(); }
  /// Multiplies the depths of row v from column `first` on; not to be called when is_one().
  void scale(int v, int first, int count, float* depth_mm) const;

 private:
  std::vector<float> by_column_;                          // in the middle of the face
  std::vector<float> across_, middle_v_, across_per_px_;  // empty unless the factor varies across
};

// Converts depth along the layer's normal to depth along z.

/// Where brightness follows the layer's thickness along its normal, a pixel with the view point p
/// sees the pressed face at p + n (layer - d_n). The depth map holds the distance along z between
/// the contact-free and the pressed face on the line through p. Another pixel sees that point, up
/// to a layer's thickness away on an inclined face. For every pixel this finds the pixel that sees
/// its line, by a few fixed-point steps along the finger, and across it where the finger twists.
///
/// depth_normal_mm: CV_32FC1, NaN where not measured. cells_mm: its means, which
/// select the pixels to look up. The result has the size and type of depth_normal_mm and is NaN
/// where that is. Bulges (depth < 0) are converted alike. A converted pixel takes the flag (CV_8UC1
/// of PixelFlag) of the pixel that sees its line.
[[nodiscard]] cv::Mat depth_along_z(const cv::Mat& depth_normal_mm, const cv::Mat& cells_mm,
                                    const FaceShape& shape, cv::Mat& flags);

}  // namespace alltact
