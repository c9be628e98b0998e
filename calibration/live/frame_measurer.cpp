#include "calibration/live/frame_measurer.h"

#include "calibration/finger/measuring_settings.h"
#include "calibration/finger/paper_pipeline.h"
#include "core/sensing/depth/depth_sd.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

MeasuredFrame measured_by(const FingerSnapshot& finger,
                          const PipelineSettings& settings,
                          FrameResult result) {
  MeasuredFrame frame;
  frame.result = std::move(result);
  frame.face = finger.finger.face;
  frame.camera = frame.result.shape ? frame.result.shape->camera() : finger.camera;
  frame.is_calibrated = finger.mapping.has_value();
  frame.mapping = finger.mapping;
  frame.smoothing_px = settings.smoothing_px;
  const FrameResult& first = frame.result;
  if (!finger.mapping || !first.depth || !first.shape || !first.reference) return frame;
  frame.sd_mm = depth_sd_mm(*first.depth, *first.reference, *first.shape, *finger.mapping);
  return frame;
}

}  // namespace

cv::Mat depth_difference_mm(const MeasuredFrame& frame) {
  const cv::Mat& ours = frame.result.depth->depth_mm;
  cv::Mat other = frame.other->depth->depth_mm;
  if (other.size() != ours.size())  // ours is reduced: beside what lies in its pixels' middles
    cv::resize(other, other, ours.size(), 0, 0, cv::INTER_NEAREST);
  return ours - other;
}

Status FrameMeasurer::load_finger(const std::filesystem::path& folder, const Job& job) {
  if (folder != folder_) store_ = folder.empty() ? nullptr : FingerStore::of(folder);
  const auto finger = store_ ? store_->snapshot() : Result<FingerPtr>(Error());
  const bool is_as_before = finger && finger_ && (*finger)->revision == finger_->revision &&
                            (*finger)->measuring == finger_->measuring;
  if (folder == folder_ && first_ && is_as_before) return {};
  folder_ = folder;
  finger_.reset();
  first_.reset();
  other_.reset();
  last_.reset();
  if (folder.empty())
    return Error{en::say("no finger is open, so the recording cannot be measured"),
                 "",
                 en::say("opening a finger")};
  if (!finger) return finger.error();
  auto pipeline = Pipeline::create(**finger, measuring_settings(folder), job);
  if (!pipeline) return pipeline.error();
  finger_ = *finger;
  first_ = std::move(*pipeline);
  return {};
}

Status FrameMeasurer::open_other(const Job& job) {
  if (other_) return {};
  auto pipeline = paper_pipeline(*finger_, job);
  if (!pipeline) return pipeline.error();
  other_ = std::move(*pipeline);
  return {};
}

Status FrameMeasurer::open_recording(const std::filesystem::path& input, const Job& job) {
  if (input == input_ && frames_) return {};
  input_ = input;
  frames_.reset();
  last_.reset();
  std::error_code ignored;
  if (!std::filesystem::exists(input, ignored))
    return Error{en::say("this recording is not there any more"),
                 input.string(),
                 en::say("plugging in the disk it lies on, or opening another one")};
  auto frames = RecordedFrames::open(input, job);
  if (!frames) return frames.error();
  frames_ = std::move(*frames);
  times_ns_ = frames_->times_ns();
  return {};
}

RecordingInfo FrameMeasurer::recording() const {
  return {input_, frames_->count(), frames_->frames_per_s(), times_ns_};
}

void FrameMeasurer::measure_by_other(MeasuredFrame& frame, bool is_next, const Job& job) {
  if (const Status status = open_other(job); !status) {
    frame.other_problem = status.error();
    return;
  }
  if (!is_next) other_->forget();
  auto result = (*other_)(frame.result.frame);
  if (result) frame.other = std::move(*result);
}

Result<MeasuredFrame> FrameMeasurer::measure(std::size_t number,
                                             OtherMethod other,
                                             const Job& job) {
  number = std::min(number, frames_->count() - 1);
  auto picture = frames_->frame(number);
  if (!picture) return picture.error();
  const bool is_next = frames_->is_continuous() && last_ && *last_ + 1 == number;
  if (!is_next) first_->forget();
  auto result = (*first_)(*picture);
  if (!result) return result.error();
  last_ = number;
  MeasuredFrame frame = measured_by(*finger_, first_->settings(), std::move(*result));
  frame.number = number;
  if (other == OtherMethod::kPaper) measure_by_other(frame, is_next, job);
  return frame;
}

Result<MeasuredFrame> FrameMeasurer::complete(const FrameResult& live,
                                              const Finger& finger,
                                              const std::filesystem::path& folder,
                                              OtherMethod other,
                                              const Job& job) {
  const auto snapshot = FingerSnapshot::of(folder, finger);
  if (!snapshot) return snapshot.error();
  last_.reset();
  MeasuredFrame frame = measured_by(
      *snapshot, folder.empty() ? PipelineSettings{} : measuring_settings(folder), live);
  if (other == OtherMethod::kPaper && !folder.empty()) {
    if (const Status status = load_finger(folder, job); !status) return status.error();
    measure_by_other(frame, false, job);
  }
  return frame;
}

}  // namespace alltact
