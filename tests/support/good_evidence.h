// A calibration that has all the evidence of a good one, for tests that take single pieces away.
#pragma once

#include "calibration/verdict/verdict.h"

namespace alltact::test {

inline CalibrationEvidence good_evidence() {
  CalibrationEvidence evidence;
  evidence.presses = 6;
  evidence.positions = 6;
  evidence.thirds = {2, 2, 2};
  evidence.shallowest_mm = 0.4;
  evidence.deepest_mm = 0.9;
  evidence.residual_mm = 0.008;
  evidence.held_out_mm = 0.01;
  evidence.scale_sd_mm = 0.012;
  evidence.pixel_sd_mm = 0.01;
  evidence.position_leverage = 2.0 / 6;
  evidence.depth_per_radius = 1.2;
  evidence.ball_radii_mm = {4};
  evidence.layer_mm = 1.5;
  evidence.has_basis = true;
  evidence.repeat_command = Message::typed("alltact calibrate left-07 --again");
  return evidence;
}

/// A record of the same, which names four presses, for a finger whose face and camera are set.
inline MappingRecord good_record(const Finger& finger) {
  const CalibrationEvidence evidence = good_evidence();
  MappingRecord record;
  record.method = "joint";
  record.presses = {"a", "b", "c", "d"};
  record.residual_mm = evidence.residual_mm;
  record.held_out_mm = evidence.held_out_mm;
  record.spread_mm = 0.008;
  record.pixel_mm = 0.01;
  CalibrationBasis basis;
  basis.ball_radii_mm = evidence.ball_radii_mm;
  basis.layer_mm = finger.face.layer_mm;
  basis.width_mm = finger.face.width_mm;
  basis.plane_z_mm = finger.face.plane_z_mm;
  basis.camera = camera_fingerprint(finger.camera);
  basis.positions = 4;
  basis.thirds = {1, 2, 1};
  basis.position_leverage = 0.5;
  basis.shallowest_mm = evidence.shallowest_mm;
  basis.deepest_mm = evidence.deepest_mm;
  basis.scale_sd_mm = evidence.scale_sd_mm;
  basis.pixel_sd_mm = evidence.pixel_sd_mm;
  basis.depth_per_radius = evidence.depth_per_radius;
  record.basis = basis;
  return record;
}

}  // namespace alltact::test
