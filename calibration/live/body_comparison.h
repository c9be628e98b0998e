// A frame's contact compared with a nominal body: the body's pose that fits the skin best, how deep
// it would press in that pose, and how far the skin is from it.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/mesh/mesh_distance.h"
#include "core/sensing/frame_result.h"

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace alltact {

struct PosedNominal {
  Eigen::Isometry3d camera_from_body = Eigen::Isometry3d::Identity();
  double rms_mm = 0;  ///< distance of the skin that determines the pose from the body
  /// Depth along z to which the body presses in, CV_32FC1: where skin is pressed in, and where it
  /// would be. NaN elsewhere.
  cv::Mat depth_mm;
  /// Signed distance of the skin from its nominal surface, CV_32FC1: to the nearest point of the
  /// body, or of the untouched skin where that is nearer. Positive where the skin is deeper, off
  /// the body; negative where it is inside of the body. NaN without a depth.
  cv::Mat distance_mm;
};

/// The pose from the largest contact, where it is deeper than a third of its deepest point; away
/// from the contact's rim skin and body agree, next to it the skin lifts off. `result` has a depth.
/// Errors: too little is pressed in; no pose of the body explains the depths; stopped.
[[nodiscard]] Result<PosedNominal> pose_nominal(const FrameResult& result, const Face& face,
                                                const MeshDistance& body, const Job& job);

}  // namespace alltact
