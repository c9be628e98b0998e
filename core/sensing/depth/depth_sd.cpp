#include "core/sensing/depth/depth_sd.h"

#include "core/sensing/depth/smoothing.h"
#include "core/sensing/reference/image_warp.h"
#include "core/sensing/reference/reference_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace alltact {
namespace {

constexpr int kTable = 512;
constexpr double kLateralPx = 0.25;  // of edges, skin and lens together

cv::Mat nan_image(const cv::Size& size) {
  return {size, CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN())};
}

}  // namespace

double DepthErrorTerms::total() const {
  return std::sqrt(noise * noise + mapping * mapping + reference * reference + light * light +
                   lateral * lateral);
}

DepthErrorModel::DepthErrorModel(const DepthMap& depth, const Reference& reference,
                                 const FaceShape& shape, const Mapping& mapping)
    : depth_(depth),
      reference_(reference),
      shape_(shape),
      mapping_(mapping),
      reader_(reference.image),
      along_z_(mapping.parameters().along == MappingAlong::kZ
                   ? std::vector<float>(static_cast<std::size_t>(depth.depth_mm.cols), 1.0F)
                   : shape.along_z_per_normal()),
      step_mm_(mapping.depth_mm(mapping.x_max()) / kTable) {
  CV_Assert(depth.depth_mm.type() == CV_32FC1 && depth.depth_mm.size() == reference.image.size());
}

void DepthErrorModel::build_curve() {
  if (!x_.empty()) return;
  for (int i = -kTable; i <= kTable; ++i) {
    x_.push_back(mapping_.difference_at(i * step_mm_));
    slope_mm_.push_back(mapping_.slope_mm(x_.back()));
  }
}

/// x and slope at a depth of the mapping; linear beyond the table.
DepthErrorModel::At DepthErrorModel::table_curve_at(double depth_mm) const {
  const double end_mm = step_mm_ * kTable;
  if (depth_mm >= end_mm)
    return {x_.back() + (depth_mm - end_mm) / slope_mm_.back(), slope_mm_.back()};
  if (depth_mm <= -end_mm)
    return {x_.front() + (depth_mm + end_mm) / slope_mm_.front(), slope_mm_.front()};
  const double index = depth_mm / step_mm_ + kTable;
  const auto i =
      std::min(static_cast<std::size_t>(index), static_cast<std::size_t>(2 * kTable - 1));
  const double part = index - static_cast<double>(i);
  const auto between = [&](const std::vector<double>& values) {
    return values[i] + part * (values[i + 1] - values[i]);
  };
  return {between(x_), between(slope_mm_)};
}

namespace {

constexpr int kSlopePx = 3;  // on either side: over more than the noise's correlation

}  // namespace

DepthErrorModel::Level DepthErrorModel::level_from(const std::int16_t* row, int u) const {
  const auto here = static_cast<double>(row[u]);
  // Next to the face's ends only one side has values.
  int first = u, last = u;
  while (first > std::max(0, u - kSlopePx) && row[first - 1] > 0) --first;
  while (last < std::min(depth_.depth_mm.cols - 1, u + kSlopePx) && row[last + 1] > 0) ++last;
  const double per_px = (row[last] - row[first]) / (here * std::max(1, last - first));
  return {here / kGreySteps, per_px};
}

double DepthErrorModel::reference_sd(int u, int v, const Level& level) {
  const cv::Mat& sd = reference_.relative_sd;
  if (sd.empty()) return 0.0;
  const ChartWarp& warp = reference_.image.warp();
  if (u < warp.first() || u >= warp.end()) return 0.0;
  float at_u = 0, at_v = 0;
  warp.positions(v, u, 1, &at_u, &at_v);
  const cv::Point origin = reference_.image.origin();
  const int x = static_cast<int>(at_u - static_cast<float>(origin.x)) / kErrorCellPx,
            y = static_cast<int>(at_v - static_cast<float>(origin.y)) / kErrorCellPx;
  const double factor =
      reference_.image.is_first_mix(u) ? reference_.error_factor : reference_.outer_error_factor;
  const auto recorded = static_cast<double>(
      sd.at<float>(std::clamp(y, 0, sd.rows - 1), std::clamp(x, 0, sd.cols - 1)));
  const auto& registration_sd_px = reference_.registration_sd_px;
  const double moved =
      registration_sd_px.empty()
          ? 0.0
          : static_cast<double>(registration_sd_px[static_cast<std::size_t>(u)]) * level.per_px;
  return std::hypot(factor * recorded, moved);
}

