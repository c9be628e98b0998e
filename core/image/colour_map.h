// Perceptually uniform colour maps for figures, also in grey and for colour-blind people.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace alltact {

struct MapColour {
  std::uint8_t red, green, blue;
};

/// viridis on 0 to 1; `part` is clamped.
[[nodiscard]] MapColour viridis(double part);

/// Diverging map on -1 (blue), 0 (light grey) and 1 (red), for differences (Moreland's cool to
/// warm); clamped.
[[nodiscard]] MapColour cool_to_warm(double part);

/// Range of the colours for bulges, relative to that for presses: 0.1 mm of bulge shows on a scale
/// for presses of 1.5 mm.
inline constexpr double kBulgeFraction = 0.25;
/// Map for depth relative to the top of its scale. Untouched skin, 0, is neutral grey. Above it are
/// blue, green and yellow, the upper three quarters of viridis. Below it, where skin bulges, are
/// red and light pink down to -kBulgeFraction. Lightness rises in both directions, so zero is the
/// darkest; clamped.
[[nodiscard]] MapColour depth_colour(double part);

/// Colours of values beyond the ends of every scale; no map contains them.
inline constexpr MapColour kBelowScale{0, 225, 255}, kAboveScale{238, 0, 190};

/// The first colour for `low_mm`, the last for `top_mm`.
struct ColourScale {
  double low_mm = 0, top_mm = 1;
  MapColour (*colour)(double part) = viridis;  ///< on [0, 1]
  int steps = 4;                               ///< number of intervals between labels

  /// Decimals, at least 2, that write each of so many evenly spaced labels as it is; at most 5.
  [[nodiscard]] int label_decimals(int labels) const;
  /// kBelowScale and kAboveScale more than half a 255th of the scale beyond its ends.
  [[nodiscard]] MapColour colour_at(double mm) const;
};

/// The colours of a scale for maps of many values.
class ColourTable {
 public:
  explicit ColourTable(const ColourScale& scale);
  /// As ColourScale::colour_at(), within half a 255th of the scale; not for NaN.
  [[nodiscard]] MapColour operator()(float mm) const {
    const float step = (mm - low_mm_) * per_mm_ + 1.5F;
    return colours_[static_cast<std::size_t>(std::clamp(step, 0.0F, kSteps + 1.0F))];
  }

 private:
  static constexpr int kSteps = 256;
  float low_mm_, per_mm_;
  std::array<MapColour, kSteps + 2> colours_;  // below, the scale's, above
};

/// The depth scale begins at -kBulgeFraction top_mm, as depth_colour(). The difference scale begins
/// at -top_mm, with light grey in the middle.
[[nodiscard]] ColourScale depth_scale(double top_mm);
[[nodiscard]] ColourScale difference_scale(double top_mm);

}  // namespace alltact
