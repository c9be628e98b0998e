#include "core/io/image_note.h"

#include "core/io/png_check_sum.h"

namespace alltact {
namespace {

using std::string_view_literals::operator""sv;

constexpr std::string_view kSignature = "\x89PNG\r\n\x1A\n"sv;
constexpr std::size_t kHeaderEnd = 33;  // signature, then the chunk IHDR
constexpr std::size_t kAround = 12;     // length, type and check sum of a chunk
// Keyword; then neither compressed, nor in a language, nor with a translated keyword.
constexpr std::string_view kBefore = "AllTact settings\0\0\0\0\0"sv;

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    bytes.push_back(static_cast<char>(number >> shift & 0xFFU));
  return bytes;
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = number << 8U | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

}  // namespace

std::string with_note(std::string_view png, std::string_view note) {
  std::string chunk = "iTXt";
  chunk.append(kBefore).append(note);
  std::string content(png.substr(0, kHeaderEnd));
  content += big_endian(static_cast<std::uint32_t>(chunk.size() - 4));
  content += chunk;
  content += big_endian(png_check_sum(chunk));
  return content.append(png.substr(kHeaderEnd));
}

std::string note_of(std::string_view png) {
  if (!png.starts_with(kSignature)) return {};
  for (std::size_t at = kSignature.size(); at + kAround <= png.size();) {
    const std::size_t length = number_at(png, at);
    if (length > png.size() - at - kAround) return {};
    const std::string_view data = png.substr(at + 8, length);
    if (png.substr(at + 4, 4) == "iTXt" && data.starts_with(kBefore))
      return std::string(data.substr(kBefore.size()));
    at += kAround + length;
  }
  return {};
}

}  // namespace alltact
