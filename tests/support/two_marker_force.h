// A force model that is simple enough to work out by hand.
#pragma once

#include "core/finger/force_model.h"

namespace alltact::test {

/// Two markers; Fx = u0 / 10, Fy = v1 / 5, each member half a hundredth off.
inline ForceModel two_marker_force() {
  ForceModel model;
  model.kind = ForceKind::kRidge;
  model.axes = 2, model.marker_count = 2;
  model.rest_px = {{100, 50}, {100, 450}};
  ForceRange& range = model.range;
  range.mean_px = Eigen::VectorXd::Zero(4);
  range.components = Eigen::MatrixXd::Identity(4, 2);
  range.component_sd_px = Eigen::Vector2d(5, 5);
  range.noise_px = 0.1, range.max_t2 = 9, range.max_residual_px = 8, range.min_seen = 1;
  for (const double off : {-0.005, 0.005}) {
    ForceMember member;
    member.basis.mean_px = Eigen::VectorXd::Zero(4);
    member.basis.scale = Eigen::VectorXd::Ones(4);
    member.basis.components = Eigen::MatrixXd::Identity(4, 4);
    member.basis.gain = Eigen::VectorXd::Ones(4);
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(2, 4);
    weights(0, 0) = 0.1, weights(1, 3) = 0.2;
    member.regressors = {{ForceLayer{weights, Eigen::Vector2d(off, 0)}}};
    model.members.push_back(member);
  }
  model.scores = {Eigen::Vector2d(0.03, 0.04), Eigen::Vector2d(1, 1), Eigen::Vector2d(1.7, 1.7),
                  Eigen::Vector2d(2, 2)};
  model.record["split"] = "block";
  return model;
}

}  // namespace alltact::test
