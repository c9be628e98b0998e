#include "core/sensing/markers/networks/dot_network.h"

#include "core/io/atomic_file.h"
#include "core/sensing/markers/networks/network_check.h"
#include "core/sensing/markers/networks/network_dots.h"
#include "core/sensing/markers/networks/onnx_header.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>

namespace alltact {
namespace {

constexpr std::size_t kMaxNetworkBytes = std::size_t{256} << 20;
constexpr std::int64_t kMinSide = 32, kMaxSide = 4096;  // side of the input, px

enum class NetworkKind { kDots = 1, kBoxes };

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
  return Error{std::move(what),
               onnx,
               en::say("a network exported with fixed sizes, one picture at a time and opset 11 or "
                       "12, or --marker-network own")};
}

std::string shape_text(const std::vector<std::int64_t>& shape) {
  std::string text;
  for (const std::int64_t n : shape)
    text += (text.empty() ? "" : " x ") + (n > 0 ? fmt::format("{}", n) : std::string("?"));
  return text.empty() ? "?" : text;
}

std::vector<std::int64_t> shape_of(const cv::Mat& m) {
  return {m.size.p, m.size.p + m.dims};
}

bool is_finite(const cv::Mat& m) {
  const auto* values = m.ptr<float>();
  return std::all_of(values, values + m.total(), [](float x) { return std::isfinite(x); });
}

}  // namespace

struct DotNetwork::Impl {
  std::filesystem::path onnx;
  NetworkKind kind = NetworkKind::kDots;
  cv::Size size;  // of the input
  int channels = 1;
  cv::dnn::Net net;

  [[nodiscard]] bool is_output(const cv::Mat& m, const cv::Mat& input) const;
  [[nodiscard]] Result<cv::Mat> run(const cv::Mat& input);
  [[nodiscard]] cv::Mat input_of(const cv::Mat& grey, InputMap* input_map) const {
    return kind == NetworkKind::kDots ? dots_input(grey, input_map)
                                      : boxes_input(grey, size, channels, input_map);
  }
  [[nodiscard]] Status check();
};

bool DotNetwork::Impl::is_output(const cv::Mat& m, const cv::Mat& input) const {
  if (m.type() != CV_32F || !m.isContinuous()) return false;
  if (kind == NetworkKind::kDots)
    return m.dims == 4 && m.size[0] == 1 && m.size[1] == 3 &&
           m.size[2] == (input.size[2] + 3) / 4 && m.size[3] == (input.size[3] + 3) / 4;
  return m.dims == 3 && m.size[0] == 1 && std::min(m.size[1], m.size[2]) >= 5;
}

Result<cv::Mat> DotNetwork::Impl::run(const cv::Mat& input) {
  std::vector<cv::Mat> outputs;
  try {
    const QuietOpenCv quiet;
    net.setInput(input);
    net.forward(outputs, net.getUnconnectedOutLayersNames());
  } catch (const std::exception&) {
    return unusable(en::say("OpenCV cannot run this network"), onnx);
  }
  // Selected by shape: OpenCV returns several outputs in an order of its own.
  const auto output = std::find_if(
      outputs.begin(), outputs.end(), [&](const cv::Mat& m) { return is_output(m, input); });
  if (output == outputs.end())
    return unusable(
        en::say("this network makes {} of {}, which are neither dots nor boxes",
                outputs.empty() ? std::string("nothing") : shape_text(shape_of(outputs.front())),
                shape_text(shape_of(input))),
        onnx);
  if (!is_finite(*output))
    return unusable(en::say("this network gives numbers that are not finite"), onnx);
  return *output;
}

Status DotNetwork::Impl::check() {
  auto yaml = onnx;
  const auto expected = NetworkCheck::load(yaml.replace_extension(".yaml"));
  if (!expected) return expected.error();
  if (kind == NetworkKind::kDots && !*expected)
    return Error{en::say("the file that says what this network must give is not there"),
                 yaml,
                 en::say("training it again, which writes both")};
  const cv::Size own = *expected ? (*expected)->image_size : size;
  if (kind == NetworkKind::kBoxes && own != size)
    return Error{en::say("the picture must be as large as what the network takes, {} x {}",
                         size.width,
                         size.height),
                 yaml,
                 ""};
  InputMap input_map;
  const auto got = run(input_of(check_image(own), &input_map));
  if (!got) return got.error();
  return *expected ? (*expected)->holds(*got, onnx) : Status();
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
      std::max(in[2], in[3]) > kMaxSide)
    return unusable(en::say("this network takes {}, not one picture of 1 or 3 channels and a fixed "
                            "size of {} to {} px a side",
                            shape_text(in),
                            kMinSide,
                            kMaxSide),
                    onnx);
  auto impl = std::make_unique<Impl>();
  impl->onnx = onnx;
  impl->channels = static_cast<int>(in[1]);
  impl->size = {static_cast<int>(in[3]), static_cast<int>(in[2])};
  const bool has_dots =
      std::any_of(header->outputs.begin(), header->outputs.end(), [](const OnnxPort& port) {
        return port.shape.size() == 4 && port.shape[1] == 3;
      });
  impl->kind = has_dots && in[1] == 1 ? NetworkKind::kDots : NetworkKind::kBoxes;
  try {
    const QuietOpenCv quiet;
    impl->net = cv::dnn::readNetFromONNX(bytes->data(), bytes->size());
    impl->net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    // With fusion OpenCV 4.6 computes YOLO11's attention wrongly without an error.
    impl->net.enableFusion(impl->kind == NetworkKind::kDots);
  } catch (const std::exception&) {
    return unusable(
        en::say("OpenCV cannot read this network (opset {}; it knows those up to 12 well)",
                header->opset),
        onnx);
  }
  if (const Status status = impl->check(); !status) return status.error();
  return DotNetwork(std::move(impl));
}

Result<std::vector<NetworkDot>> DotNetwork::operator()(const cv::Mat& grey) {
  InputMap input_map;
  const auto output = impl_->run(impl_->input_of(grey, &input_map));
  if (!output) return output.error();
  return impl_->kind == NetworkKind::kDots ? dots_of(*output, input_map)
                                           : boxes_of(*output, input_map);
}

DotNetwork::DotNetwork(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
DotNetwork::DotNetwork(DotNetwork&&) noexcept = default;
DotNetwork& DotNetwork::operator=(DotNetwork&&) noexcept = default;
DotNetwork::~DotNetwork() = default;

}  // namespace alltact
