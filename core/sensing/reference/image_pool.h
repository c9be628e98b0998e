// Pool of image memory: a frame's results are as large as the last frame's.
#pragma once

#include <cstring>

#include <opencv2/core.hpp>

namespace alltact {

/// An image of undefined content from a pool that all threads share. Its memory returns to the pool
/// with the last cv::Mat that refers to it, for the next image of the same size. Fresh pages from
/// the system cost more than the work done on them (0.25 us each, several thousand per frame at
/// 1920x1080). At most 256 MB stay idle in the pool.
[[nodiscard]] cv::Mat pooled_image(const cv::Size& size, int type);

/// Fills with the NaN whose four bytes are equal: as fast as the memory.
inline void fill_nan(float* values, int count) {
  std::memset(values, 0xFF, static_cast<std::size_t>(count) * sizeof(float));
}

}  // namespace alltact
