#include "core/printable.h"

#include <algorithm>

#include <fmt/format.h>

namespace alltact {
namespace {

/// Bytes of the text's first UTF-8 character; 0 where it is invalid, or a control character (one
/// byte, or U+0080 to U+009F).
std::size_t printable_bytes(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  const bool is_overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool is_beyond = (first == 0xED && byte(1) >= 0xA0) || (first == 0xF4 && byte(1) >= 0x90);
  const bool is_control = first == 0xC2 && byte(1) < 0xA0;
  return is_overlong || is_beyond || is_control ? 0 : size;
}

std::string escaped(char c) {
  if (c == '\n') return "\\n";
  if (c == '\t') return "\\t";
  return fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::string_view kCut = "...";
  std::string result;
  std::size_t shown = 0, cut_at = 0;  // length at which a too long text is cut
  while (!text.empty()) {
    const std::size_t bytes = printable_bytes(text);
    const std::string one = bytes > 0 ? std::string(text.substr(0, bytes)) : escaped(text[0]);
    shown += bytes > 0 ? 1 : one.size();
    if (shown > kMaxPrinted) {
      result.resize(cut_at);
      result += kCut;
      break;
    }
    result += one;
    if (shown <= kMaxPrinted - kCut.size()) cut_at = result.size();
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return result;
}

}  // namespace alltact
