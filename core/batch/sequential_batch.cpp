#include "core/batch/sequential_batch.h"

#include <utility>

namespace alltact {

SequentialBatch::SequentialBatch(Pipeline pipeline, bool is_continuous)
    : pipeline_(std::move(pipeline)),
      is_continuous_(is_continuous),
      is_sequential_(pipeline_.has_long_memory()),
      contacts_(is_continuous) {}

void SequentialBatch::begin_piece() {
  if (is_sequential_ || index_ % kPieceFrames != 0) return;
  pipeline_.forget();
  if (!is_continuous_) return;
  for (const FramePtr& frame : before_)
    if (frame) pipeline_.warm_up(frame);
}

void SequentialBatch::remember(const FramePtr& frame) {
  before_.push_back(frame);
  if (before_.size() > kWarmUpFrames) before_.pop_front();
  ++index_;
}

void SequentialBatch::skip() {
  begin_piece();
  remember(nullptr);
  static_cast<void>(contacts_(nullptr, {}));
}

Result<FrameResult> SequentialBatch::operator()(const FramePtr& frame) {
  begin_piece();
  if (!is_continuous_) pipeline_.forget();
  remember(frame);
  if (is_sequential_) return pipeline_(frame);
  std::optional<FrameContacts> contacts;
  auto result = pipeline_.measure_untracked(frame, contacts);
  std::array<PushedFace, 5> faces{};
  if (contacts)
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = contacts->by_face[i].face;
  const auto lasting = contacts_(contacts ? &contacts->seen : nullptr, faces);
  if (!result || !lasting) return result;
  FingerContact& contact = result->contact.emplace(contacts->by_face[lasting->which]);
  contact.is_new = lasting->estimate.is_new;
  contact.held_s = lasting->estimate.held_s;
  contact.is_slipping = lasting->estimate.is_slipping;
  return result;
}

}  // namespace alltact
