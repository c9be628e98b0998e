// The messages of `alltact serve`: about its finger, and for each frame.
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

/// `line`: of results.jsonl, to which finger_revision is added. Only the requested parts are made,
/// as far as the frame has them.
[[nodiscard]] StreamMessage frame_message(const FrameResult& result,
                                          const std::string& line,
                                          const FingerSnapshot& finger,
                                          StreamPartSet requested);
/// For a frame that could not be measured: the image as it came.
[[nodiscard]] StreamMessage unmeasured_message(const Frame& frame,
                                               const std::string& line,
                                               const FingerSnapshot& finger,
                                               StreamPartSet requested);
[[nodiscard]] StreamMessage problem_message(const Error& problem);
/// Content of a kEnd message.
[[nodiscard]] std::string end_json(const Message& reason);

}  // namespace alltact
