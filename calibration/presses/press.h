// A press: one image of a ball of known radius pushed into the face, compared with its reference;
// its ball, found or set by a person; its samples for the fits.
#pragma once

#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/finger/press_set.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/face/face_shape.h"

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

class MeshDistance;

/// A body that is not a ball, its shape known as a mesh.
struct KnownBody {
  std::string file;                           ///< its name, without folders
  std::shared_ptr<const MeshDistance> shape;  ///< in mm, in a frame of its own
};

/// Input of the calibration from one press: the brightness difference on the face, and the face.
struct Press {
  std::string name;  ///< file name of the image without its ending
  Difference difference;
  FaceShape shape;
  double ball_radius_mm = 0;  ///< of the pressed ball
  /// The ball's centre as a person set it, camera frame; empty: find_ball() searches it.
  std::optional<Eigen::Vector3d> ball_mm = std::nullopt;
  std::optional<GivenDepth> given_depth = std::nullopt;
  /// Height of the step of a flat punch, mm.
  std::optional<double> step_mm = std::nullopt;
  std::optional<KnownBody> body = std::nullopt;
  /// Neither a punch nor another body presses.
  [[nodiscard]] bool is_ball() const { return !step_mm && !body; }
};

/// A ball found in a press before the mapping is known.
struct BallGuess {
  Eigen::Vector3d centre_mm;  ///< camera frame
  double contact_radius_mm;   ///< of the dark disc on the face
  double rim_arc_deg;         ///< visible arc of the disc's rim on the face
  bool cut_by_edge;           ///< part of the disc lies off the face
  /// The disc in the image: the 40 % contour of the darkness, as a circle.
  Eigen::Vector2d disc_px;
  double disc_radius_px;
  double disc_radius_mm = 0;  ///< of that disc on the face, independent of the ball's radius
};

/// Finds the dark disc of one ball without a start: off axis (an ellipse in the image), with or
/// without a bright halo, complete or cut by an edge of the face. Errors, each with what was found
/// and what to try: nothing dark enough; two contacts; a shape that is no disc on the face; less
/// than 60 degrees of the rim visible; a disc larger than the ball; a ball radius that is not
/// finite and positive.
[[nodiscard]] Result<BallGuess> find_ball(const Press& press, const Face& face);

// A ball whose outline a person drew, and the pose of a ball on the face.

/// A ball over the nearest point of the face, with the face as a plane there.
struct BallOnFace {
  double depth_mm = 0;        ///< along the normal; <= 0: no contact
  double radius_mm = 0;       ///< of the circle in which the ball cuts the untouched face; 0: none
  Eigen::Vector3d middle_mm;  ///< of that circle
  Eigen::Vector3d normal;     ///< of the face, away from the camera
};
/// nullopt where the ball is not over the visible part of the face.
[[nodiscard]] std::optional<BallOnFace> ball_on_face(const FaceShape& shape, const Face& face,
                                                     const Eigen::Vector3d& centre_mm,
                                                     double radius_mm);

/// The circle in which the ball cuts the untouched face, in pixels, in even steps around.
[[nodiscard]] std::vector<Eigen::Vector2d> contact_rim_px(const Camera& camera,
                                                          const BallOnFace& contact, int count);

/// The guess for a ball that a person set at `centre_mm`, in the form of find_ball(). Error: it
/// does not touch the visible face.
[[nodiscard]] Result<BallGuess> guess_of_manual_ball(const Press& press, const Face& face,
                                                     const Eigen::Vector3d& centre_mm);

// A press reduced to block means on the face: the input of the fits.

/// One block of pixels: the mean difference, and the untouched face at its middle.
struct Sample {
  Eigen::Vector2d pixel;
  Eigen::Vector3d untouched_z;  ///< outer side of the layer along z, mm
  Eigen::Vector3d untouched_n;  ///< the same along the normal, mm
  Eigen::Vector3d normal;       ///< outward, away from the camera
  /// Derivative of untouched_n by the pixel, mm.
  Eigen::Vector3d by_u = Eigen::Vector3d::Zero(), by_v = Eigen::Vector3d::Zero();
  double cos_incline = 1;
  double x = 0;
  Eigen::Vector2d position_mm;  ///< along the face and across it (FaceShape::position_mm)
  Eigen::Vector2d unit_position = Eigen::Vector2d::Zero();  ///< within a PressedArea, -1 to 1
};

/// A point in the image where the line of sight grazes the ball (see outline_methods.h).
struct OutlinePoint {
  Eigen::Vector3d direction;  ///< of the ray from the camera's centre, any length
  double sd_rad = 0;          ///< of the angle to the ball's centre
};

struct PressSamples {
  std::vector<Sample> samples;        ///< by rows, then columns; only blocks completely on the face
  std::vector<OutlinePoint> outline;  ///< empty where the ball occludes no part of itself
  double ball_radius_mm = 0;
  int block_px = 1;
  /// Variance of the averaging of each sample along either axis, by smoothing and block, px^2.
  double blur_px2 = 0;
  std::optional<GivenDepth> given_depth = std::nullopt;
  double x_sd = 0;  ///< noise of a block's mean, from second differences along rows
};

/// The rectangle of the face, mm along and across it, that contains the samples.
struct PressedArea {
  Eigen::Vector2d middle_mm = Eigen::Vector2d::Zero(), half_mm = Eigen::Vector2d::Ones();
};
[[nodiscard]] PressedArea pressed_area(const std::vector<const PressSamples*>& presses);
/// Sets `unit_position` of every sample.
void set_unit_positions(const PressedArea& part, PressSamples* press);

/// Block means of side `block_px`. A block with an unmeasured pixel is left out.
[[nodiscard]] PressSamples sample_press(const Press& press, const Face& face, int block_px);

/// The sample whose untouched_n is nearest to a point; null without samples.
[[nodiscard]] const Sample* nearest_sample(const PressSamples& press,
                                           const Eigen::Vector3d& point_mm);

/// The blocks within `radius_mm` of `middle` (camera frame, measured from untouched_n). Their size
/// is the smallest from 2 px on that gives at most about `limit` of them.
[[nodiscard]] PressSamples sample_around(const Press& press, const Face& face,
                                         const Eigen::Vector3d& middle, double radius_mm,
                                         int limit);

/// Replaces the brightness of samples by that in another difference of the same press.
void update_brightness(const cv::Mat& x, PressSamples* samples);

// Which pixels of an image of measurements have a value.

/// 255 where `x` is finite, 0 where it is NaN or infinite: both mean that nothing was measured. x:
/// CV_32FC1; returns CV_8UC1 of its size.
[[nodiscard]] inline cv::Mat measured_pixels(const cv::Mat& x) {
  return cv::abs(x) < std::numeric_limits<double>::infinity();  // false for NaN
}

}  // namespace alltact
