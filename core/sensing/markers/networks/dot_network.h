// A convolutional network that finds dots, from an ONNX file, run by OpenCV.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <memory>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Where a network sees a dot, in px of the picture it was given.
struct SeenDot {
  double u = 0, v = 0, half_u = 0, half_v = 0;
  double score = 0;  ///< 0 to 1
};

/// Two kinds of networks are known by the shapes of what goes in and comes out:
///   - dots: [1, 1, h, w] to [1, 3, h / 4, w / 4], the project's own
///     (resources/models/train_marker_network.py says what the numbers are);
///   - boxes: [1, 3 or 1, h, w] to [1, 4 + classes, N] or [1, N, 4 + classes], as YOLO11 and its
///     like are exported: centre, width and height in px of the square that the picture is laid
///     into, and a score of each class.
/// Wherever a network comes from, it is run on a picture that the program makes for itself when it
/// is loaded: what comes out must have its shape and be finite, and where NAME.yaml lies beside
/// NAME.onnx (the project's own has to have it) be what that says, to its tolerance. OpenCV 4.6
/// computes some networks wrongly without a word, so that the last is no formality.
class DotNetwork {
 public:
  /// Errors, each with what to try: no such file, not ONNX or cut off, sizes left open, layers that
  /// OpenCV 4.6 does not know, shapes of neither kind, numbers that are not finite, a disagreement
  /// with NAME.yaml.
  static Result<DotNetwork> load(const std::filesystem::path& onnx);

  /// The dots of an 8-bit grey picture, surest first, none twice. Error: the network gave numbers
  /// that are not finite.
  [[nodiscard]] Result<std::vector<SeenDot>> operator()(const cv::Mat& grey);

  DotNetwork(DotNetwork&&) noexcept;
  DotNetwork& operator=(DotNetwork&&) noexcept;
  ~DotNetwork();

 private:
  struct Content;
  explicit DotNetwork(std::unique_ptr<Content> content);
  std::unique_ptr<Content> content_;
};

/// The project's own, in resources/models.
inline constexpr const char* kOwnMarkerNetwork = "models/marker_network.onnx";

}  // namespace alltact
