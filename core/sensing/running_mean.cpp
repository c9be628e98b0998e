#include "core/sensing/running_mean.h"

namespace alltact {

cv::Mat RunningMean::operator()(const cv::Mat& grey) {
  if (max_frames_ == 1) return grey;
  if (!last_.empty() && last_.front().size() != grey.size()) forget();
  if (last_.empty()) sum_ = cv::Mat::zeros(grey.size(), CV_16UC1);
  if (last_.size() == max_frames_) {
    cv::subtract(sum_, last_.front(), sum_, cv::noArray(), CV_16U);
    last_.pop_front();
  }
  cv::add(sum_, grey, sum_, cv::noArray(), CV_16U);
  last_.push_back(grey);
  cv::Mat mean;
  sum_.convertTo(mean, CV_8U, 1.0 / static_cast<double>(last_.size()));
  return mean;
}

}  // namespace alltact
