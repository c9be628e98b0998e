#include "core/sensing/markers/dot_network.h"

#include "core/base/atomic_file.h"
#include "core/base/yaml.h"
#include "core/sensing/markers/dot_measure.h"
#include "core/sensing/markers/marker_detector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr std::size_t kMaxNetworkBytes = std::size_t{256} << 20;
constexpr std::int64_t kMinSide = 32, kMaxInputSide = 4096;  // side of the input, px

/// Silences OpenCV, which writes errors to standard error in addition to throwing.
class QuietOpenCv {
 public:
  QuietOpenCv() : before_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}
  ~QuietOpenCv() { cv::utils::logging::setLogLevel(before_); }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;

 private:
  cv::utils::logging::LogLevel before_;
};

Error unusable(Message what, const std::filesystem::path& onnx) {
  return Error{std::move(what), onnx,
               en::say("a network exported with fixed sizes, one image at a time and opset 11 or "
                       "12, or --marker-network own")};
}

std::string shape_text(const std::vector<std::int64_t>& shape) {
  std::string text;
  for (const std::int64_t n : shape)
    text += (text.empty() ? "" : " x ") + (n > 0 ? fmt::format("{}", n) : std::string("?"));
  return text.empty() ? "?" : text;
}

std::vector<std::int64_t> shape_of(const cv::Mat& m) { return {m.size.p, m.size.p + m.dims}; }

bool is_finite(const cv::Mat& m) {
  const auto* values = m.ptr<float>();
  return std::all_of(values, values + m.total(), [](float x) { return std::isfinite(x); });
}

}  // namespace

cv::Mat DotNetwork::input_of(const cv::Mat& grey, InputMap* input_map) const {
  return outputs_dots_ ? dots_input(grey, input_map)
                       : boxes_input(grey, size_, channels_, input_map);
}

bool DotNetwork::is_output(const cv::Mat& m, const cv::Mat& input) const {
  if (m.type() != CV_32F || !m.isContinuous()) return false;
  if (outputs_dots_)
    return m.dims == 4 && m.size[0] == 1 && m.size[1] == 3 &&
           m.size[2] == (input.size[2] + 3) / 4 && m.size[3] == (input.size[3] + 3) / 4;
  return m.dims == 3 && m.size[0] == 1 && std::min(m.size[1], m.size[2]) >= 5;
}

Result<cv::Mat> DotNetwork::run(const cv::Mat& input) {
  std::vector<cv::Mat> outputs;
  try {
    const QuietOpenCv quiet;
    net_.setInput(input);
    net_.forward(outputs, net_.getUnconnectedOutLayersNames());
  } catch (const std::exception&) {
    return unusable(en::say("OpenCV cannot run this network"), onnx_);
  }
  // Selected by shape: OpenCV returns several outputs in an order of its own.
  const auto output = std::find_if(outputs.begin(), outputs.end(),
                                   [&](const cv::Mat& m) { return is_output(m, input); });
  if (output == outputs.end())
    return unusable(
        en::say("this network outputs {} for {}, which are neither dots nor boxes",
                outputs.empty() ? std::string("nothing") : shape_text(shape_of(outputs.front())),
                shape_text(shape_of(input))),
        onnx_);
  if (!is_finite(*output))
    return unusable(en::say("this network outputs numbers that are not finite"), onnx_);
  return *output;
}

Status DotNetwork::check() {
  auto yaml = onnx_;
  const auto expected = NetworkCheck::load(yaml.replace_extension(".yaml"));
  if (!expected) return expected.error();
  if (outputs_dots_ && !*expected)
    return Error{en::say("the file with this network's expected output is missing"), yaml,
                 en::say("training it again, which writes both files")};
  const cv::Size own = *expected ? (*expected)->image_size : size_;
  if (!outputs_dots_ && own != size_)
    return Error{en::say("the image must have the size of the network's input, {} x {}",
                         size_.width, size_.height),
                 yaml, ""};
  InputMap input_map;
  const auto got = run(input_of(check_image(own), &input_map));
  if (!got) return got.error();
  return *expected ? (*expected)->holds(*got, onnx_) : Status();
}

