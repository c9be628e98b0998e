#include "core/image/colour_map.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

/// Linear interpolation between equidistant stops; part in [0, 1].
template <std::size_t kCount>
MapColour between(const std::array<MapColour, kCount>& stops, double part) {
  const double at = std::clamp(std::isfinite(part) ? part : 0.0, 0.0, 1.0) * (kCount - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kCount - 2);
  const double share = at - static_cast<double>(low);
  const auto mix = [&](std::uint8_t MapColour::*channel) {
    const double a = stops[low].*channel, b = stops[low + 1].*channel;
    return static_cast<std::uint8_t>(std::lround(a + share * (b - a)));
  };
  return {mix(&MapColour::red), mix(&MapColour::green), mix(&MapColour::blue)};
}

}  // namespace

MapColour viridis(double part) {
  // Every sixteenth of matplotlib's table; linear between, at most two levels from it.
  static constexpr std::array<MapColour, 17> kStops{{{68, 1, 84},
                                                     {72, 24, 106},
                                                     {71, 45, 123},
                                                     {66, 64, 134},
                                                     {59, 82, 139},
                                                     {51, 99, 141},
                                                     {44, 114, 142},
                                                     {38, 130, 142},
                                                     {33, 145, 140},
                                                     {31, 160, 136},
                                                     {40, 174, 128},
                                                     {63, 188, 115},
                                                     {94, 201, 98},
                                                     {132, 212, 75},
                                                     {173, 220, 48},
                                                     {216, 226, 25},
                                                     {253, 231, 37}}};
  return between(kStops, part);
}

MapColour cool_to_warm(double part) {
  // Every eighth of Moreland's table (Diverging Color Maps for Scientific Visualization, 2009).
  static constexpr std::array<MapColour, 9> kStops{{{59, 76, 192},
                                                    {98, 130, 234},
                                                    {141, 176, 254},
                                                    {184, 208, 249},
                                                    {221, 221, 221},
                                                    {245, 196, 173},
                                                    {244, 154, 123},
                                                    {222, 96, 77},
                                                    {180, 4, 38}}};
  return between(kStops, 0.5 + 0.5 * (std::isfinite(part) ? part : 0.0));
}

MapColour depth_colour(double part) {
  // As dark as the colours next to it.
  constexpr MapColour kUntouched{78, 78, 80};
  static constexpr std::array<MapColour, 6> kBulge{
      {kUntouched, {135, 56, 74}, {177, 56, 94}, {222, 84, 101}, {249, 145, 131}, {255, 208, 190}}};
  if (part < 0) return between(kBulge, -part / kBulgeFraction);
  constexpr double kFirst = 0.25;  // of viridis
  constexpr double kGreyUpTo = 0.06;
  const MapColour colour = viridis(kFirst + (1 - kFirst) * std::max(part, kGreyUpTo));
  return between(std::array<MapColour, 2>{kUntouched, colour}, part / kGreyUpTo);
}

int ColourScale::label_decimals(int labels) const {
  constexpr int kMin = 2, kMax = 5;
  constexpr double kExact = 1e-6;  // units of the last decimal
  const double step_mm = (top_mm - low_mm) / std::max(1, labels - 1);
  for (int decimals = kMin; decimals < kMax; ++decimals) {
    const double unit = std::pow(10.0, decimals);
    const auto is_exact = [&](double mm) {
      return std::abs(mm * unit - std::round(mm * unit)) < kExact;
    };
    if (is_exact(low_mm) && is_exact(step_mm)) return decimals;
  }
  return kMax;
}

MapColour ColourScale::colour_at(double mm) const {
  constexpr double kHalfStep = 0.5 / 255;
  const double part = (mm - low_mm) / (top_mm - low_mm);
  if (part < -kHalfStep) return kBelowScale;
  if (part > 1 + kHalfStep) return kAboveScale;
  return colour(std::clamp(part, 0.0, 1.0));
}

ColourTable::ColourTable(const ColourScale& scale)
    : low_mm_(static_cast<float>(scale.low_mm)),
      per_mm_(static_cast<float>((kSteps - 1) / (scale.top_mm - scale.low_mm))) {
  colours_.front() = kBelowScale;
  for (int i = 0; i < kSteps; ++i)
    colours_[static_cast<std::size_t>(i) + 1] = scale.colour(static_cast<double>(i) / (kSteps - 1));
  colours_.back() = kAboveScale;
}

ColourScale depth_scale(double top_mm) {
  return {-kBulgeFraction * top_mm, top_mm,
          [](double part) { return depth_colour((1 + kBulgeFraction) * part - kBulgeFraction); },
          5};
}

ColourScale difference_scale(double top_mm) {
  return {-top_mm, top_mm, [](double part) { return cool_to_warm(2 * part - 1); }, 2};
}

}  // namespace alltact
