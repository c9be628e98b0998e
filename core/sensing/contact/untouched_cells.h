// Errors of the depth of contact-free skin, cell by cell.
#pragma once

#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/depth/depth_cells.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Errors of the depth in the middles of a box of cells without contact. Each is computed once, on
/// request.
class UntouchedCells {
 public:
  UntouchedCells(const RegionOptions& options, const cv::Size& image_size, const cv::Rect& box)
      : options_(options),
        image_size_(image_size),
        box_(box),
        sd_(static_cast<std::size_t>(box.area())) {}

  [[nodiscard]] const UntouchedSd& at(const cv::Point& cell) {
    std::optional<UntouchedSd>& sd =
        sd_[static_cast<std::size_t>((cell.y - box_.y) * box_.width + cell.x - box_.x)];
    if (!sd) sd = estimate(cell);
    return *sd;
  }

 private:
  [[nodiscard]] UntouchedSd estimate(const cv::Point& cell) const {
    if (!options_.untouched) return {options_.noise_mm, 0.0};
    return options_.untouched(
        std::min(image_size_.width - 1, cell.x * kDepthCellPx + kDepthCellPx / 2),
        std::min(image_size_.height - 1, cell.y * kDepthCellPx + kDepthCellPx / 2));
  }

  const RegionOptions& options_;
  cv::Size image_size_;
  cv::Rect box_;
  std::vector<std::optional<UntouchedSd>> sd_;
};

}  // namespace alltact