Result<DotNetwork> DotNetwork::load(const std::filesystem::path& onnx) {
  const auto bytes = read_file(onnx, kMaxNetworkBytes);
  if (!bytes) return bytes.error();
  const auto header = read_onnx_header(*bytes, onnx);
  if (!header) return header.error();
  const auto& in = header->inputs.front().shape;
  const bool is_fixed = std::all_of(in.begin(), in.end(), [](std::int64_t n) { return n > 0; });
  if (header->inputs.size() != 1 || in.size() != 4 || !is_fixed || in[0] != 1 ||
      (in[1] != 1 && in[1] != 3) || std::min(in[2], in[3]) < kMinSide ||
      std::max(in[2], in[3]) > kMaxInputSide)
    return unusable(en::say("this network takes {}, not one image of 1 or 3 channels and a fixed "
                            "size of {} to {} px a side",
                            shape_text(in), kMinSide, kMaxInputSide),
                    onnx);
  DotNetwork network;
  network.onnx_ = onnx;
  network.channels_ = static_cast<int>(in[1]);
  network.size_ = {static_cast<int>(in[3]), static_cast<int>(in[2])};
  const bool has_dots = std::any_of(
      header->outputs.begin(), header->outputs.end(),
      [](const OnnxPort& port) { return port.shape.size() == 4 && port.shape[1] == 3; });
  network.outputs_dots_ = has_dots && in[1] == 1;
  try {
    const QuietOpenCv quiet;
    network.net_ = cv::dnn::readNetFromONNX(bytes->data(), bytes->size());
    network.net_.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    // With fusion OpenCV 4.6 computes YOLO11's attention wrongly without an error.
    network.net_.enableFusion(network.outputs_dots_);
  } catch (const std::exception&) {
    return unusable(
        en::say("OpenCV cannot read this network (opset {}; it supports those up to 12 well)",
                header->opset),
        onnx);
  }
  if (const Status status = network.check(); !status) return status.error();
  return network;
}

Result<std::vector<NetworkDot>> DotNetwork::operator()(const cv::Mat& grey) {
  InputMap input_map;
  const auto output = run(input_of(grey, &input_map));
  if (!output) return output.error();
  return outputs_dots_ ? dots_of(*output, input_map) : boxes_of(*output, input_map);
}

Result<std::optional<NetworkCheck>> NetworkCheck::load(const std::filesystem::path& yaml) {
  std::error_code failed;
  if (!std::filesystem::exists(yaml, failed)) return std::optional<NetworkCheck>();
  constexpr std::size_t kMaxNumbers = 100000;
  constexpr double kMaxPx = 4096;
  NetworkCheck check;
  const Status status = YamlFile(yaml, YamlFile::Unknown::kRefused).load([&](YamlSection& section) {
    const auto size = section.numbers("picture", 2, 2, {16, kMaxPx});
    check.image_size = {static_cast<int>(size[0]), static_cast<int>(size[1])};
    check.every = section.integer("every", 1, 1 << 20);
    check.tolerance = section.number("tolerance", Limits{0, 1e6, true});
    check.output = section.numbers("output", 1, kMaxNumbers, kAnyNumber);
  });
  if (!status) return status.error();
  return std::optional(std::move(check));
}

Status NetworkCheck::holds(const cv::Mat& got, const std::filesystem::path& onnx) const {
  const std::size_t total = got.total(), step = static_cast<std::size_t>(every);
  const std::size_t count = (total + step - 1) / step;
  const auto refused = [&](Message what) {
    return Error{std::move(what), onnx,
                 en::say("the network and its .yaml of the same training, or exporting it with "
                         "opset 11 or 12")};
  };
  if (count != output.size())
    return refused(
        en::say("the network outputs {} numbers where its .yaml has {}", count, output.size()));
  const auto* values = got.ptr<float>();
  double max_error = 0;
  for (std::size_t k = 0; k < count; ++k)
    max_error = std::max(max_error, std::abs(static_cast<double>(values[k * step]) - output[k]));
  if (max_error <= tolerance) return {};
  return refused(
      en::say("for a known image the network's numbers deviate by up to {:.3g} from its .yaml, and "
              "{:.3g} is allowed",
              max_error, tolerance));
}

