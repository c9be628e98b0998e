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

/// Name of a frame that could not be read, from the error that says which it was.
[[nodiscard]] std::string name_of(const Error& error, std::size_t index);

/// As problems stand in a line.
[[nodiscard]] Message as_sentence(const Error& error);

/// A contact as it stands in a line, without what lasts over frames (is_new and behind it).
[[nodiscard]] std::string contact_text(const FingerContact& contact);

/// A line of a frame measured by itself (Pipeline::alone) with its contact put into it.
///   contact: contact_text()
[[nodiscard]] std::string with_contact(const std::string& line,
                                       const std::string& contact,
                                       const ContactState::Told& told);

}  // namespace alltact
