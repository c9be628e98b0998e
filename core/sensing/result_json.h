// What one frame told, as a line of results.jsonl.
#pragma once

#include "core/message.h"
#include "core/sensing/pipeline.h"

#include <cstddef>
#include <string>
#include <vector>

namespace alltact {

/// One JSON object without line break. What could not be had is absent, never zero; `problems`,
/// where there are any, say why in English.
[[nodiscard]] std::string result_line(const FrameResult& result,
                                      std::size_t index,
                                      ReferenceMethod method);

/// The line of a frame that could not be read at all.
[[nodiscard]] std::string failure_line(const std::string& frame,
                                       std::size_t index,
                                       const std::vector<Message>& problems);

}  // namespace alltact