cv::Mat check_image(const cv::Size& size) {
  constexpr int kDiscs = 8;
  cv::Mat grey(size, CV_8UC1);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      int level = 40 + (x * 3 + y * 5) % 64;
      for (int k = 0; k < kDiscs; ++k) {
        const int dx = x - (12 + 11 * k), dy = y - (16 + 6 * k), radius = 2 + k / 2;
        if (dx * dx + dy * dy <= radius * radius) level = k % 2 == 0 ? 200 : 5;
      }
      grey.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(level);
    }
  return grey;
}

namespace {

/// One field of a protocol buffer's message.
struct Field {
  std::uint64_t number = 0;
  std::uint64_t value = 0;  // of an integer field
  std::string_view bytes;   // of a message or a string
  bool is_bytes = false;
};

/// Reads a message field by field. Every length is checked against the bytes left.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : rest_(bytes) {}

  /// False at the end, and where no valid field follows.
  bool next(Field& field) {
    if (rest_.empty() || is_broken_) return false;
    std::uint64_t key = 0;
    field = {};
    if (!read_varint(key)) return fail();
    field.number = key >> 3U;
    switch (key & 7U) {
      case 0:
        return read_varint(field.value) || fail();
      case 1:
        return skip(8) || fail();
      case 2: {
        std::uint64_t length = 0;
        if (!read_varint(length) || length > rest_.size()) return fail();
        field.bytes = rest_.substr(0, static_cast<std::size_t>(length));
        field.is_bytes = true;
        return skip(static_cast<std::size_t>(length));
      }
      case 5:
        return skip(4) || fail();
      default:
        return fail();
    }
  }
  [[nodiscard]] bool is_broken() const { return is_broken_; }
  /// The next integer of a packed field; nullopt at the end.
  std::optional<std::uint64_t> packed_number() {
    std::uint64_t value = 0;
    if (rest_.empty() || is_broken_) return std::nullopt;
    if (read_varint(value)) return value;
    is_broken_ = true;
    return std::nullopt;
  }

 private:
  bool fail() {
    is_broken_ = true;
    return false;
  }
  bool skip(std::size_t count) {
    if (count > rest_.size()) return false;
    rest_.remove_prefix(count);
    return true;
  }
  bool read_varint(std::uint64_t& value) {
    value = 0;
    for (unsigned shift = 0; shift < 64 && !rest_.empty(); shift += 7) {
      const auto byte = static_cast<unsigned char>(rest_.front());
      rest_.remove_prefix(1);
      value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if ((byte & 0x80U) == 0) return true;
    }
    return false;
  }

  std::string_view rest_;
  bool is_broken_ = false;
};

/// Calls visit for each field; false where the message is damaged.
template <class Visit>
bool each_field(std::string_view message, Visit visit) {
  Fields fields(message);
  Field field;
  while (fields.next(field)) visit(field);
  return !fields.is_broken();
}

/// ValueInfoProto: name 1, type 2 > tensor_type 1 > shape 2 > dim 1 > dim_value 1.
bool read_port(std::string_view message, OnnxPort& port) {
  bool is_complete = true;
  const auto dimension = [&](const Field& dim) {
    if (dim.number != 1 || !dim.is_bytes) return;
    std::int64_t size = 0;
    is_complete &= each_field(dim.bytes, [&](const Field& f) {
      constexpr auto kLargest =
          static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
      if (f.number == 1 && !f.is_bytes) size = f.value <= kLargest ? static_cast<int>(f.value) : 0;
    });
    port.shape.push_back(size);
  };
  const auto shape = [&](const Field& f) {
    if (f.number == 2 && f.is_bytes) is_complete &= each_field(f.bytes, dimension);
  };
  const auto type = [&](const Field& f) {
    if (f.number == 1 && f.is_bytes) is_complete &= each_field(f.bytes, shape);
  };
  is_complete &= each_field(message, [&](const Field& f) {
    if (f.number == 1 && f.is_bytes) port.name = f.bytes;
    if (f.number == 2 && f.is_bytes) is_complete &= each_field(f.bytes, type);
  });
  return is_complete;
}

