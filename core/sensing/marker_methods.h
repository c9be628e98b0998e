// The ways of finding a finger's markers, one beside the other.
#pragma once

#include "core/finger/finger.h"
#include "core/result.h"
#include "core/sensing/markers/dot_finder.h"
#include "core/sensing/markers/markers.h"

#include <memory>
#include <string>

namespace alltact {

enum class MarkerMethod {
  /// Spots that stand out of the side faces, numbered by what the recording says of how the finger
  /// moves, then followed from frame to frame.
  kBlobs = 1,
  /// The source paper's: each frame's dots sorted into two rows, hidden ones told from their
  /// neighbours (paper_rows.h). The spots of kBlobs, or a network's where one is named.
  kPaper,
  /// A convolutional network in every frame, its dots numbered as those of kBlobs.
  kNetwork,
};

/// As text: "blobs", "paper", "network".
[[nodiscard]] const char* to_string(MarkerMethod method);

/// network: an ONNX file, or kOwnNetwork. Errors: those of DotNetwork::load where a network is
/// used.
[[nodiscard]] Result<std::unique_ptr<MarkerFinder>> make_marker_finder(MarkerMethod method,
                                                                       const std::string& network,
                                                                       const Finger& finger,
                                                                       const MarkerModel& model);

/// The network that comes with the program.
inline constexpr const char* kOwnNetwork = "own";

}  // namespace alltact
