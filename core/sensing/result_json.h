// The result of one frame as a line of results.jsonl.
#pragma once

#include "core/base/message.h"
#include "core/sensing/contact/finger_contact.h"
#include "core/sensing/frame_result.h"

#include <cstddef>
#include <string>
#include <vector>

namespace alltact {

/// One JSON object without line break. Fields that could not be estimated are absent, never zero;
/// `problems` holds the reasons in English.
[[nodiscard]] std::string result_line(const FrameResult& result, std::size_t index,
                                      ReferenceMethod method);

/// The line of a frame that could not be read.
[[nodiscard]] std::string failure_line(const std::string& frame, std::size_t index,
                                       const std::vector<Message>& problems);

/// Name of a frame that could not be read, from the error that names its file.
[[nodiscard]] std::string frame_name(const Error& error, std::size_t index);

/// The form in which an error is listed among the problems of a line.
[[nodiscard]] Message as_sentence(const Error& error);

/// Inserts a contact into the line of a frame that was measured without tracking
/// (Pipeline::measure_untracked). Equals to the byte result_line() of the result with the contact.
[[nodiscard]] std::string with_contact(const std::string& line, const FingerContact& contact);

}  // namespace alltact
