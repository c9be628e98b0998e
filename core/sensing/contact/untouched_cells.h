// How far off untouched skin may be told, cell by cell.
#pragma once

#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/depth/depth_cells.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// How far off the untouched skin of a box of cells may be told, in their middles. Each is worked
/// out when it is asked for, once.
class UntouchedCells {
 public:
  UntouchedCells(const RegionOptions& options, const cv::Size& picture, const cv::Rect& box)
      : options_(options),
        picture_(picture),
        box_(box),
        sd_(static_cast<std::size_t>(box.area())) {}

  [[nodiscard]] const UntouchedSd& at(const cv::Point& cell) {
    std::optional<UntouchedSd>& sd =
        sd_[static_cast<std::size_t>((cell.y - box_.y) * box_.width + cell.x - box_.x)];
    if (!sd) sd = told(cell);
    return *sd;
  }

 private:
  [[nodiscard]] UntouchedSd told(const cv::Point& cell) const {
    if (!options_.untouched) return {options_.noise_mm, 0.0};
    return options_.untouched(
        std::min(picture_.width - 1, cell.x * kDepthCellPx + kDepthCellPx / 2),
        std::min(picture_.height - 1, cell.y * kDepthCellPx + kDepthCellPx / 2));
  }

  const RegionOptions& options_;
  cv::Size picture_;
  cv::Rect box_;
  std::vector<std::optional<UntouchedSd>> sd_;
};

}  // namespace alltact
