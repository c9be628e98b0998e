// Bodies of known shape under spread light, for its fit (light_spread_fit.h).
#pragma once

#include "calibration/joint/known_shape.h"
#include "calibration/joint/light_spread_fit.h"
#include "calibration/presses/press.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/finger/finger.h"
#include "core/finger/mapping.h"

#include <vector>

namespace alltact {

class SpreadShapes {
 public:
  /// Of the presses that were not made with a ball. The arguments must outlive it.
  SpreadShapes(const std::vector<Press>& presses, const Face& face, const Job& job);

  /// The scales that a mapping has by the bodies, after its spread of light is undone. They are
  /// found by the first call; later ones read the same skin.
  [[nodiscard]] std::vector<ScaleSeen> read(const MappingParameters& mapping);

  /// As the last call read them.
  [[nodiscard]] const std::vector<KnownShape>& shapes() const { return shapes_; }
  /// Why presses are not among them.
  [[nodiscard]] const std::vector<Message>& left_out() const { return left_out_; }

 private:
  void find(const std::vector<Press>& local, const MappingCurve& curve);

  std::vector<Press> presses_;
  const Face& face_;
  const Job& job_;
  bool is_found_ = false;
  std::vector<KnownShape> shapes_;
  std::vector<Message> left_out_;
};

}  // namespace alltact
