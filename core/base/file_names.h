// Names of files that look the same and are stored differently: "é" is one character or two.
#pragma once

#include <filesystem>
#include <string>

namespace alltact {

/// The composed form of a text (Unicode's NFC): one character where one looks like two. Bytes that
/// are no UTF-8 leave the text unchanged.
[[nodiscard]] std::string composed(const std::string& text);

/// The file or folder that a path means: each of its names as it is where that exists; else the
/// only name in its folder with the same composed form, if there is one.
[[nodiscard]] std::filesystem::path as_stored(const std::filesystem::path& path);

}  // namespace alltact
