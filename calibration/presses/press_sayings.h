// What can be said of a single press, as the command line writes it: NAME=VALUE.
#pragma once

#include "core/finger/press_set.h"
#include "core/result.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// One kind of it.
struct PressSaying {
  const char* flag;  ///< of the command line, without dashes
  const char* form;  ///< what follows it: "NAME=MM"
  const char* help;
  /// What stands in place of the value to take back what was said; nullptr: nothing does.
  const char* take_back;
  /// Takes a value into a note. False: it is none.
  bool (*read)(const std::string& value, PressNote& note);
  /// The value back, with all digits; absent: the note says nothing of this kind.
  std::optional<std::string> (*write)(const PressNote& note);
  void (*forget)(PressNote& note);
  /// The value may be left out, and then begins behind the first '=' instead of the last.
  bool is_free_text = false;
};

/// All of them, in the order in which they are written.
[[nodiscard]] const std::vector<PressSaying>& press_sayings();

/// Takes what `text` says, or takes back, into `presses`. Error: it is not of the kind's form.
[[nodiscard]] Status say_of_press(const PressSaying& kind,
                                  const std::string& text,
                                  PressSet& presses);

/// "--depth press_2=1.2+-0.01", for all that is said; pairs of flag and text.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> said_of_presses(
    const PressSet& presses);

}  // namespace alltact