void DepthErrorModel::add_lateral(int u, int v, DepthErrorTerms& causes) const {
  constexpr int kStep = 2;  // longer than the correlation of most noise
  const cv::Mat& mm = depth_.depth_mm;
  const double here = static_cast<double>(mm.at<float>(v, u));
  const auto at = [&](int du, int dv) {
    const int x = u + du * kStep, y = v + dv * kStep;
    if (x < 0 || y < 0 || x >= mm.cols || y >= mm.rows) return here;
    const auto depth = static_cast<double>(mm.at<float>(y, x));
    return std::isfinite(depth) ? depth : here;
  };
  const double left = at(-1, 0), right = at(1, 0), above = at(0, -1), below = at(0, 1);
  const auto squares = [](double a, double b) { return a * a + b * b; };
  // Subtracts the share that noise alone adds to these differences.
  const double noise = causes.noise * causes.noise;
  const double slope_square =
      std::max(0.0, squares(right - left, below - above) - 4.0 * noise) / (4.0 * kStep * kStep);
  const double bend_square =
      std::max(0.0, squares(left - 2.0 * here + right, above - 2.0 * here + below) - 12.0 * noise) /
      std::pow(kStep, 4);
  causes.per_px = std::sqrt(slope_square);
  const cv::Mat& lost = depth_.spread_removed.lost_mm;
  const double lost_mm =
      lost.empty()
          ? 0.0
          : static_cast<double>(along_z_[static_cast<std::size_t>(u)] * lost.at<float>(v, u));
  causes.lateral = std::sqrt(kLateralPx * kLateralPx * slope_square +
                             0.25 * kOpticsPx2 * kOpticsPx2 * bend_square + lost_mm * lost_mm);
}

DepthErrorModel::SpreadGain DepthErrorModel::spread_gain(int u) const {
  const SpreadRemoved& removed = depth_.spread_removed;
  if (removed.is_none()) return {};
  const auto column = static_cast<std::size_t>(u);
  return {static_cast<double>(removed.noise_gain[column]),
          static_cast<double>(removed.level_gain[column])};
}

double DepthErrorModel::spread_sd(int u, int v) const {
  const cv::Mat& sd = depth_.spread_removed.sd;
  return sd.empty() ? 0.0 : static_cast<double>(sd.at<float>(v, u));
}

DepthErrorModel::Level DepthErrorModel::level_at(int u, int v) {
  const FaceRun near{v, std::max(0, u - kSlopePx), std::min(depth_.depth_mm.cols, u + kSlopePx + 1),
                     0};
  return level_from(reader_.row(v, {&near, 1}), u);
}

/// The same without the table, which costs as much as some hundred single depths. Newton's method
/// with bracketing finds x to a millionth of the domain.
DepthErrorModel::At DepthErrorModel::solved_curve_at(double depth_mm) const {
  const double end = mapping_.x_max(), end_mm = step_mm_ * kTable;
  if (depth_mm >= end_mm) {
    const double slope_mm = mapping_.slope_mm(end);
    return {end + (depth_mm - end_mm) / slope_mm, slope_mm};
  }
  const double start = mapping_.x_min(), start_mm = mapping_.depth_mm(start);
  if (depth_mm <= start_mm) {
    const double slope_mm = mapping_.slope_mm(start);
    return {start + (depth_mm - start_mm) / slope_mm, slope_mm};
  }
  const bool is_bulge = depth_mm < 0;
  double low = is_bulge ? start : 0, high = is_bulge ? 0 : end;
  double x = is_bulge ? start * depth_mm / start_mm : end * depth_mm / end_mm;
  double slope_mm = mapping_.slope_mm(x);
  for (int step = 0; step < 20; ++step) {
    const double off_mm = mapping_.depth_mm(x) - depth_mm;
    (off_mm < 0 ? low : high) = x;
    double next = x - off_mm / slope_mm;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool is_near = std::abs(next - x) < 1e-6 * end;
    x = next;
    slope_mm = mapping_.slope_mm(x);
    if (is_near) break;
  }
  return {x, slope_mm};
}

