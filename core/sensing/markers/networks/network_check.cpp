#include "core/sensing/markers/networks/network_check.h"

#include "core/yaml/yaml_reader.h"

#include <cmath>

namespace alltact {

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
    return Error{std::move(what),
                 onnx,
                 en::say("the network and its .yaml of the same training, or exporting it with "
                         "opset 11 or 12")};
  };
  if (count != output.size())
    return refused(
        en::say("the network gives {} numbers where its .yaml has {}", count, output.size()));
  const auto* values = got.ptr<float>();
  double max_error = 0;
  for (std::size_t k = 0; k < count; ++k)
    max_error = std::max(max_error, std::abs(static_cast<double>(values[k * step]) - output[k]));
  if (max_error <= tolerance) return {};
  return refused(
      en::say("on a known picture the network gives numbers that are up to {:.3g} off what its "
              ".yaml says, and {:.3g} is allowed",
              max_error,
              tolerance));
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

}  // namespace alltact