constexpr std::uint64_t kMaxNumbers = std::uint64_t{1} << 28U;

/// Bytes of one number of a tensor, by TensorProto.DataType; 0 of unsupported types.
std::uint64_t bytes_of(std::uint64_t kind) {
  switch (kind) {
    case 1:  // float
    case 6:  // int32
      return 4;
    case 7:   // int64
    case 11:  // double
      return 8;
    case 2:  // uint8
    case 3:  // int8
    case 9:  // bool
      return 1;
    case 10:  // float16
      return 2;
    default:
      return 0;
  }
}

/// Integers of a repeated field, packed or one by one.
bool add_numbers(const Field& field, std::vector<std::uint64_t>& numbers) {
  if (!field.is_bytes) return numbers.push_back(field.value), true;
  Fields packed(field.bytes);
  while (auto value = packed.packed_number()) numbers.push_back(*value);
  return !packed.is_broken();
}

/// TensorProto: dims 1, data_type 2, float_data 4, int32_data 5, int64_data 7, name 8, raw_data 9,
/// double_data 10. True where the count of numbers matches the dimensions, which OpenCV trusts.
bool is_sound_tensor(std::string_view message, std::string* name) {
  std::vector<std::uint64_t> dims, numbers;
  std::uint64_t kind = 0, given = 0;
  bool is_complete = true;
  std::optional<std::uint64_t> raw;
  is_complete &= each_field(message, [&](const Field& field) {
    if (field.number == 1) is_complete &= add_numbers(field, dims);
    if (field.number == 2) kind = field.value;
    if (field.number == 4) given += field.is_bytes ? field.bytes.size() / 4 : 1;
    if (field.number == 10) given += field.is_bytes ? field.bytes.size() / 8 : 1;
    if (field.number == 5 || field.number == 7) is_complete &= add_numbers(field, numbers);
    if (field.number == 8 && field.is_bytes && name) *name = field.bytes;
    if (field.number == 9 && field.is_bytes) raw = field.bytes.size();
  });
  std::uint64_t count = 1;
  for (const std::uint64_t n : dims) {
    if (n > kMaxNumbers || (n > 0 && count > kMaxNumbers / n)) return false;
    count *= n;
  }
  const std::uint64_t size = bytes_of(kind);
  if (!is_complete || size == 0) return false;
  return raw ? *raw == count * size : given + numbers.size() == count;
}

/// AttributeProto: name 1, i 3, t 5, ints 8. Sizes, steps and groups are at least 1.
bool is_sound_attribute(std::string_view message) {
  std::string_view name;
  std::vector<std::uint64_t> numbers;
  bool is_complete = true;
  is_complete &= each_field(message, [&](const Field& field) {
    if (field.number == 1 && field.is_bytes) name = field.bytes;
    if (field.number == 3 || field.number == 8) is_complete &= add_numbers(field, numbers);
    if (field.number == 5 && field.is_bytes) is_complete &= is_sound_tensor(field.bytes, nullptr);
  });
  const bool is_size =
      name == "kernel_shape" || name == "strides" || name == "dilations" || name == "group";
  constexpr std::uint64_t kMaxSize = 1U << 16U;
  return is_complete &&
         (!is_size || std::all_of(numbers.begin(), numbers.end(),
                                  [](std::uint64_t n) { return n >= 1 && n <= kMaxSize; }));
}

/// A graph, parsed node by node.
struct Graph {
  OnnxHeader header;
  int nodes = 0;
  bool is_sound = true;
  std::set<std::string, std::less<>> known;  // weights, inputs and outputs of earlier nodes
  std::set<std::string, std::less<>> weights;

