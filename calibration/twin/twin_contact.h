// Layer, roll-off, bulge, blur and the balls of a twin, from pressed images.
#pragma once

#include "calibration/twin/twin.h"
#include "calibration/twin/twin_solver.h"
#include "core/base/job.h"
#include "core/base/result.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// The compared part of a press: blocks of pixels around the contact.
struct TwinPatch {
  std::vector<cv::Point> corners;  ///< of blocks; all their pixels are on the face
  Eigen::VectorXd target;          ///< I / I_ref * T_untouched, their means, grey levels
  std::vector<int> sectors;        ///< about the contact's middle, counted from 0
  cv::Rect view;  ///< rendered part of the image: these blocks, and a border that blurs into them
  int side_px = 1;
  /// Fast approximation: the twin is rendered by a camera whose pixels are the blocks, without the
  /// face's structure within one.
  bool is_coarse = false;
};
inline constexpr int kTwinSectors = 16;     // a press
inline constexpr double kTwinReach = 2.75;  // of the dark disc's radius: outside the halo

/// `untouched`: the twin's image in the press's pose (CV_32FC1). Empty where no block can be
/// compared. Coarse blocks are three times as wide.
[[nodiscard]] TwinPatch patch_of(const TwinPress& press, const cv::Mat& untouched,
                                 const CameraParameters& camera, bool is_coarse);

/// Initial estimates for the fit, from the rings of one press.
struct TwinRings {
  double rim_px = 0;     ///< where the face is as bright as untouched; 0: nowhere
  double halo_px = 0;    ///< from there to the brightest ring
  double brightest = 0;  ///< of that ring, relative to the untouched face, minus 1; 0: no halo
};
[[nodiscard]] TwinRings rings_of(const TwinPress& press);

/// Standard deviations of the fitted values; empty: not determined, or not fitted.
struct ContactSpread {
  std::optional<double> scatter_per_mm, coat, rolloff_mm, halo_share, halo_width_mm, halo_steepness,
      blur_px;
  struct Ball {
    std::optional<double> s_mm, y_mm, depth_mm, light;
  };
  std::vector<Ball> balls;
};

struct TwinContact {
  TwinScene scene;  ///< as given, with the fitted numbers; the lamps' powers follow the layer
  ContactSpread spread;
  double rms = 0;  ///< of block means, grey levels
  /// Residual of the other kind of roll-off, with its best halo, relative to the chosen one's.
  TwinRolloff other_rolloff = TwinRolloff::kHertz;
  double other_factor = 1;
};

/// `scene` holds camera, face, lamps and initial values, with one ball a press. Both kinds of
/// roll-off and of halo are tried. Within two standard deviations of zero the coat counts as black,
/// and halo and blur as absent.
[[nodiscard]] Result<TwinContact> fit_contact(const TwinScene& scene,
                                              const std::vector<TwinPatch>& coarse,
                                              const std::vector<TwinPatch>& patches,
                                              const std::vector<TwinPress>& presses,
                                              const Job& job);

}  // namespace alltact
