#include "calibration/live/frame_measurer.h"

#include "calibration/finger/measuring_presets.h"
#include "calibration/finger/paper_pipeline.h"
#include "calibration/live/body_comparison.h"
#include "calibration/presses/press_bodies.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/surface_measurement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

MeasuredFrame measured_by(const FingerSnapshot& finger, const PipelineSettings& settings,
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
  DepthSdAndLimits made =
      depth_sd_and_limits(*first.depth, *first.reference, *first.shape, *finger.mapping);
  frame.sd_mm = std::move(made.sd_mm);
  frame.limits = std::move(made.limits);
  return frame;
}

/// Pixel by pixel; the image sizes may differ.
cv::Mat difference_of(const FrameResult& own, const FrameResult& other) {
  cv::Mat depth = other.depth->depth_mm;
  if (depth.size() != own.depth->depth_mm.size())  // from the pixels' middles
    cv::resize(depth, depth, own.depth->depth_mm.size(), 0, 0, cv::INTER_NEAREST);
  return own.depth->depth_mm - depth;
}

/// At the same positions on the face.
cv::Mat difference_on_face(const FrameResult& own, const FrameResult& other) {
  const cv::Mat& depth = own.depth->depth_mm;
  cv::Mat difference(depth.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  for (int v = 0; v < depth.rows; ++v) {
    const auto* from = depth.ptr<float>(v);
    auto* to = difference.ptr<float>(v);
    for (int u = 0; u < depth.cols; ++u) {
      if (!std::isfinite(from[u])) continue;
      if (const auto at = pixel_of_position(*other.shape, own.shape->position_mm(u, v)))
        to[u] = from[u] - bilinear_value(other.depth->depth_mm, at->x(), at->y());
    }
  }
  return difference;
}

}  // namespace

Result<Pipeline> measuring_pipeline(const FingerSnapshot& finger, const PipelineSettings& settings,
                                    const Job& job) {
  if (finger.folder.empty() || !finger.finger.reference)
    return Pipeline::without_reference(finger, settings);
  return Pipeline::create(finger, settings, job);
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
  other_frame_.reset();
  last_.reset();
  if (folder.empty())
    return Error{en::say("no finger is open, so the recording cannot be measured"), "",
                 en::say("opening a finger")};
  if (!finger) return finger.error();
  auto pipeline = measuring_pipeline(**finger, measuring_settings(folder), job);
  if (!pipeline) return pipeline.error();
  finger_ = *finger;
  first_ = std::move(*pipeline);
  return {};
}

Result<Pipeline> FrameMeasurer::other_pipeline(const ComparisonSpec& other, const Job& job) const {
  if (other.method == OtherMethod::kPaper) return paper_pipeline(*finger_, job);
  if (other.method == OtherMethod::kFinger) {
    const auto finger = FingerStore::of(other.finger)->snapshot();
    if (!finger) return finger.error();
    if (!(*finger)->finger.mapping)
      return Error{en::say("the other finger is not calibrated yet"), other.finger,
                   en::say("calibrating it, or choosing another one")};
    return measuring_pipeline(**finger, measuring_settings(other.finger), job);
  }
  PipelineSettings settings = measuring_settings(folder_);
  for (const auto& setting : pipeline_settings())
    if (setting.name == other.setting)
      if (const Status status = setting.set(settings, other.value); !status) return status.error();
  return measuring_pipeline(*finger_, settings, job);
}

Status FrameMeasurer::open_other(const ComparisonSpec& other, const Job& job) {
  ComparisonSpec what = other;  // whatever it measures
  what.frame = 0;
  what.file.clear();
  if (other_ && other_comparison_ == what) return {};
  other_.reset();
  auto pipeline = other_pipeline(other, job);
  if (!pipeline) return pipeline.error();
  other_ = std::move(*pipeline);
  other_comparison_ = what;
  return {};
}

Status FrameMeasurer::open_recording(const std::filesystem::path& input, const Job& job) {
  if (input == input_ && frames_) return {};
  input_ = input;
  frames_.reset();
  other_frame_.reset();
  last_.reset();
  std::error_code ignored;
  if (!std::filesystem::exists(input, ignored))
    return Error{en::say("this recording no longer exists"), input.string(),
                 en::say("plugging in its disk, or opening another one")};
  auto frames = RecordedFrames::open(input, job);
  if (!frames) return frames.error();
  frames_ = std::move(*frames);
  times_ns_ = frames_->times_ns();
  return {};
}

RecordingInfo FrameMeasurer::recording() const {
  return {input_, frames_->count(), frames_->frames_per_s(), times_ns_};
}

