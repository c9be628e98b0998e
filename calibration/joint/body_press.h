// A press of a body whose shape is known as a mesh. The skin that rests on it gives the scale of
// depth without any ball, whatever the body's pose.
#pragma once

#include "calibration/joint/body_pose.h"
#include "calibration/joint/mapping_curve.h"
#include "calibration/presses/press.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/mapping.h"

#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace alltact {

/// The skin that rests on a body: pressed in deep enough, and away from the body's edges.
struct BodySamples {
  std::string press;
  PressSamples samples;
  std::vector<BodyPatch> patches;  ///< of the body under each sample, in its frame
  Eigen::VectorXd blur_mm;         ///< of each sample: how much deeper it reads than at its middle
  Eigen::Isometry3d camera_from_body = Eigen::Isometry3d::Identity();  ///< start of read_body()
};

/// The samples of the pressed skin and what is around it.
[[nodiscard]] PressSamples sample_for_body(const Press& press, const Face& face);

/// Finds the pose of a body from the depths that `curve` gives, which may be wrong by a third, and
/// the skin that rests on it. `samples`: of sample_for_body(). All orientations are tried. Errors:
/// too little skin is pressed in; no pose of the body explains the depths; its shape leaves the
/// scale of depth open, such as that of a flat punch; stopped.
[[nodiscard]] Result<BodySamples> find_body(const std::string& press, PressSamples samples,
                                            const MeshDistance& shape, const MappingCurve& curve,
                                            MappingAlong along, const Job& job);

/// What a curve reads where the skin rests on the body.
struct BodyReading {
  double factor = 1;          ///< true depth / depth read
  double sd = 0;              ///< of the factor, by noise and by skin that does not follow the
                              ///< body; infinite where the depths read show nothing
  double rms_mm = 0;          ///< distance of the skin from the body with that factor
  Eigen::VectorXd by_values;  ///< derivative of the factor by the curve's numbers
};

/// Fits the body's pose and the factor on all depths by least squares. `values`: the curve's own,
/// or those in a solver; a result depends on nothing else.
[[nodiscard]] BodyReading read_body(const BodySamples& body, const MappingCurve& curve,
                                    const double* values, MappingAlong along);

}  // namespace alltact
