// How noisy a picture is, from the picture itself.
#pragma once

#include <opencv2/core.hpp>

namespace alltact {

/// Standard deviation of the noise of a CV_8UC1 picture in grey levels, from second differences
/// along every 16th row, which smooth content leaves alone; differences beyond 3 sd (dots, edges)
/// do not count, nor do pixels at the floor or the ceiling. At least that of quantisation
/// (1/sqrt(12)), which is also returned when too few pixels qualify.
[[nodiscard]] double picture_noise_sd(const cv::Mat& grey);

}  // namespace alltact
