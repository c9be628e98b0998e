#include "widgets/inspect/inspector.h"

#include "core/sensing/measures.h"

#include <utility>

namespace alltact {
namespace {

constexpr int kVertices = 25000;  // 30 faces a second, drawn in software

}  // namespace

InspectAnswer Inspector::operator()(const InspectWish& wish, const Job& job) {
  if (std::exchange(grid_of_, wish.finger) != wish.finger) grid_ = {};
  InspectAnswer answer;
  auto frame = measured(wish, job, answer.recording);
  if (!frame) {
    answer.problem = frame.error();
    return answer;
  }
  answer.problem = frame->other_problem;
  answer.frame = with_surfaces(std::move(*frame));
  return answer;
}

Result<MeasuredFrame> Inspector::measured(const InspectWish& wish,
                                          const Job& job,
                                          std::optional<RecordingInfo>& recording) {
  if (wish.live)
    return measurer_.complete(wish.live->result, *wish.live_finger, wish.finger, wish.other, job);
  if (const Status status = measurer_.open_recording(wish.input, job); !status)
    return status.error();
  recording = measurer_.recording();
  if (const Status status = measurer_.load_finger(wish.finger, job); !status) return status.error();
  auto frame = measurer_.measure(wish.number, wish.other, job);
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
    news_ = {true, {}};
  }
  if (frame.number < has_summary_.size() && has_summary_[frame.number] == 0) {
    has_summary_[frame.number] = 1;
    news_.summaries.push_back(summary_of(frame));
  }
  while (next_ < has_summary_.size() && has_summary_[next_] != 0) ++next_;
}

bool Inspector::look_further(const Job& job) {
  if (next_ >= has_summary_.size() || !measurer_.is_open() || summaries_by_ != measurer_.finger() ||
      summaries_of_ != measurer_.recording().input)
    return false;
  const auto frame = measurer_.measure(next_, {}, job);
  if (frame) {
    note(*frame);
  } else {
    has_summary_[next_] = 1;  // it cannot be read
    news_.summaries.push_back({next_, {}, {}, {}, false, frame.error().what});
    ++next_;
  }
  return true;
}

Inspector::News Inspector::news() {
  return std::exchange(news_, {});
}

std::shared_ptr<const InspectedFrame> Inspector::with_surfaces(MeasuredFrame measured) {
  auto shown = std::make_shared<InspectedFrame>();
  InspectedFrame& frame = *shown;
  static_cast<MeasuredFrame&>(frame) = std::move(measured);
  const FrameResult& result = frame.result;
  if (!result.shape || (!result.depth && frame.is_calibrated)) return shown;
  if (grid_.area() == 0) grid_ = grid_for(result, kVertices);
  if (!result.depth) {
    frame.bare = bare_surface(result, frame.face, grid_.width, grid_.height);
    return shown;
  }
  frame.surface = face_surface(result, frame.face, grid_.width, grid_.height);
  if (!frame.other || !frame.other->depth || !frame.other->shape || !frame.surface) return shown;
  frame.other_surface = face_surface(*frame.other, frame.face, grid_.width, grid_.height);
  frame.other_depth_mm.create(frame.surface->depth_mm.size(), CV_32FC1);
  for (int j = 0; j < grid_.height; ++j) {
    for (int i = 0; i < grid_.width; ++i) {
      const auto& pixel = frame.surface->pixel.at<cv::Vec2f>(j, i);
      frame.other_depth_mm.at<float>(j, i) = frame.surface->depth_mm.at<float>(j, i) -
                                             value_between(frame.difference_mm, pixel[0], pixel[1]);
    }
  }
  return shown;
}

}  // namespace alltact
