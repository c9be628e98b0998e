// Selectable methods of finding a finger's markers.
#pragma once

#include "core/finger/finger.h"
#include "core/result.h"
#include "core/sensing/markers/dot_finder.h"
#include "core/sensing/markers/markers.h"

#include <memory>
#include <string>

namespace alltact {

enum class MarkerMethod {
  /// Bright or dark spots of the side faces, numbered by the recorded motion of the finger and then
  /// followed from frame to frame.
  kBlobs = 1,
  /// The source paper's method: sorts each frame's dots into two rows and estimates hidden ones
  /// from their neighbours (paper_rows.h). The dots are those of kBlobs, or of a network where one
  /// is named.
  kPaper,
  /// A convolutional network in every frame. Its dots are numbered like those of kBlobs.
  kNetwork,
};

/// As text: "blobs", "paper", "network".
[[nodiscard]] const char* to_string(MarkerMethod method);

/// network: an ONNX file, or kBuiltInNetwork. Errors: those of DotNetwork::load, where a network is
/// used.
[[nodiscard]] Result<std::unique_ptr<MarkerFinder>> make_marker_finder(MarkerMethod method,
                                                                       const std::string& network,
                                                                       const Finger& finger,
                                                                       const MarkerModel& model);

/// The network that comes with the program.
inline constexpr const char* kBuiltInNetwork = "own";

}  // namespace alltact
