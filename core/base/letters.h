// Letters, digits and blanks of ASCII, alike in every locale: in a Turkish one std::tolower leaves
// 'I' as it is.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace alltact {

[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

[[nodiscard]] constexpr bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

[[nodiscard]] constexpr char lowered(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

[[nodiscard]] inline std::string lowered(std::string text) {
  for (char& c : text) c = lowered(c);
  return text;
}

/// The letters and digits alone, in lower case: camera_matrix, cameraMatrix and Camera-Matrix are
/// one.
[[nodiscard]] inline std::string plain_word(std::string_view text) {
  std::string word;
  for (const char c : text)
    if (is_digit(c) || is_letter(c)) word += lowered(c);
  return word;
}

/// ".png" of "a.PNG".
[[nodiscard]] inline std::string lowered_extension(const std::filesystem::path& file) {
  return lowered(file.extension().string());
}

[[nodiscard]] constexpr std::string_view trimmed(std::string_view text,
                                                 std::string_view around = " \t\r\n") {
  const std::size_t first = text.find_first_not_of(around);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(around) + 1 - first);
}

}  // namespace alltact
