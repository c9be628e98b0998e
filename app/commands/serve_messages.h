// What `alltact serve` says: of its finger, and of each frame.
#pragma once

#include "core/finger/finger_store.h"
#include "core/sensing/pipeline.h"
#include "core/stream/stream_format.h"

#include <string>

namespace alltact {

struct ServedSource {
  std::string name;
  double frames_per_s = 30;
  bool is_camera = false;  ///< its times are the kernel's
};

[[nodiscard]] StreamMessage finger_message(const FingerSnapshot& finger,
                                           const Pipeline& pipeline,
                                           const ServedSource& source);

/// `line`: of results.jsonl, to which finger_revision is added. Only the parts that somebody wants
/// are made, as far as the frame tells them.
[[nodiscard]] StreamMessage frame_message(const FrameResult& result,
                                          const std::string& line,
                                          const FingerSnapshot& finger,
                                          StreamPartSet wanted);
/// Of a frame that could not be measured: its picture as it came.
[[nodiscard]] StreamMessage unmeasured_message(const Frame& frame,
                                               const std::string& line,
                                               const FingerSnapshot& finger,
                                               StreamPartSet wanted);
[[nodiscard]] StreamMessage problem_message(const Error& problem);
/// Of a kEnd message.
[[nodiscard]] std::string end_json(const Message& reason);

}  // namespace alltact
