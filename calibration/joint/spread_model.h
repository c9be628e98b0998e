// Brightness around balls as a layer with spread light, or with local light, would show it.
//
// Ball and skin are round, so all is a function of the distance from the contact's axis, and the
// skirt of scattered light one tridiagonal system.
#pragma once

#include "calibration/joint/skin_profile.h"
#include "calibration/presses/press.h"
#include "core/finger/finger.h"
#include "core/finger/mapping.h"

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A block of pixels near a ball.
struct SpreadSample {
  Eigen::Vector2d position_mm;  // on the face
  Eigen::Vector2d sight_mm;     // SightInLayer::displacement_mm
  Eigen::Vector2d z_mm;         // from the foot of the normal to the outer side along z
  double cos_sight = 1;
  double x = 0;   // brightness difference
  double sd = 1;  // its noise, and what the formulas of light_spread.h leave
};

/// Unknowns of one press: where it is on the face, mm, log of its depth along the normal, and the
/// error of the light that its reference assumes, over SpreadPress::light_sd.
enum Own { kAlong, kAcross, kLogDepth, kLight, kOwnCount };
using OwnUnknowns = Eigen::Matrix<double, kOwnCount, 1>;

/// A press and the face around it.
struct SpreadPress {
  std::vector<SpreadSample> samples;
  double radius_mm = 0;
  double curvature_per_mm = 0;  // RoundContact
  double reach_mm = 0;          // of radial profiles
  double blur_px2 = 0;          // variance in the image, by a sharp lens and by samples
  double mm2_per_px2 = 0;       // the same on the face
  /// Samples that count as independent: what the formulas leave varies over the layer's thickness.
  double observations = 1;
  double light_sd = 0;  // of brightness: error of the light that the reference assumes
  std::optional<GivenDepth> given_depth;
  OwnUnknowns start;

  [[nodiscard]] const SpreadSample& nearest_to(const Eigen::Vector2d& position_mm) const;
};

/// nullopt: the ball is off the face, or hardly any of its surroundings is visible.
[[nodiscard]] std::optional<SpreadPress> spread_press(const Press& press, const Face& face,
                                                      const Eigen::Vector3d& centre_mm);

/// Where the light of a pixel comes from: local light from the skin along the normal, along z or
/// along the line of sight, or from as deep a skin where these lines meet the untouched outer side.
enum class SeenAt { kNormal, kZ, kSight, kOuterZ, kOuterSight, kSpread };
struct Hypothesis {
  SeenAt seen;
  Bed bed;
};

/// Unknowns that all presses share, scaled to about 1: the curve (light_spread.h), the skin's form
/// (skin_profile.h), and for spread light only the layer's optical thickness and the factors of the
/// skirt's width and of the lens's variance.
enum Shared {
  kLogRho,
  kLogB,
  kLogBAlong,
  kLogReturn,  // lift-off length of a membrane, or length of a half space's fading
  kLiftPower,
  kRise,
  kRisePower = kRise + 3,
  kLogOpticalThickness,
  kLogWidth,
  kLogBlur,
  kSharedCount
};
struct FitState {
  Eigen::VectorXd shared = Eigen::VectorXd::Zero(kSharedCount);
  std::vector<OwnUnknowns> own;  // by press
};

/// The scale of depth by a body of known shape, linear in what all presses share.
struct ScaleEvidence {
  double scale = 1, sd = 0;  ///< at `shared`
  Eigen::VectorXd shared, by_shared;
};

struct UnknownPrior {
  double mean, sd;
};
[[nodiscard]] UnknownPrior prior_of(int shared, Hypothesis hypothesis);

/// Prior of the logarithm of an unknown of the curve, by light_spread.h, with the derivatives by
/// that of the optical thickness.
struct CurvePrior {
  double mean, mean_by_log, sd, sd_by_log;
};
[[nodiscard]] CurvePrior rho_prior(double optical_thickness);
[[nodiscard]] CurvePrior b_prior(double optical_thickness);

class SpreadModel {
 public:
  SpreadModel(std::vector<SpreadPress> presses, double layer_mm);

  /// How many of Shared a hypothesis has.
  [[nodiscard]] static int count_of(Hypothesis hypothesis) {
    return hypothesis.seen == SeenAt::kSpread ? kSharedCount : kLogOpticalThickness;
  }
  [[nodiscard]] const std::vector<SpreadPress>& presses() const { return presses_; }
  [[nodiscard]] double layer_mm() const { return layer_mm_; }
  /// Bodies that the mapping shall reproduce.
  [[nodiscard]] const std::vector<ScaleEvidence>& scales() const { return scales_; }
  void set_scales(std::vector<ScaleEvidence> scales) { scales_ = std::move(scales); }
  [[nodiscard]] LightSpread spread_by(const Eigen::VectorXd& shared) const;
  /// From the positions found by brightness, and the priors' means.
  [[nodiscard]] FitState start() const;

  /// Brightness differences that the press at `index` should show.
  void predict(std::size_t index, Hypothesis hypothesis, const Eigen::VectorXd& shared,
               const OwnUnknowns& own, Eigen::VectorXd* x) const;

 private:
  std::vector<SpreadPress> presses_;
  std::vector<ScaleEvidence> scales_;
  double layer_mm_, middle_mm_ = 0, half_mm_ = 1;
};

}  // namespace alltact
