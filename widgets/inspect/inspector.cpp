#include "widgets/inspect/inspector.h"

#include "calibration/finger/measuring_settings.h"
#include "core/sensing/depth/depth_sd.h"

#include <limits>

namespace alltact {
namespace {

constexpr int kVertices = 25000;  // 30 faces a second, drawn in software

}  // namespace

cv::Mat depth_difference_mm(const InspectedFrame& frame) {
  return frame.result.depth->depth_mm - frame.other->depth->depth_mm;
}

Status Inspector::load_finger(const std::filesystem::path& folder, const Job& job) {
  if (folder == folder_ && first_) return {};
  folder_ = folder;
  finger_.reset();
  first_.reset();
  other_.reset();
  last_.reset();
  grid_ = {};
  if (folder.empty())
    return Error{en::say("no finger is open, so the recording cannot be measured"),
                 "",
                 en::say("opening a finger")};
  auto finger = open_finger(folder);
  if (!finger) return finger.error();
  auto pipeline = Pipeline::create(**finger, measuring_settings(folder), job);
  if (!pipeline) return pipeline.error();
  finger_ = *finger;
  first_ = std::move(*pipeline);
  return {};
}

Status Inspector::load_other(const Job& job) {
  if (other_) return {};
  auto pipeline = Pipeline::create(*finger_, paper_settings(), job);
  if (!pipeline) return pipeline.error();
  other_ = std::move(*pipeline);
  return {};
}

Status Inspector::open(const std::filesystem::path& input, const Job& job) {
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

void Inspector::compare(InspectedFrame& frame, bool is_next) {
  if (!is_next) other_->forget();
  auto result = (*other_)(frame.result.frame);
  if (result) frame.other = std::move(*result);
}

void Inspector::finish(InspectedFrame& frame, const std::optional<MappingParameters>& mapping) {
  const FrameResult& result = frame.result;
  frame.is_calibrated = mapping.has_value();
  if (!result.depth || !result.shape) return;
  if (grid_.area() == 0) grid_ = grid_for(result, kVertices);
  frame.surface = face_surface(result, frame.face, grid_.width, grid_.height);
  if (mapping && result.reference)
    if (const auto curve = Mapping::create(*mapping))
      frame.sd_mm = depth_sd_mm(*result.depth, *result.reference, *result.shape, *curve);
  if (!frame.other || !frame.other->depth || !frame.surface) return;
  frame.other_surface = face_surface(*frame.other, frame.face, grid_.width, grid_.height);
  frame.other_depth_mm.create(frame.surface->depth_mm.size(), CV_32FC1);
  for (int j = 0; j < grid_.height; ++j) {
    for (int i = 0; i < grid_.width; ++i) {
      const auto& pixel = frame.surface->pixel.at<cv::Vec2f>(j, i);
      frame.other_depth_mm.at<float>(j, i) =
          value_between(frame.other->depth->depth_mm, pixel[0], pixel[1]);
    }
  }
}

Result<std::shared_ptr<InspectedFrame>> Inspector::measure(const InspectWish& wish,
                                                           const Job& job) {
  const std::size_t number = std::min(wish.number, frames_->count() - 1);
  auto picture = frames_->frame(number);
  if (!picture) return picture.error();
  const bool is_next = frames_->is_continuous() && last_ && *last_ + 1 == number;
  if (!is_next) first_->forget();
  auto result = (*first_)(*picture);
  if (!result) return result.error();
  last_ = number;
  auto frame = std::make_shared<InspectedFrame>();
  frame->number = number;
  frame->result = std::move(*result);
  frame->face = finger_->finger.face;
  frame->camera = first_->camera();
  if (wish.other == OtherMethod::kPaper) {
    if (const Status status = load_other(job); !status) return status.error();
    compare(*frame, is_next);
  }
  finish(*frame, finger_->finger.mapping);
  return frame;
}

Result<std::shared_ptr<InspectedFrame>> Inspector::take_live(const InspectWish& wish,
                                                             const Job& job) {
  const Finger& finger = *wish.live_finger;
  auto camera = Camera::create(finger.camera);
  if (!camera) return camera.error();
  auto frame = std::make_shared<InspectedFrame>();
  frame->result = wish.live->result;
  frame->face = finger.face;
  frame->camera = *camera;
  last_.reset();
  if (wish.other == OtherMethod::kPaper && !wish.finger.empty()) {
    if (const Status status = load_finger(wish.finger, job); !status) return status.error();
    if (const Status status = load_other(job); !status) return status.error();
    compare(*frame, false);
  }
  finish(*frame, finger.mapping);
  return frame;
}

InspectAnswer Inspector::operator()(const InspectWish& wish, const Job& job) {
  InspectAnswer answer;
  const auto fail = [&](const Error& error) {
    answer.problem = error;
    return answer;
  };
  if (wish.live) {
    auto frame = take_live(wish, job);
    if (!frame) return fail(frame.error());
    answer.frame = *frame;
    return answer;
  }
  if (const Status status = open(wish.input, job); !status) return fail(status.error());
  answer.recording =
      RecordingInfo{wish.input, frames_->count(), frames_->frames_per_s(), times_ns_};
  if (const Status status = load_finger(wish.finger, job); !status) return fail(status.error());
  auto frame = measure(wish, job);
  if (!frame) return fail(frame.error());
  answer.frame = *frame;
  return answer;
}

}  // namespace alltact
