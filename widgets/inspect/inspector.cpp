#include "widgets/inspect/inspector.h"

#include "core/sensing/measures.h"

#include <utility>

namespace alltact {
namespace {

constexpr int kVertices = 25000;  // 30 faces per second with software rendering

}  // namespace

InspectAnswer Inspector::operator()(const InspectRequest& request, const Job& job) {
  if (std::exchange(grid_of_, request.finger) != request.finger) grid_ = {};
  InspectAnswer answer;
  auto frame = measured(request, job, answer.recording);
  if (!frame) {
    answer.problem = frame.error();
    return answer;
  }
  answer.problem = frame->other_problem;
  answer.frame = with_surfaces(std::move(*frame));
  return answer;
}

Result<MeasuredFrame> Inspector::measured(const InspectRequest& request,
                                          const Job& job,
                                          std::optional<RecordingInfo>& recording) {
  if (request.live)
    return measurer_.complete(
        request.live->result, *request.live_finger, request.finger, request.other, job);
  if (const Status status = measurer_.open_recording(request.input, job); !status)
    return status.error();
  recording = measurer_.recording();
  if (const Status status = measurer_.load_finger(request.finger, job); !status)
    return status.error();
  auto frame = measurer_.measure(request.number, request.other, job);
  if (frame) note(*frame);
  return frame;
}

void Inspector::note(const MeasuredFrame& frame) {
  const RecordingInfo recording = measurer_.recording();
  if (summaries_of_ != recording.input || summaries_by_ != measurer_.finger()) {
    summaries_of_ = recording.input;
    summaries_by_ = measurer_.finger();
    has_summary_.assign(recording.count, 0);
    next_ = 0;
    update_ = {true, {}};
  }
  if (frame.number < has_summary_.size() && has_summary_[frame.number] == 0) {
    has_summary_[frame.number] = 1;
    update_.summaries.push_back(summary_of(frame));
  }
  while (next_ < has_summary_.size() && has_summary_[next_] != 0) ++next_;
}

bool Inspector::scan_next(const Job& job) {
  if (next_ >= has_summary_.size() || !measurer_.is_open() || summaries_by_ != measurer_.finger() ||
      summaries_of_ != measurer_.recording().input)
    return false;
  const auto frame = measurer_.measure(next_, {}, job);
  if (frame) {
    note(*frame);
  } else {
    has_summary_[next_] = 1;  // it cannot be read
    update_.summaries.push_back({next_, {}, {}, {}, false, frame.error().what});
    ++next_;
  }
  return true;
}

Inspector::SummaryUpdate Inspector::update() {
  return std::exchange(update_, {});
}

std::shared_ptr<const InspectedFrame> Inspector::with_surfaces(MeasuredFrame measured) {
  auto shown = std::make_shared<InspectedFrame>();
  InspectedFrame& frame = *shown;
  static_cast<MeasuredFrame&>(frame) = std::move(measured);
  const FrameResult& result = frame.result;
  if (!result.shape || (!result.depth && frame.is_calibrated)) return shown;
  if (grid_.area() == 0) grid_ = grid_for(result, kVertices);
  if (!result.depth) {
    frame.bare = uncalibrated_surface(result, frame.face, grid_.width, grid_.height);
    return shown;
  }
  frame.surface = face_surface(result, frame.face, grid_.width, grid_.height);
  if (!frame.other || !frame.other->depth || !frame.other->shape || !frame.surface) return shown;
  frame.other_surface = face_surface(*frame.other, frame.face, grid_.width, grid_.height);
  frame.other_depth_mm.create(frame.surface->depth_mm.size(), CV_32FC1);
  for (int j = 0; j < grid_.height; ++j) {
    for (int i = 0; i < grid_.width; ++i) {
      const auto& pixel = frame.surface->pixel.at<cv::Vec2f>(j, i);
      frame.other_depth_mm.at<float>(j, i) =
          frame.surface->depth_mm.at<float>(j, i) -
          bilinear_value(frame.difference_mm, pixel[0], pixel[1]);
    }
  }
  return shown;
}

}  // namespace alltact
