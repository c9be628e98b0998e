// Every choice of the frame pipeline that trades accuracy for time.
#pragma once

#include "core/finger/finger_store.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_region.h"
#include "core/sensing/marker_methods.h"
#include "core/sensing/reference/reference_library.h"
#include "core/settings.h"

#include <string>
#include <vector>

namespace alltact {

/// Whether the light is taken to be that of the recording.
enum class LightChange {
  kIgnored = 1,  ///< the light of the recording is that of now
  kCorrected,    ///< the untouched skin tells how it has changed (light_gain.h)
};

/// How many pixels a side are averaged into one before anything looks at a picture. Lengths in
/// pixels, of settings and results, are then of what comes out.
enum class Resolution { kWhole = 1, kHalf = 2, kQuarter = 4 };
[[nodiscard]] constexpr int pixels_a_side(Resolution resolution) {
  return static_cast<int>(resolution);
}

/// How depth along the layer's normal becomes depth along z (depth_along_z.h).
enum class LayerRays {
  kExact = 1,  ///< where the normal leads on the face
  kParallel,   ///< at the same pixel, by the slope alone: the source paper's way
};

/// Whether the lens's distortion is taken out of every point.
enum class Undistortion { kExact = 1, kNone };

struct PipelineSettings {
  Resolution resolution = Resolution::kWhole;
  int average_frames = 1;
  FaceRegion region;
  EdgeMethod edge_method = EdgeMethod::kCrossing;
  int edge_columns = 8;
  int profile_degree = 7;
  MarkerMethod marker_method = MarkerMethod::kBlobs;
  std::string marker_network = kOwnNetwork;  ///< an ONNX file
  ReferenceMethod reference = ReferenceMethod::kLocal;
  int reference_neighbours = kPoseNeighbours;
  LightChange light = LightChange::kCorrected;
  double smoothing_px = 1.0;
  LayerRays rays = LayerRays::kExact;
  Undistortion undistortion = Undistortion::kExact;
  double contact_threshold_mm = 0.1;
  int mesh_step_px = 1;
};

/// The table that flags, help and files are made from.
[[nodiscard]] const std::vector<Setting<PipelineSettings>>& pipeline_settings();

/// Names of those that no mapping depends on: it is made from presses that are measured whole, each
/// by itself.
[[nodiscard]] const std::vector<std::string>& settings_beyond_mapping();
/// These as usual, the others as they are: what presses are measured with.
[[nodiscard]] PipelineSettings for_presses(PipelineSettings settings);

/// The finger as it is in the pictures that a pipeline of these settings measures: reduced
/// (reduced_finger.h), its lens taken as they say. What a pipeline's library is loaded of.
[[nodiscard]] FingerSnapshot finger_as_measured(const FingerSnapshot& finger,
                                                const PipelineSettings& settings);

}  // namespace alltact