  /// GraphProto: node 1, initializer 5, input 11, output 12.
  void read(std::string_view message) {
    // Inputs of nodes may follow them in the file.
    is_sound &= each_field(message, [&](const Field& field) {
      if (field.is_bytes && field.number == 5) add_weights(field.bytes);
      if (!field.is_bytes || (field.number != 11 && field.number != 12)) return;
      OnnxPort port;
      is_sound &= read_port(field.bytes, port);
      if (field.number == 11) known.insert(port.name);
      (field.number == 11 ? header.inputs : header.outputs).push_back(std::move(port));
    });
    is_sound &= each_field(message, [&](const Field& field) {
      if (field.is_bytes && field.number == 1) add_node(field.bytes);
    });
    std::erase_if(header.inputs,
                  [this](const OnnxPort& port) { return weights.contains(port.name); });
    for (const OnnxPort& port : header.outputs) is_sound &= known.contains(port.name);
  }

 private:
  void add_weights(std::string_view message) {
    std::string name;
    is_sound &= is_sound_tensor(message, &name) && weights.insert(name).second;
    known.insert(std::move(name));
  }
  /// NodeProto: input 1, output 2, op_type 4, attribute 5. An optional input has an empty name.
  void add_node(std::string_view message) {
    std::vector<std::string> made;
    ++nodes;
    is_sound &= each_field(message, [&](const Field& field) {
      if (!field.is_bytes) return;
      if (field.number == 1) is_sound &= field.bytes.empty() || known.contains(field.bytes);
      if (field.number == 2) made.emplace_back(field.bytes);
      if (field.number == 5) is_sound &= is_sound_attribute(field.bytes);
    });
    is_sound &= !made.empty();
    for (std::string& name : made) is_sound &= name.empty() || known.insert(std::move(name)).second;
  }
};

}  // namespace

Result<OnnxHeader> read_onnx_header(std::string_view bytes, const Where& where) {
  Graph graph;
  bool is_complete = true;
  // ModelProto: graph 7, opset_import 8 (version 2).
  is_complete &= each_field(bytes, [&](const Field& field) {
    if (!field.is_bytes) return;
    if (field.number == 7) graph.read(field.bytes);
    if (field.number != 8) return;
    is_complete &= each_field(field.bytes, [&](const Field& f) {
      if (f.number == 2 && !f.is_bytes)
        graph.header.opset =
            std::max<std::int64_t>(graph.header.opset, static_cast<int>(f.value & 0xFFFFU));
    });
  });
  if (!is_complete || !graph.is_sound || graph.nodes == 0 || graph.header.inputs.empty() ||
      graph.header.outputs.empty())
    return Error{
        en::say("this is not a network in the ONNX format, or it is incomplete or damaged"), where,
        en::say("copying or exporting the file again")};
  return std::move(graph.header);
}

namespace {

constexpr int kStride = 4;          // of the output for dots, px
constexpr float kMinLogit = -2.0F;  // probability 0.12: measuring rejects false ones
constexpr double kMinBoxScore = 0.25;
constexpr double kMaxIou = 0.45;  // intersection over union of two boxes
constexpr float kPadding = 114.0F / 255.0F;
constexpr double kLargestHalfPx = 64;

double probability(float logit) { return 1.0 / (1.0 + std::exp(-static_cast<double>(logit))); }

/// Vertex of a parabola through three neighbours, in units of their distance.
double vertex(float before, float here, float after) {
  const float bend = before - 2 * here + after;
  if (!(bend < 0)) return 0;
  return std::clamp(0.5 * static_cast<double>((before - after) / bend), -0.5, 0.5);
}

void sort_by_score(std::vector<NetworkDot>& dots) {
  std::stable_sort(dots.begin(), dots.end(),
                   [](const NetworkDot& a, const NetworkDot& b) { return a.score > b.score; });
}

/// Retains the first of those that are the same by `is_same`.
template <class Same>
std::vector<NetworkDot> without_duplicates(const std::vector<NetworkDot>& dots, Same is_same) {
  std::vector<NetworkDot> retained;
  for (const NetworkDot& dot : dots)
    if (std::none_of(retained.begin(), retained.end(),
                     [&](const NetworkDot& k) { return is_same(k, dot); }))
      retained.push_back(dot);
  return retained;
}

/// Intersection over union of two boxes.
double iou(const NetworkDot& a, const NetworkDot& b) {
  const double width =
      std::min(a.u + a.half_u, b.u + b.half_u) - std::max(a.u - a.half_u, b.u - b.half_u);
  const double height =
      std::min(a.v + a.half_v, b.v + b.half_v) - std::max(a.v - a.half_v, b.v - b.half_v);
  if (!(width > 0 && height > 0)) return 0;
  const double both = width * height;
  return both / (4 * a.half_u * a.half_v + 4 * b.half_u * b.half_v - both);
}

}  // namespace