DepthErrorTerms DepthErrorModel::causes(int u, int v, const Level& level, double depth_mm,
                                        ReadCurve read) {
  const Eigen::Vector2d position = shape_.position_mm(u, v);
  const double longer = static_cast<double>(along_z_[static_cast<std::size_t>(u)]);
  const double factor = mapping_.parameters().variation.at(position);
  const auto [x, slope_mm] = (this->*read)(depth_mm / (longer * factor));
  const double per_part = longer * factor * slope_mm;  // mm per relative brightness
  const double left = std::max(0.0, 1.0 - x);
  DepthErrorTerms causes;
  const SpreadGain gain = spread_gain(u);
  causes.noise = per_part * gain.noise * depth_.live_sd / level.here *
                 std::hypot(1.0, left * reference_.noise_gain);
  causes.mapping =
      std::hypot(longer * mapping_.depth_sd_mm(x, position), per_part * spread_sd(u, v));
  causes.reference = per_part * gain.level * left * reference_sd(u, v, level);
  causes.light = per_part * gain.level * left * depth_.light.sd_at(u, v) / depth_.light.at(u, v);
  return causes;
}

DepthErrorTerms DepthErrorModel::of_depth(int u, int v, double depth_mm) {
  const Level level = level_at(u, v);
  if (!(level.here > 0)) return {};
  DepthErrorTerms all = causes(u, v, level, depth_mm, &DepthErrorModel::solved_curve_at);
  add_lateral(u, v, all);
  return all;
}

UntouchedSd DepthErrorModel::untouched(int u, int v) {
  const Level level = level_at(u, v);
  if (!(level.here > 0)) return {};
  const double per_part = static_cast<double>(along_z_[static_cast<std::size_t>(u)]) *
                          mapping_.parameters().variation.at(shape_.position_mm(u, v)) *
                          mapping_.slope_mm(0.0);
  const SpreadGain gain = spread_gain(u);
  return {
      per_part * gain.noise * depth_.live_sd / level.here * std::hypot(1.0, reference_.noise_gain),
      per_part * gain.level *
          std::hypot(reference_sd(u, v, level), depth_.light.sd_at(u, v) / depth_.light.at(u, v))};
}

cv::Mat depth_sd_mm(const DepthMap& depth, const Reference& reference, const FaceShape& shape,
                    const Mapping& mapping) {
  DepthErrorModel error(depth, reference, shape, mapping);
  cv::Mat sd = nan_image(depth.depth_mm.size());
  for (int v = 0; v < sd.rows; ++v)
    error.row(v, [row = sd.ptr<float>(v)](int u, const DepthErrorTerms& causes) {
      row[u] = static_cast<float>(causes.total());
    });
  return sd;
}

std::vector<NamedSdMap> depth_sd_by_cause(const DepthMap& depth, const Reference& reference,
                                          const FaceShape& shape, const Mapping& mapping) {
  DepthErrorModel error(depth, reference, shape, mapping);
  std::vector<NamedSdMap> maps;
  for (const char* name : {"noise", "mapping", "reference", "light", "lateral"})
    maps.push_back({name, nan_image(depth.depth_mm.size())});
  for (int v = 0; v < depth.depth_mm.rows; ++v)
    error.row(v, [&](int u, const DepthErrorTerms& causes) {
      std::size_t next = 0;
      for (const double sd :
           {causes.noise, causes.mapping, causes.reference, causes.light, causes.lateral})
        maps[next++].sd_mm.at<float>(v, u) = static_cast<float>(sd);
    });
  return maps;
}

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

DepthSdAndLimits depth_sd_and_limits(const DepthMap& depth, const Reference& reference,
                                     const FaceShape& shape, const Mapping& mapping) {
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
