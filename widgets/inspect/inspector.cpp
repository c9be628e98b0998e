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
  return measurer_.measure(wish.number, wish.other, job);
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
  if (!frame.other || !frame.other->depth || !frame.surface) return shown;
  frame.other_surface = face_surface(*frame.other, frame.face, grid_.width, grid_.height);
  frame.other_depth_mm.create(frame.surface->depth_mm.size(), CV_32FC1);
  for (int j = 0; j < grid_.height; ++j) {
    for (int i = 0; i < grid_.width; ++i) {
      const auto& pixel = frame.surface->pixel.at<cv::Vec2f>(j, i);
      frame.other_depth_mm.at<float>(j, i) =
          value_between(frame.other->depth->depth_mm, pixel[0], pixel[1]);
    }
  }
  return shown;
}

}  // namespace alltact
