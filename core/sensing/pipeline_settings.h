// All settings of the frame pipeline that trade accuracy for time.
#pragma once

#include "core/base/settings.h"
#include "core/finger/finger_store.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_pixels.h"
#include "core/sensing/markers/marker_tracker.h"
#include "core/sensing/reference/reference_library.h"

#include <string>
#include <vector>

namespace alltact {

/// Binning: how many pixels a side are averaged into one before anything else. Lengths in pixels,
/// of settings and results, are those of the binned image.
enum class Resolution { kFull = 1, kHalf = 2, kQuarter = 4 };
[[nodiscard]] constexpr int binning_factor(Resolution resolution) {
  return static_cast<int>(resolution);
}

struct PipelineSettings {
  Resolution resolution = Resolution::kFull;
  int average_frames = 1;
  FaceRegion region;
  EdgeMethod edge_method = EdgeMethod::kCrossing;
  int edge_columns = 8;
  int profile_degree = 7;
  MarkerMethod marker_method = MarkerMethod::kBlobs;
  std::string marker_network = kBuiltInNetwork;  ///< an ONNX file
  ReferenceMethod reference = ReferenceMethod::kLocal;
  int reference_neighbours = kPoseNeighbours;
  /// Changes of the light since the recording are estimated on the skin without contact
  /// (light_gain.h) and removed; false: the light is assumed to be that of the recording.
  bool correct_light = true;
  double smoothing_px = 1.0;
  /// Depth along the layer's normal is converted to depth along z at the position on the face that
  /// the normal leads to (depth_map.h). False: at the same pixel, by the slope alone, as the source
  /// paper does.
  bool exact_rays = true;
  bool undistort = true;  ///< lens distortion is removed from every point
  double contact_threshold_mm = 0.1;
  int mesh_step_px = 1;
};

/// Table of all settings, from which flags, help and files are generated.
[[nodiscard]] const std::vector<Setting<PipelineSettings>>& pipeline_settings();

/// Names of the settings that no mapping depends on. A mapping is fitted to presses that are
/// measured over the full face and one by one.
[[nodiscard]] const std::vector<std::string>& mapping_independent_settings();
/// The settings that presses are measured with: those of mapping_independent_settings() at their
/// defaults, the others unchanged.
[[nodiscard]] PipelineSettings settings_for_presses(PipelineSettings settings);

/// The finger as it appears in the images that a pipeline with these settings measures: reduced
/// (finger_store.h), with the lens model of the settings. ReferenceLibrary::load takes it.
[[nodiscard]] FingerSnapshot finger_as_measured(const FingerSnapshot& finger,
                                                const PipelineSettings& settings);

}  // namespace alltact
