// Gripper files for tests.
#pragma once

namespace alltact::test {

/// A gripper that is the same on both sides of its screw; one key a line.
inline constexpr const char* kGripper = R"(format: alltact-gripper/1
name: lab gripper
motor:
  lead_mm: 2.0
  range_turns: [0.0, 10.0]
  sd_turns: 0.01
fingers:
  - name: left
    folder: left
    pivot_mm: [-30.0, 20.0]
    nut_mm: [-10.0, 5.0]
    crank_mm: 25.0
    rod_mm: 30.0
    assembly: behind
    link_from_camera: {translation_mm: [5.0, 0.0, 10.0], rotation: [0.0, 0.0, 0.0, 1.0]}
  - name: right
    folder: right
    pivot_mm: [30.0, 20.0]
    nut_mm: [10.0, 5.0]
    crank_mm: 25.0
    rod_mm: 30.0
    assembly: ahead
    link_from_camera: {translation_mm: [-5.0, 0.0, 10.0], rotation: [1.0, 0.0, 0.0, 0.0]}
)";

}  // namespace alltact::test
