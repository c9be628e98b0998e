// Forces on the finger from where its markers are.
//
// BACKGROUND
// A force bends the finger, which moves its markers. Rows of a table (marker positions, place of
// the contact, force of a gauge beside) teach how much; calibration/force does that. A frame is
// described by
//   z = (principal components of the markers' displacements from rest, which markers were seen,
//        place of the contact, what the markers crept)
// and its force is the mean of several members, each learnt without one block of the table:
//   mean        F = b
//   ridge       F = W z + b
//   quadratic   F = W (z, products of the first components and the place) + b
//   network     F = W3 relu(W2 relu(W1 z + b1) + b2) + b3
// UNCERTAINTY
// s(z)^2 = floor^2 + variance of the members at z. The half width of an interval is s(z) times a
// quantile of |error| / s over blocks that the member had not seen: split-conformal prediction with
// a normalised score (Lei, G'Sell, Rinaldo, Tibshirani, Wasserman, "Distribution-free predictive
// inference for regression", JASA 2018), over folds as cross-conformal prediction (Vovk, Annals of
// Mathematics and AI 2015; Barber, Candes, Ramdas, Tibshirani, "Predictive inference with the
// jackknife+", Annals of Statistics 2021). It holds for blocks like those of the table and says
// nothing of frames out of range.
// RANGE
// Hotelling's T^2 within the principal components and the distance to them (Q), both against the
// greatest of the table, as is usual for principal components (Jackson and Mudholkar, Technometrics
// 1979).
#pragma once

#include "core/finger/finger.h"
#include "core/result.h"

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

/// The force on the finger in one frame, in the axes of the table that the model was trained with
/// (the camera frame where that was one of simulated fingers).
struct Force {
  int axes = 0;  ///< 2: Fx, Fy; 3: Fz too. What lies beyond is 0.
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d sd_N = Eigen::Vector3d::Zero();       ///< standard deviation to be expected
  Eigen::Vector3d half_90_N = Eigen::Vector3d::Zero();  ///< 90 % lie within force_N +- this
  Eigen::Vector3d half_95_N = Eigen::Vector3d::Zero();
  /// The frame is like those of the table. Else neither force nor intervals can be relied on.
  bool in_range = false;
};

/// What a force is measured from.
struct ForceInput {
  Eigen::VectorXd
      displacement_px;   ///< (du0, dv0, du1, ...) from rest; where not seen of no account
  Eigen::VectorXd seen;  ///< 1 or 0 of each marker
  std::optional<Eigen::Vector2d> place_mm;  ///< of the contact, along the face and across it
  /// displacement_px less its running mean over the model's creep time; empty: not known.
  Eigen::VectorXd crept_px;
};

enum class ForceKind { kMean = 1, kRidge, kQuadratic, kNetwork };
inline constexpr std::array<std::string_view, 4> kForceKinds{
    "mean", "ridge", "quadratic", "network"};
[[nodiscard]] inline std::string to_string(ForceKind kind) {
  return std::string(kForceKinds.at(static_cast<std::size_t>(kind) - 1));
}

/// Columns of a frame's displacements, and what is known of them all. Fills in markers that are not
/// seen with what is likeliest given those that are, and says how unusual a frame is.
struct ForceRange {
  Eigen::VectorXd mean_px;                 ///< 2m
  Eigen::MatrixXd components;              ///< 2m x k, orthonormal
  Eigen::VectorXd component_sd_px;         ///< k, above 0
  double noise_px = 0;                     ///< sd of a coordinate beside the components, above 0
  double most_t2 = 0, most_beside_px = 0;  ///< greatest of the table
  int least_seen = 0;                      ///< markers
  /// Least and most of the contact's place; absent where the table told none.
  std::optional<std::array<Eigen::Vector2d, 2>> place_mm;
  bool always_placed = false;  ///< the table told it of every frame

  [[nodiscard]] Eigen::VectorXd scores(const ForceInput& input) const;
  void fill(ForceInput& input) const;
  /// Hotelling's T^2 and the root mean square distance of the seen coordinates to the components.
  struct Unusual {
    double t2 = 0, beside_px = 0;
  };
  [[nodiscard]] Unusual unusual(const ForceInput& filled) const;
  [[nodiscard]] bool holds(const ForceInput& filled) const;
};

/// From a frame to z.
struct ForceBasis {
  Eigen::VectorXd mean_px, scale;  ///< 2m; scale is 1 / sd, 0 of a column that does not change
  Eigen::MatrixXd components;      ///< 2m x p
  Eigen::VectorXd gain;            ///< p: z = gain * component
  /// Behind the components: which flags, place along and across, place known, creep of the first
  /// components.
  std::vector<int> flags;
  bool has_place = false;
  int crept = 0;
  Eigen::VectorXd extra_mean, extra_scale;  ///< of flags, 3 where has_place, and crept
  int squared = 0;  ///< products of so many first components and, with has_place, its three numbers

  [[nodiscard]] int extras() const {
    return static_cast<int>(flags.size()) + (has_place ? 3 : 0) + crept;
  }
  [[nodiscard]] int plain_size() const { return static_cast<int>(gain.size()) + extras(); }
  [[nodiscard]] int size() const;
  /// Flags, place and creep as they are.
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

/// Learnt without one block of the table. N: the mean of its regressors.
struct ForceMember {
  ForceBasis basis;
  std::vector<ForceRegressor> regressors;
  [[nodiscard]] Eigen::VectorXd operator()(const ForceInput& filled) const;
};

/// How large errors are against s(z), by axis.
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
  std::vector<Eigen::Vector2d> rest_px;  ///< from where displacements count
  double creep_s = 0;                    ///< time of the running mean; 0: creep is no input
  ForceRange range;
  std::vector<ForceMember> members;
  ForceScores scores;
  /// For people: table, split, errors, label noise, date.
  std::map<std::string, std::string> record;

  /// The file's content. Ends with its last brace: a part of it is no model.
  [[nodiscard]] std::string to_json() const;
  /// Errors: no such model; shapes that do not fit each other, impossible numbers; each says where.
  static Result<ForceModel> parse(std::string_view json, const std::filesystem::path& origin);
  static Result<ForceModel> load(const std::filesystem::path& file);
  /// What parse() checks. The error's `where` is the key.
  [[nodiscard]] Status validate() const;

  /// Error: trained with other markers than this finger's, with what to do.
  [[nodiscard]] Status belongs_to(const Finger& finger) const;

  /// nullopt: other markers, or a seen one lies nowhere. Never NaN.
  [[nodiscard]] std::optional<Force> operator()(ForceInput input) const;
};

}  // namespace alltact
