// Pictures whose memory comes back: a frame's results are as large as the last frame's.
#pragma once

#include <cstring>

#include <opencv2/core.hpp>

namespace alltact {

/// A picture of undefined content from a store that all threads share. Its memory returns to the
/// store when the last cv::Mat that holds it goes, and the next picture of the same size takes it:
/// pages fresh from the system cost more than the work done on them (0.25 us each, several thousand
/// a frame at 1920x1080). At most 256 MB wait in the store.
[[nodiscard]] cv::Mat pooled_picture(const cv::Size& size, int type);

/// NaN, by the one bit pattern that is the same byte four times: as fast as memory takes it.
inline void fill_nan(float* values, int count) {
  std::memset(values, 0xFF, static_cast<std::size_t>(count) * sizeof(float));
}

}  // namespace alltact
