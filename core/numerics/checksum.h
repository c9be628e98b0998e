// A 64-bit checksum that detects changes. Not cryptographic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include <fmt/format.h>

namespace alltact {

/// The multiplication of FNV-1a, over words of 8 bytes instead of bytes. Files store its values.
class Checksum {
 public:
  /// Splitting the same bytes into other lengths gives another value.
  void add(const void* bytes, std::size_t count) {
    const auto* at = static_cast<const unsigned char*>(bytes);
    for (; count >= sizeof(std::uint64_t);
         count -= sizeof(std::uint64_t), at += sizeof(std::uint64_t)) {
      std::uint64_t word = 0;
      std::memcpy(&word, at, sizeof word);
      mix(word);
    }
    for (; count > 0; --count) mix(*at++);
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }
  /// 16 hexadecimal digits.
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", value_); }

 private:
  void mix(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x100000001b3U;
    value_ ^= value_ >> 32;  // a multiplication alone never carries high bits down
  }
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace alltact
