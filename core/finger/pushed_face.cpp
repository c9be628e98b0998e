#include "core/finger/pushed_face.h"

#include <array>

namespace alltact {

std::string_view to_string(PushedFace face) {
  constexpr std::array<std::string_view, 4> words{"contact", "back", "upper", "lower"};
  return words[static_cast<std::size_t>(face) - 1];
}

}  // namespace alltact
