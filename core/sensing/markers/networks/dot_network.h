// Convolutional network that detects dots, loaded from an ONNX file and run by OpenCV.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <memory>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// A detected dot, in px of the input image.
struct NetworkDot {
  double u = 0, v = 0, half_u = 0, half_v = 0;
  double score = 0;  ///< 0 to 1
};

/// Two kinds of networks are distinguished by the shapes of their inputs and outputs:
///   - dots: [1, 1, h, w] to [1, 3, h / 4, w / 4], the project's own
///     (resources/models/train_marker_network.py defines the channels);
///   - boxes: [1, 3 or 1, h, w] to [1, 4 + classes, N] or [1, N, 4 + classes], as exported by
///     YOLO11 and similar: centre, width and height in px of the letterboxed square, and a score of
///     each class.
/// On loading, every network is run on a synthetic image. Its output must have the right shape and
/// be finite. Where NAME.yaml exists next to NAME.onnx (required for the project's own), the output
/// must match it within its tolerance. OpenCV 4.6 computes some networks wrongly without an error,
/// so that this check is needed.
class DotNetwork {
 public:
  /// Errors, each with advice: no such file, not ONNX or truncated, dynamic sizes, layers that
  /// OpenCV 4.6 does not support, shapes of neither kind, numbers that are not finite, a
  /// disagreement with NAME.yaml.
  static Result<DotNetwork> load(const std::filesystem::path& onnx);

  /// The dots of an 8-bit grey image, highest score first, without duplicates. Error: the network
  /// returns numbers that are not finite.
  [[nodiscard]] Result<std::vector<NetworkDot>> operator()(const cv::Mat& grey);

  DotNetwork(DotNetwork&&) noexcept;
  DotNetwork& operator=(DotNetwork&&) noexcept;
  ~DotNetwork();

 private:
  struct Impl;
  explicit DotNetwork(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The project's own network, in resources/models.
inline constexpr const char* kBuiltInMarkerNetwork = "models/marker_network.onnx";

}  // namespace alltact
