// A recording measured frame after frame by whoever asks for one after the other, each frame to the
// bit as measure_batch() (batch.h) measures it on any number of cores.
#pragma once

#include "core/batch/batch.h"

#include <cstddef>
#include <deque>

namespace alltact {

class FramesInTurn {
 public:
  /// `is_continuous`: Source::is_continuous(). The pipeline is this one's own.
  FramesInTurn(Pipeline pipeline, bool is_continuous);

  /// The next frame. Error: its size is not the finger's.
  [[nodiscard]] Result<FrameResult> operator()(const FramePtr& frame);
  /// The next frame could not be read.
  void skip();

  [[nodiscard]] const Pipeline& pipeline() const { return pipeline_; }

 private:
  void begin_piece();
  void remember(const FramePtr& frame);

  Pipeline pipeline_;
  bool is_continuous_, in_one_;
  LastingContacts contacts_;
  std::size_t index_ = 0;
  std::deque<FramePtr> before_;  // null: could not be read
};

}  // namespace alltact
