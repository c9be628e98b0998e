// The quick guide: two pages to print and to pin up beside the finger, made from the words and the
// pictures with which the places' help begins.
#pragma once

#include "core/result.h"

#include <string>

namespace alltact {

/// A4, in the window's language. `date` (UTC, 2026-01-31T12:00:00Z) stands in the file as its time,
/// so that the same texts give the same bytes. GUI thread. Error: the texts do not fit on two pages
/// in letters that can be read.
[[nodiscard]] Result<std::string> quick_guide_pdf(const std::string& date);

}  // namespace alltact
