// The quick guide: two pages to print and to pin up next to the finger, made from the beginning and
// the images of the pages' help.
#pragma once

#include "core/result.h"

#include <string>

namespace alltact {

/// A4, in the window's language. `date` (UTC, 2026-01-31T12:00:00Z) becomes the file's creation
/// time, so that the same texts give the same bytes. GUI thread. Error: the texts do not fit on two
/// pages in readable letters.
[[nodiscard]] Result<std::string> quick_guide_pdf(const std::string& date);

}  // namespace alltact
