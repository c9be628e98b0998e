// What the libraries say, in the window's language.
#pragma once

#include <QString>
#include <string_view>

namespace alltact {

/// A text of core, calibration or the command line, which know no languages: an error's words, a
/// warning, a verdict, a phrase of progress, or several of them put together. It is recognised by
/// the patterns of the catalogue (catalogue.h); what fits none stays as it is, and so do numbers
/// and names. GUI thread only. Some ten microseconds for a text that was not seen before.
[[nodiscard]] QString in_window_language(std::string_view text);

/// The same, as one to begin a line with: a capital first and a full stop last.
[[nodiscard]] QString window_sentence(std::string_view text);

}  // namespace alltact
