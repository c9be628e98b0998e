// How many threads OpenCV may use.
#pragma once

#include <opencv2/core/utility.hpp>

namespace alltact {

inline void set_opencv_threads([[maybe_unused]] int threads) {
#if defined(__SANITIZE_THREAD__)
  cv::setNumThreads(1);  // it cannot see how TBB's threads hand memory over
#else
  cv::setNumThreads(threads);
#endif
}

}  // namespace alltact