cv::Mat dots_input(const cv::Mat& grey, InputMap* input_map) {
  int f = 1;
  const cv::Mat small = reduced_for_dots(grey, &f);
  *input_map = {1.0 / f, -0.5 * (f - 1) / f, -0.5 * (f - 1) / f};
  std::array<float, 256> root;
  for (std::size_t g = 0; g < 256; ++g) root[g] = std::sqrt(static_cast<float>(g) / 255.0F);
  const std::array<int, 4> shape{1, 1, small.rows, small.cols};
  cv::Mat input(4, shape.data(), CV_32F);
  auto* to = input.ptr<float>();
  for (int y = 0; y < small.rows; ++y) {
    const std::uint8_t* from = small.ptr<std::uint8_t>(y);
    for (int x = 0; x < small.cols; ++x) *to++ = root[from[x]];
  }
  return input;
}

cv::Mat boxes_input(const cv::Mat& grey, const cv::Size& size, int channels, InputMap* input_map) {
  const double scale = std::min(static_cast<double>(size.width) / grey.cols,
                                static_cast<double>(size.height) / grey.rows);
  const int width = std::clamp(static_cast<int>(std::lround(grey.cols * scale)), 1, size.width);
  const int height = std::clamp(static_cast<int>(std::lround(grey.rows * scale)), 1, size.height);
  const int left = (size.width - width) / 2, top = (size.height - height) / 2;
  cv::Mat small;
  cv::resize(grey, small, cv::Size(width, height), 0, 0,
             scale < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
  // Box coordinates count from the corner of the first pixel, image coordinates from its centre.
  *input_map = {scale, left + 0.5 * scale, top + 0.5 * scale};
  const std::array<int, 4> shape{1, channels, size.height, size.width};
  cv::Mat input(4, shape.data(), CV_32F, cv::Scalar(kPadding));
  for (int c = 0; c < channels; ++c) {
    cv::Mat plane(size, CV_32F, input.ptr<float>(0, c));
    small.convertTo(plane(cv::Rect(left, top, width, height)), CV_32F, 1.0 / 255.0);
  }
  return input;
}

std::vector<NetworkDot> dots_of(const cv::Mat& output, const InputMap& input_map) {
  const int height = output.size[2], width = output.size[3];
  const auto plane = [&](int channel) {
    return cv::Mat(height, width, CV_32F, const_cast<float*>(output.ptr<float>(0, channel)));
  };
  const cv::Mat logits = plane(0), wide = plane(1), high = plane(2);
  const auto extent = [&](float logarithm) {
    return std::clamp(std::exp(static_cast<double>(logarithm)), 0.5, kLargestHalfPx) /
           input_map.scale;
  };
  std::vector<NetworkDot> dots;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float here = logits.at<float>(y, x);
      if (here < kMinLogit || !is_peak<float>(logits, x, y)) continue;
      double cell_x = x, cell_y = y;
      if (x > 0 && x + 1 < width)
        cell_x += vertex(logits.at<float>(y, x - 1), here, logits.at<float>(y, x + 1));
      if (y > 0 && y + 1 < height)
        cell_y += vertex(logits.at<float>(y - 1, x), here, logits.at<float>(y + 1, x));
      dots.push_back({input_map.u(kStride * cell_x), input_map.v(kStride * cell_y),
                      extent(wide.at<float>(y, x)), extent(high.at<float>(y, x)),
                      probability(here)});
    }
  sort_by_score(dots);
  const double cell_px = kStride / input_map.scale;
  return without_duplicates(dots, [cell_px](const NetworkDot& a, const NetworkDot& b) {
    return std::abs(a.u - b.u) < std::max(1.5 * cell_px, a.half_u) &&
           std::abs(a.v - b.v) < std::max(1.5 * cell_px, a.half_v);
  });
}

