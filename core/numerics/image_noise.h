// Noise of an image, estimated from the image itself.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <opencv2/core.hpp>

namespace alltact {

/// Standard deviation of the noise of a CV_8UC1 image in grey levels, from second differences along
/// every 16th row, which suppress smooth content. Differences beyond 3 sd (dots, edges) do not
/// count, nor do pixels at the floor or the ceiling. At least that of quantisation (1/sqrt(12)),
/// which is also returned when too few pixels qualify.
[[nodiscard]] double image_noise_sd(const cv::Mat& grey);

/// Standard deviation, grey levels, of normal differences with outliers: from those within 3 sd,
/// corrected for the cut. `histogram`: counts of the magnitudes 0, 1, 2, ... grey levels. At least
/// 0.5; nullopt: fewer than 100 within 3 sd.
[[nodiscard]] std::optional<double> sd_of_differences(std::span<const std::int64_t> histogram);

}  // namespace alltact
