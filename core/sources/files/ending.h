// What a file is, by how its name ends.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string>

namespace alltact {

/// ".png", in small letters.
inline std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return ending;
}

template <std::size_t N>
bool is_one_of(const std::string& ending, const std::array<const char*, N>& endings) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

}  // namespace alltact