std::vector<NetworkDot> boxes_of(const cv::Mat& output, const InputMap& input_map) {
  // The longer dimension is that of the boxes.
  const bool is_transposed = output.size[2] < output.size[1];
  const int boxes = is_transposed ? output.size[1] : output.size[2];
  const int numbers = is_transposed ? output.size[2] : output.size[1];
  const auto* values = output.ptr<float>();
  const auto at = [&](int box, int number) {
    const std::size_t row = static_cast<std::size_t>(is_transposed ? box : number);
    const std::size_t column = static_cast<std::size_t>(is_transposed ? number : box);
    return static_cast<double>(
        values[row * static_cast<std::size_t>(is_transposed ? numbers : boxes) + column]);
  };
  std::vector<NetworkDot> dots;
  for (int box = 0; box < boxes; ++box) {
    double score = 0;
    for (int number = 4; number < numbers; ++number) score = std::max(score, at(box, number));
    const double width = at(box, 2), height = at(box, 3);
    if (score < kMinBoxScore || !(width > 0 && height > 0)) continue;
    dots.push_back({input_map.u(at(box, 0)), input_map.v(at(box, 1)), 0.5 * width / input_map.scale,
                    0.5 * height / input_map.scale, std::min(score, 1.0)});
  }
  sort_by_score(dots);
  return without_duplicates(
      dots, [](const NetworkDot& a, const NetworkDot& b) { return iou(a, b) > kMaxIou; });
}

namespace {

/// Measures the dot at a detection. Detections have an accuracy of about half an output cell, which
/// may miss a thin dot. Positions slightly above and below are tried too.
std::optional<Dot> measured(const cv::Mat& grey, const SideEdges& edges, const NetworkDot& seen,
                            double sign) {
  const int u = std::clamp(static_cast<int>(std::lround(seen.u)), 0, grey.cols - 1);
  DotSeed seed;
  seed.u = seen.u;
  seed.half_u = std::max(1.0, seen.half_u);
  seed.half_v = std::max(1.0, seen.half_v);
  seed.upper = seen.v < static_cast<double>(edges.middle(u));
  seed.sign = sign;
  for (const double offset : {0.0, -1.5, 1.5}) {
    seed.v = seen.v + offset;
    auto dot = measure_dot(grey, edges, seed);
    const double far = std::max(seen.half_u, seen.half_v) + 3.0;
    if (!dot || std::hypot(dot->u - seen.u, dot->v - seen.v) > far) continue;
    dot->score = seen.score;
    return dot;
  }
  return std::nullopt;
}

}  // namespace

FoundDots NetworkDotFinder::operator()(const cv::Mat& grey, const FaceShape& shape) const {
  FoundDots found;
  found.polarity = rows_.polarity == Polarity::kAuto ? Polarity::kBright : rows_.polarity;
  if (grey.type() != CV_8UC1 || grey.cols != shape.width_px() || rows_.per_row <= 0) return found;
  const auto seen = (*network_)(grey);
  if (!seen) {
    found.problem = seen.error().message();
    return found;
  }
  const SideEdges edges(shape);
  const auto dots_as = [&](Polarity polarity) {
    std::vector<Dot> dots;
    for (const NetworkDot& candidate : *seen) {
      if (!(candidate.u >= 0 && candidate.v >= 0 && candidate.u <= grey.cols - 1 &&
            candidate.v <= grey.rows - 1))
        continue;
      const auto dot = measured(grey, edges, candidate, polarity == Polarity::kBright ? 1 : -1);
      if (dot && !is_among(dots, *dot)) dots.push_back(*dot);
    }
    return dots;
  };
  found.dots = dots_as(found.polarity);
  if (rows_.polarity == Polarity::kAuto) {
    auto dark = dots_as(Polarity::kDark);
    if (dark.size() > found.dots.size())
      found.dots = std::move(dark), found.polarity = Polarity::kDark;
  }
  locate_on_finger(found.dots, shape, edges);
  return found;
}

}  // namespace alltact
