// Every choice of the frame pipeline that trades accuracy for time.
#pragma once

#include "core/sensing/face/face_edges.h"
#include "core/sensing/marker_methods.h"
#include "core/sensing/reference/reference_library.h"
#include "core/settings.h"

#include <string>

namespace alltact {

/// Whether the light is taken to be that of the recording.
enum class LightChange {
  kIgnored = 1,  ///< the light of the recording is that of now
  kCorrected,    ///< the untouched skin tells how it has changed (light_gain.h)
};

struct PipelineSettings {
  EdgeMethod edge_method = EdgeMethod::kCrossing;
  int edge_columns = 8;
  int profile_degree = 7;
  MarkerMethod marker_method = MarkerMethod::kBlobs;
  std::string marker_network = kOwnNetwork;  ///< an ONNX file
  ReferenceMethod reference = ReferenceMethod::kLocal;
  LightChange light = LightChange::kCorrected;
  double smoothing_px = 1.0;
  double contact_threshold_mm = 0.1;
};

/// The table that flags, help and files are made from.
[[nodiscard]] const std::vector<Setting<PipelineSettings>>& pipeline_settings();

}  // namespace alltact
