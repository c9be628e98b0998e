// Forces on the finger from the positions of its markers.
//
// BACKGROUND
// A force bends the finger, which moves its markers. calibration/force learns the relation from
// rows of a table: marker positions, position of the contact, and the simultaneous force of a
// gauge. A frame is described by
//   z = (principal components of the markers' displacements from rest, flags of seen markers,
//        position of the contact, creep of the markers)
// and its force is the mean of several members, each trained without one block of the table:
//   mean        F = b
//   ridge       F = W z + b
//   quadratic   F = W (z, products of the first components and the position) + b
//   network     F = W3 relu(W2 relu(W1 z + b1) + b2) + b3
// UNCERTAINTY
// s(z)^2 = floor^2 + variance of the members at z. The half width of an interval is s(z) times a
// quantile of |error| / s over blocks that the member had not seen: split-conformal prediction with
// a normalised score (Lei, G'Sell, Rinaldo, Tibshirani, Wasserman, "Distribution-free predictive
// inference for regression", JASA 2018), over folds as cross-conformal prediction (Vovk, Annals of
// Mathematics and AI 2015; Barber, Candes, Ramdas, Tibshirani, "Predictive inference with the
// jackknife+", Annals of Statistics 2021). It holds for blocks like those of the table, not for
// frames out of range.
// RANGE
// Hotelling's T^2 within the principal components and the distance to them (Q), both against the
// maximum of the table, the standard method for principal components (Jackson and Mudholkar,
// Technometrics 1979).
#pragma once

#include "core/base/result.h"
#include "core/finger/finger.h"

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// The force on the finger in one frame, in the axes of the training table (for simulated fingers
/// the camera frame).
struct Force {
  int axes = 0;  ///< 2: Fx, Fy; 3: Fz too. Other axes are 0.
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d sd_N = Eigen::Vector3d::Zero();       ///< expected standard deviation
  Eigen::Vector3d half_90_N = Eigen::Vector3d::Zero();  ///< 90 % lie within force_N +- this
  Eigen::Vector3d half_95_N = Eigen::Vector3d::Zero();
  /// True when the frame is like those of the table. Else force and intervals are unreliable.
  bool in_range = false;
};

/// Input of a force measurement.
struct ForceInput {
  Eigen::VectorXd displacement_px;  ///< (du0, dv0, du1, ...) from rest; ignored where not seen
  Eigen::VectorXd seen;             ///< 1 or 0 for each marker
  std::optional<Eigen::Vector2d> position_mm;  ///< of the contact, along the face and across it
  /// displacement_px minus its running mean over the model's creep time; empty: unknown.
  Eigen::VectorXd crept_px;
};

enum class ForceKind { kMean = 1, kRidge, kQuadratic, kNetwork };
inline constexpr std::array<std::string_view, 4> kForceKinds{"mean", "ridge", "quadratic",
                                                             "network"};
[[nodiscard]] inline std::string to_string(ForceKind kind) {
  return std::string(kForceKinds.at(static_cast<std::size_t>(kind) - 1));
}

/// Statistics of the displacements in the table. Estimates unseen markers from the seen ones, and
/// detects frames out of range.
struct ForceRange {
  Eigen::VectorXd mean_px;                 ///< 2m
  Eigen::MatrixXd components;              ///< 2m x k, orthonormal
  Eigen::VectorXd component_sd_px;         ///< k, above 0
  double noise_px = 0;                     ///< residual sd of a coordinate outside the components,
                                           ///< above 0
  double max_t2 = 0, max_residual_px = 0;  ///< maxima of the table
  int min_seen = 0;                        ///< minimum number of seen markers
  /// Minimum and maximum of the contact's position; absent where the table has none.
  std::optional<std::array<Eigen::Vector2d, 2>> position_mm;
  bool has_all_positions = false;  ///< the table has it for every frame

  [[nodiscard]] Eigen::VectorXd scores(const ForceInput& input) const;
  void fill(ForceInput& input) const;
  /// Hotelling's T^2, and the root mean square distance of the seen coordinates to the components.
  struct RangeDeviation {
    double t2 = 0, residual_px = 0;
  };
  [[nodiscard]] RangeDeviation deviation(const ForceInput& filled) const;
  [[nodiscard]] bool holds(const ForceInput& filled) const;
};

/// Converts a frame to the feature vector z.
struct ForceBasis {
  Eigen::VectorXd mean_px, scale;  ///< 2m; scale is 1 / sd, 0 for a constant column
  Eigen::MatrixXd components;      ///< 2m x p
  Eigen::VectorXd gain;            ///< p: z = gain * component
  /// Markers whose flags follow the components. Then follow position along and across, a flag for a
  /// known position, and creep of the first components.
  std::vector<int> flags;
  bool has_position = false;
  int crept = 0;
  Eigen::VectorXd extra_mean, extra_scale;  ///< of flags, 3 where has_position, and crept
  int squared = 0;  ///< number of first components in products, with has_position together with its
                    ///< three numbers

  [[nodiscard]] int extras() const {
    return static_cast<int>(flags.size()) + (has_position ? 3 : 0) + crept;
  }
  [[nodiscard]] int plain_size() const { return static_cast<int>(gain.size()) + extras(); }
  [[nodiscard]] int size() const;
  /// Flags, position and creep without scaling.
  [[nodiscard]] Eigen::VectorXd raw_extras(const ForceInput& filled) const;
  [[nodiscard]] Eigen::VectorXd operator()(const ForceInput& filled) const;
};

struct ForceLayer {
  Eigen::MatrixXd weights;
  Eigen::VectorXd bias;
};
/// One layer, or three with max(0, .) behind the first two.
using ForceRegressor = std::vector<ForceLayer>;
[[nodiscard]] Eigen::VectorXd force_of(const ForceRegressor& regressor, const Eigen::VectorXd& z);

/// Trained without one block of the table. Returns N: the mean of its regressors.
struct ForceMember {
  ForceBasis basis;
  std::vector<ForceRegressor> regressors;
  [[nodiscard]] Eigen::VectorXd operator()(const ForceInput& filled) const;
};

/// Scale of errors relative to s(z), by axis.
struct ForceScores {
  Eigen::VectorXd floor_N;  ///< above 0
  Eigen::VectorXd rms, quantile_90, quantile_95;
};

struct ForceModel {
  static constexpr const char* kFormat = "alltact-force/1";

  ForceKind kind = ForceKind::kMean;
  int axes = 2;
  int marker_count = 0;
  std::vector<int> missing;              ///< MarkerRows::missing of its finger
  std::vector<Eigen::Vector2d> rest_px;  ///< origin of the displacements
  double creep_s = 0;                    ///< time of the running mean; 0: creep is no input
  ForceRange range;
  std::vector<ForceMember> members;
  ForceScores scores;
  /// For people: table, split, errors, label noise, date.
  std::map<std::string, std::string> record;

  /// The file's content. It ends with its last brace, so that a truncated file is no model.
  [[nodiscard]] std::string to_json() const;
  /// Errors: no such model; inconsistent shapes or impossible numbers; each with its key.
  static Result<ForceModel> parse(std::string_view json, const std::filesystem::path& origin);
  static Result<ForceModel> load(const std::filesystem::path& file);
  /// The checks of parse(). The error's `where` is the key.
  [[nodiscard]] Status validate() const;

  /// Error: trained with other markers than this finger's, with a remedy.
  [[nodiscard]] Status belongs_to(const Finger& finger) const;

  /// nullopt: another number of markers, or a seen one is not finite. Never NaN.
  [[nodiscard]] std::optional<Force> operator()(ForceInput input) const;
};

}  // namespace alltact
