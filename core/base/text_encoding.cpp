#include "core/base/text_encoding.h"

#include "core/base/message.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <iconv.h>

namespace alltact {
namespace {

void append_utf8(std::uint32_t code, std::string& text) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  const auto put_behind = [&](int shift) { put(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | code >> 6), put_behind(0);
  } else if (code < 0x10000) {
    put(0xE0 | code >> 12), put_behind(6), put_behind(0);
  } else {
    put(0xF0 | code >> 18), put_behind(12), put_behind(6), put_behind(0);
  }
}

/// Number of bytes at the front that are UTF-8.
std::size_t utf8_size(std::string_view bytes) {
  std::size_t at = 0;
  while (at < bytes.size()) {
    const auto first = static_cast<unsigned char>(bytes[at]);
    if (first < 0x80) {
      ++at;
      continue;
    }
    const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || at + size > bytes.size()) return at;
    std::uint32_t code = first & (0x7FU >> size);
    for (std::size_t i = 1; i < size; ++i) {
      const auto next = static_cast<unsigned char>(bytes[at + i]);
      if ((next & 0xC0) != 0x80) return at;
      code = code << 6 | (next & 0x3F);
    }
    const std::uint32_t least = size == 2 ? 0x80 : size == 3 ? 0x800 : 0x10000;
    if (code < least || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return at;
    at += size;
  }
  return at;
}

/// Half surrogates become U+FFFD.
std::string from_utf16(std::string_view bytes, bool is_big_endian) {
  constexpr std::uint32_t kReplacement = 0xFFFD;
  const auto unit_at = [&](std::size_t i) {
    const auto first = static_cast<unsigned char>(bytes[i]),
               second = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<std::uint32_t>(is_big_endian ? first << 8 | second : second << 8 | first);
  };
  std::string text;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit_at(i);
    if (code >= 0xD800 && code < 0xE000) {
      const std::uint32_t low = code < 0xDC00 && i + 3 < bytes.size() ? unit_at(i + 2) : 0;
      const bool is_pair = low >= 0xDC00 && low < 0xE000;
      code = is_pair ? 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00) : kReplacement;
      if (is_pair) i += 2;
    }
    append_utf8(code, text);
  }
  return text;
}

/// As browsers decode it (WHATWG Encoding, index windows-1252).
std::string from_windows_1252(std::string_view bytes) {
  constexpr std::array<std::uint16_t, 32> kFrom80{
      0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
      0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
      0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};
  std::string text;
  for (const char c : bytes) {
    const std::uint32_t code = static_cast<unsigned char>(c);
    append_utf8(code >= 0x80 && code < 0xA0 ? kFrom80[code - 0x80] : code, text);
  }
  return text;
}

/// UTF-16 without a byte order mark: digits and commas have a zero on one side. 0: neither.
char utf16_side(std::string_view bytes) {
  const std::string_view front = bytes.substr(0, std::min<std::size_t>(bytes.size(), 4096) / 2 * 2);
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < front.size(); ++i) zeros[i % 2] += front[i] == '\0' ? 1 : 0;
  const std::size_t few = front.size() / 40, many = front.size() / 8;
  if (zeros[1] > many && zeros[0] <= few) return 'L';
  return zeros[0] > many && zeros[1] <= few ? 'B' : '\0';
}

/// The name of a kind of file that is no text; empty: unknown.
Message kind_of_binary(std::string_view bytes) {
  if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0"))
    return en::say("this is a workbook of a spreadsheet program, not a text");
  if (bytes.starts_with("%PDF-")) return en::say("this is a PDF, not a text");
  return {};
}

}  // namespace

std::optional<std::string> from_gb18030(std::string_view bytes) {
  const iconv_t converter = ::iconv_open("UTF-8", "GB18030");
  if (converter == iconv_t(-1)) return std::nullopt;
  std::string text(2 * bytes.size(), '\0');  // at most 3 bytes for 2, and 1 for 1
  char* from = const_cast<char*>(bytes.data());
  char* to = text.data();
  std::size_t from_size = bytes.size(), to_size = text.size();
  const std::size_t status = ::iconv(converter, &from, &from_size, &to, &to_size);
  ::iconv_close(converter);
  if (status == static_cast<std::size_t>(-1)) return std::nullopt;
  text.resize(text.size() - to_size);
  return text;
}

Result<DecodedText> decode_text(std::string_view bytes, const std::filesystem::path& origin) {
  const auto refused = [](Message what, Where where) {
    return Error{std::move(what), std::move(where), en::say("saving the table as CSV")};
  };
  if (Message binary = kind_of_binary(bytes); !binary.empty())
    return refused(std::move(binary), origin);
  const auto cut = en::say("the file ends in the middle of a character: it is not complete");
  DecodedText decoded;
  char side = bytes.starts_with("\xFF\xFE") ? 'L' : bytes.starts_with("\xFE\xFF") ? 'B' : '\0';
  if (side != '\0') decoded.mark_size = 2;
  if (side == '\0') side = utf16_side(bytes);
  if (side != '\0') {
    if (bytes.size() % 2 != 0) return refused(cut, origin);
    decoded.converted = from_utf16(bytes.substr(decoded.mark_size), side == 'B');
    decoded.encoding = "UTF-16";
  } else {
    if (bytes.starts_with("\xEF\xBB\xBF")) decoded.mark_size = 3;
    const std::size_t size = utf8_size(bytes);
    const std::string_view utf8 = bytes.substr(0, size), behind = bytes.substr(size);
    const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    const bool is_cut = !behind.empty() && behind.size() < 4 &&
                        static_cast<unsigned char>(behind[0]) >= 0xC2 &&
                        std::none_of(behind.begin(), behind.end(), is_ascii) &&
                        !std::all_of(utf8.begin(), utf8.end(), is_ascii);
    if (is_cut) return refused(cut, origin);
    if (!behind.empty()) {
      decoded.converted = from_windows_1252(bytes);
      decoded.encoding = kWesternEncoding;
    }
  }
  const std::string_view text = decoded.converted ? std::string_view(*decoded.converted) : bytes;
  const auto zero = std::find(text.begin(), text.end(), '\0');
  if (zero != text.end())
    return refused(en::say("holds a zero byte: this is no text, or was not written to its end"),
                   en::say("{}, line {}", origin, 1 + std::count(text.begin(), zero, '\n')));
  return decoded;
}

}  // namespace alltact
