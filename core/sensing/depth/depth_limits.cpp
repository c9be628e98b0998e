#include "core/sensing/depth/depth_limits.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace alltact {

std::vector<std::string_view> limit_names(std::uint8_t limits) {
  static constexpr std::array<std::pair<DepthLimit, std::string_view>, 5> kNames{
      {{kLayerLimit, "layer_limit"},
       {kBulgeTop, "bulge_limit"},
       {kOutOfRange, "out_of_range"},
       {kSteep, "steep"},
       {kDoubtfulLight, "doubtful_light"}}};
  std::vector<std::string_view> names;
  for (const auto& [bit, name] : kNames)
    if ((limits & bit) != 0) names.push_back(name);
  return names;
}

std::uint8_t limit_of_flag(std::uint8_t flag) {
  switch (flag) {
    case kBeyondLayer:
      return kLayerLimit;
    case kBulgeLimit:
      return kBulgeTop;
    case kExtrapolated:
      return kOutOfRange;
    default:
      return kNoLimit;
  }
}

bool is_light_doubtful(const DepthMap& depth) {
  return depth.is_light_unknown || std::abs(depth.light.change()) > kMaxLightChange;
}

std::uint8_t limits_of(const DepthErrorTerms& causes, bool is_doubtful) {
  // smaller values do not matter: corners of every face have some
  constexpr double kMinLightMm = 0.02;
  std::uint8_t limits = kNoLimit;
  const double total = causes.total();
  if (causes.per_px > total) limits |= kSteep;
  const bool is_mainly_light = 2 * causes.light * causes.light > total * total;
  if (is_doubtful || (is_mainly_light && causes.light > kMinLightMm)) limits |= kDoubtfulLight;
  return limits;
}

DepthSdAndLimits depth_sd_and_limits(const DepthMap& depth,
                                     const Reference& reference,
                                     const FaceShape& shape,
                                     const Mapping& mapping) {
  const cv::Size size = depth.depth_mm.size();
  DepthSdAndLimits made{
      cv::Mat(size, CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN())),
      cv::Mat::zeros(size, CV_8UC1)};
  const bool is_doubtful = is_light_doubtful(depth);
  DepthErrorModel error(depth, reference, shape, mapping);
  for (int v = 0; v < size.height; ++v) {
    auto* sd = made.sd_mm.ptr<float>(v);
    auto* limits = made.limits.ptr<std::uint8_t>(v);
    const auto* flags = depth.flags.ptr<std::uint8_t>(v);
    error.row(v, [&](int u, const DepthErrorTerms& causes) {
      sd[u] = static_cast<float>(causes.total());
      limits[u] =
          static_cast<std::uint8_t>(limit_of_flag(flags[u]) | limits_of(causes, is_doubtful));
    });
  }
  return made;
}

}  // namespace alltact
