// Standard deviation of every pixel's depth, by cause.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/reference/reference_image.h"

#include <cstdint>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Standard deviations of one pixel's depth, mm along z, by independent causes.
struct DepthErrorTerms {
  /// Noise of the image and of its reference: f M'(x) sd / I_ref sqrt(1 + (1 - x)^2 gain^2).
  double noise = 0;
  /// Uncertainty of the calibration: Mapping::depth_sd_mm at the position, and that of the
  /// scattering of light (light_spread.h).
  double mapping = 0;
  /// Error of this recording's references here (reference_image.h), from the pose, imperfect skin
  /// registration and blemishes: f M'(x) (1 - x) sd_ref / I_ref. sd_ref comprises that of this
  /// frame's registration (Reference::registration_sd_px) times the slope of I_ref.
  double reference = 0;
  double light = 0;  ///< uncertainty of the light's change: f M'(x) (1 - x) sd(q) / q
  /// Where depth changes fast: a lateral offset of a quarter of a pixel, and the bias of smoothing.
  double lateral = 0;
  /// Not an error of its own: the depth difference between adjacent pixels, mm. 0: within noise.
  double per_px = 0;

  [[nodiscard]] double total() const;
};

/// Errors of a pixel without contact, mm: noise averages out over a region, the systematic part
/// (reference and light) does not.
struct UntouchedSd {
  double noise = 0, systematic = 0;
};

/// Error model of one frame. Its inputs must outlive it.
class DepthErrorModel {
 public:
  DepthErrorModel(const DepthMap& depth, const Reference& reference, const FaceShape& shape,
                  const Mapping& mapping);

  /// Calls put(u, causes) for each pixel of row v that has a depth.
  template <class Put>
  void row(int v, Put put);

  /// Errors of the depth at a pixel without contact.
  [[nodiscard]] UntouchedSd untouched(int u, int v);

  /// Errors of a given depth at a pixel; `lateral` is that of the depths around it.
  [[nodiscard]] DepthErrorTerms of_depth(int u, int v, double depth_mm);

 private:
  struct At {
    double x, slope_mm;
  };
  void build_curve();
  [[nodiscard]] At table_curve_at(double depth_mm) const;
  [[nodiscard]] At solved_curve_at(double depth_mm) const;
  /// Grey level of the reference at a pixel, and its relative change from column to column.
  struct Level {
    double here, per_px;
  };
  [[nodiscard]] Level level_from(const std::int16_t* row, int u) const;
  [[nodiscard]] double reference_sd(int u, int v, const Level& level);
  void add_lateral(int u, int v, DepthErrorTerms& causes) const;
  [[nodiscard]] Level level_at(int u, int v);
  /// Errors after the removal of spread light over before.
  struct SpreadGain {
    double noise = 1, level = 1;
  };
  [[nodiscard]] SpreadGain spread_gain(int u) const;
  [[nodiscard]] double spread_sd(int u, int v) const;  ///< of x, see SpreadRemoved
  using ReadCurve = At (DepthErrorModel::*)(double depth_mm) const;
  [[nodiscard]] DepthErrorTerms causes(int u, int v, const Level& level, double depth_mm,
                                       ReadCurve read);

  const DepthMap& depth_;
  const Reference& reference_;
  const FaceShape& shape_;
  const Mapping& mapping_;
  ReferenceImage::Reader reader_;
  std::vector<float> along_z_;
  double step_mm_;
  std::vector<double> x_, slope_mm_;  // of the mapping, by depth
};

/// All causes combined: CV_32FC1, mm along z, NaN where there is no depth. As expensive as the
/// depth itself, so not computed for every live frame.
[[nodiscard]] cv::Mat depth_sd_mm(const DepthMap& depth, const Reference& reference,
                                  const FaceShape& shape, const Mapping& mapping);

/// Each cause separately, named as in DepthErrorTerms.
struct NamedSdMap {
  const char* name;
  cv::Mat sd_mm;
};
[[nodiscard]] std::vector<NamedSdMap> depth_sd_by_cause(const DepthMap& depth,
                                                        const Reference& reference,
                                                        const FaceShape& shape,
                                                        const Mapping& mapping);

template <class Put>
void DepthErrorModel::row(int v, Put put) {
  build_curve();
  const FaceRun full_row{v, 0, depth_.depth_mm.cols, 0};
  const std::int16_t* grey = reader_.row(v, {&full_row, 1});
  const float* depth = depth_.depth_mm.ptr<float>(v);
  for (int u = 0; u < depth_.depth_mm.cols; ++u)
    if (depth[u] == depth[u] && grey[u] > 0) {
      DepthErrorTerms all = causes(u, v, level_from(grey, u), static_cast<double>(depth[u]),
                                   &DepthErrorModel::table_curve_at);
      add_lateral(u, v, all);
      put(u, all);
    }
}

// What limits the depth of a pixel or a region.

/// Bits of one byte.
enum DepthLimit : std::uint8_t {
  kNoLimit = 0,
  kLayerLimit = 1,  ///< as deep as the layer is thick: the depth is a lower bound
  kBulgeTop = 2,    ///< bulges by the layer's thickness: minus that is an upper bound of the depth
  kOutOfRange = 4,  ///< deeper than calibrated: extrapolated with the end slope
  kSteep = 8,       ///< the depth changes by more than its sd over one pixel
  kDoubtfulLight = 16  ///< is_light_doubtful(), or light is above 0.02 mm and half of the variance
};
inline constexpr std::uint8_t kDepthClamped = kLayerLimit | kBulgeTop;

/// In files: "layer_limit", "bulge_limit", "out_of_range", "steep", "doubtful_light".
[[nodiscard]] std::vector<std::string_view> limit_names(std::uint8_t limits);

/// kLayerLimit, kBulgeTop or kOutOfRange, from the pixel's flag (PixelFlag).
[[nodiscard]] std::uint8_t limit_of_flag(std::uint8_t flag);

/// True where too little of the face shows the requested light correction. Also true where the
/// light differs from that of the recording by more than kMaxLightChange.
inline constexpr double kMaxLightChange = 0.06;
[[nodiscard]] bool is_light_doubtful(const DepthMap& depth);

/// kSteep and kDoubtfulLight of one depth; `is_doubtful` applies to the full frame.
[[nodiscard]] std::uint8_t limits_of(const DepthErrorTerms& causes, bool is_doubtful);

/// Standard deviation (depth_sd_mm) and limits of every pixel in one pass: CV_32FC1, mm, and
/// CV_8UC1 of DepthLimit bits, 0 where there is no depth.
struct DepthSdAndLimits {
  cv::Mat sd_mm, limits;
};
[[nodiscard]] DepthSdAndLimits depth_sd_and_limits(const DepthMap& depth,
                                                   const Reference& reference,
                                                   const FaceShape& shape, const Mapping& mapping);

}  // namespace alltact
