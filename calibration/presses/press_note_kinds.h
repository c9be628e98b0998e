// Notes on single presses, as the command line writes them: NAME=VALUE.
#pragma once

#include "core/base/result.h"
#include "core/finger/press_set.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// One kind of note.
struct PressNoteKind {
  const char* flag;  ///< of the command line, without dashes
  const char* form;  ///< its value: "NAME=MM"
  const char* help;
  /// The word instead of a value that resets the note; nullptr: there is none.
  const char* reset_word;
  /// Parses a value into a note. False: it is invalid.
  bool (*read)(const std::string& value, PressNote& note);
  /// The value as text with all digits; empty: the note has none of this kind.
  std::optional<std::string> (*write)(const PressNote& note);
  void (*forget)(PressNote& note);
  /// The value is optional, and begins behind the first '=' instead of the last.
  bool is_free_text = false;
};

/// All kinds, in the order in which they are written.
[[nodiscard]] const std::vector<PressNoteKind>& press_note_kinds();

/// Sets or resets the note in `text` in `presses`. Error: `text` has not the kind's form.
[[nodiscard]] Status set_press_note(const PressNoteKind& kind, const std::string& text,
                                    PressSet& presses);

/// "--depth press_2=1.2+-0.01", for all notes; pairs of flag and text.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> press_note_flags(
    const PressSet& presses);

}  // namespace alltact
