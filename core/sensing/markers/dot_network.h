// Convolutional network that detects dots, loaded from an ONNX file and run by OpenCV.
#pragma once

#include "core/base/result.h"
#include "core/sensing/markers/markers.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/dnn.hpp>

namespace alltact {

/// A detected dot, in px of the input image.
struct NetworkDot {
  double u = 0, v = 0, half_u = 0, half_v = 0;
  double score = 0;  ///< 0 to 1
};

/// Map from the input of a network to the image: u = (x - left) / scale, with pixel centres at
/// integers.
struct InputMap {
  double scale = 1, left = 0, top = 0;
  [[nodiscard]] double u(double x) const { return (x - left) / scale; }
  [[nodiscard]] double v(double y) const { return (y - top) / scale; }
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

 private:
  DotNetwork() = default;
  [[nodiscard]] bool is_output(const cv::Mat& m, const cv::Mat& input) const;
  [[nodiscard]] Result<cv::Mat> run(const cv::Mat& input);
  [[nodiscard]] cv::Mat input_of(const cv::Mat& grey, InputMap* input_map) const;
  [[nodiscard]] Status check();

  std::filesystem::path onnx_;
  bool outputs_dots_ = true;  // else boxes
  cv::Size size_;             // of the input
  int channels_ = 1;
  cv::dnn::Net net_;
};

/// The project's own network, in resources/models.
inline constexpr const char* kBuiltInMarkerNetwork = "models/marker_network.onnx";

// Check that a network computes the same on this computer as where it was trained.

/// Content of NAME.yaml next to NAME.onnx:
///   size [width, height]       of the image of check_image(), px; key: see NetworkCheck::load
///   every: 13                  stride between the listed numbers of the output
///   tolerance: 0.001
///   output: [ ... ]            the first number, the one `every` further, and so on
struct NetworkCheck {
  cv::Size image_size;
  int every = 1;
  double tolerance = 0;
  std::vector<double> output;

  /// nullopt: the file does not exist. Error: it cannot be read, or has a line of another form.
  static Result<std::optional<NetworkCheck>> load(const std::filesystem::path& yaml);

  /// Error: another count of numbers, or one that is off by more than the tolerance.
  [[nodiscard]] Status holds(const cv::Mat& got, const std::filesystem::path& onnx) const;
};

/// Synthetic image: ramps and discs of four sizes, bright and dark, the same as in
/// train_marker_network.py.
[[nodiscard]] cv::Mat check_image(const cv::Size& size);

// Header of an ONNX file, read without running it: OpenCV reports neither the input size of a
// network nor why it cannot read one.

/// One input or output of a network. shape: 0 for a dynamic size.
struct OnnxPort {
  std::string name;
  std::vector<std::int64_t> shape;
};

struct OnnxHeader {
  std::vector<OnnxPort> inputs, outputs;  ///< inputs exclude the weights
  std::int64_t opset = 0;
};

/// Parses the protocol buffer of a model (onnx.proto3: ModelProto, GraphProto, ValueInfoProto).
/// OpenCV trusts a damaged file and then reads out of bounds. So every length is checked against
/// the bytes left, every weight's dimensions against its bytes, and every input of a node against
/// the names defined before it. `where`: the file, for errors. Error: not an ONNX model, truncated,
/// or damaged.
[[nodiscard]] Result<OnnxHeader> read_onnx_header(std::string_view bytes, const Where& where);

// Converts images to network inputs, and network outputs to dots.

/// Input of the network for dots: the image reduced by an integer factor to a width of about 960
/// px, and the square root of grey / 255 as [1, 1, height, width].
[[nodiscard]] cv::Mat dots_input(const cv::Mat& grey, InputMap* input_map);

/// Letterboxed input of a network for boxes: the image as large as fits in the middle of `size`,
/// the rest grey (114). [1, channels, height, width], grey / 255 in each.
[[nodiscard]] cv::Mat boxes_input(const cv::Mat& grey, const cv::Size& size, int channels,
                                  InputMap* input_map);

/// Peaks of the first channel of [1, 3, h, w], highest score first; of two with overlapping extents
/// the one of higher score.
[[nodiscard]] std::vector<NetworkDot> dots_of(const cv::Mat& output, const InputMap& input_map);

/// Boxes of [1, 4 + classes, N] or [1, N, 4 + classes], by non-maximum suppression at an
/// intersection over union of 0.45.
[[nodiscard]] std::vector<NetworkDot> boxes_of(const cv::Mat& output, const InputMap& input_map);

// Dots that a network detects, measured with sub-pixel accuracy.

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
