// Dots that a network sees, measured to a part of a pixel.
#pragma once

#include "core/sensing/markers/dot_finder.h"
#include "core/sensing/markers/networks/dot_network.h"

#include <memory>

namespace alltact {

/// Takes each place that the network names, measures the dot there at full resolution
/// (core/sensing/markers/dot_measure.h) and leaves out what is no dot beside the face: a network
/// alone is 0.1 to 0.5 px off. The network tells no polarity; with kAuto it is that of most dots.
/// Remembers nothing.
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
