// Damage as disks, editors and strangers do it, the same for the same random numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>

namespace alltact::test {

/// One to four times: bytes changed, removed, doubled, moved, a number made another, the end cut.
inline std::string damaged(std::string bytes, std::mt19937& random) {
  static const std::string kMarks = "[]{}:,-\"0e.x\\ n\n\xFF\x80";
  for (auto count = 1 + random() % 4; count > 0 && !bytes.empty(); --count) {
    const std::size_t at = random() % bytes.size();
    const std::size_t size = std::min<std::size_t>(1 + random() % 12, bytes.size() - at);
    switch (random() % 7) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = kMarks[random() % kMarks.size()];
        break;
      case 2:
        bytes.erase(at, size);
        break;
      case 3:
        bytes.insert(at, bytes.substr(at, size));
        break;
      case 4:
        bytes.insert(random() % bytes.size(), bytes.substr(at, size));
        break;
      case 5:
        if (const auto digit = bytes.find_first_of("0123456789", at); digit != std::string::npos)
          bytes.replace(digit, 1, random() % 2 == 0 ? "9e99" : "-0");
        break;
      default:
        if (random() % 8 == 0) bytes.resize(at);
    }
  }
  return bytes;
}

}  // namespace alltact::test