/// Uses the pipeline of all frames, and announces that others follow; that of another finger for
/// its frame.
Result<FrameResult> FrameMeasurer::measure_other_frame(const ComparisonSpec& other,
                                                       const Job& job) {
  if (other_frame_ && other_frame_of_ == other) return *other_frame_;
  other_frame_.reset();
  RecordedFrames* frames = &*frames_;
  Pipeline* pipeline = &*first_;
  if (other.method != OtherMethod::kFrame) {
    if (!other_frames_ || other_input_ != other.file) {
      auto opened = RecordedFrames::open(other.file, job);
      if (!opened) return opened.error();
      other_frames_ = std::move(*opened);
      other_input_ = other.file;
    }
    frames = &*other_frames_;
  }
  if (other.method == OtherMethod::kFinger) {
    if (const Status status = open_other(other, job); !status) return status.error();
    pipeline = &*other_;
  }
  const auto frame_read = frames->frame(std::min(other.frame, frames->count() - 1));
  if (!frame_read) return frame_read.error();
  pipeline->forget();
  auto result = (*pipeline)(*frame_read);
  pipeline->forget();
  if (pipeline == &*first_) last_.reset();
  if (!result) return result.error();
  other_frame_of_ = other;
  other_frame_ = std::move(*result);
  return *other_frame_;
}

void FrameMeasurer::compare_with_body(MeasuredFrame& frame, const std::filesystem::path& file,
                                      const Job& job) {
  if (!frame.result.depth || !frame.result.shape) return;
  if (!body_ || body_file_ != file) {
    body_.reset();
    auto loaded = load_body(file);
    if (!loaded) {
      frame.other_problem = loaded.error();
      return;
    }
    body_ = std::move(*loaded);
    body_file_ = file;
  }
  auto posed = pose_nominal(frame.result, frame.face, *body_->shape, job);
  if (!posed) {
    frame.other_problem = posed.error();
    return;
  }
  frame.body_rms_mm = posed->rms_mm;
  const cv::Mat& own_mm = frame.result.depth->depth_mm;
  // Where the body does not reach, it leaves the skin untouched.
  cv::Mat body_mm = posed->depth_mm;
  body_mm.setTo(0.0F, ~(body_mm == body_mm));
  body_mm.setTo(std::numeric_limits<float>::quiet_NaN(), ~(own_mm == own_mm));
  frame.other = frame.result;
  frame.other->depth->depth_mm = body_mm;
  frame.difference_mm = posed->distance_mm;
}

void FrameMeasurer::compare(MeasuredFrame& frame, const ComparisonSpec& other, bool is_next,
                            const Job& job) {
  frame.other_face = frame.face;
  if (other.method == OtherMethod::kBody) return compare_with_body(frame, other.file, job);
  if (is_other_frame(other.method)) {
    auto result = measure_other_frame(other, job);
    if (result) frame.other = std::move(*result);
    if (!result) frame.other_problem = result.error();
    if (result && other.method == OtherMethod::kFinger) frame.other_face = other_->finger().face;
  } else {
    if (const Status status = open_other(other, job); !status) {
      frame.other_problem = status.error();
      return;
    }
    if (!is_next) other_->forget();
    auto result = (*other_)(frame.result.frame);
    if (result) frame.other = std::move(*result);
  }
  if (!frame.other || !frame.other->depth || !frame.result.depth) return;
  frame.difference_mm = is_other_frame(other.method)
                            ? difference_on_face(frame.result, *frame.other)
                            : difference_of(frame.result, *frame.other);
}

Result<MeasuredFrame> FrameMeasurer::measure(std::size_t number, const ComparisonSpec& other,
                                             const Job& job) {
  number = std::min(number, frames_->count() - 1);
  auto frame_read = frames_->frame(number);
  if (!frame_read) return frame_read.error();
  const bool is_next = frames_->is_continuous() && last_ && *last_ + 1 == number;
  if (!is_next) first_->forget();
  auto result = (*first_)(*frame_read);
  if (!result) return result.error();
  last_ = number;
  MeasuredFrame frame = measured_by(*finger_, first_->settings(), std::move(*result));
  frame.number = number;
  if (other.method != OtherMethod::kNone) compare(frame, other, is_next, job);
  return frame;
}

Result<MeasuredFrame> FrameMeasurer::complete(const FrameResult& live, const Finger& finger,
                                              const std::filesystem::path& folder,
                                              const ComparisonSpec& other, const Job& job) {
  const auto snapshot = FingerSnapshot::of(folder, finger);
  if (!snapshot) return snapshot.error();
  last_.reset();
  MeasuredFrame frame = measured_by(
      *snapshot, folder.empty() ? PipelineSettings{} : measuring_settings(folder), live);
  const bool is_itself =
      other.method == OtherMethod::kPaper || other.method == OtherMethod::kSetting;
  if (other.method == OtherMethod::kBody) compare(frame, other, false, job);
  if (is_itself && !folder.empty()) {
    if (const Status status = load_finger(folder, job); !status) return status.error();
    compare(frame, other, false, job);
  }
  return frame;
}

}  // namespace alltact
