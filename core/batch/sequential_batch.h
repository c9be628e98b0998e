// Measures a recording frame by frame on request. Each result equals to the bit that of
// measure_batch() (batch.h) on any number of cores.
#pragma once

#include "core/batch/batch.h"

#include <cstddef>
#include <deque>

namespace alltact {

class SequentialBatch {
 public:
  /// `is_continuous`: Source::is_continuous().
  SequentialBatch(Pipeline pipeline, bool is_continuous);

  /// The next frame. Error: its size is not the finger's.
  [[nodiscard]] Result<FrameResult> operator()(const FramePtr& frame);
  /// The next frame could not be read.
  void skip();

  [[nodiscard]] const Pipeline& pipeline() const { return pipeline_; }

 private:
  void begin_piece();
  void remember(const FramePtr& frame);

  Pipeline pipeline_;
  bool is_continuous_, is_sequential_;
  LastingContacts contacts_;
  std::size_t index_ = 0;
  std::deque<FramePtr> before_;  // null: could not be read
};

}  // namespace alltact
