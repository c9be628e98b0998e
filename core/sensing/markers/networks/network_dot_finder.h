// Dots that a network detects, measured with sub-pixel accuracy.
#pragma once

#include "core/sensing/markers/dot_finder.h"
#include "core/sensing/markers/networks/dot_network.h"

#include <memory>

namespace alltact {

/// Measures the dot at each detection of the network at full resolution
/// (core/sensing/markers/dot_measure.h) and rejects detections off the side faces. The network
/// alone is 0.1 to 0.5 px off and has no polarity; with kAuto it is that of most dots. Stateless.
class NetworkDotFinder : public DotFinder {
 public:
  NetworkDotFinder(DotNetwork network, MarkerRows rows)
      : network_(std::make_unique<DotNetwork>(std::move(network))), rows_(std::move(rows)) {}

  [[nodiscard]] FoundDots operator()(const cv::Mat& grey, const FaceShape& shape) const override;

 private:
  std::unique_ptr<DotNetwork> network_;
  MarkerRows rows_;
};

}  // namespace alltact
